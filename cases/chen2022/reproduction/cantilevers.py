"""Cases 1 to 5: deflections as the program answers them, each beside its closed form."""
from dataclasses import dataclass

import theory
from theory import Beam

LAWS = {"TBBM": "timoshenko", "EBBM": "euler-bernoulli", "PBM": "parallel"}
MODELS = list(LAWS)
EVERY_LAW = "bonds.0.law=" + ",".join(LAWS.values())
MODEL_OF = {law: model for model, law in LAWS.items()}
BONDS = range(1, 11)
BONDS_OF_TABLE_5 = [1, 2, 4, 6, 8, 10]

REFERENCE = Beam(4, 0.2)
MILLI = 1e3
PERCENT = 100


@dataclass
class Data:
    """What a figure or table is made of; becomes NAME.csv."""
    name: str
    columns: list
    rows: list

    def column(self, name):
        index = self.columns.index(name)
        return [row[index] for row in self.rows]


def closed_form(model, beam, x, bonds):
    """Deflection in m."""
    if model == "PBM":
        return beam.parallel(x, bonds)
    return beam.timoshenko(x) if model == "TBBM" else beam.euler_bernoulli(x)


def side_by_side(name, first_columns, models=tuple(MODELS)):
    return Data(name, [*first_columns, *models, *(f"{model} closed form" for model in models)], [])


def collect(rows, key):
    """key value -> model -> row of a sweep over every law and that key."""
    found = {}
    for row in rows:
        found.setdefault(row[key], {})[MODEL_OF[row["bonds.0.law"]]] = row
    return found


def deflection_along_beam(program, checks):
    """Fig. 8: deflection in mm, and how far it is off Eq. 28 in percent of that."""
    rows = {MODEL_OF[row["bonds.0.law"]]: row for row in program.sweep("case1.toml", EVERY_LAW)}
    deflection = side_by_side("fig8a", ["x, m"])
    error = side_by_side("fig8b", ["x, m"])
    for i in range(1, 11):
        x = 0.4 * i
        exact = MILLI * REFERENCE.timoshenko(x)
        expected = {m: MILLI * closed_form(m, REFERENCE, x, 10) for m in MODELS}
        found = {m: rows[m]["tip" if i == 10 else f"particle {i + 1}"] for m in MODELS}
        for m in MODELS:
            checks.equal("Fig. 8a", f"{m} at x = {x:.1f} m", found[m], expected[m])
        deflection.rows.append([x, *found.values(), *expected.values()])
        found_error = {m: PERCENT * abs(found[m] / exact - 1) for m in MODELS}
        expected_error = {m: PERCENT * abs(expected[m] / exact - 1) for m in MODELS}
        for m in MODELS:
            checks.equal("Fig. 8b", f"{m} at x = {x:.1f} m", found_error[m], expected_error[m], size=PERCENT)
        error.rows.append([x, *found_error.values(), *expected_error.values()])
    return deflection, error


def shortened(program, checks):
    """Fig. 10: tip deflection by length of the beam over the inverse of its slenderness."""
    sweep = program.sweep("case2.toml", EVERY_LAW, "particles.0.line.count=" + ",".join(str(n + 1) for n in BONDS))
    data = side_by_side("fig10", ["bonds", "length, m", "1 / slenderness"])
    for count, by_model in collect(sweep, "particles.0.line.count").items():
        n = int(count) - 1
        beam = Beam(0.4 * n, 0.2)
        found = {m: by_model[m]["tip"] / MILLI / beam.length for m in MODELS}
        expected = {m: closed_form(m, beam, beam.length, n) / beam.length for m in MODELS}
        for m in MODELS:
            checks.equal("Fig. 10", f"{m}, {beam.length:.1f} m", found[m], expected[m])
        data.rows.append([n, beam.length, 2 * beam.radius / beam.length, *found.values(), *expected.values()])
    return data


def setting_of_case_3(n):
    """Count and the gap that bonds neighbours only."""
    return n + 1, max(4 / n - 0.4, 0.0)


def setting_of_case_4(n):
    """Count and the radius of touching particles."""
    return n + 1, 2 / n


def tip_by_bonds(program, checks, subject, case, keys, setting, beam, numbers):
    """Fig. 12 and 14: tip deflection in mm over the number of bonds."""
    values = ",".join(f"{count}:{value!r}" for count, value in map(setting, numbers))
    sweep = program.sweep(case, EVERY_LAW, f"{':'.join(keys)}={values}")
    data = side_by_side(subject.lower().replace(". ", ""), ["bonds"])
    for count, by_model in collect(sweep, keys[0]).items():
        n = int(count) - 1
        found = {m: by_model[m]["tip"] for m in MODELS}
        expected = {m: MILLI * closed_form(m, beam, beam.length, n) for m in MODELS}
        for m in MODELS:
            checks.equal(subject, f"{m}, {n} bonds", found[m], expected[m])
        data.rows.append([n, *found.values(), *expected.values()])
    return data


