"""Keeps the tables and figures that the README shows the same as the ones just made."""
import re
import shutil

from program import CASES

README = CASES / "README.md"
FIGURES = CASES / "figures"
MADE_BY = re.compile(r"Produced by GNUPLOT [^<]*")


def _marked(name):
    """What stands between <!-- NAME --> and <!-- end -->."""
    return re.compile(rf"(<!-- {re.escape(name)} -->\n).*?(<!-- end -->)", re.DOTALL)


def update(tables, figures):
    text = README.read_text(encoding="utf-8")
    for name, table in tables.items():
        text = _marked(name).sub(lambda found, table=table: found[1] + table + "\n" + found[2], text)
    README.write_text(text, encoding="utf-8")
    FIGURES.mkdir(exist_ok=True)
    for figure in figures:
        shutil.copyfile(figure, FIGURES / figure.name)


def differences(tables, figures):
    """Figures of another gnuplot may differ in their bytes; only those of the same one are compared."""
    text = README.read_text(encoding="utf-8")
    cure = "run cases/chen2022/reproduce --update and look at what changes"
    found = [f"{README.name}: {name} is not what was found now: {cure}" for name, table in tables.items()
             if f"<!-- {name} -->\n{table}\n<!-- end -->" not in text]
    for figure in figures:
        kept = FIGURES / figure.name
        if not kept.exists():
            found.append(f"{kept.name} is missing in {FIGURES}: {cure}")
            continue
        old, new = kept.read_text(encoding="utf-8"), figure.read_text(encoding="utf-8")
        if MADE_BY.findall(old) == MADE_BY.findall(new) and old != new:
            found.append(f"{kept.name} in {FIGURES} is not what was drawn now: {cure}")
    return found
