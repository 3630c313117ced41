"""K and the reduced system against the solution, by scipy's own solver."""
import unittest

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

import bondstatic as bs
from program import CASES, beam


def solved(system):
    """The unknowns, by SuperLU as for a symmetric matrix, which is a tenth of the work."""
    factor = linalg.splu(system.K.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0,
                         options={"SymmetricMode": True})
    return system.displacement(factor.solve(system.rhs))


class Matrices(unittest.TestCase):
    def check_system(self, model, case=None, unsupported="error", tolerance=1e-9):
        system = bs.system(model, case, unsupported=unsupported)
        solution = bs.solve(model, unsupported=unsupported)
        state = solution[case if case is not None else list(solution)[0]]
        found = solved(system)
        wanted = np.nan_to_num(state.displacement)
        self.assertLess(np.abs(found - wanted).max(), tolerance * np.abs(wanted).max())
        return system, state

    def test_packing_with_prescribed_motion(self):
        model = bs.read(CASES / "yade-packing" / "press.toml")
        system, state = self.check_system(model, unsupported="drop")
        self.assertIsInstance(system.K, sparse.csr_matrix)
        self.assertEqual(system.K.shape, (len(system.dofs),) * 2)
        self.assertEqual(abs(system.K - system.K.T).max(), 0)
        K = bs.stiffness(model)
        self.assertEqual(K.shape, (6 * len(model),) * 2)
        self.assertEqual(abs(K[system.dofs][:, system.dofs] - system.K).max(), 0)
        forces = (K @ state.displacement.ravel()).reshape(-1, 6)
        size = np.abs(state.reaction).max()
        self.assertLess(np.abs(forces - state.reaction).max(), 1e-9 * size)

    def test_load_cases(self):
        model = bs.read(CASES / "yade-packing" / "loads.toml")
        for case in model.load_cases:
            self.check_system(model, case, unsupported="drop")
        with self.assertRaisesRegex(bs.InputError, "say which is meant"):
            bs.system(model)
        with self.assertRaisesRegex(bs.InputError, "no load case"):
            bs.system(model, "nowhere")

    def test_strain_of_a_cell(self):
        rng = np.random.default_rng(1)
        corner = np.array([[0, 0, 0], [0, 0.5, 0.5], [0.5, 0, 0.5], [0.5, 0.5, 0]])
        model = bs.Model(corner + rng.uniform(-0.05, 0.05, (4, 3)), 0.36, cell={"size": [1, 1, 1]})
        model.bond(law="timoshenko", young=1e9, poisson=0.2, existing="add", gap=0.1)
        system = bs.system(model, "yz")
        state = bs.solve(model)["yz"]
        beyond = solved(system)
        strain = np.hstack([model.x @ state.strain, np.zeros((4, 3))])
        np.testing.assert_allclose(beyond + strain, state.displacement, atol=1e-12)

    def test_units_of_rotations_are_radians(self):
        x, radius, bonds = beam(2, length=0.5)
        model = bs.Model(x, radius, bonds)
        model.bond(law="timoshenko", young=3e9, poisson=0.25)
        K = bs.stiffness(model).toarray()
        torsion = 3e9 / 2.5 * np.pi * radius**4 / 2 / 0.5
        self.assertAlmostEqual(K[3, 3] / torsion, 1, delta=1e-14)
        self.assertAlmostEqual(K[0, 0] / (3e9 * np.pi * radius**2 / 0.5), 1, delta=1e-14)
        rigid = np.zeros((2, 6))
        rigid[:, 5] = 1
        rigid[:, 1] = x[:, 0]  # turned about z
        self.assertLess(np.abs(K @ rigid.ravel()).max(), 1e-9 * np.abs(K).max())


if __name__ == "__main__":
    unittest.main()