COUNT_AND_GAP = ("particles.0.line.count", "bonds.0.gap")
COUNT_AND_RADIUS = ("particles.0.line.count", "particles.0.radius")
THIN = Beam(4, 0.1)


def refined(program, checks):
    return tip_by_bonds(program, checks, "Fig. 12", "case3.toml", COUNT_AND_GAP, setting_of_case_3, REFERENCE,
                        BONDS_OF_TABLE_5)


def touching(program, checks):
    return tip_by_bonds(program, checks, "Fig. 14", "case4.toml", COUNT_AND_RADIUS, setting_of_case_4, THIN, BONDS)


def every_particle(program, checks):
    """Deflection of each particle and rotation of the tip, for any number of bonds in case 3 and 4."""
    for case, keys, setting, beam in (("case3.toml", COUNT_AND_GAP, setting_of_case_3, REFERENCE),
                                      ("case4.toml", COUNT_AND_RADIUS, setting_of_case_4, THIN)):
        subject = f"Case {case[4]}, all"
        for n in BONDS:
            settings = [f"{key}={value!r}" for key, value in zip(keys, setting(n))]
            for m, law in LAWS.items():
                particles = program.particles(case, [f"bonds.0.law={law}", *settings])
                if len(particles) != n + 1:
                    raise RuntimeError(f"{case}: {len(particles)} particles where {n + 1} were asked for")
                for particle in particles[1:]:
                    x = particle["x"]
                    checks.equal(subject, f"{m}, {n} bonds, x = {x:g} m", -particle["uy"], closed_form(m, beam, x, n))
                checks.equal(subject, f"{m}, {n} bonds, rotation", -particles[-1]["rz"], beam.tip_rotation())


def polydisperse(program, checks):
    """Fig. 16: error of the tip deflection against Eq. 29, percent, over the dispersion factor."""
    # 4/3 (L/2r)^2 = 100/3 gives the PBM the shear stiffness of the EBBM.
    bonds = {"TBBM": '{ law = "timoshenko", young = 200e9, poisson = 0.3, radius = 0.2, gap = 1.6 }',
             "EBBM": '{ law = "euler-bernoulli", young = 200e9, poisson = 0.3, radius = 0.2, gap = 1.6 }',
             "PBM": f'{{ law = "parallel", young = 200e9, kappa = {100 / 3!r}, radius = 0.2, gap = 1.6 }}'}
    sweep = program.sweep("case5.toml", "bonds.0=" + ",".join(bonds.values()), "particles.1.radius=0.2,0.4,0.8")
    model_of = {text: model for model, text in bonds.items()}
    found = {(model_of[row["bonds.0"]], float(row["particles.1.radius"])): row["tip"] for row in sweep}
    exact = MILLI * REFERENCE.timoshenko(4)
    data = side_by_side("fig16", ["middle radius, m", "dispersion factor"])
    for radius in (0.2, 0.4, 0.8):
        expected = {"TBBM": exact, "EBBM": MILLI * REFERENCE.euler_bernoulli(4),
                    "PBM": MILLI * theory.two_bonds(theory.gap_centres(radius))}
        errors, expected_errors = [], []
        for m in MODELS:
            what = f"{m}, middle radius {radius} m"
            checks.equal("Fig. 16", what, found[m, radius], expected[m])
            errors.append(PERCENT * (found[m, radius] / exact - 1))
            expected_errors.append(PERCENT * (expected[m] / exact - 1))
            checks.equal("Fig. 16", what + ", error", errors[-1], expected_errors[-1], size=PERCENT)
        data.rows.append([radius, theory.dispersion(radius), *errors, *expected_errors])
    return data


POISSON_RATIOS = (0.0, 0.3, 0.5)


def slenderness_error(program, checks):
    """Fig. 19: what Euler and Bernoulli leave out of Timoshenko's tip deflection, percent, by slenderness and nu."""
    names = [f"nu = {poisson:g}" for poisson in POISSON_RATIOS]
    sweep = program.sweep("case2.toml", "bonds.0.law=timoshenko,euler-bernoulli",
                          "bonds.0.poisson=" + ",".join(map(repr, POISSON_RATIOS)),
                          "particles.0.line.count=" + ",".join(str(n + 1) for n in BONDS))
    tip = {(MODEL_OF[row["bonds.0.law"]], float(row["bonds.0.poisson"]), int(row["particles.0.line.count"]) - 1):
           row["tip"] for row in sweep}
    data = side_by_side("fig19", ["slenderness"], names)
    for n in BONDS:
        found, expected = [], []
        for poisson in POISSON_RATIOS:
            found.append(PERCENT * (1 - tip["EBBM", poisson, n] / tip["TBBM", poisson, n]))
            expected.append(PERCENT * theory.euler_bernoulli_error(n, poisson))
            checks.equal("Fig. 19", f"slenderness {n}, nu = {poisson}", found[-1], expected[-1], size=PERCENT)
        data.rows.append([n, *found, *expected])
    return data
