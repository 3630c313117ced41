"""Closed forms of the cantilever under the three bond models, independent of the program. SI units, downward is
positive."""
from dataclasses import dataclass
from math import pi

YOUNG = 200e9
POISSON = 0.3
FORCE = 100e3


@dataclass(frozen=True)
class Beam:
    length: float
    radius: float
    poisson: float = POISSON

    @property
    def area(self):
        return pi * self.radius**2

    @property
    def bending(self):
        """E I"""
        return YOUNG * pi * self.radius**4 / 4

    @property
    def shear(self):
        """G A"""
        return YOUNG / (2 * (1 + self.poisson)) * self.area

    def euler_bernoulli(self, x):
        """[Chen2022] Eq. 28, first term."""
        return FORCE * x**2 * (3 * self.length - x) / (6 * self.bending)

    def timoshenko(self, x):
        """[Chen2022] Eq. 28."""
        return self.euler_bernoulli(x) + 10 / 9 * FORCE * x / self.shear

    def parallel(self, x, bonds):
        """Springs at the middle of each of n equal bonds, the k-th at (k - 1/2) h with h = L/n: it turns by M h/EI and
        slips by F h/GA. Summing the moments F (L - s) at those points is the midpoint rule of the beam's
        integral of (L - s)(x - s), short by x h^2/12."""
        h = self.length / bonds
        return self.euler_bernoulli(x) - FORCE * x * h**2 / (12 * self.bending) + FORCE * x / self.shear

    def tip_rotation(self):
        """The same for all models: the midpoint rule is exact for the linear moment."""
        return FORCE * self.length**2 / (2 * self.bending)


def two_bonds(contacts):
    """Tip of case 5: two bonds of 2 m with the Euler-Bernoulli shear stiffness that act at the given points."""
    beam, h = Beam(4, 0.2), 2
    bending = sum(FORCE * (beam.length - x)**2 * h / beam.bending for x in contacts)
    return bending + 2 * FORCE * h**3 / (12 * beam.bending)


def gap_centres(middle_radius):
    """Contact points of case 5, ends of radius 0.2 m: [Chen2022] Eq. 1 and 2 for both bonds."""
    return [(2 + 0.2 - middle_radius) / 2, 2 + (2 + middle_radius - 0.2) / 2]


def dispersion(middle_radius):
    """[Chen2022] Eq. 31 for the three radii of case 5."""
    radii = [0.2, middle_radius, 0.2]
    return (max(radii) - min(radii)) / (sum(radii) / 3)


def axial_to_shear(model, slenderness, poisson=POISSON):
    """kappa = kn/ks, [Chen2022] Eq. 32-34 with the exact fractions; slenderness = Lb / 2 rb."""
    euler_bernoulli = 4 / 3 * slenderness**2
    return {
        "PBM": 2 * (1 + poisson),
        "EBBM": euler_bernoulli,
        "TBBM": euler_bernoulli + 20 / 9 * (1 + poisson),
    }[model]


def stiffness(model, length, radius, poisson=POISSON):
    """kn, ks, kt, kb of one bond, by the ratios of [Chen2022] Table 9; with kappa from poisson the PBM twists as the
    beams do."""
    kn = YOUNG * pi * radius**2 / length
    kb = kn * radius**2 / 4
    ks = kn / axial_to_shear(model, length / (2 * radius), poisson)
    return {"kn": kn, "ks": ks, "kt": kb / (1 + poisson), "kb": kb}


def euler_bernoulli_error(slenderness, poisson=POISSON):
    """[Chen2022] Eq. 35 with 5/12: how much of Timoshenko's tip deflection Euler and Bernoulli leave out."""
    return 1 - 1 / (1 + 5 / 12 * (1 + poisson) / slenderness**2)
