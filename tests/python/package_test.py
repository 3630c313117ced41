"""What `cmake --install` and pip put elsewhere works there, calibration's module included."""
import base64
import csv
import hashlib
import io
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

from program import CASES, ROOT

sys.path.insert(0, str(ROOT / "cmake"))
import wheel  # noqa: E402  the build backend

USE = """
import bondstatic as bs, pathlib
assert pathlib.Path(bs.__file__).is_relative_to({folder!r}), bs.__file__
print(bs.solve(bs.read({case!r})).outputs["tip"])
"""


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="bondstatic-package-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        prefix = cls.folder / "prefix"
        build = os.environ["BONDSTATIC_BUILD"]
        subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", "python", "--strip"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.packages = next(prefix.glob("lib/python*/*-packages"))

    def use(self, packages):
        code = USE.format(folder=str(packages), case=str(CASES / "cantilever" / "case.toml"))
        environment = {**os.environ, "PYTHONPATH": str(packages)}
        done = subprocess.run([sys.executable, "-B", "-c", code], env=environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(float(done.stdout), -0.008534241726, delta=1e-12)

    def test_installed(self):
        self.use(self.packages)
        names = {path.name for path in (self.packages / "bondstatic").iterdir()}
        self.assertLessEqual({"__init__.py", "_core.pyi", "py.typed", "model.py"}, names)

    def test_wheel(self):
        name = wheel.pack(self.packages, self.folder)
        with zipfile.ZipFile(self.folder / name) as packed:
            record = next(entry for entry in packed.namelist() if entry.endswith(".dist-info/RECORD"))
            rows = list(csv.reader(io.StringIO(packed.read(record).decode())))
            self.assertEqual({row[0] for row in rows}, set(packed.namelist()))
            for path, digest, size in rows[:-1]:
                content = packed.read(path)
                found = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, int(size)), ("sha256=" + found, len(content)))
            packed.extractall(self.folder / "unpacked")
        self.use(self.folder / "unpacked")

    def test_source_distribution_has_what_the_build_needs(self):
        name = wheel.build_sdist(self.folder)
        with tarfile.open(self.folder / name) as packed:
            names = packed.getnames()
        base = name.removesuffix(".tar.gz")
        for part in ("PKG-INFO", "pyproject.toml", "CMakeLists.txt", "cmake/wheel.py", "src/python/module.cpp"):
            self.assertIn(f"{base}/{part}", names)
        self.assertFalse([entry for entry in names if "__pycache__" in entry])


if __name__ == "__main__":
    unittest.main()
