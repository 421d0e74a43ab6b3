"""The report of a search: its designs, their ranking and its uncertainty."""

import pathlib

import numpy as np

from charts import Chart, Intervals, Scatter, Tornado
from markup import escaped, table
from run_data import Table

MICRO = 1e6
MOST_TIPS = 5
NOISE = "With {} samples a correlation below {:.1f} may be chance; the charts below compute each input's effect by itself."


def plain(value):
    """Three digits, without an exponent for large values."""
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"


class Search:
    """The results, with titles and units of the measures."""

    def __init__(self, study):
        self.study, self.results = study, study.results
        self.measures = self.results["measures"]
        self.objectives = self.results["objectives"]
        ranked = [entry for entry in self.results["candidates"] if "rank" in entry]
        self.ranked = sorted(ranked, key=lambda entry: entry["rank"])
        self.reference = self.results["reference"]

    def title(self, name):
        measure = self.measures[name]
        unit = measure["unit"].replace("um", "µm").replace("^2", "²")
        return f"{measure['title']} [{unit}]" if unit else measure["title"]

    def factor(self, name):
        return self.measures[name]["factor"]

    def cell(self, entry, name):
        spread = entry["measures"].get(name)
        if spread is None:
            return "unknown"
        median, low, high = (plain(spread[key] * self.factor(name)) for key in ("median", "low", "high"))
        return f"{median} ({low} to {high})"

    def range_of(self, entry, name):
        spread = entry["measures"].get(name)
        f = self.factor(name)
        return (spread["median"] * f, (spread["low"] * f, spread["high"] * f)) if spread else None


def search_part(page, study):
    if "measures" not in study.results or "uncertain" not in study.results:
        page.parts.append("<p>The search has no ranking yet; continue it with --resume.</p>")
        return
    search = Search(study)
    answer(page, search)
    bath_warnings(page, search)
    beams(page, search)
    refinement(page, search)
    piercings(page, search)
    uncertainty(page, search)
    known(page, search)


def answer(page, search):
    results, first = search.results, search.objectives[0]
    answers = [entry for entry in search.ranked if entry["is_answer"]]
    without = " without " + " and ".join(results["avoid"]) if results["avoid"] else ""
    page.heading("Answer")
    share = f"{100 * results['confidence']:.0f} %"
    if answers:
        page.parts.append(f"<p><b>{len(answers)} of {len(search.ranked)} designs{without}</b> keep to the limits and have a "
                          f"smaller {search.measures[first]['title']} than the reference in at least {share} of the "
                          "samples of the uncertain inputs.</p>")
    else:
        page.parts.append(f"<p><b>None of {len(search.ranked)} designs{without}</b> keeps to the limits with a smaller "
                          f"{search.measures[first]['title']} than the reference in {share} of the samples, in the ranges "
                          "tried.</p>")
    keys = list(search.ranked[0]["settings"]) if search.ranked else []
    header = (["rank", "design", "limits kept"] + [search.title(name) for name in search.objectives]
              + [f"less {search.measures[first]['title']}", "front"])
    rows = []
    for entry in [search.reference, *search.ranked]:
        better = entry["measures"].get(first, {}).get("better")
        rows.append([str(entry.get("rank", "")) + (" *" if entry["is_answer"] else ""), entry["label"],
                     f"{100 * entry['keeps_limits']:.0f} %",
                     *[search.cell(entry, name) for name in search.objectives],
                     "" if better is None or "rank" not in entry else f"{100 * better:.0f} %",
                     entry["level"] + 1 if "rank" in entry else ""])
    page.parts.append(table(header, rows))
    page.parts.append("<p>Medians over the samples, 5 to 95 % in brackets; * answers. The reference is the study that was "
                      "varied, as it stands; it meets the same samples. Front 1 is the Pareto front of the medians. "
                      f"Limits: {escaped('; '.join(results['limits']) or 'none')}. Every ranked design is a study file, "
                      "candidates/RANK.toml.</p>")
    page.parts.append(table(["rank", "design", *keys],
                            [[entry["rank"], entry["label"], *[entry["settings"][key] for key in keys]]
                             for entry in search.ranked]))


