"""The report of a piercing or a comparison: motion, damage, pictures, replay, energy."""

import render_zona
from charts import Chart, spectrum
from replay import replays

MICRO = 1e6


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


def pictures(page, runs):
    page.heading("The zona at chosen times")
    for run in runs:
        frames = run.frames()
        if frames is None or "zona" not in frames.group(0):
            continue
        path = page.folder / ("zona" + ("_" + run.directory.name if run.name else "") + ".png")
        render_zona.render(render_zona.nearest_frames(frames.file, None),
                           [render_zona.View(-60, 22), render_zona.View(35, 30)], None, path, 130)
        page.image(path, (f"{run.name}: " if run.name else "") + "failed points in red, seen from two sides.")


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
