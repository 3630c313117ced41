"""calibrate() of models that Python made, and of case files."""
import unittest

import numpy as np

import bondstatic as bs
from program import CASES, beam

YOUNG, POISSON = 42e9, 0.27


def cantilever(young=50e9, poisson=0.2):
    model = bs.Model(*beam(4, length=0.4))
    model.bond(law="timoshenko", young=young, poisson=poisson)
    model.fix(0)
    model.load(3, force=(0, 0, -1000.0))
    model.output("deflection", "uz", 3)
    return model


def twisted(young=50e9, poisson=0.2):
    model = bs.Model(*beam(4, length=0.4))
    model.bond(law="timoshenko", young=young, poisson=poisson)
    model.fix(0)
    model.load(3, moment=(10.0, 0, 0))
    model.output("twist", "rx", 3)
    return model


class Calibrations(unittest.TestCase):
    def targets(self):
        return {"deflection": bs.solve(cantilever(YOUNG, POISSON)).outputs["deflection"],
                "twist": bs.solve(twisted(YOUNG, POISSON)).outputs["twist"]}

    def test_what_was_put_in_comes_out(self):
        heard = []
        with self.assertWarnsRegex(bs.BondstaticWarning, "give tolerances"):
            found = bs.calibrate({"bent": cantilever(), "twisted": twisted()},
                                 {"young": (1e9, 1e12), "poisson": {"min": 0.0, "max": 0.49, "scale": "linear"}},
                                 self.targets(), progress=lambda *given: heard.append(given))
        self.assertTrue(found.converged and found.reached, found.reason)
        self.assertAlmostEqual(found.values["young"] / YOUNG, 1, delta=1e-8)
        self.assertAlmostEqual(found.values["poisson"] / POISSON, 1, delta=1e-8)
        self.assertEqual(found.correlation.shape, (2, 2))
        self.assertEqual(len(found.singular_values), 2)
        self.assertFalse(found.unidentified)
        self.assertEqual(len(heard), len(found.history))

    def test_what_cannot_be_told_apart_is_said(self):
        found = bs.calibrate(CASES / "calibration" / "unidentifiable.toml")
        self.assertTrue(found.unidentified)
        self.assertIn("only through", found.unidentified[0].sentence)
        self.assertTrue(np.isnan(found.parameters[0].lower_95))

    def test_wrong_questions(self):
        model = cantilever()
        for text, arguments in (("no target|target", ({"young": (1e9, 1e12)}, {})),
                                ("yuong", ({"yuong": (1e9, 1e12)}, {"deflection": -1e-6})),
                                ("bend", ({"young": (1e9, 1e12)}, {"bend": -1e-6})),
                                ("nan|finite|number", ({"young": (1e9, 1e12)}, {"deflection": float("nan")}))):
            with self.assertRaisesRegex(bs.InputError, text):
                bs.calibrate(model, *arguments)
        for text, bounds in (("one is no number", ("one", "two")), ("1 numbers", (1e9,)), ("no max", {"min": 1e9}),
                             ('scale = "lgo"', {"min": 1e9, "max": 1e12, "scale": "lgo"})):
            with self.assertRaisesRegex(bs.InputError, text.replace("one is", "'one' is")):
                bs.calibrate(model, {"young": bounds}, {"deflection": -1e-6})
        with self.assertRaisesRegex(bs.InputError, "set changes keys of a case file"):
            bs.calibrate(model, {"young": (1e9, 1e12)}, {"deflection": -1e-6}, set={"bonds.0.young": 1.0})
        for given in ({"parameters": {"young": (1, 2)}}, {"loss": "cauchy"}, {"most_evaluations": 3}):
            with self.assertRaisesRegex(bs.InputError, "stand in the case file"):
                bs.calibrate(CASES / "calibration" / "yade.toml", **given)
        with self.assertRaisesRegex(bs.InputError, "calibration"):
            bs.calibrate(CASES / "cantilever" / "case.toml")

    def test_a_callback_ends_it(self):
        def progress(evaluation, cost):
            raise KeyError(evaluation)

        with self.assertRaises(KeyError):
            bs.calibrate(CASES / "calibration" / "yade.toml", progress=progress)


if __name__ == "__main__":
    unittest.main()
