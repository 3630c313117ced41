"""Lets another code write a small bonded packing, imports what it wrote, and compares numbers.

    /usr/bin/python3 -B code_test.py yade|lammps|liggghts PROGRAM BONDSTATIC EXPORTERS_FOLDER
"""
import csv
import math
import os
import subprocess
import sys
import tempfile

YADE_SCENE = """
O.materials.append(CohFrictMat(young=1e7, poisson=.3, density=2650, isCohesive=True, normalCohesion=1e6,
                               shearCohesion=1e6, momentRotationLaw=True, alphaKr=2, alphaKtw=1.5, label='stone'))
O.bodies.append([sphere((0, 0, 0), 1), sphere((1.9, .1, 0), .95), sphere((1, 1.69, 1. / 3), 1),
                 facet([(-1, -1, -1.05), (1, -1, -1.05), (0, 1, -1.05)])])
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(), Ig2_Facet_Sphere_ScGeom6D()],
                             [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)],
                             [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]), NewtonIntegrator()]
O.dt = 1e-9
O.step()
exec(open(%r).read())
export_bonds('.')
from yade import export
export.text('text.txt')
export.textExt('textExt.txt', 'id_x_y_z_r_matId')
"""


def run(command, folder):
    done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=100)
    assert done.returncode == 0, "%s ended with %d:\n%s" % (command, done.returncode, done.stdout)
    return done.stdout


def rows(folder, name):
    with open(os.path.join(folder, name)) as text:
        return list(csv.DictReader(text))


def close(found, expected, tolerance):
    assert math.isclose(float(found), expected, rel_tol=tolerance, abs_tol=tolerance), (found, expected)


def test_yade(folder, program, bondstatic, exporters):
    with open(os.path.join(folder, "scene.py"), "w") as text:
        text.write(YADE_SCENE % os.path.join(exporters, "yade.py"))
    printed = run([program, "-n", "-x", "scene.py"], folder)
    assert "bonds.csv: 3 bonds" in printed and "left out: 1 of Facet" in printed, printed
    run([bondstatic, "import", "particles.csv", "bonds.csv", "--out", "case"], folder)
    particles = {row["id"]: row for row in rows(folder, "case/particles.csv")}
    assert sorted(particles) == ["0", "1", "2"] and abs(float(particles["2"]["z"]) - 1 / 3) < 1e-16
    bonds = {(row["a"], row["b"]): row for row in rows(folder, "case/bonds.csv")}
    # Ip2_FrictMat_FrictPhys: kn = 2 E Ra Rb / (Ra + Rb) of 2 E R here, ks = nu kn; kr, ktw = alpha ks Ra Rb.
    bond = bonds["0", "1"]
    kn = 2 * 1e7 * 1 * .95 / 1.95
    for name, value in (("kn", kn), ("ks", .3 * kn), ("kb", 2 * .3 * kn * .95), ("kt", 1.5 * .3 * kn * .95)):
        close(bond[name], value, 1e-14)
    length = math.hypot(1.9, .1)
    close(bond["contact_point"], (length + 1 - .95) / (2 * length), 1e-14)
    for name in ("text.txt", "textExt.txt"):
        run([bondstatic, "import", name, "--out", name + ".case"], folder)
        z = sorted(float(row["z"]) for row in rows(folder, name + ".case/particles.csv"))
        assert abs(z[0]) + abs(z[1]) < 1e-15 and z[2] == 0.333333, z


def write_data(path, style):
    """Two spheres; with a bond where the style has bonds."""
    bonded = "bond" in style
    with open(path, "w") as text:
        text.write("two spheres\n\n2 atoms\n%s1 atom types\n%s\n-1 1 xlo xhi\n-1 1 ylo yhi\n-1 1 zlo zhi\n\nAtoms\n\n"
                   % ("1 bonds\n" if bonded else "", "1 bond types\n" if bonded else ""))
        tail = " 1" if bonded else ""
        # sphere: id type diameter density x y z; a hybrid has id type x y z first
        for number, x in ((1, 0.0), (2, 0.3333333333333333)):
            text.write("%d 1 %r 0.1 0.1 0.4 2650%s\n" % (number, x, tail) if bonded else
                       "%d 1 0.4 2650 %r 0.1 0.1\n" % (number, x))
        if bonded:
            text.write("\nBonds\n\n1 1 1 2\n")


def dump_lines(exporters, code):
    """The lines of liggghts.in under "# CODE:", without comment signs."""
    with open(os.path.join(exporters, "liggghts.in")) as text:
        block = text.read().split("# %s:\n" % code)[1].split("\n\n")[0]
    return "".join(line.lstrip("# ") + "\n" for line in block.splitlines())


def test_lammps(folder, program, bondstatic, exporters):
    dump = dump_lines(exporters, "LAMMPS")
    for style, extra in (("sphere", ""), ("hybrid sphere bond", "extra/bond/per/atom 2")):
        write_data(os.path.join(folder, "in.data"), style)
        with open(os.path.join(folder, "in.lammps"), "w") as deck:
            deck.write("units si\natom_style %s\nboundary f f f\nnewton on off\ncomm_modify cutoff 1\n"
                       "read_data in.data %s\n%spair_style zero 0.5\npair_coeff * *\n%srun 0\nwrite_data out.data\n"
                       % (style, extra, "bond_style zero\nbond_coeff 1\n" if "bond" in style else "", dump))
        run([program, "-in", "in.lammps", "-log", "none"], folder)
        case = "case." + style.replace(" ", "_")
        run([bondstatic, "import", "out.data", "--atom-style", style, "--out", case], folder)
        xs = [float(row["x"]) for row in rows(folder, case + "/particles.csv")]
        assert sorted(xs) == [0, 1 / 3], xs
        run([bondstatic, "import", "particles.dump", "--out", case + ".dump"], folder)
        row = max(rows(folder, case + ".dump/particles.csv"), key=lambda r: float(r["x"]))
        assert float(row["x"]) == 1 / 3 and float(row["radius"]) == 0.2, row
        if "bond" in style:
            assert [(b["a"], b["b"]) for b in rows(folder, case + "/bonds.csv")] in ([("1", "2")], [("2", "1")])


def test_liggghts(folder, program, bondstatic, exporters):
    write_data(os.path.join(folder, "in.data"), "sphere")
    dump = dump_lines(exporters, "LIGGGHTS")
    with open(os.path.join(folder, "in.liggghts"), "w") as deck:
        deck.write("units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
                   "communicate single vel yes\nread_data in.data\nneighbor 0.01 bin\n"
                   "fix m1 all property/global youngsModulus peratomtype 1e7\n"
                   "fix m2 all property/global poissonsRatio peratomtype 0.3\n"
                   "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5\n"
                   "fix m4 all property/global coefficientFriction peratomtypepair 1 0.5\n"
                   "pair_style gran model hertz tangential history\npair_coeff * *\ntimestep 1e-7\n"
                   "fix integrate all nve/sphere\n" + dump + "run 0\n")
    run([program, "-in", "in.liggghts", "-log", "none"], folder)
    run([bondstatic, "import", "particles.dump", "--out", "case"], folder)
    particles = rows(folder, "case/particles.csv")
    assert sorted(float(row["x"]) for row in particles) == [0, 1 / 3], particles
    assert [float(row["radius"]) for row in particles] == [0.2, 0.2]
    assert [float(row["density"]) for row in particles] == [2650, 2650]


if __name__ == "__main__":
    code, program, bondstatic, exporters = sys.argv[1:]
    with tempfile.TemporaryDirectory() as scratch:
        globals()["test_" + code](scratch, program, bondstatic, exporters)
