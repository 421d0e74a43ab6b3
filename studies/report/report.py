#!/usr/bin/python3
"""Write report.html, one file for any browser, and the figures of a run: `zona report DIRECTORY`.

    report.py RUN_DIRECTORY

Charts and pictures also become files in RUN_DIRECTORY/report, as SVG, PNG and CSV. The replay needs three.js
(libjs-three of Debian); without it, the page has none.
"""

import base64
import pathlib
import sys

import numpy as np

from charts import Chart
from markup import escaped, number, table
from piercing import piercing_part
from replay import replays
from run_data import Study
from search import search_part
from validity import warnings
from vibration import vibration_part

HERE = pathlib.Path(__file__).resolve().parent
MICRO = 1e6

QUESTIONS = {
    "piercing": "What does this motion of the pipette do to the zona pellucida, and to the rest of the oocyte?",
    "comparison": "Which fill of the pipette lets the same pulse pierce the zona, and at what cost to the oocyte?",
    "vibration": "How far does the tip of the pipette swing after a pulse at its support, for each fill and pulse?",
    "search": "Which fill, pipette and pulse pierce the zona with the least damage, and what is uncertain about it?",
    "scene": "What do the bodies of this scene do?",
    "material_point": "How does one point of this material answer to the prescribed path?",
}
KEY_NUMBERS = [
    ("tip_amplitude", "greatest displacement of the beam's tip", MICRO, "µm"),
    ("largest_excursion", "greatest displacement of the tip in the window", MICRO, "µm"),
    ("initial_speed", "speed of the tip at the start of the window", 1, "m/s"),
    ("time_of_first_failure", "first failure after", MICRO, "µs"),
    ("failed_points", "failed points of the zona", 1, ""),
    ("failed_area", "failed area of the zona", 1e12, "µm²"),
    ("largest_strain_away", "greatest strain of the zona away from the hole", 1, ""),
    ("largest_displacement_away", "greatest displacement of the zona away from the hole", MICRO, "µm"),
    ("highest_cytoplasm_pressure", "highest pressure of the cytoplasm, cell averages", 1e-3, "kPa"),
    ("highest_cytoplasm_shear_rate", "highest shear rate of the cytoplasm, cell averages", 1e-3, "1/ms"),
    ("deepest_indentation", "deepest indentation of the intact zona", MICRO, "µm"),
    ("hole_over_pipette", "diameter of the hole over that of the pipette", 1, ""),
    ("path_after_failure", "path of the tip after failure began", MICRO, "µm"),
    ("largest_pipette_force", "greatest force on the pipette", MICRO, "µN"),
    ("pipette_work", "work of the pipette", 1e12, "pJ"),
]
COST = [("points", "points", 1, ""), ("steps", "steps", 1, ""), ("time_step", "time step", 1e9, "ns"),
        ("critical_time_step", "critical step", 1e9, "ns"), ("wall_seconds", "time taken", 1, "s"),
        ("output_seconds", "time for output", 1, "s"),
        ("point_steps_per_second", "speed, point-steps", 1e-6, "million/s"),
        ("peak_memory_bytes", "peak memory", 1e-6, "MB")]


def number_table(runs, entries):
    """One row per number, one column per run."""
    rows = [[f"{title} [{unit}]" if unit else title] + [number(run.results.get(key), factor) for run in runs]
            for key, title, factor, unit in entries if any(key in run.results for run in runs)]
    return table([""] + [run.name for run in runs], rows) if rows else ""


class Page:
    """Collects the parts of the page and the files beside it."""

    def __init__(self, study):
        self.study = study
        self.folder = study.directory / "report"
        self.folder.mkdir(exist_ok=True)
        self.parts, self.missing = [], []

    def heading(self, text):
        self.parts.append(f"<h2>{escaped(text)}</h2>")

    def charts(self, charts):
        drawn = [f"<figure>{chart.draw(self.folder)}<figcaption>{escaped(chart.title)}</figcaption></figure>"
                 for chart in charts if chart]
        if drawn:
            self.parts.append('<div class="charts">' + "".join(drawn) + "</div>")

    def image(self, path, caption):
        data = base64.b64encode(path.read_bytes()).decode()
        self.parts.append(f'<figure><img src="data:image/png;base64,{data}" alt="{escaped(caption)}">'
                          f"<figcaption>{escaped(caption)}</figcaption></figure>")


def scene_part(page, runs):
    data = runs[0].table("history.csv")
    if data is not None and len(data) > 1:
        page.heading("Energy")
        names = ["kinetic_energy", "stored_energy", "potential_energy"]
        page.charts([Chart("energy", "Energies of all bodies.", "time [s]", "energy [J]",
                           [(name.split("_")[0], data["time"], data[name]) for name in names if name in data])])
        probes = [name for name in data.names if name.startswith("probe.")]
        if probes:
            page.heading("Probes")
            page.charts([Chart(name.replace(".", "_"), name, "time [s]", data.units[name] or "value",
                               [("", data["time"], data[name])]) for name in probes[:24]])
    replays(page, runs)


def point_part(page, runs):
    data = runs[0].table("history.csv")
    if data is None or len(data) < 2:
        return
    page.heading("Path")
    charts = []
    for axis in ("xx", "yy", "zz", "xy", "yz", "zx"):
        strain, stress = f"strain_{axis}", f"stress_{axis}"
        if strain in data and stress in data and np.ptp(data[strain]) > 0:
            charts.append(Chart(stress, f"Stress {axis} over strain {axis}.", f"strain {axis}", "stress [Pa]",
                                [("", data[strain], data[stress])]))
    page.charts(charts)


def build(directory):
    study = Study(directory)
    page = Page(study)
    runs = study.runs()
    if study.kind in ("piercing", "comparison"):
        page.heading("Key numbers")
        page.parts.append(number_table(runs, KEY_NUMBERS))
        piercing_part(page, runs)
    elif study.kind == "vibration":
        vibration_part(page, study.results)
    elif study.kind == "search":
        search_part(page, study)
    elif study.kind == "scene":
        scene_part(page, runs)
    else:
        point_part(page, runs)
    page.heading("Cost")
    page.parts.append(number_table(runs, COST))
    summary = study.summary
    page.parts.append(f"<p>{number(summary['cost']['wall_time'])} s on {summary['cost']['threads']} threads, started "
                      f"{escaped(summary['started'])}, zona {escaped(summary['zona'])}, "
                      f"{escaped(summary['compiler'])}.</p>")
    page.heading("Study")
    page.parts.append(f"<pre>{escaped(study.text)}</pre>")
    title = pathlib.Path(summary["study_file"]).stem
    notes = "".join(f'<p class="warning">{escaped(text)}</p>' for text in warnings(study, runs))
    style = (HERE / "page.css").read_text(encoding="utf-8")
    text = (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" '
            f'content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
            f"<title>{escaped(title)}</title><style>{style}</style></head>"
            f'<body><h1>{escaped(title)}</h1><p class="question">{QUESTIONS[study.kind]}</p>{notes}'
            + "\n".join(page.parts) + "</body></html>\n")
    target = study.directory / "report.html"
    partial = target.with_suffix(".tmp")
    partial.write_text(text, encoding="utf-8")
    partial.replace(target)
    return target, page.missing


def main():
    target, missing = build(pathlib.Path(sys.argv[1]))
    for text in missing:
        print(f"left out: {text}")
    print(target)


if __name__ == "__main__":
    main()
