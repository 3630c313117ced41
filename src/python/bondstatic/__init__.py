"""What a bonded-particle DEM model does at rest: answered at once, and to the last digit.

    import bondstatic as bs
    model = bs.read("packing.data", atom_style="bpm/sphere")       # or bs.Model(x, radius, bonds)
    model.bond(law="timoshenko", young=50e9, poisson=0.2, radius_factor=0.8)
    model.fix(z_below=2e-3)
    model.load(z_above=41e-3, force=(0, 0, -1))
    s = bs.solve(model)
    s.displacement, s.bonds.normal_force, s.sensitivity("reaction_z", ["young", "radius_factor"])

Any one consistent system of units will do; texts with a unit, "50 GPa", are SI. Arrays of results are read-only views
of the library's own memory, which they keep. Errors are exceptions with the text that the command line prints.
"""
from ._core import (Bonds, BrokenBonds, Calibration, Comparison, FractureEvents, Law, Output, Report, SeparatedBody,
                    State, Strength, laws, solvers, strengths, version)
from .calibration import calibrate
from .comparison import compare
from .errors import (AccuracyError, BondstaticWarning, Error, Fault, InputError, Mechanism, MechanismError,
                     OutOfMemoryError)
from .fracturing import Fracture, fracture
from .matrices import System, stiffness, system
from .model import Model
from .reading import read
from .relaxation import Relaxation, relax
from .reporting import report
from .solution import Analysis, Solution, solve

__version__ = version()

__all__ = ["AccuracyError", "Analysis", "Bonds", "BondstaticWarning", "BrokenBonds", "Calibration", "Comparison",
           "Error", "Fault", "Fracture", "FractureEvents", "InputError", "Law", "Mechanism", "MechanismError", "Model",
           "OutOfMemoryError", "Output", "Relaxation", "Report", "SeparatedBody", "Solution", "State", "Strength",
           "System", "calibrate", "compare", "fracture", "laws", "read", "relax", "report", "solve", "solvers",
           "stiffness", "strengths", "system", "version"]
