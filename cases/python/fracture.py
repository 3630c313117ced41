#!/usr/bin/python3
"""A bundle of fibres whose strengths scatter by Weibull's law, drawn by numpy: its curve beside the closed form.

    PYTHONPATH=build/release/python cases/python/fracture.py [--out DIR]      writes bundle.png

Between two rigid rows each of N fibres of stiffness k carries k d, and the weakest that is left breaks where that
reaches its strength: F(d) = k d (N - broken), to the last digits. For many fibres that is N k d exp(-(k d / s)^m), the
largest at d = s / k m^(-1/m).
"""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  after the choice of what draws
import numpy as np  # noqa: E402

import bondstatic as bs  # noqa: E402

FIBRES, STIFFNESS, SCALE, MODULUS = 1000, 100.0, 20.0, 4.0


def bundle(strengths):
    """Feet, then heads; the factor is the elongation."""
    count = len(strengths)
    feet = np.column_stack([np.arange(count), np.zeros(count), np.zeros(count)])
    rows = np.arange(count)
    model = bs.Model(np.vstack([feet, feet + [0, 0, 1]]), 0.5, np.column_stack([rows, rows + count]))
    model.bond(law="contact", kn=STIFFNESS, ks=STIFFNESS, strength={
        "criterion": "contact-bond", "critical_tensile_force": strengths, "critical_shear_force": 1e9})
    model.fix(rows)
    model.fix(rows + count, values={"x": 0, "y": 0, "z": 1, "rx": 0, "ry": 0, "rz": 0})
    return model


def expected(strengths):
    """Elongation and force before each break, and the energy that is gone after it."""
    elongation = np.sort(strengths) / STIFFNESS
    left = np.arange(len(strengths), 0, -1)
    return elongation, STIFFNESS * elongation * left, np.cumsum(STIFFNESS * elongation**2 / 2)


def draw(found, file):
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    events = found.events
    # From rest up to each break and straight down from it.
    elongation = np.append(0, np.column_stack([events.displacement, events.displacement_after]))
    force = np.append(0, np.column_stack([events.load, events.load_after]))
    axes.plot(elongation, force, label=f"{FIBRES} fibres, bs.fracture")
    d = np.linspace(0, np.nanmax(elongation), 400)
    axes.plot(d, FIBRES * STIFFNESS * d * np.exp(-((STIFFNESS * d / SCALE) ** MODULUS)), "--", label="many fibres")
    axes.set(xlabel="elongation", ylabel="force")
    axes.legend()
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default=".", type=pathlib.Path)
    folder = parser.parse_args().out
    strengths = SCALE * np.random.default_rng(1).weibull(MODULUS, FIBRES)
    found = bs.fracture(bundle(strengths), control="displacement")

    elongation, force, dissipated = expected(strengths)
    apart = max(np.max(np.abs(found.events.displacement / elongation - 1)), np.max(np.abs(found.events.load / force - 1)),
                np.nanmax(np.abs(found.events.dissipated / dissipated - 1)))
    peak = np.argmax(found.events.load)
    print(f"{len(found.broken)} fibres broke: {found.reason}")
    print(f"largest force {found.events.load[peak]:.6g} at elongation {found.events.displacement[peak]:.6g}")
    print(f"from F = k d (N - broken), relative: {apart:.1e}")
    if not (np.array_equal(found.broken.row, np.argsort(strengths)) and apart < 1e-12):
        raise SystemExit("the two answers differ")

    folder.mkdir(parents=True, exist_ok=True)
    draw(found, folder / "bundle.png")
    print(f"written: {folder / 'bundle.png'}")


if __name__ == "__main__":
    main()
