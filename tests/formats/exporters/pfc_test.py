"""Runs pfc.py against a stand-in for PFC's module `itasca`, and checks the tables that it writes.

    /usr/bin/python3 -B pfc_test.py PFC_SCRIPT
"""
import csv
import math
import os
import sys
import tempfile
import types


class Vector:
    def __init__(self, x, y, z):
        self.at = (x, y, z)

    def x(self):
        return self.at[0]

    def y(self):
        return self.at[1]

    def z(self):
        return self.at[2]


class Ball:
    def __init__(self, number, position, radius):
        self.number, self.position, self.size = number, position, radius

    def id(self):
        return self.number

    def pos(self):
        return Vector(*self.position)

    def radius(self):
        return self.size

    def density(self):
        return 2650.0

    def vel(self):
        return Vector(0.0, 0.0, 1.0 / 3)

    def spin(self):
        return Vector(0.0, 0.0, 0.0)

    def group(self, slot):
        return "rock, hard" if self.number == 1 else None


class Contact:
    def __init__(self, a, b, model, properties):
        self.ends, self.kind, self.properties = (a, b), model, properties

    def end1(self):
        return self.ends[0]

    def end2(self):
        return self.ends[1]

    def model(self):
        return self.kind

    def prop(self, name):
        return self.properties[name]

    def active(self):
        return True


def stand_in(balls, contacts):
    module = types.ModuleType("itasca")
    module.BallBallContact = Contact
    module.ball = types.SimpleNamespace(list=lambda: iter(balls), count=lambda: len(balls))
    module.contact = types.SimpleNamespace(list=lambda process, type, all: iter(contacts))
    module.clump = types.SimpleNamespace(count=lambda: 2)
    module.wall = types.SimpleNamespace(count=lambda: 0)
    return module


def close(found, expected):
    assert math.isclose(float(found), expected, rel_tol=1e-15, abs_tol=1e-300), (found, expected)


def main(script):
    balls = [Ball(1, (0.0, 0.0, 0.0), 1.0), Ball(2, (1.9, 0.0, 0.0), 1.0), Ball(3, (0.0, 2.0, 0.0), 0.5)]
    bond = {"pb_state": 3, "pb_rmul": 0.8, "pb_kn": 3e9, "pb_ks": 1e9, "pb_ten": 1e6, "pb_coh": 2e6, "pb_fa": 30.0,
            "kn": 7e8, "ks": 5e8, "fric": 0.5}
    contacts = [Contact(balls[0], balls[1], "linearpbond", bond),
                Contact(balls[0], balls[2], "linearpbond", bond),
                Contact(balls[1], balls[2], "linearpbond", dict(bond, pb_state=1)),
                Contact(balls[1], balls[2], "linearcbond", {"cb_state": 3, "kn": 4.0, "ks": 2.0})]
    sys.modules["itasca"] = stand_in(balls, contacts)
    space = {}
    with open(script) as text:
        exec(compile(text.read(), script, "exec"), space)
    with tempfile.TemporaryDirectory() as folder:
        space["export_bonds"](folder)
        assert sorted(os.listdir(folder)) == ["bonds.csv", "particles.csv"]
        with open(os.path.join(folder, "particles.csv")) as text:
            particles = list(csv.DictReader(text))
        with open(os.path.join(folder, "bonds.csv")) as text:
            bonds = list(csv.DictReader(text))
    assert [p["id"] for p in particles] == ["1", "2", "3"]
    assert particles[0]["group"] == "rock, hard" and particles[1]["group"] == "none"
    assert float(particles[0]["vz"]) == 1.0 / 3
    assert [(b["a"], b["b"]) for b in bonds] == [("1", "2"), ("1", "3"), ("2", "3")]

    # The first overlaps by 0.1 and has its linear springs, the second has a gap of 0.5 and the smaller radius.
    for row, smaller, springs, point in ((bonds[0], 1.0, 1, 0.5), (bonds[1], 0.5, 0, 1.25 / 2)):
        r = 0.8 * smaller
        area, second_moment = math.pi * r ** 2, math.pi * r ** 4 / 4
        close(row["kn"], 3e9 * area + springs * 7e8)
        close(row["ks"], 1e9 * area + springs * 5e8)
        close(row["kt"], 2 * 1e9 * second_moment)
        close(row["kb"], 3e9 * second_moment)
        close(row["contact_point"], point)
        close(row["radius"], r)
        close(row["friction_angle (deg)"], 30)
    assert [float(bonds[2][name]) for name in ("kn", "ks", "kt", "kb")] == [4, 2, 0, 0] and bonds[2]["radius"] == ""


main(sys.argv[1])
