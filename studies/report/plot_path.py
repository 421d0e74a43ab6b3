#!/usr/bin/python3
"""Plot the results of a material_point study: stresses (or other columns) over a strain.

    studies/report/plot_path.py runs/point_uniaxial --output uniaxial.png
    studies/report/plot_path.py runs/point_mode_1 runs/point_mode_2 --columns strain_yy strain_xy --output modes.png

Without --over the abscissa is the strain that changes most; without --columns all stresses that are not zero are
drawn. Crosses mark yield, bifurcation and failure as summary.json has them. Several runs are drawn over each other.
"""

import argparse
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from plot_history import COLOURS, History, prefixed  # noqa: E402

EVENTS = {"yield": "o", "bifurcation": "D", "failure": "X"}


def widest_strain(history):
    """The strain whose values lie furthest apart."""
    strains = [name for name in history.names if name.startswith("strain_")]
    if not strains:
        sys.exit(f"{history.label}: no strains; is this the run of a material_point study?")
    return max(strains, key=lambda name: np.ptp(history.samples[history.index(name)]))


def stresses(history):
    """The stresses that are not zero all the way."""
    found = [name for name in history.names if name.startswith("stress_")]
    largest = {name: abs(history.samples[history.index(name)]).max() for name in found}
    return [name for name in found if largest[name] > 1e-6 * max(largest.values())]


def events_of(run):
    """Steps at which something happened, by name."""
    path = run / "summary.json"
    if not path.is_file():
        return {}
    results = json.loads(path.read_text(encoding="utf-8"))["results"]
    return {name: results[name]["step"] for name in EVENTS if results.get(name)}


def plot(runs, over, columns, output, dpi):
    histories = [History(run) for run in runs]
    over = over or widest_strain(histories[0])
    columns = columns or stresses(histories[0])
    largest = max(abs(h.samples[h.index(name)]).max() for h in histories for name in columns)
    factor, unit = prefixed(histories[0].units[histories[0].index(columns[0])], largest)
    figure, axes = plt.subplots(figsize=(6.4, 4), layout="constrained")
    for number, (run, history) in enumerate(zip(runs, histories)):
        strain = history.samples[history.index(over)]
        for line, name in enumerate(columns):
            colour = COLOURS[(number if len(runs) > 1 else line) % len(COLOURS)]
            label = f"{history.label}: {name}" if len(runs) > 1 and len(columns) > 1 else (
                history.label if len(runs) > 1 else name)
            stress = factor * history.samples[history.index(name)]
            axes.plot(strain, stress, color=colour, ls=["-", "--", ":", "-."][line % 4] if len(runs) > 1 else "-",
                      lw=1.4, label=label)
            for event, step in events_of(run).items() if line == 0 else []:
                axes.plot(strain[step], stress[step], EVENTS[event], color=colour, mfc="white", ms=6,
                          label=event if number == 0 else None)
    axes.set_xlabel(over)
    what = "stress" if all(name.startswith("stress_") for name in columns) else ""
    axes.set_ylabel(f"{what} [{unit}]" if unit else what)
    axes.grid(color="0.9", lw=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(output, dpi=dpi, facecolor="white")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("runs", type=pathlib.Path, nargs="+", help="run directories of material_point studies")
    parser.add_argument("--over", help="column on the abscissa, e.g. strain_xx")
    parser.add_argument("--columns", nargs="+", help="columns to draw, e.g. stress_xx equivalent_stress")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("path.png"))
    parser.add_argument("--dpi", type=int, default=200)
    arguments = parser.parse_args()
    plot(arguments.runs, arguments.over, arguments.columns, arguments.output, arguments.dpi)


if __name__ == "__main__":
    main()
