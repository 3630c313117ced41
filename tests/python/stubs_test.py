"""The type stubs say what the module has, no more and no less, as mypy sees it; everything public is documented."""
import ast
import inspect
import os
import pathlib
import subprocess
import sys
import unittest

import bondstatic as bs
from bondstatic import _core
from program import ROOT

PACKAGE = pathlib.Path(bs.__file__).parent


class Stubs(unittest.TestCase):
    def check(self, tool, *arguments):
        done = subprocess.run([sys.executable, "-B", "-m", tool, *map(str, arguments)], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_they_name_what_the_module_has(self):
        self.check("mypy.stubtest", "--allowlist", ROOT / "tests" / "python" / "stubtest.allow", "bondstatic._core")

    def test_the_package_keeps_to_them_and_the_examples_to_both(self):
        options = ("--config-file", ROOT / "pyproject.toml",
                   "--cache-dir", pathlib.Path(os.environ["BONDSTATIC_BUILD"], "mypy"))
        self.check("mypy", *options, "--strict", ROOT / "src" / "python" / "bondstatic")
        self.check("mypy", *options, "--check-untyped-defs", *(ROOT / "cases" / "python").glob("*.py"))

    def test_numbers_of_arguments(self):
        tree = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
        for node in tree.body:
            if isinstance(node, ast.FunctionDef):
                signature = getattr(_core, node.name).__doc__.splitlines()[0].split(" -> ")[0]
                names = [part.split(":")[0].strip() for part in signature[signature.index("(") + 1:-1].split(",")
                         if ":" in part]
                for argument in node.args.args:
                    self.assertIn(argument.arg, names, signature)

    def test_the_package_is_marked_as_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_everything_public_is_there_documented_and_typed(self):
        for name in bs.__all__:
            value = getattr(bs, name)
            self.assertTrue(value.__doc__, name)
            if inspect.isfunction(value):
                hints = inspect.signature(value)
                self.assertIsNot(hints.return_annotation, inspect.Signature.empty, name)
                for parameter in hints.parameters.values():
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, (name, parameter.name))
            for member, what in vars(value).items() if inspect.isclass(value) else ():
                if not member.startswith("_") and (callable(what) or isinstance(what, property)):
                    self.assertTrue(what.__doc__, (name, member))


if __name__ == "__main__":
    unittest.main()
