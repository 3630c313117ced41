"""Results are views without a copy, live as long as they are used, and leave nothing behind."""
import concurrent.futures
import gc
import os
import unittest

import numpy as np

import bondstatic as bs
from program import beam


def solved(count=11):
    model = bs.Model(*beam(count))
    model.bond(law="timoshenko", young=50e9, poisson=0.2)
    model.fix(0)
    model.load(count - 1, force=(0, 0, -1.0))
    return bs.solve(model)


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Views(unittest.TestCase):
    def test_nothing_is_copied(self):
        s = solved()
        self.assertTrue(np.shares_memory(s.displacement, s.displacement))
        self.assertTrue(np.shares_memory(s.displacement, s.rotation))
        self.assertTrue(np.shares_memory(s.bonds.force, s.bonds.force))
        self.assertFalse(np.shares_memory(s.displacement, s.reaction))
        self.assertTrue(np.shares_memory(s.model.x, s.model.x))
        for array in (s.displacement, s.rotation, s.reaction, s.bonds.normal_force, s.bonds.moment, s.model.x,
                      s.model.radius, s.model.ids, s.model.bonds, s.model.branch):
            self.assertFalse(array.flags.owndata)
            self.assertIsNotNone(array.base)
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array[0] = 0
        self.assertEqual(s.displacement.shape, (11, 6))
        self.assertTrue(s.displacement.flags.c_contiguous)
        self.assertEqual((s.bonds.normal_force.shape, s.bonds.force.shape, len(s.bonds)), ((10,), (10, 3), 10))

    def test_views_outlive_what_they_are_of(self):
        s = solved(2001)
        views = [s.displacement, s.rotation, s.reaction, s.bonds.force, s.bonds.energy, s.model.x, s.model.bonds]
        state, bonds = s[""], s.bonds
        copies = [view.copy() for view in views]
        del s
        gc.collect()
        scratch = [solved(2001) for _ in range(5)]
        for view, copy in zip(views, copies):
            np.testing.assert_array_equal(view, copy)
        np.testing.assert_array_equal(state.displacement, copies[0])
        np.testing.assert_array_equal(bonds.force, copies[3])
        self.assertEqual(len(scratch), 5)

    def test_a_solution_keeps_its_model(self):
        model = bs.Model(*beam())
        model.bond(law="timoshenko", young=50e9, poisson=0.2)
        model.fix(0)
        model.load(10, force=(0, 0, -1.0))
        s, x = bs.solve(model), model.x
        model.load(10, force=(0, 0, -1.0))
        model.set(young=1.0)
        self.assertEqual(s.model.parameters()["young"], 50e9)
        self.assertEqual(s.value("uz", 10), s.displacement[10, 2])
        np.testing.assert_array_equal(x, s.model.x)
        self.assertTrue(np.shares_memory(x, s.model.x))
        self.assertFalse(np.shares_memory(model.x, s.model.x))

    def test_a_model_without_bonds_has_empty_views(self):
        model = bs.Model(np.zeros((1, 3)), 1.0)
        self.assertEqual((model.bonds.shape, model.bond_ids.shape, model.branch.shape), ((0, 2), (0,), (0, 3)))


class Leaks(unittest.TestCase):
    def test_a_thousand_solves(self):
        def once(_):
            s = solved(101)
            return s.displacement[100, 2] < 0 and s.bonds.sigma[0] > 0 and len(s.report["seconds"]) > 0

        # Solves of a hundred particles mostly wait, for threads and for the machine's load: several at a time.
        with concurrent.futures.ThreadPoolExecutor(4) as workers:
            for done in workers.map(once, range(200)):
                self.assertTrue(done)
            gc.collect()
            before = resident_bytes()
            for done in workers.map(once, range(1000)):
                self.assertTrue(done)
        gc.collect()
        grown = resident_bytes() - before
        # A single leaked solution is about 25 kB, a thousand of them 25 MB.
        self.assertLess(grown, 4e6)

    def test_a_thousand_errors(self):
        model = bs.Model(*beam())

        def once(_):
            for call in (lambda: bs.solve(model), lambda: model.bond(law="nowhere"), lambda: bs.read("nowhere.toml")):
                try:
                    call()
                except bs.Error:
                    pass

        with concurrent.futures.ThreadPoolExecutor(4) as workers:
            list(workers.map(once, range(100)))
            gc.collect()
            before = resident_bytes()
            list(workers.map(once, range(350)))
        gc.collect()
        self.assertLess(resident_bytes() - before, 4e6)


if __name__ == "__main__":
    unittest.main()
