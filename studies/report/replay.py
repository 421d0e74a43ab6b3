"""The interactive replay of a report: packs the frames of runs for the script of the page."""

import base64
import json
import pathlib

import numpy as np

from markup import escaped

THREE = pathlib.Path("/usr/share/javascript/three")
HERE = pathlib.Path(__file__).resolve().parent
MOST_FRAMES = 41
MOST_POINTS = 12000
SURFACE_FIELDS = ("strain", "damage", "failed")


def _encoded(array):
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode()


def _quantised(values, low, high, kind):
    top = np.iinfo(kind).max
    share = (values - low) / np.where(high > low, high - low, 1)
    return np.round(np.clip(np.nan_to_num(share), 0, 1) * top).astype(kind)


def _chosen(count, most):
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(int))


def pack_run(frames):
    """Frames as replay.js expects them, in SI."""
    indices = _chosen(len(frames.names), MOST_FRAMES)
    groups = [frames.group(i) for i in indices]
    clouds = [name for name in groups[0] if all(name in group for group in groups)]
    places = {c: [np.asarray(g[c]["positions"], float) for g in groups] for c in clouds}
    low = np.min([p.min(axis=0) for c in clouds for p in places[c]], axis=0)
    high = np.max([p.max(axis=0) for c in clouds for p in places[c]], axis=0)
    packed = {"times": [float(t) for t in frames.times[indices]], "low": low.tolist(),
              "high": high.tolist(), "bodies": []}
    for cloud in clouds:
        triangles = frames.triangles(indices[0], cloud)
        is_surface = triangles.shape[1] == 3
        count = len(places[cloud][0])
        kept = np.arange(count) if is_surface else _chosen(count, MOST_POINTS)
        body = {"name": cloud, "points": len(kept), "of": count,
                "places": [_encoded(_quantised(p[kept], low, high, np.uint16)) for p in places[cloud]],
                "fields": {}}
        if is_surface:
            body["triangles"] = _encoded(triangles.astype(np.uint32))
        for name, values in _fields(groups, cloud, is_surface).items():
            values = [v[kept] for v in values]
            least, most = _range(name, values, groups, cloud)
            body["fields"][name] = {
                "low": float(least), "high": float(most),
                "values": [_encoded(_quantised(v, least, most, np.uint8)) for v in values]}
        packed["bodies"].append(body)
    return packed


def _range(name, values, groups, cloud):
    """Least and greatest value of points that have not failed; values of failed points mean nothing."""
    if name == "strain" and "failed" in groups[0][cloud]["fields"]:
        values = [v[np.asarray(g[cloud]["fields"]["failed"]) < 0.5] for v, g in zip(values, groups)]
        values = [v for v in values if len(v)] or [np.zeros(1)]
    least, most = min(map(np.min, values)), max(map(np.max, values))
    return (max(least, 0), most) if name == "strain" else (least, most)


def _fields(groups, cloud, is_surface):
    fields = {}
    available = groups[0][cloud]["fields"]
    for name in SURFACE_FIELDS if is_surface else ("pressure", "damage"):
        if name in available:
            fields[name] = [np.asarray(g[cloud]["fields"][name], float) for g in groups]
    if "velocity" in available:
        fields["speed"] = [np.linalg.norm(np.asarray(g[cloud]["fields"]["velocity"], float), axis=1)
                           for g in groups]
    return fields


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
