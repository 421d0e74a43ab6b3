#!/usr/bin/python3
"""Write report.html, one file for any browser, and the figures of a run: `zona report DIRECTORY`.

    report.py RUN_DIRECTORY FIGURE_SCRIPTS

Charts and pictures also become files in RUN_DIRECTORY/report, as SVG, PNG and CSV. FIGURE_SCRIPTS is the folder
of render_zona.py. The replay is drawn by three.js of Debian's libjs-three; without it, it is left out.
"""

import base64
import json
import pathlib
import sys

import numpy as np

from charts import Chart, Tornado, spectrum
from markup import escaped, number, table
from replay import pack_run
from run_data import Study
from search import search_part

THREE = pathlib.Path("/usr/share/javascript/three")
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
        ("output_seconds", "of it for output", 1, "s"),
        ("point_steps_per_second", "speed, point-steps", 1e-6, "million/s"),
        ("peak_memory_bytes", "memory at its greatest", 1e-6, "MB")]


def number_table(runs, entries):
    """A row a number, a column a run."""
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


def lines_of(runs, file, x, y, x_factor, y_factor):
    lines = []
    for run in runs:
        data = run.table(file)
        if data is not None and x in data and y in data and len(data) > 1:
            lines.append((run.name, data[x] * x_factor, data[y] * y_factor))
    return lines


def history_chart(runs, name, title, y, y_factor, y_label):
    lines = lines_of(runs, "history.csv", "time", y, MICRO, y_factor)
    return Chart(name, title, "time [µs]", y_label, lines) if lines else None


def tip_charts(runs):
    """Motion and spectrum of the tip of the beam, where there is one, else of the pipette."""
    charts = []
    lines = lines_of(runs, "tip.csv", "time", "displacement", MICRO, MICRO)
    if lines:
        charts.append(Chart("tip", "Displacement of the beam's tip after the pulse.", "time [µs]",
                            "displacement [µm]", lines))
        spectra = []
        for label, time, values in lines:
            frequency, amplitude = spectrum(time / MICRO, values)
            spectra.append((label, frequency / 1e3, amplitude))
        charts.append(Chart("tip_spectrum", "Amplitude spectrum of the tip's displacement.", "frequency [kHz]",
                            "amplitude [µm]", spectra, x_limit=(0, 60)))
    charts.append(history_chart(runs, "pipette_displacement", "Lateral displacement of the pipette.",
                                "pipette_y", MICRO, "displacement [µm]"))
    charts.append(history_chart(runs, "pipette_speed", "Lateral velocity of the pipette.", "pipette_vy", 1,
                                "velocity [m/s]"))
    return charts


def energy_chart(run):
    data = run.table("history.csv")
    if data is None or "kinetic_energy" not in data or len(data) < 2:
        return None
    time = data["time"] * MICRO
    kinetic, stored = data["kinetic_energy"] * 1e12, data["stored_energy"] * 1e12
    lines = [("kinetic", time, kinetic), ("stored", time, stored),
             ("change of both", time, kinetic + stored - kinetic[0] - stored[0])]
    if "pipette_work" in data:
        lines.append(("work of the pipette", time, data["pipette_work"] * 1e12))
    name = "energy" + ("_" + run.directory.name if run.name else "")
    title = "Energies" + (f" with {run.name}" if run.name else "")
    return Chart(name, title + ". In a closed balance the change of both would be the work done.",
                 "time [µs]", "energy [pJ]", lines)


def piercing_part(page, runs):
    page.heading("Motion of the pipette")
    page.charts(tip_charts(runs))
    page.heading("Damage")
    page.charts([
        history_chart(runs, "failed_area", "Failed area of the zona.", "failed_area", 1e12, "area [µm²]"),
        history_chart(runs, "strain", "Greatest strain of intact points; failure takes them out.",
                      "largest_strain", 1, "strain"),
        history_chart(runs, "strain_away", "Greatest strain further than a diameter from the hole.",
                      "strain_away", 1, "strain"),
        history_chart(runs, "pressure", "Highest pressure of the cytoplasm, cell averages.",
                      "cytoplasm_pressure_high", 1e-3, "pressure [kPa]"),
        history_chart(runs, "force", "Lateral force on the pipette.", "force_y", MICRO, "force [µN]")])
    pictures(page, runs)
    replays(page, runs)
    page.heading("Energy")
    page.charts([energy_chart(run) for run in runs])


