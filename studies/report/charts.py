"""Charts of a report: as SVG for the page, and as SVG, PNG and CSV files beside it."""

import csv
import io
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

COLOURS = ["#1f5fa8", "#c8442b", "#2f8f5b", "#8a5bb0", "#b8860b", "#4aa3b5", "#7a7a7a"]
STYLE = {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
         "grid.color": "#e4e4e4", "axes.prop_cycle": plt.cycler(color=COLOURS), "lines.linewidth": 1.3,
         "svg.fonttype": "none", "svg.hashsalt": "zona", "legend.frameon": False, "figure.dpi": 100}
plt.rcParams.update(STYLE)


class Chart:
    """Lines over one axis. `lines` are (label, x, y); `title` is the caption."""

    def __init__(self, name, title, x_label, y_label, lines, markers=False, x_limit=None):
        self.name, self.title = name, title
        self.x_label, self.y_label = x_label, y_label
        self.lines, self.markers, self.x_limit = lines, markers, x_limit

    def draw(self, folder):
        """Writes the files; returns the SVG for the page."""
        figure, axes = plt.subplots(figsize=(6.4, 3.3), layout="constrained")
        for label, x, y in self.lines:
            axes.plot(x, y, "o-" if self.markers else "-", markersize=3.5, label=label)
        axes.set_xlabel(self.x_label)
        axes.set_ylabel(self.y_label)
        if self.x_limit:
            axes.set_xlim(*self.x_limit)
        if len(self.lines) > 1 or self.lines[0][0]:
            axes.legend(fontsize=8, loc="lower left", bbox_to_anchor=(0, 1), ncols=4, borderaxespad=0.2)
        return self._save(figure, folder)

    def _save(self, figure, folder):
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None})
        (folder / f"{self.name}.svg").write_text(text.getvalue(), encoding="utf-8")
        figure.savefig(folder / f"{self.name}.png", dpi=200)
        plt.close(figure)
        self._write_csv(folder / f"{self.name}.csv")
        return _inline(text.getvalue(), self.name)

    def _write_csv(self, path):
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["line", self.x_label, self.y_label])
            for label, x, y in self.lines:
                writer.writerows((label, repr(float(a)), repr(float(b))) for a, b in zip(x, y))


class Tornado(Chart):
    """Bars left and right of zero, one per row: `rows` are (label, value), the greatest first."""

    def __init__(self, name, title, x_label, rows):
        super().__init__(name, title, x_label, "input", [])
        self.rows = rows

    def draw(self, folder):
        figure, axes = plt.subplots(figsize=(6.4, 0.9 + 0.26 * len(self.rows)), layout="constrained")
        axes.set_axisbelow(True)
        places = np.arange(len(self.rows))[::-1]
        values = np.array([value for _, value in self.rows])
        axes.barh(places, values, color=np.where(values >= 0, COLOURS[0], COLOURS[1]), height=0.7)
        axes.set_yticks(places, [label for label, _ in self.rows], fontsize=8)
        axes.axvline(0, color="#444444", linewidth=0.8)
        axes.set_xlabel(self.x_label)
        axes.grid(axis="y", visible=False)
        return self._save(figure, folder)

    def _write_csv(self, path):
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow([self.y_label, self.x_label])
            writer.writerows((label, repr(float(value))) for label, value in self.rows)


class Scatter(Chart):
    """Points of several kinds: `lines` are (label, x, y); with `logarithmic` axes."""

    def __init__(self, name, title, x_label, y_label, lines, logarithmic=False):
        super().__init__(name, title, x_label, y_label, lines)
        self.logarithmic = logarithmic

    def draw(self, folder):
        figure, axes = plt.subplots(figsize=(6.4, 4), layout="constrained")
        for index, (label, x, y) in enumerate(self.lines):
            axes.scatter(x, y, s=9, color=COLOURS[index % len(COLOURS)], label=label, linewidths=0,
                         marker="o^sDvP*X"[index // len(COLOURS) % 8], alpha=0.75)
        if self.logarithmic:
            axes.set_xscale("log")
            axes.set_yscale("log")
        axes.set_xlabel(self.x_label)
        axes.set_ylabel(self.y_label)
        axes.legend(fontsize=8, loc="lower left", bbox_to_anchor=(0, 1), ncols=5, borderaxespad=0.2, markerscale=2)
        return self._save(figure, folder)


class Intervals(Chart):
    """Values with intervals: `rows` are (label, x, (low, high), y, (low, high), is_marked); without y, one below
    another."""

    def __init__(self, name, title, x_label, y_label, rows):
        super().__init__(name, title, x_label, y_label, [])
        self.rows = rows

    def draw(self, folder):
        has_y = self.rows[0][3] is not None
        figure, axes = plt.subplots(figsize=(6.4, 4 if has_y else 0.9 + 0.3 * len(self.rows)), layout="constrained")
        for place, (label, x, x_range, y, y_range, is_marked) in enumerate(self.rows):
            colour = COLOURS[2] if is_marked else COLOURS[1] if label == "reference" else COLOURS[6]
            down = -place if not has_y else y
            axes.plot(x_range, [down, down], color=colour, linewidth=1.2 if has_y else 3, alpha=0.6)
            if has_y:
                axes.plot([x, x], y_range, color=colour, linewidth=1.2, alpha=0.6)
                axes.annotate(label, (x, y), fontsize=7, xytext=(4, 3), textcoords="offset points")
            axes.plot([x], [down], "o", color=colour, markersize=5)
        if not has_y:
            axes.set_yticks([-place for place in range(len(self.rows))], [row[0] for row in self.rows], fontsize=8)
            axes.grid(axis="y", visible=False)
        else:
            axes.set_ylabel(self.y_label)
        axes.set_xlabel(self.x_label)
        return self._save(figure, folder)

    def _write_csv(self, path):
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["design", self.x_label, "low", "high", self.y_label, "low", "high"])
            for label, x, x_range, y, y_range, _ in self.rows:
                writer.writerow([label, x, *x_range, y, *y_range])


def _inline(svg, name):
    """Without the XML prologue and with names of its own, so that several fit into one page."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r'\bid="([^"]+)"', rf'id="{name}-\1"', svg)
    svg = re.sub(r'xlink:href="#([^"]+)"', rf'xlink:href="#{name}-\1"', svg)
    return re.sub(r"url\(#([^)]+)\)", rf"url(#{name}-\1)", svg)


def spectrum(time, values):
    """Frequencies [Hz] and amplitudes of a motion without its mean; Hann's window."""
    even = np.linspace(time[0], time[-1], len(time))
    signal = np.interp(even, time, values)
    window = np.hanning(len(signal))
    amplitude = 2 * np.abs(np.fft.rfft((signal - signal.mean()) * window)) / window.sum()
    return np.fft.rfftfreq(len(signal), even[1] - even[0]), amplitude
