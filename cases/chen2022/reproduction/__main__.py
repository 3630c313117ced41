"""Regenerates the tables and figures of [Chen2022] from the program's answers; exits 1 where a number is not what its
closed form says."""
import argparse
import csv
import pathlib
import sys

import bond_stiffness
import cantilevers
import explicit_runs
import figures
import readme
import tables
from checks import TOLERANCE, Checks
from plot import draw
from program import CASES, Program

# Those that the README shows.
SHOWN = ("fig8b", "fig12", "fig16")


def parse_arguments():
    parser = argparse.ArgumentParser(prog="cases/chen2022/reproduce", description=__doc__)
    parser.add_argument("--program", required=True, metavar="FILE",
                        help="the bondstatic to ask (default: a build of the tree)")
    parser.add_argument("--out", default=CASES.parent.parent / "build" / "chen2022", type=pathlib.Path, metavar="DIR",
                        help="folder for CSV data and SVG figures (default: build/chen2022)")
    parser.add_argument("--update", action="store_true", help="renew the figures and tables that the README shows")
    parser.add_argument("--explicit", action="store_true",
                        help="explicit runs with the paper's own damping, which takes a minute or two (default: with a "
                             "stronger one, to the same end)")
    return parser.parse_args()


def write_csv(data, folder):
    with open(folder / f"{data.name}.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(data.columns)
        writer.writerows(data.rows)


def main():
    arguments = parse_arguments()
    program, checks = Program(arguments.program), Checks()

    fig8a, fig8b = cantilevers.deflection_along_beam(program, checks)
    fig10 = cantilevers.shortened(program, checks)
    fig12 = cantilevers.refined(program, checks)
    fig14 = cantilevers.touching(program, checks)
    cantilevers.every_particle(program, checks)
    fig16 = cantilevers.polydisperse(program, checks)
    stiffness = bond_stiffness.measured(program, checks)
    table5 = bond_stiffness.table_5(stiffness, checks)
    table9 = bond_stiffness.table_9(program, stiffness, checks)
    fig17 = bond_stiffness.axial_to_shear(stiffness, checks)
    fig19 = cantilevers.slenderness_error(program, checks)
    damping = explicit_runs.PAPERS_DAMPING if arguments.explicit else explicit_runs.STRONG_DAMPING
    runs = explicit_runs.at_rest(program, checks, damping)

    shown_tables = {
        "Table 4": tables.table_4(fig8a, checks),
        "Table 5": tables.table_5(table5),
        "Table 9": tables.table_9(table9, fig17),
        "Errors": tables.errors(fig12, fig16, checks),
        "Explicit runs": tables.explicit(runs),
    }
    plots = [figures.deflection(fig8a), figures.deflection_error(fig8b), figures.shortened(fig10),
             figures.refined(fig12), figures.touching(fig14), figures.polydisperse(fig16),
             figures.stiffness_ratio(fig17), figures.slenderness_error(fig19)]

    arguments.out.mkdir(parents=True, exist_ok=True)
    for data in (fig8a, fig8b, fig10, fig12, fig14, fig16, fig17, fig19, table5, table9, runs):
        write_csv(data, arguments.out)
    drawn = [draw(plot, arguments.out) for plot in plots]
    shown_figures = [path for path in drawn if path.stem in SHOWN]

    for name, table in shown_tables.items():
        print(f"{name}\n\n{table}\n")
    for row in runs.rows:
        steps = dict(zip(runs.columns, row))
        print(f"{row[0]} at rest after {steps['steps, small']} steps in {steps['seconds, small']:.1f} s (small), "
              f"{steps['steps, finite']} in {steps['seconds, finite']:.1f} s (finite), particle damping {damping}")
    print(f"\nFound against closed form, at most {TOLERANCE:.0e} allowed, {explicit_runs.REST:.0e} for explicit runs:\n"
          f"{checks.report()}\n\nwritten: {arguments.out}")
    if arguments.update and not checks.failures:
        readme.update(shown_tables, shown_figures)
    checks.failures += readme.differences(shown_tables, shown_figures)
    for failure in checks.failures:
        print(f"MISMATCH {failure}", file=sys.stderr)
    return 1 if checks.failures else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (RuntimeError, OSError) as error:
        sys.exit(f"reproduce: {error}")
