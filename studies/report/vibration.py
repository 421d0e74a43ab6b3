"""The report of a vibration study: amplitudes, natural frequencies, motions, sensitivities."""

import numpy as np

from charts import Chart, Tornado, spectrum
from markup import number, table

MICRO = 1e6


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
