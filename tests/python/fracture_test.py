"""fracture(): what the program says, to the last digit; strengths as arrays; runs that are stopped and go on."""
import csv
import json
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import bondstatic as bs
from program import CASES, beam, run

BUNDLE, NOTCHED = (CASES / "fracture" / name for name in ("bundle.toml", "beam.toml"))
HERE = os.path.dirname(os.path.abspath(__file__))
OF_EVENTS = ("factor", "load", "displacement", "runner_up", "released", "strain_energy", "work", "dissipated",
             "factor_after", "load_after", "displacement_after", "avalanche")
STRENGTH = {"criterion": "edem-v2", "critical_normal_stress": 5e6, "critical_shear_stress": 8e6}


def read_rows(path):
    """Columns of text."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], map(np.array, zip(*rows[1:]))))


def numbers(column):
    return np.array([float(field or "nan") for field in column])


def chain(strengths, **more):
    """A bar along x, pulled at its end; each bond its own strength."""
    x, radius, bonds = beam(len(strengths) + 1)
    model = bs.Model(x, radius, bonds)
    model.bond(law="contact", kn=1e3, ks=1e3,
               strength={"criterion": "contact-bond", "critical_tensile_force": strengths,
                         "critical_shear_force": 1e9, **more})
    model.fix(0)
    model.fix(np.arange(1, len(x)), dofs=["y", "z", "rx", "ry", "rz"])
    return model


def same(test, left, right):
    for name in OF_EVENTS:
        np.testing.assert_array_equal(getattr(left.events, name), getattr(right.events, name), name)
    for name in ("event", "row", "id", "mode", "utilisation"):
        np.testing.assert_array_equal(getattr(left.broken, name), getattr(right.broken, name), name)
    np.testing.assert_array_equal(left.last.displacement, right.last.displacement)
    test.assertEqual((left.end, left.reason, list(left.outputs)), (right.end, right.reason, list(right.outputs)))
    for name, column in left.outputs.items():
        np.testing.assert_array_equal(column, right.outputs[name])


class SameAsProgram(unittest.TestCase):
    def check(self, case, *settings):
        with tempfile.TemporaryDirectory() as folder:
            overrides = [word for key, value in settings for word in ("--set", f"{key}={json.dumps(value)}")]
            done = run("fracture", case, "--out", folder, "--json", *overrides)
            self.assertEqual(done.returncode, 0, done.stderr)
            told = json.loads(done.stdout)
            history, bonds = (read_rows(pathlib.Path(folder) / name) for name in ("fracture.csv", "bonds.csv"))
        found = bs.fracture(case, set=dict(settings))
        event = found.broken.event
        np.testing.assert_array_equal(event + 1, numbers(history["step"]))
        for name in OF_EVENTS:
            np.testing.assert_array_equal(getattr(found.events, name)[event], numbers(history[name]), name)
        np.testing.assert_array_equal(found.broken.id, numbers(history["bond"]))
        np.testing.assert_array_equal(found.broken.mode, history["mode"])
        np.testing.assert_array_equal(found.broken.utilisation, numbers(history["utilisation"]))
        ends = found.model.ids[found.model.bonds[found.broken.row]]
        np.testing.assert_array_equal(ends, np.column_stack([numbers(history["a"]), numbers(history["b"])]))
        for name, column in found.outputs.items():
            np.testing.assert_array_equal(column[event], numbers(history[name]))
        np.testing.assert_array_equal(found.break_event + 1, numbers(bonds["break_step"]))
        np.testing.assert_array_equal(found.last.bonds.utilisation, numbers(bonds["utilisation"]))
        np.testing.assert_array_equal(found.last.bonds.normal_force, numbers(bonds["normal_force"]))
        self.assertEqual((found.end, found.reason, len(found.events), len(found.broken)),
                         (told["end"], told["reason"], told["events"], told["breaks"]))
        self.assertEqual([(body.event + 1, list(body.particles)) for body in found.separated],
                         [(body["after_step"], body["particles"]) for body in told["separated"]])
        for name in ("backward_error", "forward_error"):
            self.assertEqual(found.report[name], told["accuracy"][name])
        self.assertEqual(found.report["energy_balance"], told["energies"]["balance"])
        self.assertEqual(found.report["factorisations"], told["solver"]["factorisations"])
        return found

    def test_fibre_bundle(self):
        found = self.check(BUNDLE)
        self.assertEqual(list(found.outputs), ["force"])
        same(self, bs.fracture(bs.read(BUNDLE)), found)
        # Told once more: 2100 at elongation 1, and what has broken carries no more.
        np.testing.assert_allclose(found.outputs["force"], found.events.load, rtol=1e-14)

    def test_notched_beam(self):
        settings = (("fracture.max_breaks", 12), ("solve.solver", "cholmod"), ("solve.threads", 1))
        found = self.check(NOTCHED, *settings)
        self.assertEqual(found.end, "breaks")
        same(self, bs.fracture(bs.read(NOTCHED), max_breaks=12, solver="cholmod", threads=2), found)

    def check_text(self, case, settings, given=None, **options):
        overrides = [word for key, value in settings.items() for word in ("--set", f"{key}={json.dumps(value)}")]
        told = run("fracture", case, *overrides)
        with self.assertRaises(bs.InputError) as caught:
            bs.fracture(case, set=settings if given is None else given, **options)
        self.assertEqual(told.returncode, 2)
        self.assertEqual(str(caught.exception), told.stderr.removeprefix("bondstatic: ").removesuffix("\n"))

    def test_text_of_errors(self):
        self.check_text(CASES / "nowhere.toml", {})
        self.check_text(CASES / "cantilever" / "case.toml", {})  # no strength
        self.check_text(BUNDLE, {"bonds.0.strength.critical_shear_force": -1.0, "fracture.control": "force"})
        self.check_text(BUNDLE, {"fracture.pattern": "pull"}, {}, pattern="pull")
        self.check_text(BUNDLE, {"fracture.load_drop": 2.0, "fracture.max_breaks": 0}, {}, load_drop=2.0, max_breaks=0)

    def test_strengths_are_those_of_the_listing(self):
        listed = json.loads(run("laws", "--strengths", "--json").stdout)
        self.assertEqual([entry["name"] for entry in listed], list(bs.strengths()))
        for entry in listed:
            criterion = bs.strengths()[entry["name"]]
            self.assertEqual((criterion.modes, criterion.scatters, criterion.needs_section),
                             (entry["modes"], entry["scatters"], entry["needs_section"]))
            self.assertEqual([parameter.name for parameter in criterion.parameters],
                             [parameter["name"] for parameter in entry["parameters"]])


class Strengths(unittest.TestCase):
    def test_arrays_are_the_columns_of_a_file(self):
        column = read_rows(CASES / "fracture" / "fibres.csv")
        feet = np.column_stack([np.arange(21.0), np.zeros(21), np.zeros(21)])
        model = bs.Model(np.vstack([feet, feet + [0, 0, 1]]), 0.5, np.column_stack([column["a"], column["b"]]).astype(int),
                         ids=np.arange(1, 43))
        model.bond(law="contact", kn=100, ks=100,
                   strength={"criterion": "contact-bond", "critical_shear_force": 1e9,
                             "critical_tensile_force": numbers(column["critical_tensile_force"])})
        model.fix(np.arange(1, 22))
        model.fix(np.arange(22, 43), values={"x": 0, "y": 0, "z": 1, "rx": 0, "ry": 0, "rz": 0})
        model.output("force", "reaction_fz", np.arange(22, 43), reduce="sum")
        same(self, bs.fracture(model, control="displacement"), bs.fracture(BUNDLE))

    def test_the_weakest_link_breaks(self):
        model = chain(np.array([7.0, 3.0, 5.0]))
        model.load(3, force=(1.0, 0, 0))
        np.testing.assert_allclose(bs.solve(model).bonds.utilisation, [1 / 7, 1 / 3, 1 / 5], rtol=1e-14)
        found = bs.fracture(model)
        self.assertEqual((found.end, list(found.broken.row), list(found.broken.mode)), ("separated", [1], ["tension"]))
        self.assertAlmostEqual(found.events.factor[0], 3, delta=3e-14)
        self.assertAlmostEqual(found.events.runner_up[0], 0.6, delta=1e-14)
        self.assertEqual(list(found.break_event), [-1, 0, -1])
        self.assertTrue(np.isnan(found.last.bonds.utilisation[1]))
        for name in OF_EVENTS:
            with self.assertRaises(ValueError):
                getattr(found.events, name)[0] = 0

    def test_they_scatter_by_seed(self):
        x, radius, bonds = beam(12)
        factors = {}
        for seed in (1, 1, 2):
            model = bs.Model(x, radius, bonds)
            model.bond(law="timoshenko", young=50e9, poisson=0.2, radius_factor=0.8,
                       strength={**STRENGTH, "scatter": "weibull", "modulus": 8, "seed": seed})
            model.fix(0)
            model.load(11, force=(1.0, 0, 0))
            factors.setdefault(seed, []).append(bs.fracture(model).events.factor[0])
        self.assertEqual(len(set(factors[1])), 1)
        self.assertNotEqual(factors[1][0], factors[2][0])

    def test_bonds_without_have_no_utilisation(self):
        model = bs.Model(*beam())
        model.bond(law="timoshenko", young=50e9, poisson=0.2)
        model.fix(0)
        model.load(10, force=(1.0, 0, 0))
        self.assertTrue(np.isnan(bs.solve(model).bonds.utilisation).all())
        with self.assertRaisesRegex(bs.InputError, "no bond has a strength"):
            bs.fracture(model)

    def test_a_moved_bond_has_none(self):
        model = bs.Model(*beam(3), density=2650.0)
        model.bond(law="timoshenko", young=50e9, poisson=0.2, strength=STRENGTH)
        model.fix(0)
        model.load(2, force=(0, 0, -1.0))
        with self.assertRaisesRegex(bs.InputError, "have moved"):
            bs.relax(model, max_steps=10).bonds.utilisation  # pylint: disable=expression-not-assigned

    def test_what_is_wrong_with_them(self):
        own = np.array([5e6, 6e6])
        for text, strength in (
                ("criterion", {"critical_normal_stress": 5e6}),
                (r"critical_normal_stress has 2 values, 10 bonds are listed", {**STRENGTH, "critical_normal_stress": own}),
                ("tensile_strength",
                 {**STRENGTH, "tensile_strength": np.full(10, 5e6)}),
                (r"critical_normal_stress = -5", {**STRENGTH, "critical_normal_stress": np.full(10, -5.0)}),
                (r"critical_normal_stress", {**STRENGTH, "critical_normal_stress": np.full(10, np.nan)}),
                ("modulus = a list of 10 must be a number", {**STRENGTH, "scatter": "weibull", "modulus": np.full(10, 8.0)})):
            model = bs.Model(*beam())
            with self.assertRaisesRegex(bs.InputError, text):
                model.bond(law="timoshenko", young=50e9, poisson=0.2, strength=strength)
            self.assertEqual(len(model.bond_ids), 0)
        x, radius, _ = beam()
        with self.assertRaisesRegex(bs.InputError, "no bonds are listed"):
            bs.Model(x, radius).bond(law="timoshenko", young=50e9, poisson=0.2, gap=1e-3,
                                     strength={**STRENGTH, "critical_normal_stress": np.full(10, 5e6)})


class Options(unittest.TestCase):
    def test_those_of_a_case_unless_given(self):
        settings = {"fracture.max_breaks": 3, "fracture.control": "load"}
        model = bs.read(BUNDLE, set=settings)
        self.assertEqual(len(bs.fracture(model.copy()).broken), 3)
        self.assertEqual(len(bs.fracture(model, max_breaks=5).broken), 5)
        self.assertEqual(bs.fracture(model, max_breaks=math.inf).end, "separated")
        self.assertEqual(len(bs.fracture(BUNDLE, set=settings, max_breaks=math.inf).broken), 21)
        found = bs.fracture(model, control="displacement", max_displacement=0.055, max_breaks=None)
        self.assertEqual((found.end, len(found.broken)), ("breaks", 3))
        found = bs.fracture(model, control="displacement", max_displacement=0.055, max_breaks=math.inf)
        self.assertEqual((found.end, len(found.broken)), ("displacement", 5))
        for limit, end, breaks in (({"max_factor": 0.025}, "factor", 2), ({"load_drop": 0.5}, "load drop", 18)):
            found = bs.fracture(BUNDLE, **limit)
            self.assertEqual((found.end, len(found.broken)), (end, breaks))

    def test_a_preload_stays(self):
        model = chain(np.array([7.0, 3.0, 5.0]))
        model.load(3, force=(1.0, 0, 0), case="hold")
        model.load(2, force=(1.0, 0, 0), case="pull")
        found = bs.fracture(model, preload="hold")
        self.assertEqual(list(found.broken.row), [1])
        self.assertAlmostEqual(found.events.factor[0], 2, delta=1e-14)
        with self.assertRaisesRegex(bs.InputError, r"does not say which load case scales; there are: hold, pull"):
            bs.fracture(model)
        with self.assertRaisesRegex(bs.InputError, '"drop" is no load case'):
            bs.fracture(model, pattern="drop")
        model.load(1, force=(1.0, 0, 0))
        with self.assertRaisesRegex(bs.InputError, "loads of no named case would count twice"):
            bs.fracture(model, preload="hold")

    def test_wrong_ones(self):
        model = bs.read(BUNDLE)
        for text, options in (("control", {"control": "force"}), ("max_breaks", {"max_breaks": 0}),
                              ("tie", {"tie": 1.5}), ("set changes keys", {"set": {"fracture.tie": 0}}),
                              ("checkpoint_every = -1", {"checkpoint_every": -1}),
                              ("resume without a checkpoint", {"resume": True})):
            with self.assertRaisesRegex(bs.InputError, text):
                bs.fracture(model, **options)


class Stops(unittest.TestCase):
    def test_progress_hears_of_every_event(self):
        heard = []
        found = bs.fracture(BUNDLE, progress=lambda *now: heard.append(now))
        # The last event ends the run itself.
        self.assertEqual([now[0] for now in heard], list(range(1, 21)))
        np.testing.assert_array_equal([now[2:] for now in heard],
                                      np.column_stack([found.events.factor_after, found.events.load_after,
                                                       found.events.displacement_after])[:-1])

    def test_false_ends_it_with_what_was_found(self):
        found = bs.fracture(BUNDLE, progress=lambda events, *_: events < 4)
        self.assertEqual((found.end, len(found.events)), ("interrupted", 4))
        whole = bs.fracture(BUNDLE)
        np.testing.assert_array_equal(found.events.load, whole.events.load[:4])

    def test_what_callbacks_raise_comes_through(self):
        def stop(*_):
            raise StopIteration

        for callbacks in ({"progress": stop}, {"on_state": stop}):
            with self.assertRaises(StopIteration):
                bs.fracture(BUNDLE, **callbacks)

    def test_states_are_shown(self):
        shown = []
        found = bs.fracture(BUNDLE, save_every=5, on_state=lambda *given: shown.append(given))
        self.assertEqual([events for events, _, _ in shown], [0, 5, 10, 15, 20, 21])
        for events, state, break_event in shown:
            np.testing.assert_array_equal(break_event >= 0, (0 <= found.break_event) & (found.break_event < events))
            np.testing.assert_array_equal(np.isnan(state.bonds.utilisation), break_event >= 0)
        self.assertEqual(shown[0][1].bonds.utilisation.max(), 1)

    def test_a_run_goes_on_to_the_same_bits(self):
        whole = bs.fracture(NOTCHED, max_breaks=30, solver="cholmod", threads=1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "run"
            for until in (7, 19):
                stopped = bs.fracture(NOTCHED, max_breaks=30, solver="cholmod", threads=1, checkpoint=file,
                                      checkpoint_every=0, resume=until > 7, progress=lambda events, *_: events < until)
                self.assertEqual((stopped.end, len(stopped.events)), ("interrupted", until))
            with self.assertRaisesRegex(bs.InputError, "an unfinished run lies here"):
                bs.fracture(NOTCHED, checkpoint=file)
            with self.assertRaisesRegex(bs.InputError, "belongs to another model or other options"):
                bs.fracture(NOTCHED, checkpoint=file, resume=True, tie=1e-6)
            model = bs.read(NOTCHED)
            model.output("once more", "energy")
            with self.assertRaisesRegex(bs.InputError, r"a run with other \[\[outputs\]\]"):
                bs.fracture(model, checkpoint=file, resume=True)
            same(self, bs.fracture(NOTCHED, max_breaks=30, solver="cholmod", threads=1, checkpoint=file, resume=True),
                 whole)
            self.assertFalse(file.exists())

    def test_outputs_go_on_too(self):
        whole = bs.fracture(BUNDLE)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "run"
            bs.fracture(BUNDLE, checkpoint=file, progress=lambda events, *_: events < 9)
            same(self, bs.fracture(BUNDLE, checkpoint=file, resume=True), whole)
            file.write_bytes(b"nothing")
            with self.assertRaisesRegex(bs.InputError, "run"):
                bs.fracture(BUNDLE, checkpoint=file, resume=True)


CHILD = """
import sys, warnings
sys.path.insert(0, {here!r})
from fracture_test import NOTCHED, bs
warnings.simplefilter("ignore")
def tell(events, *_):
    if events == 2:
        print("begun", flush=True)
    {busy}