def bath_warnings(page, search):
    for entry in [search.reference, *search.ranked[:1]]:
        for text in entry["warnings"]:
            page.parts.append(f'<p class="warning">The beam\'s bath ({escaped(entry["label"])}): {escaped(text)}.</p>')


def beams(page, search):
    path = search.study.directory / "designs.csv"
    names = search.results["tip_objectives"]
    if not path.is_file():
        return
    designs = Table(path)
    page.heading("Designs by their beams")
    page.parts.append(f"<p>{search.results['beams']['designs']} designs, {search.results['beams']['seconds']:.0f} s; "
                      f"{search.results['beams']['impossible']} were impossible. The best of every combination went on to "
                      "piercings.</p>")
    x, y = names[0], names[1] if len(names) > 1 else "tip_travel"
    words = np.array(designs.first_cells)
    lines = [(word, designs[x][words == word] * search.factor(x), designs[y][words == word] * search.factor(y))
             for word in dict.fromkeys(words)]
    page.charts([Scatter("designs", "All designs that were tried; each point is a beam.", search.title(x),
                         search.title(y), lines, logarithmic=True)])


def piercings(page, search):
    page.heading("Piercings")
    entries = [search.reference, *search.ranked]
    charts = []
    for name in search.objectives:
        rows = [(entry["label"], *found, None, (None, None), entry["is_answer"])
                for entry in entries if (found := search.range_of(entry, name))]
        if rows:
            charts.append(Intervals(f"interval_{name}", f"{search.measures[name]['title'].capitalize()}: medians and 5 to "
                                    "95 % of the samples; answers green, the reference red.", search.title(name), "", rows))
    if len(search.objectives) > 1:
        x, y = search.objectives[:2]
        rows = [(entry["label"], *a, *b, entry["is_answer"]) for entry in entries
                if (a := search.range_of(entry, x)) and (b := search.range_of(entry, y))]
        if rows:
            charts.insert(0, Intervals("pareto", "The first two objectives; down and left is better.", search.title(x),
                                       search.title(y), rows))
    page.charts(charts)
    lines = []
    for entry in [search.reference, *search.ranked[:MOST_TIPS]]:
        path = pathlib.Path(entry["folder"]) / "tip.csv"
        if not path.is_file():
            path = search.study.directory / "cases" / path.parent.name / "tip.csv"
        if path.is_file():
            tip = Table(path)
            lines.append((entry["label"], tip["time"] * MICRO, tip["displacement"] * MICRO))
    if lines:
        page.charts([Chart("tips", "The tip after the pulse: the reference and the first of the ranking.", "time [µs]",
                           "displacement [µm]", lines)])


def refinement(page, search):
    """Evaluations of the second optimiser, search by search."""
    path = search.study.directory / "trials.csv"
    if not path.is_file():
        return
    trials = Table(path)
    ways = [np.flatnonzero(trials["way"] == way) for way in np.unique(trials["way"])]
    lines = [(f"{int(trials['way'][rows[0]])}: {trials.first_cells[rows[0]]}",
              np.arange(1, len(rows) + 1), np.minimum.accumulate(trials["cost"][rows])) for rows in ways]
    page.heading("Refinement")
    page.parts.append(f"<p>From the best candidates of {len(ways)} combinations an optimiser tried {len(trials)} piercings; "
                      "where it found something better, that is a candidate, too, called refined.</p>")
    page.charts([Chart("refinement", "The least cost so far: the worst objective over that of the reference, and a "
                       "penalty where limits are violated.", "piercing", "cost", lines, markers=True)])


def uncertainty(page, search):
    inputs = search.results["uncertain"]
    if not inputs:
        return
    page.heading("Effect of the uncertain inputs")
    header = ["input", "range", "source"] + [f"rank correlation with {search.measures[name]['title']}"
                                             for name in search.objectives]
    rows = [[entry["key"], range_text(entry), entry["source"] or "not given"]
            + [f"{entry['correlations'][name]:+.2f}" for name in search.objectives] for entry in inputs]
    page.parts.append(table(header, rows))
    count = len(inputs[0]["samples"])
    page.parts.append("<p>Spearman's correlation over the samples, mean over the designs. "
                      + NOISE.format(count, min(1, 2 / max(count - 1, 1) ** 0.5)) + "</p>")
    page.charts(tornadoes(search, inputs))
    off = [f"{end['subject']} with {entry['key']} at the {end['end']} end" for entry in inputs
           for end in entry["ends"] if not end["keeps_limits"]]
    if off:
        page.parts.append(f'<p class="warning">At ends of the ranges these violate the limits: {escaped("; ".join(off))}.</p>')


