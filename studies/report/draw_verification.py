#!/usr/bin/python3
"""Draw the figures of `zona verify`.

    studies/report/draw_verification.py figures.json FOLDER

`figures.json` describes them: panels of curves become one SVG each; pictures of the zona are left to
`render_zona.py`, which reads the fields of the run.
"""

import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = ["#c0392b", "#1f77b4", "#2e8b57", "#8e5ea2", "#d68910", "#5d6d7e", "#17a2b8", "#795548"]
STYLES = {
    "line": {"linewidth": 1.4},
    "points": {"linestyle": "none", "marker": "o", "markersize": 3.2},
    "reference": {"linewidth": 1.6, "color": "#202020"},
    "limit": {"linewidth": 1.0, "linestyle": "--", "color": "#808080"},
}


def draw_panel(axes, panel):
    """One panel; an unnamed curve takes the colour of the one before it."""
    number = -1
    for curve in panel["curves"]:
        style = dict(STYLES[curve["style"]])
        if "color" not in style:
            number += 1 if curve["label"] or number < 0 else 0
            style["color"] = COLOURS[number % len(COLOURS)]
        axes.plot(curve["x"], curve["y"], label=curve["label"] or None, **style)
    axes.set_title(panel["title"], fontsize=9)
    axes.set_xlabel(panel["x"]["label"])
    axes.set_ylabel(panel["y"]["label"])
    axes.set_xscale("log" if panel["x"]["logarithmic"] else "linear")
    axes.set_yscale("log" if panel["y"]["logarithmic"] else "linear")
    axes.grid(True, linewidth=0.3, color="#c0c0c0")
    if any(curve["label"] for curve in panel["curves"]):
        axes.legend(fontsize=7, frameon=False)


def draw_panels(figure, path):
    panels = figure["panels"]
    columns = min(len(panels), 2 if len(panels) == 4 else 3)
    rows = -(-len(panels) // columns)
    canvas, grid = plt.subplots(rows, columns, figsize=(4.6 * columns, 3.4 * rows), squeeze=False)
    for axes, panel in zip(grid.flat, panels):
        draw_panel(axes, panel)
    for axes in grid.flat[len(panels):]:
        axes.remove()
    canvas.tight_layout()
    canvas.savefig(path, metadata={"Date": None})
    plt.close(canvas)


def draw_zona(figure, folder):
    script = pathlib.Path(__file__).with_name("render_zona.py")
    for picture, name in zip(figure["zona"], figure["files"]):
        command = [sys.executable, script, pathlib.Path(figure["runs"]) / picture["run"], "--dpi", "110",
                   "--output", folder / name]
        if picture["microseconds"]:
            command += ["--times", *map(str, picture["microseconds"])]
        subprocess.run(command, check=True)


def main():
    description, folder = map(pathlib.Path, sys.argv[1:])
    plt.rcParams.update({"font.size": 8, "svg.hashsalt": "zona", "svg.fonttype": "path"})
    folder.mkdir(parents=True, exist_ok=True)
    for figure in json.loads(description.read_text(encoding="utf-8")):
        if figure["zona"]:
            draw_zona(figure, folder)
        else:
            draw_panels(figure, folder / figure["files"][0])


if __name__ == "__main__":
    main()
