"""Makes the reports that a browser then opens, with the program itself.

    /usr/bin/python3 make_reports.py PROGRAM CASES OUT

<<<<<<< HEAD
OUT gets press.html (a packing), beam.html (a crack), moving.html (two load cases on their way to rest), all.html (a run of every
kind side by side), hostile.html (a title that would be a script) and large.html (106,856 particles, 410,000 bonds), and beside
them the folders of results that they show.
=======
OUT gets press.html (a packing), beam.html (a crack), all.html (a run of every kind side by side), hostile.html (a title
that would be a script), sweeps.html ([Chen2022] Fig. 12 and 10) and large.html (106,856 particles, 410,000 bonds), and beside them the folders of results that they show.
>>>>>>> ba9d799 (Sweeps are drawn over what the reader chooses: number of bonds, keys, outputs, inverse or log; sweep.csv tells particles and bonds)
"""
import pathlib
import shutil
import subprocess
import sys

HOSTILE = "</script><script>alert(1)</script>"

LARGE = """
title = "A large packing"
[[particles]]
lattice = { kind = "bcc", count = [38, 37, 38], spacing = "2 mm" }
radius = "0.9 mm"
jitter = 0.02
seed = 1
[[bonds]]
law = "timoshenko"
young = "50 GPa"
poisson = 0.2
radius_factor = 0.6
contact_radius_factor = 1.0
[[supports]]
at = { lowest = { axis = "z", within = "0.5 mm" } }
fix = "all"
[[loads]]
at = { highest = { axis = "z", within = "0.5 mm" } }
total_force = ["20 N", 0, "-100 N"]
"""

MOVING = """
case = "down"
[[loads]]
at = { id = 11 }
force = [0, 0, "50 kN"]
case = "up"
[dynamics]
save_interval = "10 ms"
"""


def run(program, *arguments):
    subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def make(program, cases, out):
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    results = {}

    def results_of(name, command, *arguments):
        results[name] = out / name
        run(program, command, *arguments, "--out", results[name])

    def report(file, *names):
        run(program, "report", *(results[name] for name in names), "--out", out / file)

    cantilever = cases / "cantilever/case.toml"
    results_of("press", "solve", cases / "yade-packing/press.toml")
    results_of("loads", "solve", cases / "yade-packing/loads.toml")
    results_of("beam", "fracture", cases / "fracture/beam.toml")
    results_of("relax", "relax", cantilever)
    moving = cantilever.read_text(encoding="utf-8").replace("force = [0, -100e3, 0]", 'force = [0, -100e3, 0]\ncase = "down"')
    (out / "moving.toml").write_text(moving + MOVING, encoding="utf-8")
    results_of("moving", "relax", out / "moving.toml")
    results_of("check", "check", cantilever)
    results_of("sweep", "sweep", cases / "chen2022/case3.toml", "--vary",
               "bonds.0.law=parallel,euler-bernoulli,timoshenko", "--vary",
               "particles.0.line.count:bonds.0.gap=2:3.6,3:1.6,5:0.6,11:0")
    results_of("shortened", "sweep", cases / "chen2022/case2.toml", "--vary",
               "bonds.0.law=timoshenko,euler-bernoulli,parallel", "--vary",
               "particles.0.line.count=11,10,9,8,7,6,5,4,3,2")
    results_of("compare", "compare", cases / "lammps-bpm/case.toml", cases / "lammps-bpm/dump.final")
    results_of("calibrate", "calibrate", cases / "calibration/yade.toml")
    results_of("hostile", "solve", cantilever, "--set", f"title={HOSTILE}")
    (out / "large.toml").write_text(LARGE, encoding="utf-8")
    results_of("large", "solve", out / "large.toml")
    report("press.html", "press")
    report("loads.html", "loads")
    report("beam.html", "beam")
    report("moving.html", "moving")
    report("all.html", "press", "relax", "check", "compare", "sweep", "beam", "calibrate")
    report("sweeps.html", "sweep", "shortened")
    report("hostile.html", "hostile")
    report("large.html", "large")


if __name__ == "__main__":
    make(sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
