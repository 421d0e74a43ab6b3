#!/usr/bin/python3
"""Plot columns of a run's history.csv, one panel per unit.

    studies/report/plot_history.py RUN_DIRECTORY --output history.png
    studies/report/plot_history.py RUN_1 RUN_2 --columns "kinetic energy" --output compared.png

The first row of the file holds names and units in brackets, `time [s],kinetic energy [J],...`; the first column
is the abscissa. Without a choice every column is drawn. Several runs are drawn over each other.
"""

import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

COLOURS = ["#1f4e79", "#c0392b", "#2e8b57", "#8e5ea2", "#d68910", "#5d6d7e"]
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"),
            (1e-15, "f")]


class History:
    """The columns of a history file: names, units, samples."""

    def __init__(self, path):
        self.label = path.name if path.is_dir() else path.stem
        path = path / "history.csv" if path.is_dir() else path
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
        if len(rows) < 2:
            sys.exit(f"{path}: no samples yet")
        width = len(rows[0])
        rows = [row for row in rows if len(row) == width]  # the last may be half written
        headings = [self.split(text) for text in rows[0]]
        self.names = [name for name, _ in headings]
        self.units = [unit for _, unit in headings]
        self.samples = np.array(rows[1:], dtype=float).T

    @staticmethod
    def split(heading):
        name, bracket, unit = heading.strip().partition("[")
        return name.strip(), unit.rstrip("] ") if bracket else ""

    def index(self, name):
        if name not in self.names:
            sys.exit(f"no column '{name}'; there are: {', '.join(self.names)}")
        return self.names.index(name)


def prefixed(unit, largest):
    """Factor and label that make numbers of this size readable, e.g. 1e6 and 'µs'; simple units and areas only."""
    if unit == "m^2" and 0 < largest < 1e-6:
        return 1e12, "µm²"
    if unit not in ("s", "m", "N", "J", "Pa", "W", "m/s") or not 0 < largest < np.inf:
        return 1.0, unit
    for size, prefix in PREFIXES:
        if largest >= size:
            return 1 / size, prefix + unit
    return 1.0, unit


def draw(axes, histories, names, unit):
    """All columns of one unit in one panel."""
    time_factor, time_unit = prefixed(histories[0].units[0], max(abs(h.samples[0]).max() for h in histories))
    values = [[h.samples[h.index(name)] for name in names] for h in histories]
    factor, label = prefixed(unit, max(np.nanmax(abs(v)) for of_run in values for v in of_run))
    for run, (history, of_run) in enumerate(zip(histories, values)):
        for number, (name, samples) in enumerate(zip(names, of_run)):
            text = name if len(histories) == 1 else f"{history.label}: {name}" if len(names) > 1 else history.label
            colour = COLOURS[(number if len(names) > 1 else run) % len(COLOURS)]
            axes.plot(time_factor * history.samples[0], factor * samples, color=colour, lw=1.3, label=text,
                      ls=["-", "--", ":", "-."][run % 4] if len(names) > 1 else "-")
    several = len(names) * len(histories) > 1
    what = "" if len(names) > 1 else names[0]
    axes.set_ylabel(" ".join(filter(None, [what, f"[{label}]" if label not in ("", "-", "1") else ""])))
    axes.set_xlabel(f"{histories[0].names[0]} [{time_unit}]")
    axes.margins(x=0)
    axes.grid(color="0.9", lw=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    top = axes.get_subplotspec().is_first_row()
    if several and (top or len(names) > 1):  # runs keep their colours from panel to panel
        axes.legend(frameon=False, fontsize=8, loc="lower left", bbox_to_anchor=(-0.01, 0.98), borderpad=0,
                    ncol=4 if len(names) == 1 or len(histories) == 1 else 2)


def plot(histories, columns, output, dpi):
    first = histories[0]
    columns = columns or first.names[1:]
    by_unit = {}
    for name in columns:
        by_unit.setdefault(first.units[first.index(name)], []).append(name)
    figure, panels = plt.subplots(len(by_unit), 1, squeeze=False, sharex=True, layout="constrained",
                                  figsize=(6.4, 0.4 + 2.1 * len(by_unit)))
    for axes, (unit, names) in zip(panels[:, 0], by_unit.items()):
        draw(axes, histories, names, unit)
        axes.label_outer()
    figure.align_ylabels()
    figure.savefig(output, dpi=dpi, facecolor="white")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("runs", type=pathlib.Path, nargs="+", help="run directories, or history files")
    parser.add_argument("--columns", nargs="+", help="names without units; default: all")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("history.png"))
    parser.add_argument("--dpi", type=int, default=200)
    arguments = parser.parse_args()
    plot([History(path) for path in arguments.runs], arguments.columns, arguments.output, arguments.dpi)


if __name__ == "__main__":
    main()