def tornadoes(search, inputs):
    first = search.objectives[0]
    subjects = list(dict.fromkeys(end["subject"] for entry in inputs for end in entry["ends"]))
    charts = []
    for index, subject in enumerate(subjects):
        rows = []
        for entry in inputs:
            ends = {end["end"]: end["values"].get(first) for end in entry["ends"] if end["subject"] == subject}
            if None not in (ends.get("low"), ends.get("high")):
                rows.append((f"{entry['key']}, {range_text(entry)}",
                             (ends["high"] - ends["low"]) * search.factor(first)))
        rows.sort(key=lambda row: -abs(row[1]))
        if rows:
            charts.append(Tornado(f"ends_{index + 1}", f"{subject}: change of the {search.measures[first]['title']} from the "
                                  "low to the high end of each input, the others at their value in the study.",
                                  search.title(first), rows))
    return charts


def range_text(entry):
    if "values" in entry:
        return ", ".join(value.strip('"') for value in entry["values"])
    low, high = entry["range"]
    return f"{low:g} to {high:g} {entry['unit']}".strip()


def weight(search, entry):
    """How much an input moves the first objective over its range: of the reference, if that was computed."""
    first = search.objectives[0]
    ends = [end["values"].get(first) for end in entry["ends"] if end["subject"] == "reference"]
    if len(ends) == 2 and None not in ends:
        return abs(ends[1] - ends[0])
    return abs(entry["correlations"][first])


def known(page, search):
    """What is computed, what is assumed, what to measure next."""
    first, inputs = search.objectives[0], search.results["uncertain"]
    page.heading("Known, assumed, to be measured")
    items = ["<b>Known</b>: the response of the beam and the liquid around it, and the motion of the material points, are "
             "compared with exact solutions (zona verify). The samples of the inputs are the same for all designs, so their "
             "order is better known than their values."]
    assumed = [f"{entry['key']} ({range_text(entry)}; {entry['source'] or 'no source given'})" for entry in inputs]
    items.append("<b>Assumed</b>: " + escaped("; ".join(assumed) + "; " if assumed else "")
                 + "every other value of the reference study, below; that the liquid's load is that of small swings; that "
                 "the tip is rigid and moves as the beam does, whatever resists it; that failed area orders the damage, "
                 "though it depends on the cells.")
    items.append("<b>Not known</b>: no threshold of strain, pressure or shear at which an oocyte lyses is published, so "
                 "nothing here is a rate of survival. Less of every measure is taken to be gentler.")
    if inputs:
        by_weight = sorted(inputs, key=lambda entry: -weight(search, entry))
        order = ", then ".join(entry["key"] for entry in by_weight)
        items.append(f"<b>To be measured next</b>: what moves the {search.measures[first]['title']} most over its range, "
                     f"{escaped(order)}; and the motion of the tip itself at the microscope for the first of the ranking, "
                     "which tests the beam, the drive and the liquid together.")
    page.parts.append("<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>")
    titles = " and ".join(search.measures[name]["title"] for name in search.results["tip_objectives"])
    trials = search.results["trials"]
    chosen = sum(not entry["label"].endswith(" refined") for entry in search.results["candidates"])
    refined = f" and the {trials} piercings of the optimiser" if trials else ""
    page.parts.append(f"<p>{chosen} candidates were chosen by the {escaped(titles)} of their beams; the search "
                      f"says nothing of designs beyond these{refined}.</p>")
    reference = search.study.directory / "reference.toml"
    if reference.is_file():
        page.heading("Reference study")
        page.parts.append(f"<pre>{escaped(reference.read_text(encoding='utf-8'))}</pre>")
