#!/usr/bin/python3
"""The calibration of cases/calibration/yade.toml by scipy instead of `bondstatic calibrate`: the same answer.

    PYTHONPATH=build/release/python cases/python/calibrate.py

A packing of 2068 spheres made by YADE, bonded by Timoshenko beams: which young and poisson of the bonds make the block
a rock of 35 GPa and 0.20? Residuals and their exact Jacobian come from one factorisation each.
"""
import math
import pathlib
import time

import numpy as np
from scipy.optimize import least_squares

import bondstatic as bs

CASE = pathlib.Path(__file__).resolve().parents[1] / "calibration" / "yade.toml"
WANTED = {"E": 35e9, "nu": 0.20}
PARAMETERS = ["young", "poisson"]
START = np.array([math.log(50e9), 0.2])  # in ln(young), as it spans decades
BOUNDS = ([math.log(1e9), -0.9], [math.log(1000e9), 0.5])


class Fit:
    """Residuals relative to what is wanted. scipy asks for the Jacobian where it has just asked for the residuals."""

    def __init__(self, model):
        self.analysis = bs.Analysis(model)
        self.wanted = np.array(list(WANTED.values()))
        self.solves = 0

    def residuals(self, unknowns):
        self.analysis.model.set(young=math.exp(unknowns[0]), poisson=unknowns[1])
        self.solution = self.analysis.solve()
        self.solves += 1
        found = np.array([self.solution.outputs[name] for name in WANTED])
        return found / self.wanted - 1

    def jacobian(self, unknowns):
        derivatives = self.solution.jacobian(list(WANTED), PARAMETERS) / self.wanted[:, None]
        return derivatives * [math.exp(unknowns[0]), 1]  # d/d ln(young) = young d/d(young)


def by_scipy():
    model = bs.read(CASE)
    fit = Fit(model)
    found = least_squares(fit.residuals, START, fit.jacobian, bounds=BOUNDS, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    fit.residuals(found.x)
    return (math.exp(found.x[0]), found.x[1]), fit.solution.outputs, fit.solves


def by_bondstatic():
    calibration = bs.calibrate(CASE)
    achieved = {target.output: target.achieved for target in calibration.targets}
    return tuple(parameter.value for parameter in calibration.parameters), achieved, calibration.solves


def main():
    answers = []
    print(f"{'':28}{'young, GPa':>20}{'poisson':>20}{'E, GPa':>12}{'nu':>12}{'solves':>8}{'s':>8}")
    for name, solve in (("scipy.optimize", by_scipy), ("bondstatic.calibrate", by_bondstatic)):
        begin = time.perf_counter()
        (young, poisson), outputs, solves = solve()
        seconds = time.perf_counter() - begin
        answers.append((young, poisson))
        print(f"{name:28}{young / 1e9:20.12f}{poisson:20.14f}{outputs['E'] / 1e9:12.6f}{outputs['nu']:12.8f}"
              f"{solves:8}{seconds:8.2f}")
    apart = np.max(np.abs(np.divide(answers[0], answers[1]) - 1))
    print(f"apart, relative: {apart:.1e}")
    if not apart < 1e-8:
        raise SystemExit("the two answers differ")


if __name__ == "__main__":
    main()
