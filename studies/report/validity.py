"""Warnings of a report: where its results stop being valid, with the run's own numbers."""

import numpy as np

MICRO = 1e6


def warnings(study, runs):
    """The warnings as sentences."""
    found = []
    status = study.summary["status"]
    if status != "complete":
        message = study.summary.get("message", "")
        found.append(f"The run is {status}{': ' + message if message else ''}; the report covers the part computed.")
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
                     "separates from the glass and drags on it; the model of the beam ignores this.")
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
