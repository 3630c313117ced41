"""Ctrl-C, callbacks that raise, other threads meanwhile."""
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import bondstatic as bs
from program import CASES, beam


HERE = os.path.dirname(os.path.abspath(__file__))


def block(edge):
    """A simple cubic block of edge^3 spheres on a rough floor, pressed from above."""
    x = np.stack(np.meshgrid(*[np.arange(float(edge))] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    model = bs.Model(x, 0.5)
    model.bond(law="timoshenko", young=1e9, poisson=0.2)
    model.fix(z_below=0.5)
    model.load(z_above=edge - 1.5, force=(0, 0, -1.0))
    return model


CHILD = """
import sys, time
sys.path.insert(0, {here!r})
from interrupt_test import block, bs
model = block({edge})
small = block(3)
print("begin", flush=True)
try:
    bs.solve(model, solver={solver!r}, threads=1, progress=lambda phase: print(phase, flush=True))
    print("done")
except KeyboardInterrupt:
    # Everything is usable again, at once.
    print("interrupted", time.time(), len(bs.solve(small).displacement), len(model.x), flush=True)
"""


def start(code):
    return subprocess.Popen([sys.executable, "-B", "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True)


class Interrupts(unittest.TestCase):
    def check(self, edge, solver, phase):
        child = start(CHILD.format(here=HERE, edge=edge, solver=solver))
        self.assertIn(f"{phase}\n", iter(child.stdout.readline, ""))
        time.sleep(0.2)
        sent = time.time()
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=100)
        word, at, particles, count = out.splitlines()[-1].split()
        self.assertEqual((word, particles, count), ("interrupted", "27", str(edge**3)), err)
        self.assertLess(float(at) - sent, 5)  # 0.05 s and a solve of 27 particles, on an idle machine
        self.assertEqual(child.returncode, 0, err)

    def test_inside_a_factorisation(self):
        self.check(30, "cholmod", "factorisation")

    def test_inside_multigrid(self):
        self.check(40, "multigrid", "iterations")

    def test_uncaught_it_ends_python(self):
        code = CHILD.format(here=HERE, edge=30, solver="cholmod").split("try:")[0]
        child = start(code + "bs.solve(model, solver='cholmod', threads=1)")
        child.stdout.readline()
        time.sleep(1.0)
        child.send_signal(signal.SIGINT)
        _, err = child.communicate(timeout=100)
        self.assertEqual(child.returncode, -signal.SIGINT, err)
        self.assertTrue(err.strip().endswith("KeyboardInterrupt"), err)


class Callbacks(unittest.TestCase):
    def test_progress_hears_of_each_phase(self):
        heard = []
        s = bs.solve(block(4), progress=heard.append)
        self.assertIn("bonds", heard)
        self.assertLessEqual(set(s.report["seconds"]), set(heard))

    def test_what_it_raises_comes_through(self):
        class Enough(Exception):
            pass

        def progress(phase):
            if phase == "mechanisms":
                raise Enough(phase)

        model = block(4)
        for _ in range(3):
            with self.assertRaisesRegex(Enough, "mechanisms"):
                bs.solve(model, progress=progress)
        self.assertEqual(len(bs.solve(model).displacement), 64)

    def test_it_is_called_by_the_thread_that_solves(self):
        threads = set()
        bs.solve(block(3), progress=lambda phase: threads.add(threading.get_ident()))
        self.assertEqual(threads, {threading.get_ident()})

    def test_it_may_solve_itself(self):
        inner = []
        bs.solve(block(3), progress=lambda phase: inner.append(len(bs.solve(block(2)).displacement)))
        self.assertEqual(set(inner), {8})


class Threads(unittest.TestCase):
    def test_others_run_meanwhile(self):
        model = block(24)
        counts, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counts[0] += 1

        counter = threading.Thread(target=count)
        begin = counts[0]
        counter.start()
        time.sleep(0.05)
        started = time.perf_counter()
        before = counts[0]
        bs.solve(model, threads=1)
        seconds, during = time.perf_counter() - started, counts[0] - before
        stop.set()
        counter.join()
        self.assertEqual(begin, 0)
        # With the GIL held not one; without, millions a second.
        self.assertGreater(during, 1000 * seconds)

    def test_several_solve_at_once(self):
        models = [block(edge) for edge in (3, 4, 5, 6)]
        wanted = [bs.solve(model).displacement for model in models]
        found = [None] * 16

        def solve(k):
            found[k] = bs.solve(models[k % 4]).displacement

        workers = [threading.Thread(target=solve, args=(k,)) for k in range(16)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for k, displacement in enumerate(found):
            np.testing.assert_array_equal(displacement, wanted[k % 4])

    def test_the_interpreter_ends_under_one(self):
        code = CHILD.format(here=HERE, edge=24, solver="cholmod").split("try:")[0] + (
            "import threading\n"
            "threading.Thread(target=lambda: bs.solve(model, solver='cholmod', threads=1), daemon=True).start()\n"
            "time.sleep(0.3)\n")
        child = start(code)
        _, err = child.communicate(timeout=100)
        self.assertEqual((child.returncode, err), (0, ""))

    def test_forked_children_solve(self):
        bs.solve(block(4))
        child = os.fork()
        if child == 0:
            try:
                os._exit(0 if len(bs.solve(block(4)).displacement) == 64 else 1)
            finally:
                os._exit(2)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


class Runs(unittest.TestCase):
    def model(self):
        x, radius, bonds = beam(3)
        model = bs.Model(x, radius, bonds, density=2650.0)
        model.bond(law="timoshenko", young=50e9, poisson=0.2)
        model.fix(0)
        model.load(2, force=(0, 0, -1.0))
        return model

    def test_a_run_ends_at_the_static_answer(self):
        model = self.model()
        heard = []
        run = bs.relax(model, kinematics="small", progress=lambda *given: heard.append(given))
        self.assertTrue(run.at_rest)
        np.testing.assert_allclose(run.displacement, bs.solve(model).displacement,
                                   atol=1e-7 * abs(run.displacement).max())
        self.assertEqual(run.reports[""]["steps"], run.history()["step"][-1])
        self.assertTrue(heard and heard[0][0] == "")

    def test_states_on_the_way_are_shown(self):
        model = self.model()
        shown = []
        whole = bs.relax(model)
        interval = whole.history()["time"][-1] / 10
        run = bs.relax(model, save_interval=interval, on_state=lambda *given: shown.append(given))
        times = [time for time, _, _ in shown]
        self.assertEqual(times[0], 0)
        self.assertEqual(times[-1], run.history()["time"][-1])
        self.assertTrue(10 <= len(times) <= 12 and (np.diff(times) > 0).all())
        np.testing.assert_array_equal(shown[-1][1].displacement, run.displacement)
        np.testing.assert_array_equal(run.displacement, whole.displacement)
        for time, state, velocity in shown:
            self.assertEqual((state.name, velocity.shape), ("", (3, 3)))
            row = np.searchsorted(run.history()["time"], time)
            self.assertEqual(state.energy, run.history()["strain"][row])
            self.assertLessEqual(np.linalg.norm(velocity, axis=1).max(), run.history()["fastest"][row] * (1 + 1e-15))
        with self.assertRaisesRegex(bs.InputError, "save_interval without on_state"):
            bs.relax(model, save_interval=interval)

    def test_options_are_those_of_a_case(self):
        model = bs.read(CASES / "cantilever" / "case.toml", set={
            "particles.0.density": 2650.0, "dynamics.kinematics": "small", "dynamics.time_step": 1e-6})
        report = bs.relax(model, max_steps=10).reports[""]
        self.assertEqual((report["steps"], report["time_step"]), (10, 1e-6))
        self.assertEqual(bs.relax(model, time_step=2e-6, max_steps=10).reports[""]["time_step"], 2e-6)
        report = bs.relax(model, safety=0.5, max_steps=10).reports[""]
        self.assertAlmostEqual(report["time_step"] / report["critical_time_step"], 0.5, delta=0.005)
        with self.assertRaisesRegex(bs.InputError, "load_factor = nan"):
            bs.relax(model, load_factor=float("nan"))
        model = self.model()
        with self.assertRaisesRegex(bs.InputError, "kinematics"):
            bs.relax(model, kinematics="tiny")
        with self.assertRaisesRegex(bs.InputError, "density"):
            light = bs.Model(*beam(3))
            light.bond(law="timoshenko", young=50e9, poisson=0.2)
            light.fix(0)
            bs.relax(light)

    def test_a_callback_stops_it(self):
        def progress(*given):
            raise StopIteration

        with self.assertRaises(StopIteration):
            bs.relax(bs.read(CASES / "yade-packing" / "press.toml"), progress=progress)


if __name__ == "__main__":
    unittest.main()
