#!/usr/bin/python3
"""Draw the zona pellucida of a run at chosen times, seen from two sides.

    studies/report/render_zona.py RUN_DIRECTORY --times 0 10 20 40 --output zona.png

Reads `fields.h5`. Columns are instants (times in us, the nearest frame is taken), rows are views. The zona is
drawn as shaded triangles, failed points in red (or, with --field, any scalar of the zona in colour), the
pipette and the holding plate as shaded points. All lengths in the figure are in um.
"""

import argparse
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

MICRO = 1e6
INTACT = np.array([0.93, 0.80, 0.62])
FAILED = np.array([0.80, 0.07, 0.10])
PIPETTE = np.array([0.80, 0.83, 0.86])
PLATE = np.array([0.45, 0.60, 0.80])
LIGHT = np.array([-0.35, 0.55, 0.76])  # in the viewer's frame: right, up, towards the viewer


class View:
    """An orthographic view from a direction given by azimuth and elevation [degrees]."""

    def __init__(self, azimuth, elevation):
        azimuth, elevation = np.radians(azimuth), np.radians(elevation)
        towards = np.array([np.cos(elevation) * np.cos(azimuth),
                            np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
        self.axes = np.stack([right, np.cross(towards, right), towards])

    def project(self, points):
        """Coordinates to the right, upwards and towards the viewer."""
        return points @ self.axes.T


class Frame:
    """One stored instant; positions in um."""

    def __init__(self, file, name):
        self.file = file
        self.group = file["frames"][name]
        self.time = float(self.group.attrs["time"])

    def __contains__(self, cloud):
        return cloud in self.group

    def positions(self, cloud):
        return MICRO * np.asarray(self.group[cloud]["positions"], dtype=float)

    def triangles(self, cloud):
        topology = self.group[cloud].attrs["topology"]
        return np.asarray(self.file[topology.decode() if isinstance(topology, bytes) else topology])

    def field(self, cloud, field):
        fields = self.group[cloud]["fields"]
        if field not in fields:
            sys.exit(f"no field '{field}' of '{cloud}'; there are: {', '.join(fields)}")
        return np.asarray(fields[field])


def nearest_frames(file, times):
    """The frames nearest to the wanted times [us]; four spread evenly if none are given."""
    frames = [Frame(file, name) for name in file["frames"] if "time" in file["frames"][name].attrs]
    if not frames:
        sys.exit("no frames yet")
    stored = np.array([frame.time for frame in frames])
    if times is None:
        times = MICRO * np.linspace(stored[0], stored[-1], 4)
    chosen = [int(np.argmin(abs(stored - time / MICRO))) for time in times]
    return [frames[index] for index in dict.fromkeys(chosen)]


def shade(colours, normals):
    """Lambert's law with ambient light and a little gloss; colours and unit normals, one per row."""
    light = LIGHT / np.linalg.norm(LIGHT)
    diffuse = np.clip(normals @ light, 0, 1)
    half = light + np.array([0, 0, 1.0])
    gloss = np.clip(normals @ (half / np.linalg.norm(half)), 0, 1) ** 40
    return np.clip(colours * (0.42 + 0.62 * diffuse)[:, None] + 0.14 * gloss[:, None], 0, 1)


def vertex_normals(points, triangles):
    """Unit normals at the vertices, outwards for a closed surface around its centroid."""
    edges = points[triangles[:, 1:]] - points[triangles[:, :1]]
    faces = np.cross(edges[:, 0], edges[:, 1])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], faces)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    outwards = np.sum(normals * (points - points.mean(axis=0)))
    return normals if outwards >= 0 else -normals


def surface_polygons(frame, view, field, norm, colour_map):
    """Depths, polygons and colours of the zona's triangles that face the viewer."""
    points, triangles = frame.positions("zona"), frame.triangles("zona")
    normals = vertex_normals(points, triangles)
    seen, seen_normals = view.project(points), view.project(normals)
    if field:
        colours = colour_map(norm(frame.field("zona", field)))[:, :3]
    else:
        failed = np.clip(frame.field("zona", "failed"), 0, 1)[:, None]
        colours = INTACT * (1 - failed) + FAILED * failed
    face_normals = seen_normals[triangles].mean(axis=1)
    face_normals /= np.maximum(np.linalg.norm(face_normals, axis=1), 1e-300)[:, None]
    facing = face_normals[:, 2] > -0.15
    corners = seen[triangles[facing]]
    colours = shade(colours[triangles[facing]].mean(axis=1), face_normals[facing])
    return corners[:, :, 2].mean(axis=1), corners[:, :, :2], colours


def spacing_of(points):
    """Median distance of a point to the one nearest to it [um]."""
    sample = points[np.random.default_rng(1).choice(len(points), min(len(points), 200), False)]
    distances = np.linalg.norm(sample[:, None] - points[None], axis=2)
    distances[distances < 1e-9] = np.inf
    return float(np.median(distances.min(axis=1)))


def blurred(density, passes):
    """Repeated averaging with weights 1/4 1/2 1/4 along each axis; nothing beyond the edges."""
    for _ in range(passes):
        for axis in range(3):
            density = density / 2 + (np.roll(density, 1, axis) + np.roll(density, -1, axis)) / 4
    return density


