"""The type stubs name what the module has, no more and no less, and everything public is documented."""
import ast
import inspect
import pathlib
import unittest

import bondstatic as bs
from bondstatic import _core

PACKAGE = pathlib.Path(bs.__file__).parent


def stub_names():
    tree = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
               for node in tree.body if isinstance(node, ast.ClassDef)}
    return functions, classes


class Stubs(unittest.TestCase):
    def test_functions(self):
        self.assertEqual(stub_names()[0], {name for name, value in vars(_core).items()
                                           if inspect.isroutine(value) and not name.startswith("_")})

    def test_classes_and_their_members(self):
        classes = {name: value for name, value in vars(_core).items() if inspect.isclass(value)}
        stubs = stub_names()[1]
        self.assertEqual(set(stubs), set(classes))
        for name, members in stubs.items():
            found = {member for member in vars(classes[name]) if not member.startswith("_")}
            self.assertEqual({member for member in members if not member.startswith("__")}, found, name)

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
