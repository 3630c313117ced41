"""The check must see second definitions, and nothing else: each test plants one in a sound tree."""
import pathlib
import tempfile
import unittest

from one_definition import violations


class OneDefinition(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bondstatic-one-definition-")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("include/bondstatic/model.hpp", "namespace bondstatic {\nstruct Model {\n  int size;\n};\n}\n")
        self.write("src/io/table.hpp", "namespace bondstatic {\n\nclass Table final : public Rows {};\n\n}\n")
        self.write("tests/io/table_test.cpp", "namespace bondstatic::test {\nstruct Answer { struct Row {}; };\n}\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def assert_caught(self, name, text, place, what):
        self.assertEqual(violations(self.root), [])
        self.write(name, text)
        found = violations(self.root)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{place}: {what} is defined in "), found)

    def test_two_headers(self):
        self.assert_caught("src/text/table.hpp", "namespace bondstatic {\nstruct Table {};\n}\n",
                           "src/text/table.hpp:2", "bondstatic::Table")

    def test_private_beside_public(self):
        self.assert_caught("src/io/x.cpp", "namespace bondstatic {\nnamespace {\nint x;\n}\nstruct Model {};\n}\n",
                           "src/io/x.cpp:5", "bondstatic::Model")

    def test_two_tests_with_nested_namespaces(self):
        self.assert_caught("tests/io/x_test.cpp", "namespace bondstatic {\nnamespace test {\nclass Answer {};\n}\n}\n",
                           "tests/io/x_test.cpp:3", "bondstatic::test::Answer")

    def test_template_and_enumeration(self):
        for name, text in {"a": "template <class T>\nstruct Fit<T*> {};", "b": "enum class Kind : int { one, two };"}.items():
            self.write(f"src/io/{name}.hpp", f"namespace n {{\n{text}\n}}\n")
        self.assert_caught("src/io/c.hpp", "namespace n {\ntemplate <class A>\nstruct Fit<A> {};\nenum class Kind {};\n}\n",
                           "src/io/c.hpp:4", "n::Kind")

    def test_behind_braces_that_are_none(self):
        self.assert_caught("src/io/x.cpp",
                           "#define OPEN {\n// {\n/* { */ namespace bondstatic {\nchar c = '{';\nint n = 1'000;\n"
                           "auto s = \"\\\"{\", r = R\"x({)\"{)x\";\nstruct [[nodiscard]] Table {};\n}\n",
                           "src/io/x.cpp:7", "bondstatic::Table")

    def assert_sound(self, text):
        self.write("src/io/x.cpp", text)
        self.assertEqual(violations(self.root), [])

    def test_namespaces_without_a_name_may_repeat(self):
        self.assert_sound("namespace bondstatic {\nnamespace {\nstruct Table {};\nnamespace inner {\nstruct Table {};\n}\n}\n}\n")

    def test_other_namespaces_members_and_locals_may_repeat(self):
        self.assert_sound("namespace other { struct Table {}; }\nnamespace bondstatic {\n"
                          "struct X { struct Table {}; };\nvoid f() { struct Table {}; }\n}\n")

    def test_declarations_and_uses_are_no_definitions(self):
        self.assert_sound("namespace bondstatic {\nclass Table;\nstruct Model model{};\n"
                          "struct Model f(struct Table& t) { return {}; }\ntemplate <class Table>\nint g() { return 0; }\n}\n")


if __name__ == "__main__":
    unittest.main()
