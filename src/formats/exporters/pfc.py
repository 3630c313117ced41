"""Writes the bonded balls of a PFC3D model as particles.csv and bonds.csv, which `bondstatic import` reads.

In PFC's Python:

    exec(open("/path/to/pfc.py").read())
    export_bonds("folder")

particles.csv  id, x, y, z, radius, density, group, vx .. vz, wx .. wz
bonds.csv      a, b, kn, ks, kt, kb, contact_point (part of the branch from a), radius, strengths

A bond is a ball-ball contact of the model linearpbond with pb_state 3 or linearcbond with cb_state 3. With the
bond's radius r = pb_rmul min(Ra, Rb), A = pi r^2, I = pi r^4 / 4, J = 2 I (PFC documentation, "Linear Parallel
Bond Model"):

    kn = pb_kn A    ks = pb_ks A    kt = pb_ks J    kb = pb_kn I

The springs kn, ks of the contact's linear part act beside the bond where the balls overlap, ks only with friction.
They are added there (linear_springs=False leaves them out): the static answer then holds as long as these contacts
neither open nor slip. linearcbond has only them.
"""
import math
import os

import itasca


def _number(value):
    return repr(float(value))  # 17 digits where they are needed


def _write(path, header, rows):
    with open(path + ".part", "w") as out:
        out.write(",".join(header) + "\n")
        out.writelines(",".join(row) + "\n" for row in rows)
    if os.path.exists(path):
        os.remove(path)  # Windows does not rename over a file
    os.rename(path + ".part", path)


def _is_bonded(contact):
    model = contact.model()
    return (model == "linearpbond" and contact.prop("pb_state") == 3 or
            model == "linearcbond" and contact.prop("cb_state") == 3)


def _ball_row(ball):
    vectors = [ball.pos(), ball.vel(), ball.spin()]
    pos, vel, spin = [[_number(v.x()), _number(v.y()), _number(v.z())] for v in vectors]
    group = '"%s"' % (ball.group("default") or "none").replace('"', '""')
    return [str(ball.id())] + pos + [_number(ball.radius()), _number(ball.density()), group] + vel + spin


def _bond_row(contact, linear_springs):
    a, b = contact.end1(), contact.end2()
    ra, rb = a.radius(), b.radius()
    xa, xb = a.pos(), b.pos()
    length = math.sqrt((xb.x() - xa.x()) ** 2 + (xb.y() - xa.y()) ** 2 + (xb.z() - xa.z()) ** 2)
    if contact.model() == "linearpbond":
        r = contact.prop("pb_rmul") * min(ra, rb)
        area, second_moment = math.pi * r ** 2, math.pi * r ** 4 / 4
        normal, shear = contact.prop("pb_kn"), contact.prop("pb_ks")
        stiffness = [normal * area, shear * area, 2 * shear * second_moment, normal * second_moment]
        strength = [_number(r), _number(contact.prop("pb_ten")), _number(contact.prop("pb_coh")),
                    _number(contact.prop("pb_fa"))]
        springs = linear_springs and ra + rb > length
    else:
        stiffness, strength, springs = [0, 0, 0, 0], ["", "", "", ""], True
    if springs:
        stiffness[0] += contact.prop("kn")
        if contact.model() == "linearcbond" or contact.prop("fric") > 0:
            stiffness[1] += contact.prop("ks")
    point = (length + ra - rb) / (2 * length)  # the centre of gap or overlap
    return [str(a.id()), str(b.id())] + [_number(v) for v in stiffness + [point]] + strength


def export_bonds(folder=".", linear_springs=True):
    """Writes particles.csv and bonds.csv into the folder, and prints what was left out."""
    if not os.path.isdir(folder):
        os.makedirs(folder)
    contacts = list(itasca.contact.list("mechanical", type=itasca.BallBallContact, all=True))
    bonds = [contact for contact in contacts if _is_bonded(contact)]
    _write(os.path.join(folder, "particles.csv"),
           ["id", "x", "y", "z", "radius", "density", "group", "vx", "vy", "vz", "wx", "wy", "wz"],
           (_ball_row(ball) for ball in itasca.ball.list()))
    print("particles.csv: %d balls" % itasca.ball.count())
    if bonds:
        _write(os.path.join(folder, "bonds.csv"),
               ["a", "b", "kn", "ks", "kt", "kb", "contact_point", "radius", "tensile_strength", "cohesion",
                "friction_angle (deg)"], (_bond_row(contact, linear_springs) for contact in bonds))
        print("bonds.csv: %d bonds; forces that they carry now are not written: a static solve takes this state "
              "as free of stress" % len(bonds))
    else:
        print("no bonds: no ball-ball contact is linearpbond or linearcbond in the bonded state")
    loose = {}
    for contact in contacts:
        if contact.active() and not _is_bonded(contact):
            loose[contact.model()] = loose.get(contact.model(), 0) + 1
    for model, count in sorted(loose.items()):
        print("left out: %d active ball-ball contacts of model %s that are not bonded as said above" % (count, model))
    for name in ("clump", "wall"):
        count = getattr(itasca, name).count()
        if count:
            print("left out: %d %ss, with all that is bonded to them" % (count, name))