found = bs.fracture(NOTCHED, threads=1, load_drop=1, progress=tell)
print(found.end, len(found.events) > 1, len(found.events) == len(found.broken.event), flush=True)
"""


class Interrupts(unittest.TestCase):
    def check(self, busy):
        code = CHILD.format(here=HERE, busy=busy)
        child = subprocess.Popen([sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True)
        self.assertEqual(child.stdout.readline(), "begun\n")
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=100)
        self.assertEqual((out, child.returncode), ("interrupted True True\n", 0), err)

    def test_ctrl_c_leaves_what_was_found(self):
        self.check("pass")

    def test_inside_a_callback(self):
        self.check("__import__('time').sleep(0.3)")

    def test_a_warning_says_so(self):
        def interrupt(events, *_):
            if events == 3:
                signal.raise_signal(signal.SIGINT)

        with self.assertWarnsRegex(bs.BondstaticWarning, "stopped by Ctrl-C after 3 events"):
            self.assertEqual(bs.fracture(BUNDLE, progress=interrupt).end, "interrupted")

    def test_before_a_bond_breaks_it_raises_and_the_second_time(self):
        def interrupt(at):
            def heard(events, *_):
                if events == at:
                    raise KeyboardInterrupt
            return heard

        with self.assertRaises(KeyboardInterrupt):
            bs.fracture(BUNDLE, on_state=interrupt(0))
        # The state after two breaks is shown, then progress heard.
        with self.assertRaises(KeyboardInterrupt):
            bs.fracture(BUNDLE, save_every=1, on_state=interrupt(2), progress=interrupt(2))
        with self.assertWarns(bs.BondstaticWarning):
            self.assertEqual(len(bs.fracture(BUNDLE, save_every=1, on_state=interrupt(2)).events), 2)


if __name__ == "__main__":
    unittest.main()
