"""Tables 5 and 9, Fig. 17: the stiffness of one bond, measured by moving one of its particles."""
import theory
from cantilevers import BONDS, BONDS_OF_TABLE_5, EVERY_LAW, MODEL_OF, MODELS, REFERENCE, Data, side_by_side

GIGA = 1e9
BOND_RADIUS = 0.2
# Numbers as printed in [Chen2022] Table 5, GN/m: bonds -> kn, ks of PBM, EBBM, TBBM.
PRINTED = {1: ("6.283", "2.416", "0.04712", "0.04612"), 2: ("12.56", "4.833", "0.3769", "0.3469"),
           4: ("25.13", "9.66", "3.016", "2.240"), 6: ("37.69", "14.50", "10.18", "5.718"),
           8: ("50.26", "19.33", "24.13", "10.11"), 10: ("62.83", "24.17", "47.12", "14.88")}
# The order of the columns of Table 5.
PRINTED_MODELS = ("PBM", "EBBM", "TBBM")


def measured(program, checks):
    """(model, bonds) -> kn, ks, kt, kb in N/m and N m, for bonds of 4/n m as in case 3."""
    lengths = {repr([4 / n, 0, 0]).replace(" ", ""): n for n in BONDS}
    found = {}
    for row in program.sweep("stiffness.toml", EVERY_LAW, "particles.1.line.from=" + ",".join(lengths)):
        model, n = MODEL_OF[row["bonds.0.law"]], lengths[row["particles.1.line.from"]]
        expected = theory.stiffness(model, 4 / n, BOND_RADIUS)
        found[model, n] = {name: checks.equal("Stiffness", f"{name} of {model}, {n} bonds", GIGA * row[name], value)
                           for name, value in expected.items()}
    return found


def table_5(found, checks):
    shear_columns = [f"ks of {m}, GN/m" for m in PRINTED_MODELS]
    data = Data("table5", ["bonds", "length / beam length", "kn, GN/m", *shear_columns], [])
    for n in BONDS_OF_TABLE_5:
        numbers = [found["PBM", n]["kn"] / GIGA, *(found[m, n]["ks"] / GIGA for m in PRINTED_MODELS)]
        for name, number, printed in zip(data.columns[2:], numbers, PRINTED[n]):
            checks.printed("Table 5", f"{name}, {n} bonds", number, printed)
        data.rows.append([n, 1 / n, *numbers])
    shear = {(m, n): found[m, n]["ks"] for m in MODELS for n in (1, 10)}
    # Section 4.1 in words.
    checks.printed("Table 5", "PBM over TBBM, 1 bond", shear["PBM", 1] / shear["TBBM", 1], "52")
    checks.printed("Table 5", "PBM over TBBM, 10 bonds", shear["PBM", 10] / shear["TBBM", 10], "1.6")
    checks.printed("Table 5", "EBBM over TBBM, 10 bonds", shear["EBBM", 10] / shear["TBBM", 10], "3.1")
    return data


def axial_to_shear(found, checks):
    """Fig. 17."""
    data = side_by_side("fig17", ["bonds", "bond slenderness"])
    for n in BONDS:
        slenderness = 4 / n / (2 * BOND_RADIUS)
        ratios = {m: found[m, n]["kn"] / found[m, n]["ks"] for m in MODELS}
        expected = {m: theory.axial_to_shear(m, slenderness) for m in MODELS}
        for m in MODELS:
            checks.equal("Fig. 17", f"kn/ks of {m}, {n} bonds", ratios[m], expected[m])
        data.rows.append([n, slenderness, *ratios.values(), *expected.values()])
    return data


def contact_fraction(model, length, radius_a, radius_b):
    """Table 9, first row: distance of the contact point from particle a over the bond's length."""
    return (length + radius_a - radius_b) / (2 * length) if model == "PBM" else 0.5


def table_9(program, found, checks):
    """Ratios of one model's stiffnesses for the bond of case 1 (L = 0.4 m, r = 0.2 m), and where it acts."""
    ratios = {
        "kn L / EA": lambda k: k["kn"] * 0.4 / (theory.YOUNG * REFERENCE.area),
        "kn / ks": lambda k: k["kn"] / k["ks"],
        "kt / (kn r^2)": lambda k: k["kt"] / (k["kn"] * BOND_RADIUS**2),
        "kb / (kn r^2)": lambda k: k["kb"] / (k["kn"] * BOND_RADIUS**2),
    }
    data = side_by_side("table9", ["ratio"])
    for name, ratio in ratios.items():
        row, expected = [], []
        for m in MODELS:
            expected.append(ratio(theory.stiffness(m, 0.4, BOND_RADIUS)))
            row.append(checks.equal("Table 9", f"{name} of {m}", ratio(found[m, 10]), expected[-1]))
        data.rows.append([name, *row, *expected])

    # Unequal particles 2 m apart, as in case 5: the shear force's moment about particle a tells its lever arm.
    sweep = program.sweep("stiffness.toml", EVERY_LAW, "particles.1.radius=0.2,0.4,0.8",
                          settings=["particles.1.line.from=[2,0,0]"])
    for radius in ("0.2", "0.4", "0.8"):
        fraction = {MODEL_OF[row["bonds.0.law"]]: row["root moment"] / row["root shear"] / 2
                    for row in sweep if row["particles.1.radius"] == radius}
        expected = {m: contact_fraction(m, 2, 0.2, float(radius)) for m in MODELS}
        for m in MODELS:
            checks.equal("Table 9", f"contact point of {m}, Rb = {radius} m", fraction[m], expected[m])
        data.rows.append([f"a / L, Ra = 0.2, Rb = {radius} m", *(fraction[m] for m in MODELS), *expected.values()])
    return data
