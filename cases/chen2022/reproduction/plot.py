"""A figure as gnuplot sees it: points where the program answered, lines where a closed form says what it should be."""
import os
import subprocess
from dataclasses import dataclass, field

WIDTH, HEIGHT = 640, 440
# Told apart by shape as well as by colour, and open: where models agree their symbols lie on each other.
POINTS = {
    "TBBM": "pt 6 ps 1.2 lw 2 lc rgb '#0072b2'",
    "EBBM": "pt 4 ps 1.1 lw 2 lc rgb '#d55e00'",
    "PBM": "pt 8 ps 1.2 lw 2 lc rgb '#009e73'",
    "first": "pt 8 ps 1.2 lw 2 lc rgb '#888888'",
    "second": "pt 6 ps 1.2 lw 2 lc rgb '#cc79a7'",
    "third": "pt 4 ps 1.1 lw 2 lc rgb '#000000'",
}
LINES = {
    "TBBM": "lw 1.6 dt 1 lc rgb '#0072b2'",
    "EBBM": "lw 1.6 dt 2 lc rgb '#d55e00'",
    "PBM": "lw 1.6 dt 4 lc rgb '#009e73'",
    "first": "lw 1.6 dt 4 lc rgb '#888888'",
    "second": "lw 1.6 dt 1 lc rgb '#cc79a7'",
    "third": "lw 1.6 dt 2 lc rgb '#000000'",
}


@dataclass
class Plot:
    name: str
    title: str
    xlabel: str
    ylabel: str
    points: list = field(default_factory=list)    # (label, style, xs, ys)
    lines: list = field(default_factory=list)     # (label, style, xs, ys)
    settings: list = field(default_factory=list)  # further lines of gnuplot


def block(number, xs, ys):
    rows = "\n".join(f"{x!r} {y!r}" for x, y in zip(xs, ys, strict=True))
    return f"$data{number} << EOD\n{rows}\nEOD"


def script(plot, output):
    series = [(*line, f"with lines {LINES[line[1]]}") for line in plot.lines]
    series += [(*points, f"with points {POINTS[points[1]]}") for points in plot.points]
    curves = ", \\\n  ".join(f'$data{i} using 1:2 {style} title "{label}"'
                             for i, (label, _, _, _, style) in enumerate(series))
    return "\n".join([
        "set encoding utf8",
        f'set terminal svg size {WIDTH},{HEIGHT} fixed font "Helvetica,14" background "#ffffff"',
        f'set output "{output}"',
        f'set title "{plot.title}" font ",15"',
        f'set xlabel "{plot.xlabel}"',
        f'set ylabel "{plot.ylabel}"',
        "set border lw 0.8",
        "set tics nomirror",
        'set grid lw 0.5 lc rgb "#dddddd"',
        "set key samplen 2.5 spacing 1.25",
        *plot.settings,
        *(block(i, xs, ys) for i, (_, _, xs, ys, _) in enumerate(series)),
        f"plot {curves}",
        "unset output",
    ]) + "\n"


def draw(plot, folder):
    """Writes FOLDER/NAME.svg, the same bytes for the same data and gnuplot."""
    path = folder / f"{plot.name}.svg"
    # The caller's locale would change decimal signs and what gnuplot makes of Greek letters.
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    try:
        done = subprocess.run(["gnuplot", "-"], input=script(plot, path), encoding="utf-8", capture_output=True,
                              env=environment, check=False)
    except FileNotFoundError:
        raise RuntimeError("gnuplot is missing: apt-get install gnuplot-nox") from None
    if done.returncode != 0 or done.stderr.strip():
        raise RuntimeError(f"{plot.name}: gnuplot says: {done.stderr.strip()}")
    return path
