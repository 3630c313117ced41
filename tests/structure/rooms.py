"""Checks how the source is laid out: rooms include only what they may, and no file grows past its limit.

    /usr/bin/python3 rooms.py REPOSITORY      prints each violation as file:line: what, and exits 1 if there is any
"""
import pathlib
import re
import sys

# A room may include from itself and from the rooms in its set. io holds what everything stands on.
LINE_OF_ROOMS = ["io", "model", "bond", "formats", "dynamics", "system", "mechanism", "multigrid", "solver", "statics", "modes", "relax",
                 "check", "compare", "fracture", "results", "calibration"]
MAY_USE = {room: set(LINE_OF_ROOMS[:i]) for i, room in enumerate(LINE_OF_ROOMS)}
# The explicit run checks the static answer, so neither may stand on the other.
for room in ["system", "mechanism", "multigrid", "solver", "statics", "modes"]:
    MAY_USE[room].discard("dynamics")
# The module that is loaded on demand; nobody includes from it.
MAY_USE["petsc"] = {"io", "model", "bond", "system", "solver"}
# What other codes' files say is data for cases, commands and comparisons; mechanics does not ask where a model comes from.
for room in ["dynamics", "system", "mechanism", "multigrid", "solver", "statics", "modes", "relax", "check"]:
    MAY_USE[room].discard("formats")
MAY_USE["case"] = {"io", "model", "bond", "formats"}
MAY_USE["report"] = {"io", "model", "results"}
MAY_USE["app"] = set(MAY_USE) - {"petsc"}
MAY_USE["python"] = set(MAY_USE) - {"petsc", "app"}

# The public headers belong to rooms, too.
ROOM_OF_HEADER = {
    "types": "io", "error": "io", "units": "io", "version": "io",
    "model": "model",
    "bond": "bond", "bond_law": "bond", "strength": "bond",
    "state": "model",
    "network": "system",
    "linear_solver": "solver",
    "mechanism": "mechanism", "statics": "statics", "effective_stiffness": "statics", "sensitivity": "statics",
    "modes": "modes", "dynamics": "dynamics", "relaxation": "relax", "check": "check", "compare": "compare", "fracture": "fracture",
    "output": "results", "results": "results", "resolution": "results", "calibration": "calibration",
    "case_file": "case", "report": "report",
}
# A case says what is asked of the solve: it may fill these structs, and ask which solvers there are.
ALSO_ALLOWED = {"case": {"bondstatic/statics.hpp", "bondstatic/output.hpp", "bondstatic/linear_solver.hpp",
                         "bondstatic/relaxation.hpp", "bondstatic/dynamics.hpp", "bondstatic/fracture.hpp", "bondstatic/calibration.hpp"}}

# Foreign headers that only one place may know.
ONLY_IN = {
    r"toml\+\+/": r"case/",
    r"Spectra/": r"modes/",
    r"ceres/|glog/|boost/math/": r"calibration/",
    r"pybind11/": r"python/",
    r"CLI/": r"app/",
    r"petsc.*\.h$|mpi\.h": r"petsc/",
    r"pugixml|zlib\.h": r"report/",
    r"cholmod\.h|SuiteSparse_config\.h|suitesparse/": r"solver/cholmod",
}

LONGEST_FILE = 400
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
PRINTS = re.compile(r"\bstd::(cout|cerr|clog)\b|\bpy::print\b")


def source_files(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in {".cpp", ".hpp", ".h", ".py"}:
                yield path


def room_of_include(header):
    """The room that an include of ours leads to; None for a foreign header."""
    folder, _, name = header.partition("/")
    if folder == "bondstatic":
        return ROOM_OF_HEADER.get(name.removesuffix(".hpp"), "unknown")
    return folder if name and folder in MAY_USE else None


def violations_of_line(room, where, line):
    found = INCLUDE.match(line)
    if not found:
        if room != "app" and PRINTS.search(line):
            yield "prints: only app does, the library returns values"
        return
    header = found.group(1)
    target = room_of_include(header)
    allowed = MAY_USE[room] | {room}
    if target and target not in allowed and header not in ALSO_ALLOWED.get(room, set()):
        yield f"{room} includes {header} of room {target}; it may use {', '.join(sorted(allowed))}"
    for foreign, place in ONLY_IN.items():
        if re.match(foreign, header) and not re.match(place, where):
            yield f"includes {header}, which only {place} may know"


def violations(root):
    root = pathlib.Path(root)
    found = []
    for path in source_files(root, "src", "include"):
        lines = path.read_text(encoding="utf-8").splitlines()
        name = path.relative_to(root)
        if name.parts[0] == "include":
            where = room = ROOM_OF_HEADER.get(path.stem)
        else:
            where, room = "/".join(name.parts[1:]), name.parts[1]
        if room not in MAY_USE:
            found.append(f"{name}:1: belongs to no room; give it one in tests/structure/rooms.py")
            continue
        for number, line in enumerate(lines, 1):
            found += [f"{name}:{number}: {what}" for what in violations_of_line(room, where, line)]
    for path in source_files(root, "src", "include", "tests", "cases"):
        count = len(path.read_text(encoding="utf-8").splitlines())
        if count > LONGEST_FILE:
            found.append(f"{path.relative_to(root)}:{count}: longer than {LONGEST_FILE} lines; split it")
    return found


if __name__ == "__main__":
    found = violations(sys.argv[1])
    print("\n".join(found) if found else "every room keeps to its place")
    sys.exit(1 if found else 0)
