"""Runs bondstatic and reads its tables."""
import csv
import io
import json
import pathlib
import subprocess
import tempfile

CASES = pathlib.Path(__file__).resolve().parent.parent


class Program:
    def __init__(self, path):
        self.path = str(path)

    def sweep(self, case, *variations, settings=()):
        """Rows of sweep.csv as dictionaries: keys and `status` as text, outputs as numbers."""
        arguments = [option for text in variations for option in ("--vary", text)]
        keys = {key for text in variations for key in text.split("=")[0].split(":")}
        table = self._run("sweep", case, *arguments, *self._set(settings))
        rows = []
        for row in csv.DictReader(io.StringIO(table)):
            if row["status"] != "done":
                raise RuntimeError(f"{case}: a point of the sweep ended with {row['status']}: {row}")
            rows.append({name: text if name in keys or name == "status" else float(text) for name, text in row.items()})
        return rows

    def particles(self, case, settings=()):
        """Rows of particles.csv, all numbers."""
        with tempfile.TemporaryDirectory() as folder:
            self._run("solve", case, "--out", folder, *self._set(settings))
            return self._particles_in(folder)

    def run_to_rest(self, case, settings=()):
        """The same of an explicit run, and what summary.json says of its load case. One thread: the model is small."""
        with tempfile.TemporaryDirectory() as folder:
            summary = self._run("relax", case, "--out", folder, "--threads", "1", "--json", *self._set(settings))
            return self._particles_in(folder), json.loads(summary)["load_cases"][0]

    @staticmethod
    def _particles_in(folder):
        with open(pathlib.Path(folder) / "particles.csv", newline="", encoding="utf-8") as table:
            return [{name: float(text) for name, text in row.items()} for row in csv.DictReader(table)]

    @staticmethod
    def _set(settings):
        return [option for text in settings for option in ("--set", text)]

    def _run(self, command, case, *arguments):
        line = [self.path, command, str(CASES / case), *arguments]
        done = subprocess.run(line, capture_output=True, encoding="utf-8", check=False)
        if done.returncode != 0:
            raise RuntimeError(f"exit {done.returncode}: {' '.join(line)}\n{done.stderr}{done.stdout}")
        return done.stdout