def pictures(page, runs):
    import render_zona  # noqa: PLC0415 (loads matplotlib, which few reports need)
    page.heading("The zona at chosen times")
    for run in runs:
        frames = run.frames()
        if frames is None or "zona" not in frames.group(0):
            continue
        path = page.folder / ("zona" + ("_" + run.directory.name if run.name else "") + ".png")
        render_zona.render(render_zona.nearest_frames(frames.file, None),
                           [render_zona.View(-60, 22), render_zona.View(35, 30)], None, path, 130)
        page.image(path, (f"{run.name}: " if run.name else "") + "failed points in red, seen from two sides.")


def replays(page, runs):
    scripts = [THREE / "build/three.min.js", THREE / "examples/js/controls/OrbitControls.js"]
    packed = [{"name": run.name, "data": pack_run(frames)} for run in runs if (frames := run.frames())]
    if not packed:
        return
    page.heading("Replay")
    if not all(script.is_file() for script in scripts):
        page.missing.append("the interactive replay: three.js is missing; install the package libjs-three")
        page.parts.append(f'<p class="warning">Left out is {escaped(page.missing[-1])}.</p>')
        return
    page.parts.append('<p>Drag to turn, wheel to zoom, right button to shift. Frames are those of fields.h5; large '
                      'bodies of points are thinned.</p><div class="replay"></div>')
    data = json.dumps(packed, separators=(",", ":"))
    code = [script.read_text(encoding="utf-8") for script in scripts]
    code += [f"window.zonaReplay = {data};", (HERE / "replay.js").read_text(encoding="utf-8")]
    page.parts += ["<script>" + text.replace("</script", "<\\/script") + "</script>" for text in code]


def vibration_part(page, results):
    page.heading("Amplitude of the tip over that of the support")
    oblique = any("axial_amplitude_ratio" in result for result in results)
    amplitudes(page, results, "amplitude_ratio", "across the pipette" if oblique else "as in Figure 5.28")
    if oblique:
        amplitudes(page, results, "axial_amplitude_ratio", "along the pipette")
    fluids = list(dict.fromkeys(result["fluid"] for result in results))
    page.heading("Natural frequencies")
    frequencies = {result["fluid"]: result["natural_frequencies"] for result in results}
    count = min(6, min(map(len, frequencies.values())))
    page.parts.append(table(["[kHz]"] + [f"mode {i + 1}" for i in range(count)],
                            [[fluid] + [f"{f / 1e3:.4g}" for f in frequencies[fluid][:count]] for fluid in fluids]))
    vibration_motions(page)
    sensitivities(page, results)


def amplitudes(page, results, measure, what):
    """Ratios as a table and as a chart."""
    fluids = list(dict.fromkeys(result["fluid"] for result in results))
    is_sine = any(result["angular_frequency"] for result in results)
    key, factor, unit = ("angular_frequency", 1, "rad/s") if is_sine else ("pulse_duration", MICRO, "µs")
    pulses = list(dict.fromkeys(result[key] for result in results))
    ratios = {(result["fluid"], result[key]): result[measure] for result in results}
    if len(pulses) <= 24:
        page.parts.append(table([what] + [f"{number(pulse, factor)} {unit}" for pulse in pulses],
                                [[fluid] + [f"{ratios[fluid, pulse]:.4f}" if (fluid, pulse) in ratios else "-"
                                            for pulse in pulses] for fluid in fluids]))
    lines = [(fluid, [factor * pulse for pulse in pulses if (fluid, pulse) in ratios],
              [ratios[fluid, pulse] for pulse in pulses if (fluid, pulse) in ratios]) for fluid in fluids]
    page.charts([Chart(measure, f"Amplitude ratio by pulse, {what}.",
                       f"{'angular frequency' if is_sine else 'duration'} [{unit}]", "tip over support", lines,
                       markers=len(pulses) <= 50)])


def sensitivities(page, results):
    """A tornado chart per fill, of the first pulse that has one, across and along the pipette."""
    shown = {}
    for result in results:
        for key, motion in (("sensitivities", "tip's amplitude"),
                            ("axial_sensitivities", "tip's amplitude along the pipette")):
            if key in result:
                shown.setdefault((result["fluid"], motion), result[key])
    if not shown:
        return
    page.heading("What the amplitude depends on")
    for index, ((fluid, motion), found) in enumerate(list(shown.items())[:8]):
        rows = [(entry["key"], 10 * entry["amplitude"] * entry["value"] / found["amplitude"])
                for entry in found["inputs"]]
        rows = [row for row in rows if abs(row[1]) > 0.005][:16]
        page.charts([Tornado(f"sensitivity_{index + 1}", f"{fluid}: change of the {motion} for 10 % more of each "
                             "input, to first order.", "change of the amplitude [%]", rows)])


