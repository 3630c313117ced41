"""The figures of [Chen2022] that show numbers: their axes, a symbol per model, closed forms as lines."""
import theory
from cantilevers import MILLI, MODELS, PERCENT, POISSON_RATIOS, REFERENCE, THIN, closed_form
from plot import Plot
from theory import Beam

LINE_LABELS = {"TBBM": "Timoshenko beam", "EBBM": "Euler-Bernoulli beam", "PBM": "PBM, closed form"}


def between(low, high, steps=100):
    return [low + (high - low) * i / steps for i in range(steps + 1)]


def of_models(data, x, scale=1.0):
    return [(model, model, data.column(x), [scale * y for y in data.column(model)]) for model in MODELS]


def curves(xs, ordinate, labels=None):
    """ordinate(model, x)"""
    labels = labels or LINE_LABELS
    return [(labels[model], model, xs, [ordinate(model, x) for x in xs]) for model in MODELS if model in labels]


def deflection(data):
    return Plot("fig8a", "Fig. 8a   Case 1: deflection along the beam", "distance from the fixed end [m]",
                "deflection [mm]", of_models(data, "x, m"),
                curves(between(0, 4), lambda m, x: MILLI * closed_form(m, REFERENCE, x, 10),
                       {"TBBM": "Timoshenko beam", "EBBM": "Euler-Bernoulli beam"}),
                ["set key left top", "set xrange [0:4.1]", "set yrange [0:9]"])


def deflection_error(data):
    def error(model, x):
        return PERCENT * abs(closed_form(model, REFERENCE, x, 10) / REFERENCE.timoshenko(x) - 1)
    return Plot("fig8b", "Fig. 8b   Case 1: error against the Timoshenko beam", "distance from the fixed end [m]",
                "magnitude of the error [%]", of_models(data, "x, m"), curves(between(0.2, 4), error),
                ["set xrange [0:4.1]", "set yrange [-0.2:6]"])


def shortened(data):
    # The PBM has a length of bonds, 0.4 m, where the beams have none: n = L0 / 0.4 m, continued between whole numbers.
    def relative(model, inverse_slenderness):
        beam = Beam(0.4 / inverse_slenderness, 0.2)
        return closed_form(model, beam, beam.length, 1 / inverse_slenderness) / beam.length
    return Plot("fig10", "Fig. 10   Case 2: tip deflection of a shortened beam", "1/λ_0 = 2r_b/L_0",
                "tip deflection over L_0", of_models(data, "1 / slenderness"), curves(between(0.1, 1), relative),
                ["set logscale y", 'set format y "10^{%L}"', "set xrange [0:1.05]", "set yrange [1e-5:1e-2]"])


def refined(data):
    return Plot("fig12", "Fig. 12   Case 3: number of bonds", "number of bonds", "tip deflection [mm]",
                of_models(data, "bonds"), curves(between(1, 10), lambda m, n: MILLI * closed_form(m, REFERENCE, 4, n)),
                ["set key right bottom", "set xrange [0:11]", "set yrange [6:9]", "set xtics 0,2"])


def touching(data):
    return Plot("fig14", "Fig. 14   Case 4: large touching particles", "number of bonds", "tip deflection [mm]",
                of_models(data, "bonds"), curves(between(1, 10), lambda m, n: MILLI * closed_form(m, THIN, 4, n)),
                ["set key right bottom", "set xrange [0:11]", "set yrange [95:145]", "set xtics 0,2"])


def polydisperse(data):
    exact = REFERENCE.timoshenko(4)
    radii = between(0.2, 1.2)

    def error(model, radius):
        tip = {"TBBM": exact, "EBBM": REFERENCE.euler_bernoulli(4), "PBM": theory.two_bonds(theory.gap_centres(radius))}
        return PERCENT * (tip[model] / exact - 1)
    lines = [(label, model, [theory.dispersion(r) for r in radii], ys) for label, model, _, ys in curves(radii, error)]
    return Plot("fig16", "Fig. 16   Case 5: particles of two sizes", "dispersion factor",
                "error against the Timoshenko beam [%]", of_models(data, "dispersion factor"), lines,
                ["set key left top", "set xrange [-0.05:1.6]", "set yrange [-2:15]"])


def stiffness_ratio(data):
    return Plot("fig17", "Fig. 17   Case 3: axial over shear stiffness of a bond", "number of bonds", "k_n/k_s",
                of_models(data, "bonds"),
                curves(between(1, 10), lambda m, n: theory.axial_to_shear(m, 10 / n),
                       {"TBBM": "Eq. 34, 20/9", "EBBM": "Eq. 33, 4/3", "PBM": "Eq. 32"}),
                ["set logscale y", "set xrange [0:11]", "set yrange [1:200]", "set xtics 0,2"])


def slenderness_error(data):
    styles = dict(zip(POISSON_RATIOS, ("first", "second", "third")))
    slenderness = between(0.8, 10)
    points = [(f"EBBM against TBBM, ν = {nu:g}", styles[nu], data.column("slenderness"), data.column(f"nu = {nu:g}"))
              for nu in POISSON_RATIOS]
    lines = [(f"Eq. 35, ν = {nu:g}", styles[nu], slenderness,
              [PERCENT * theory.euler_bernoulli_error(s, nu) for s in slenderness]) for nu in POISSON_RATIOS]
    return Plot("fig19", "Fig. 19   What the Euler-Bernoulli beam leaves out", "slenderness λ_0 = L_0/2r_b",
                "error of the tip deflection [%]", points, lines, ["set xrange [0:10.5]", "set yrange [0:45]"])
