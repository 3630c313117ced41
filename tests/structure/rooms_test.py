"""The layout check must see what it is there to see: each test plants one violation in a sound tree."""
import pathlib
import tempfile
import unittest

from rooms import LONGEST_FILE, violations


class Rooms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bondstatic-rooms-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("include/bondstatic/model.hpp", '#include "bondstatic/types.hpp"\n')
        self.write("include/bondstatic/output.hpp", '#include "bondstatic/statics.hpp"\n')
        self.write("src/bond/bond.cpp", '#include <vector>\n#include "bondstatic/model.hpp"\n#include "io/a.hpp"\n')
        self.write("src/case/read.cpp", '#include <toml++/toml.h>\n#include "bondstatic/output.hpp"\n')
        self.write("src/solver/cholmod_solver.cpp", "#include <cholmod.h>\n")
        self.write("src/app/main.cpp", '#include <CLI/CLI.hpp>\n#include "case/read.hpp"\nint main() { std::cout; }\n')

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def assert_caught(self, name, text, place, reason):
        self.assertEqual(violations(self.root), [])
        self.write(name, text)
        found = violations(self.root)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{place}: "), found)
        self.assertIn(reason, found[0])

    def test_private_header_to_the_right(self):
        self.assert_caught("src/bond/x.cpp", '\n#include "system/a.hpp"\n', "src/bond/x.cpp:2", "room system")

    def test_public_header_to_the_right(self):
        self.assert_caught("src/model/x.hpp", '# include <bondstatic/bond.hpp>\n', "src/model/x.hpp:1", "room bond")

    def test_public_header_includes_to_the_right(self):
        self.assert_caught("include/bondstatic/bond.hpp", '#include "bondstatic/network.hpp"\n',
                           "include/bondstatic/bond.hpp:1", "room system")

    def test_case_uses_the_structs_of_statics_but_not_its_inside(self):
        self.assert_caught("src/case/x.cpp", '#include "bondstatic/statics.hpp"\n#include "statics/refine.hpp"\n',
                           "src/case/x.cpp:2", "room statics")

    def test_results_does_not_know_cases(self):
        self.assert_caught("src/results/x.cpp", '#include "bondstatic/case_file.hpp"\n', "src/results/x.cpp:1",
                           "room case")

    def test_app_is_used_by_nobody(self):
        self.assert_caught("src/case/x.cpp", '#include "app/a.hpp"\n', "src/case/x.cpp:1", "room app")

    def test_toml_outside_of_case(self):
        self.assert_caught("src/app/x.cpp", "#include <toml++/toml.h>\n", "src/app/x.cpp:1", "only case/")

    def test_command_line_outside_of_app(self):
        self.assert_caught("src/case/x.cpp", "#include <CLI/CLI.hpp>\n", "src/case/x.cpp:1", "only app/")

    def test_cholmod_outside_of_its_backend(self):
        self.assert_caught("src/solver/eigen.cpp", "#include <cholmod.h>\n", "src/solver/eigen.cpp:1",
                           "only solver/cholmod")

    def test_petsc_and_mpi_outside_of_their_module(self):
        self.assert_caught("src/solver/petsc.cpp", "#include <petscksp.h>\n", "src/solver/petsc.cpp:1", "only petsc/")
        self.write("src/solver/petsc.cpp", "")
        self.assert_caught("src/app/ranks.cpp", "#include <mpi.h>\n", "src/app/ranks.cpp:1", "only petsc/")

    def test_including_from_the_module(self):
        self.assert_caught("src/app/x.cpp", '#include "petsc/backends.hpp"\n', "src/app/x.cpp:1", "room petsc")

    def test_python_outside_of_its_module(self):
        self.assert_caught("src/case/x.cpp", "#include <pybind11/numpy.h>\n", "src/case/x.cpp:1", "only python/")
        self.write("src/case/x.cpp", "")
        self.assert_caught("src/app/x.cpp", '#include "python/arrays.hpp"\n', "src/app/x.cpp:1", "room python")

    def test_the_program_in_the_python_module(self):
        self.assert_caught("src/python/x.cpp", '#include "app/report.hpp"\n', "src/python/x.cpp:1", "room app")
        self.write("src/python/x.cpp", "")
        self.assert_caught("src/python/y.cpp", "void f() { py::print(1); }\n", "src/python/y.cpp:1", "prints")

    def test_printing_in_the_library(self):
        self.assert_caught("src/statics/x.cpp", "void f() { std::cerr << 1; }\n", "src/statics/x.cpp:1", "prints")

    def test_folder_that_is_no_room(self):
        self.assert_caught("src/util/x.cpp", "int x;\n", "src/util/x.cpp:1", "no room")

    def test_public_header_without_a_room(self):
        self.assert_caught("include/bondstatic/misc.hpp", "int x;\n", "include/bondstatic/misc.hpp:1", "no room")

    def test_file_that_is_too_long(self):
        self.write("tests/io/fits_test.cpp", "int x;\n" * LONGEST_FILE)
        self.assert_caught("tests/io/x_test.cpp", "int x;\n" * (LONGEST_FILE + 1),
                           f"tests/io/x_test.cpp:{LONGEST_FILE + 1}", "longer")


if __name__ == "__main__":
    unittest.main()