def vibration_motions(page):
    data = page.study.runs()[0].table("history.csv")
    if data is None or len(data) < 2:
        return
    page.heading("Motion of the tip")
    time = data["time"]

    def some(prefix):
        tips = [name for name in data.names if name.startswith(prefix)]
        return tips, tips if len(tips) <= 6 else [tips[i] for i in np.linspace(0, len(tips) - 1, 6).round().astype(int)]

    tips, shown = some("tip ")
    page.charts([
        Chart("tip", f"Displacement of the tip, {len(shown)} of {len(tips)} runs.", "time [µs]", "displacement [µm]",
              [(name[4:].strip(), time * MICRO, data[name] * MICRO) for name in shown]),
        Chart("tip_spectrum", "Amplitude spectra of these displacements.", "frequency [kHz]", "amplitude [µm]",
              [(name[4:].strip(), f / 1e3, a) for name in shown for f, a in [spectrum(time, data[name] * MICRO)]],
              x_limit=(0, 60))])
    tips, shown = some("axial tip ")
    if tips:
        page.charts([Chart("axial_tip", f"Displacement of the tip along the pipette, {len(shown)} of {len(tips)} runs.",
                           "time [µs]", "displacement [µm]",
                           [(name[10:].strip(), time * MICRO, data[name] * MICRO) for name in shown])])


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


def warnings(study, runs):
    """What limits the validity of the results, with the run's own numbers."""
    found = []
    status = study.summary["status"]
    if status != "complete":
        message = study.summary.get("message", "")
        found.append(f"The run is {status}{': ' + message if message else ''}; what follows is of the part computed.")
    for run in runs if study.kind != "vibration" else []:
        named = f" ({run.name})" if run.name else ""
        found += [f"The beam's bath{named}: {text}." for text in run.results.get("warnings", [])]
    if study.kind == "vibration":
        worst = max(study.results, key=lambda result: len(result.get("warnings", [])), default={})
        found += [f"The bath ({worst['fluid']}): {text}." for text in worst.get("warnings", [])]
    if study.kind not in ("piercing", "comparison"):
        return found
    diameter = _micrometres(study.keys["pipette"]["outer_diameter"])
    swings, strains, noises = {}, {}, {}
    for run in runs:
        swing = run.results.get("largest_excursion")
        if swing and diameter and swing * MICRO > diameter:
            swings[run.name] = f"{swing * MICRO:.3g} µm"
        history = run.table("history.csv")
        if history is None or len(history) < 8 or "largest_strain" not in history:
            continue
        strain = np.nanmax(history["largest_strain"])
        if strain > 0.05:
            strains[run.name] = f"{strain:.3f}"
        noise = _scatter(np.linalg.norm([history[f"force_{axis}"] for axis in "xyz"], axis=0))
        if noise > 0.05:
            noises[run.name] = f"{100 * noise:.0f} %"
    if swings:
        found.append(f"The tip swings further than its outer diameter of {diameter:g} µm: {_listed(swings)}. Liquid then "
                     "separates from the glass and drags on it; the beam knows nothing of that.")
    if strains:
        found.append(f"Intact points of the zona are strained by up to {_listed(strains)}. The law is that of small "
                     "strains: measures of strain differ by about half of the strain itself.")
    if noises:
        found.append(f"The force on the pipette scatters around its mean over five rows, by {_listed(noises)} of the "
                     "mean: read its trend, not its peaks.")
    found.append(f"Failed areas depend on the mesh (cells of {study.keys['grid']['cell']}): failure is per point, without "
                 "an inner length. They compare runs with one mesh; they are not sizes of holes.")
    return found


def _listed(values):
    return ", ".join(f"{value} ({name})" if name else value for name, value in values.items())


def _scatter(values):
    """Standard deviation from the mean over five values, over the mean of all."""
    smooth = np.convolve(values, np.ones(5) / 5, "same")
    return np.std((values - smooth)[3:-3]) / max(np.mean(smooth), 1e-300)


def _micrometres(text):
    value, _, unit = str(text).partition(" ")
    scale = {"um": 1.0, "µm": 1.0, "mm": 1e3, "nm": 1e-3, "m": 1e6}.get(unit.strip())
    return float(value) * scale if scale else None


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