def local_normals(points, spacing, reach=4):
    """Outward unit normals of a body of points: against the gradient of its blurred density."""
    margin = 2 * reach + 2
    cells = (points - points.min(axis=0)) / spacing + margin
    shape = np.ceil(cells.max(axis=0)).astype(int) + margin + 1
    nearest = np.round(cells).astype(int)
    density = np.zeros(shape)
    np.add.at(density, tuple(nearest.T), 1.0)
    gradient = np.stack(np.gradient(blurred(np.minimum(density, 1), reach**2)), axis=-1)
    corner = np.floor(cells).astype(int)
    weight = cells - corner
    normals = np.zeros_like(points)
    for offset in np.ndindex(2, 2, 2):
        share = np.prod(np.where(offset, weight, 1 - weight), axis=1)
        normals -= share[:, None] * gradient[tuple((corner + offset).T)]
    return normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def point_polygons(frame, view, cloud, colour):
    """Depths, polygons and colours of a body's points, each an octagon as wide as the spacing."""
    points = frame.positions(cloud)
    spacing = spacing_of(points)
    normals = view.project(local_normals(points, spacing))
    seen = view.project(points)
    facing = normals[:, 2] > -0.6
    angles = np.arange(8) * np.pi / 4 + np.pi / 8
    octagon = 0.75 * spacing * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    colours = shade(np.broadcast_to(colour, (facing.sum(), 3)), normals[facing])
    return seen[facing, 2], seen[facing, None, :2] + octagon, colours


def draw_panel(axes, frame, view, field, norm, colour_map):
    """Everything of one instant from one side, the farthest first."""
    parts = [surface_polygons(frame, view, field, norm, colour_map)]
    for cloud, colour in (("pipette", PIPETTE), ("plate", PLATE)):
        if cloud in frame:
            parts.append(point_polygons(frame, view, cloud, colour))
    depth = np.concatenate([part[0] for part in parts])
    polygons = [polygon for part in parts for polygon in part[1]]
    colours = np.concatenate([part[2] for part in parts])
    order = np.argsort(depth)
    axes.add_collection(PolyCollection([polygons[i] for i in order], facecolors=colours[order],
                                       edgecolors=colours[order], linewidths=0.4, rasterized=True))
    axes.set_aspect("equal")
    axes.axis("off")


def common_limits(frames, view, margin=0.03):
    """Bounds of the bodies over all frames, so that panels of a row compare."""
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    for frame in frames:
        for cloud in ("zona", "pipette", "plate"):
            if cloud in frame:
                seen = view.project(frame.positions(cloud))[:, :2]
                low, high = np.minimum(low, seen.min(axis=0)), np.maximum(high, seen.max(axis=0))
    pad = margin * (high - low).max()
    return low - pad, high + pad


def scale_bar(axes, low, high):
    """A bar of a round length, about a quarter of the panel, in its lower left corner."""
    width = high[0] - low[0]
    length = max(size for size in (1, 2, 5, 10, 20, 50, 100, 200, 500) if size <= max(1, width / 3.5))
    left, bottom = low[0] + 0.02 * width, low[1] + 0.01 * width
    axes.plot([left, left + length], [bottom, bottom], color="black", lw=2, solid_capstyle="butt")
    axes.text(left + length / 2, bottom + 0.015 * width, f"{length} µm", ha="center", va="bottom", fontsize=8)


def render(frames, views, field, output, dpi):
    limits = [common_limits(frames, view) for view in views]
    widest = max(high[0] - low[0] for low, high in limits)
    heights = [high[1] - low[1] for low, high in limits]
    panel = 2.5
    figure, panels = plt.subplots(
        len(views), len(frames), squeeze=False, gridspec_kw={"height_ratios": heights},
        figsize=(panel * len(frames) + (0.75 if field else 0), panel * sum(heights) / widest + 0.3))
    width, height = figure.get_size_inches()
    figure.subplots_adjust(0.005, 0.005, 1 - (0.75 / width if field else 0.005), 1 - 0.28 / height, 0.03, 0.04)
    norm, colour_map = None, plt.get_cmap("YlOrRd")
    if field:
        values = [frame.field("zona", field) for frame in frames]
        norm = plt.Normalize(min(v.min() for v in values), max(v.max() for v in values))
    for row, (view, (low, high)) in enumerate(zip(views, limits)):
        for column, frame in enumerate(frames):
            axes = panels[row, column]
            draw_panel(axes, frame, view, field, norm, colour_map)
            middle = (low[0] + high[0]) / 2
            axes.set_xlim(middle - widest / 2, middle + widest / 2)
            axes.set_ylim(low[1], high[1])
            if row == 0:
                axes.set_title(f"{MICRO * frame.time:.3g} µs", fontsize=10, pad=4)
            if column == 0:
                scale_bar(axes, (middle - widest / 2, low[1]), (middle + widest / 2, high[1]))
    if field:
        bar = figure.add_axes([1 - 0.68 / width, 0.25, 0.1 / width, 0.5])
        figure.colorbar(plt.cm.ScalarMappable(norm, colour_map), cax=bar).set_label(field, fontsize=8)
        bar.tick_params(labelsize=7)
    figure.savefig(output, dpi=dpi, facecolor="white")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("run", type=pathlib.Path, help="run directory")
    parser.add_argument("--times", type=float, nargs="+", help="[us]; default: four, evenly spread")
    parser.add_argument("--view", type=float, nargs=2, action="append", metavar=("AZIMUTH", "ELEVATION"),
                        help="[degrees]; once per row of panels; default: -60 22 and 35 30")
    parser.add_argument("--field", help="scalar of the zona to colour by, instead of failed points in red")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("zona.png"))
    parser.add_argument("--dpi", type=int, default=220)
    arguments = parser.parse_args()
    with h5py.File(arguments.run / "fields.h5", "r") as file:
        views = [View(*angles) for angles in arguments.view or [(-60, 22), (35, 30)]]
        render(nearest_frames(file, arguments.times), views, arguments.field, arguments.output,
               arguments.dpi)


if __name__ == "__main__":
    main()
