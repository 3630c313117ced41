"""Case 1 as the paper ran it: through time, until it rests. What a run of small displacements ends at is the closed
form; what a run of finite ones ends at is worked out here from the equilibrium of the bent chain."""
from math import cos, sin

import theory
from cantilevers import LAWS, MILLI, MODELS, REFERENCE, Data, closed_form

BONDS = 10
PAPERS_DAMPING = 0.001
# Ends where the paper's does, in a hundredth of the steps.
STRONG_DAMPING = 0.7

# 1e-9 m/s is the swing of 1e-11 m that the slowest mode, 122 rad/s, may still have.
REST = 1e-9 / 122 / 8.5e-3
# Along the beam, where it comes to that as it moves across: the slope of the tip is 3e-3.
REST_ALONG = 1e-5


def bent_chain(model, force):
    """How far across and along the tip is then. Halfway each bond the moment turns its two particles against each
    other, the force across the bond shears it, and the force along stretches it."""
    h = REFERENCE.length / BONDS
    bond = theory.stiffness(model, h, REFERENCE.radius)
    middles, tip = [(k + 0.5) * h for k in range(BONDS)], REFERENCE.length
    for _ in range(100):
        x = y = turned = 0
        halfway = []
        for middle in middles:
            bend = force * (tip - middle) / bond["kb"]
            mean, turned = turned + bend / 2, turned + bend
            chord = mean
            for _ in range(50):
                chord = mean + force * cos(chord) / (bond["ks"] * h)
            length = h + force * sin(chord) / bond["kn"]
            halfway.append(x + length * cos(chord) / 2)
            x, y = x + length * cos(chord), y + length * sin(chord)
        middles, tip = halfway, x
    return y, x - REFERENCE.length


def at_rest(program, checks, particle_damping):
    """Tip of case 1 under each model, mm, and what the runs took."""
    data = Data("explicit", ["model", "static", "small", "finite", "finite along", "bent chain", "bent chain along",
                             "steps, small", "steps, finite", "seconds, small", "seconds, finite"], [])
    for m in MODELS:
        static = closed_form(m, REFERENCE, REFERENCE.length, BONDS)
        chain = bent_chain(m, theory.FORCE)
        tips, runs = {}, {}
        for kinematics in ("small", "finite"):
            settings = [f"bonds.0.law={LAWS[m]}", f"dynamics.kinematics={kinematics}",
                        f"dynamics.particle_damping={particle_damping!r}"]
            particles, runs[kinematics] = program.run_to_rest("case1.toml", settings)
            tips[kinematics] = particles[-1]
        across = {kinematics: -tip["uy"] for kinematics, tip in tips.items()}
        checks.equal("Explicit", f"{m}, small", across["small"], static, tolerance=REST)
        checks.equal("Explicit", f"{m}, finite", across["finite"], chain[0], tolerance=REST)
        checks.equal("Explicit", f"{m}, finite, along", tips["finite"]["ux"], chain[1], tolerance=REST_ALONG)
        data.rows.append([m, *(MILLI * value for value in (static, across["small"], across["finite"],
                                                           tips["finite"]["ux"], *chain)),
                          *(runs[k][what] for what in ("steps", "seconds") for k in ("small", "finite"))])
    return data
