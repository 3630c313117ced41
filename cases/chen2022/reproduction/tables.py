"""Tables 4, 5 and 9, explicit runs, and errors of cases 3 and 5 as Markdown, the same on the terminal and in the
README."""
import theory
from bond_stiffness import PRINTED, PRINTED_MODELS
from cantilevers import MILLI, MODELS, PERCENT, REFERENCE

DIGITS = 7
# [Chen2022] Table 4: what their DEM runs and the theories gave, mm.
PRINTED_DEM = {"TBBM": "8.537", "EBBM": "8.489", "PBM": "8.508"}
PRINTED_THEORY = {"TBBM": "8.534", "EBBM": "8.488"}


def markdown(header, rows):
    cells = [header, *rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    lines = ["| " + " | ".join(text.ljust(width) for text, width in zip(row, widths)) + " |" for row in cells]
    lines.insert(1, "|" + "|".join("-" * (width + 2) for width in widths) + "|")
    return "\n".join(lines)


def number(value, digits=DIGITS):
    # Rounding leaves a zero of either sign.
    text = f"{value:#.{digits}g}" if abs(value) > 1e-9 else "0"
    return text.rstrip(".")


def percent(value):
    return f"{value:+.3f}" if abs(value) >= 5e-4 else "0"


def table_4(deflection, checks):
    tip = dict(zip(deflection.columns, deflection.rows[-1]))
    exact = MILLI * REFERENCE.timoshenko(4)
    rows = []
    for m in MODELS:
        rows.append([m, number(tip[m]), number(tip[f"{m} closed form"]), PRINTED_DEM[m],
                     percent(PERCENT * (tip[m] / exact - 1)),
                     percent(PERCENT * (float(PRINTED_DEM[m]) / exact - 1))])
    for m, printed in PRINTED_THEORY.items():
        checks.printed("Table 4", f"theory of {m}", tip[m], printed, last_digits=0.5)
    # Their runs of these two came to rest within one unit; the one of the TBBM stopped 0.03 % off.
    for m in ("EBBM", "PBM"):
        checks.printed("Table 4", f"DEM of {m}", tip[m], PRINTED_DEM[m])
    header = ["model", "found, mm", "closed form, mm", "paper's DEM, mm", "error found, %", "error of the DEM, %"]
    return markdown(header, rows)


def explicit(data):
    header = ["model", "static, mm", "run, small, mm", "run, finite, mm", "finite against static", "along, mm",
              "paper's DEM, mm", "against static"]
    rows = []
    for row in data.rows:
        values = dict(zip(data.columns, row))
        static, found = values["static"], values["finite"]
        rows.append([values["model"], number(static), number(values["small"]), number(found),
                     f"{found / static - 1:+.2e}", f"{values['finite along']:+.4f}", PRINTED_DEM[values["model"]],
                     f"{float(PRINTED_DEM[values['model']]) / static - 1:+.1e}"])
    return markdown(header, rows)


def table_5(data):
    rows = []
    for row in data.rows:
        n = row[0]
        expected = [theory.stiffness("PBM", 4 / n, 0.2)["kn"]]
        expected += [theory.stiffness(m, 4 / n, 0.2)["ks"] for m in PRINTED_MODELS]
        names = ["kn", *(f"ks, {m}" for m in PRINTED_MODELS)]
        for i, name in enumerate(names):
            rows.append([str(n) if i == 0 else "", name, number(row[2 + i]), number(expected[i] / 1e9), PRINTED[n][i]])
    return markdown(["bonds", "stiffness", "found, GN/m", "closed form, GN/m", "printed, GPa m"], rows)


def table_9(data, ratios):
    header = ["ratio", *(text for m in MODELS for text in (m, "closed form"))]

    def line(name, row, columns):
        values = dict(zip(columns, row))
        return [name, *(number(values[key]) for m in MODELS for key in (m, f"{m} closed form"))]
    rows = [line(row[0], row, data.columns) for row in data.rows]
    rows += [line(f"kn / ks, case 3, {row[0]} bond{'s' * (row[0] > 1)}", row, ratios.columns)
             for row in ratios.rows if row[0] in (1, 2, 4, 6, 8)]
    return markdown(header, rows)


# Errors against Eq. 29, %, worked out by hand.
CASE_3_PBM = {1: "-24.92", 2: "-6.27", 4: "-1.61", 6: "-0.745", 8: "-0.442", 10: "-0.303"}
CASE_5_PBM = {0.2: "-0.54", 0.4: "3.38", 0.8: "12.33"}
EBBM_ERROR = "-0.539"


def errors(refined, polydisperse, checks):
    exact = MILLI * REFERENCE.timoshenko(4)
    header = ["case", "TBBM, %", "EBBM, %", "PBM, %", "PBM by closed form, %"]
    rows = []
    for row in refined.rows:
        values = dict(zip(refined.columns, row))
        found = {m: PERCENT * (values[m] / exact - 1) for m in MODELS}
        n = values["bonds"]
        checks.printed("Errors", f"PBM, {n} bonds", found["PBM"], CASE_3_PBM[n], last_digits=0.5)
        checks.printed("Errors", f"EBBM, {n} bonds", found["EBBM"], EBBM_ERROR, last_digits=0.5)
        rows.append([f"3, {n} bond{'s' * (n > 1)}", *(percent(found[m]) for m in MODELS),
                     percent(PERCENT * (values["PBM closed form"] / exact - 1))])
    for row in polydisperse.rows:
        values = dict(zip(polydisperse.columns, row))
        radius = values["middle radius, m"]
        checks.printed("Errors", f"PBM, middle radius {radius} m", values["PBM"], CASE_5_PBM[radius], last_digits=0.5)
        checks.printed("Errors", f"EBBM, middle radius {radius} m", values["EBBM"], EBBM_ERROR, last_digits=0.5)
        rows.append([f"5, middle radius {radius} m", *(percent(values[m]) for m in MODELS),
                     percent(values["PBM closed form"])])
    return markdown(header, rows)
