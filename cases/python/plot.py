#!/usr/bin/python3
"""Forces in a slice of the packing of cases/yade-packing, and how they spread, by matplotlib.

    PYTHONPATH=build/release/python cases/python/plot.py [--out DIR]      writes forces.png
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  after the choice of what draws
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402

import bondstatic as bs  # noqa: E402

CASE = pathlib.Path(__file__).resolve().parents[1] / "yade-packing" / "press.toml"


def slice_of(axes, solution):
    """Bonds of the middle of the packing as lines, as wide as their normal force is large."""
    x, bonds, force = solution.model.x, solution.model.bonds, solution.bonds.normal_force
    centre, depth = np.median(x[:, 1]), 4 * np.median(solution.model.radius)
    inside = np.all(np.abs(x[bonds][:, :, 1] - centre) < depth, axis=1) & ~np.isnan(force)
    largest = np.abs(force[inside]).max()
    lines = LineCollection(1e3 * x[bonds[inside]][:, :, [0, 2]], linewidths=4 * np.abs(force[inside]) / largest,
                           colors=np.where(force[inside] < 0, "tab:blue", "tab:red"), capstyle="round")
    axes.add_collection(lines)
    axes.autoscale()
    axes.set(aspect="equal", xlabel="x, mm", ylabel="z, mm", title="normal forces in a slice")
    axes.plot([], [], color="tab:blue", label="compression")
    axes.plot([], [], color="tab:red", label="tension")
    axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1), frameon=False)


def spread_of(axes, solution):
    force = solution.bonds.normal_force
    force = force[~np.isnan(force)] / np.mean(np.abs(force[~np.isnan(force)]))
    bins = np.linspace(0, np.abs(force).max(), 40)
    sides = (("compression", -force[force < 0], "tab:blue"), ("tension", force[force > 0], "tab:red"))
    for name, side, colour in sides:
        axes.hist(side, bins, histtype="step", color=colour, label=f"{name}, {len(side)} bonds")
    axes.set(yscale="log", xlabel="|normal force| over its mean", ylabel="bonds", title="how forces spread")
    axes.legend()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default=".", type=pathlib.Path)
    folder = parser.parse_args().out
    solution = bs.solve(bs.read(CASE))
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5), layout="constrained",
                                         gridspec_kw={"width_ratios": [1, 1.3]})
    slice_of(left, solution)
    spread_of(right, solution)
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / "forces.png", dpi=120)
    print(f"{len(solution.bonds)} bonds; written: {folder / 'forces.png'}")


if __name__ == "__main__":
    main()
