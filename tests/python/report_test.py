"""report(): the file that the program writes, byte by byte; what is refused."""
import os
import pathlib
import tempfile
import unittest

import bondstatic as bs
from program import CASES, run


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="bondstatic-report-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for name, law in (("one", "timoshenko"), ("other", "parallel")):
            done = run("solve", CASES / "cantilever" / "case.toml", "--set", f"bonds.0.law={law}", "--out",
                       cls.folder / name)
            if done.returncode != 0:
                raise AssertionError(done.stderr)

    def of_program(self, *folders):
        file = self.folder / "program.html"
        done = run("report", *folders, "--out", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return file.read_bytes()

    def test_one_folder_and_several_are_what_the_program_writes(self):
        one, other, file = self.folder / "one", self.folder / "other", self.folder / "report.html"
        made = bs.report(one, file)
        self.assertEqual(file.read_bytes(), self.of_program(one))
        self.assertEqual((made.file, made.bytes, made.notes), (str(file), file.stat().st_size, []))
        self.assertEqual(os.fspath(made), str(file))
        bs.report((str(one), other), str(file))
        self.assertEqual(file.read_bytes(), self.of_program(one, other), "an older report is replaced")

    def test_it_lies_in_the_current_folder_unless_said_otherwise(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        made = bs.report("one")
        self.assertEqual(made.file, "report.html")
        self.assertEqual((self.folder / "report.html").read_bytes(), self.of_program("one"))

    def test_what_is_refused(self):
        letter = self.folder / "letter.html"
        letter.write_text("<p>Dear colleague", encoding="utf-8")
        with self.assertRaisesRegex(bs.InputError, "no folders to report of\n    cure: "):
            bs.report([])
        with self.assertRaisesRegex(bs.Error, "exists, and is no report\n    cure: "):
            bs.report(self.folder / "one", letter)
        self.assertEqual(letter.read_text(encoding="utf-8"), "<p>Dear colleague")
        with self.assertRaisesRegex(bs.InputError, "nowhere"):
            bs.report(["nowhere"], self.folder / "of_nowhere.html")
        self.assertFalse((self.folder / "of_nowhere.html").exists())


if __name__ == "__main__":
    unittest.main()
