"""Writes the bonded spheres of a YADE scene as particles.csv and bonds.csv, which `bondstatic import` reads.

In a script, or at the prompt of a running YADE:

    exec(open("/path/to/yade.py").read())
    export_bonds("folder")

or without touching the script, on a saved scene:  yade -n -x yade.py scene.yade.bz2 folder

particles.csv  id, x, y, z, radius, density, group (material), vx .. vz, wx .. wz
bonds.csv      a, b, kn, ks, kt, kb, contact_point (part of the branch from a), strengths, force carried now

A bond is a real interaction of two spheres that coheres:
  CohFrictPhys  not cohesionBroken, some adhesion; kt = ktw, kb = kr where momentRotationLaw, else 0
  JCFpmPhys     isCohesive, not isBroken; no moments
  CpmPhys       isCohesive, omega < 1; kn and ks are those of now, (1 - omega) of the first; no moments
(YADE, pkg/dem/CohesiveFrictionalContactLaw, JointedCohesiveFrictionalPM, ConcretePM.)
"""
import os
import sys


def _number(value):
    return repr(float(value))  # 17 digits where they are needed


def _write(path, header, rows):
    with open(path + ".part", "w") as out:
        out.write(",".join(header) + "\n")
        out.writelines(",".join(row) + "\n" for row in rows)
    os.rename(path + ".part", path)


def _cohesive(phys):
    """kn, ks, kt, kb, tensile strength, shear strength (forces) of a bond; None where there is none."""
    kind = type(phys).__name__
    if kind == "CohFrictPhys":
        if phys.cohesionBroken or max(phys.normalAdhesion, phys.shearAdhesion) <= 0:
            return None
        twisting, bending = (phys.ktw, phys.kr) if phys.momentRotationLaw else (0, 0)
        return phys.kn, phys.ks, twisting, bending, phys.normalAdhesion, phys.shearAdhesion
    if kind == "JCFpmPhys":
        if not phys.isCohesive or phys.isBroken:
            return None
        return phys.kn, phys.ks, 0, 0, phys.FnMax, phys.FsMax
    if kind == "CpmPhys":
        if not phys.isCohesive or phys.omega >= 1:
            return None
        return (phys.kn * (1 - phys.omega), phys.ks * (1 - phys.omega), 0, 0,
                phys.E * phys.epsCrackOnset * phys.crossSection, phys.undamagedCohesion * phys.crossSection)
    return None


def _material(body):
    return body.material.label or "material %d" % body.material.id


def _particle_row(body):
    state = body.state
    values = list(state.pos) + [body.shape.radius, body.material.density] + list(state.vel) + list(state.angVel)
    numbers = [_number(value) for value in values]
    group = '"%s"' % _material(body).replace('"', '""')
    return [str(body.id)] + numbers[:5] + [group] + numbers[5:]


def _bond_row(interaction):
    bond = _cohesive(interaction.phys)
    a, b = O.bodies[interaction.id1], O.bodies[interaction.id2]
    branch = b.state.pos - a.state.pos
    if O.periodic:
        branch += O.cell.hSize * interaction.cellDist
    # It lies on the branch, but for what both moved since the last step.
    point = (interaction.geom.contactPoint - a.state.pos).dot(branch) / branch.squaredNorm()
    normal = interaction.phys.normalForce.dot(interaction.geom.normal)  # positive in compression
    values = bond[:4] + (point,) + bond[4:] + (-normal, interaction.phys.shearForce.norm())
    return [str(interaction.id1), str(interaction.id2)] + [_number(value) for value in values]


def export_bonds(folder="."):
    """Writes particles.csv and bonds.csv into the folder, and prints what was left out."""
    os.makedirs(folder, exist_ok=True)
    spheres = [b for b in O.bodies if b and isinstance(b.shape, Sphere)]
    others = {}
    for body in O.bodies:
        if body and not isinstance(body.shape, Sphere):
            kind = "clumps, taken as their spheres without what joins them" if body.isClump else type(body.shape).__name__
            others[kind] = others.get(kind, 0) + 1
    ids = {body.id for body in spheres}
    bonds, loose, outside = [], {}, 0
    for interaction in O.interactions:
        if not interaction.isReal:
            continue
        bonded = _cohesive(interaction.phys) is not None
        if interaction.id1 in ids and interaction.id2 in ids and bonded:
            bonds.append(interaction)
        elif bonded:
            outside += 1
        else:
            kind = type(interaction.phys).__name__
            loose[kind] = loose.get(kind, 0) + 1

    _write(os.path.join(folder, "particles.csv"),
           ["id", "x", "y", "z", "radius", "density", "group", "vx", "vy", "vz", "wx", "wy", "wz"],
           (_particle_row(body) for body in spheres))
    print("particles.csv: %d spheres" % len(spheres))
    if bonds:
        _write(os.path.join(folder, "bonds.csv"),
               ["a", "b", "kn", "ks", "kt", "kb", "contact_point", "tensile_strength", "shear_strength",
                "normal_force", "shear_force"], (_bond_row(i) for i in bonds))
        largest = max(i.phys.normalForce.norm() for i in bonds)
        print("bonds.csv: %d bonds; they carry up to %g now: a static solve takes this state as free of stress"
              % (len(bonds), largest))
    else:
        print("no bonds: no cohesive interaction between spheres is there; run a step of the scene first")
    for kind, count in sorted(others.items()):
        print("left out: %d of %s" % (count, kind))
    if outside:
        print("left out: %d bonds to something that is no sphere" % outside)
    for kind, count in sorted(loose.items()):
        print("left out: %d contacts without cohesion (%s)" % (count, kind))
    if O.periodic:
        print("the scene is periodic: give the edges of its cell, the columns of O.cell.hSize, as [cell] in the case:")
        for i in range(3):
            print("  edge %d: %s" % (i + 1, ", ".join(_number(value) for value in O.cell.hSize.col(i))))


if len(sys.argv) == 3 and os.path.basename(sys.argv[0]) == "yade.py":
    O.load(sys.argv[1])
    export_bonds(sys.argv[2])
