"""Draws parallel lines within areas."""

import math

import numpy as np
import suffuse
from suffuse import extension

WIND_NONZERO = 0  # as the column "rule" has it
POINTS = 24  # of a curve's polygon
MOST_LINES = 20000
LINE_SECONDS = 0.04  # between two lines, when the painting is played


def polygon_edges(segments):
    """The outline of a stroke as directed edges, (edges, 2, 2): curves as chords, and what closes each chain."""
    t = np.linspace(0, 1, POINTS + 1)[:, None]
    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3]
    edges = []
    first = np.ones(len(segments), bool)
    first[1:] = segments["start"][1:]
    begins = np.flatnonzero(first)
    for begin, end in zip(begins, [*begins[1:], len(segments)]):
        curves = segments["bezier"][begin:end].astype(float)
        points = np.concatenate([sum(w * p for w, p in zip(weights, curve)) for curve in curves])
        edges.append(np.stack([points, np.roll(points, -1, axis=0)], axis=1))
    return np.concatenate(edges)


def is_closed(segments):
    """Whether the first chain ends where it begins, or nearly so, as a hand closes it."""
    starts = np.flatnonzero(segments["start"][1:]) + 1
    end = starts[0] if len(starts) else len(segments)
    gap = np.linalg.norm(segments["bezier"][0, 0] - segments["bezier"][end - 1, 3])
    box = segments["bezier"].reshape(-1, 2)
    return gap <= 0.1 * np.linalg.norm(box.max(axis=0) - box.min(axis=0))


def spans_across(edges, y, nonzero):
    """Where the line at a height runs within the area, as pairs (from, to)."""
    (x0, y0), (x1, y1) = edges[:, 0].T, edges[:, 1].T
    crosses = (y0 <= y) != (y1 <= y)
    x = x0[crosses] + (y - y0[crosses]) * (x1[crosses] - x0[crosses]) / (y1[crosses] - y0[crosses])
    turns = np.where(y1[crosses] > y0[crosses], 1, -1)
    order = np.argsort(x)
    x, wind = x[order], np.cumsum(turns[order])
    inside = wind != 0 if nonzero else np.arange(1, len(x) + 1) % 2 == 1
    spans = []
    for k in np.flatnonzero(inside[:-1]):
        if spans and spans[-1][1] == x[k]:
            spans[-1] = (spans[-1][0], x[k + 1])
        else:
            spans.append((x[k], x[k + 1]))
    return spans


def hatch_lines(edges, nonzero, angle, values, random):
    """Lines as curves, (4, 2) each. They run to and fro, as a hand draws them."""
    cosine, sine = math.cos(angle), math.sin(angle)
    to_lines = np.array([[cosine, -sine], [sine, cosine]])  # of row vectors: turned back by the angle
    turned = edges @ to_lines
    gap, ragged, wobble = values["gap"], values["ragged"], values["wobble"]
    low, high = turned[..., 1].min(), turned[..., 1].max()
    if (high - low) / gap > MOST_LINES:
        extension.fail("These are too many lines. Choose a greater distance.")
    lines = []
    for k, y in enumerate(np.arange(low + gap / 2, high, gap)):
        spans = spans_across(turned, y + random.uniform(-0.15, 0.15) * min(wobble, gap), nonzero)
        for begin, end in spans if k % 2 == 0 else [(b, a) for a, b in reversed(spans)]:
            length = abs(end - begin)
            cut = min(ragged, 0.4 * length)
            toward = math.copysign(1, end - begin)
            begin, end = begin + toward * random.uniform(0, cut), end - toward * random.uniform(0, cut)
            if abs(end - begin) < 0.3 * gap:
                continue
            stray = random.normal(0, wobble, 4) * min(1, abs(end - begin) / (6 * gap))
            xs = begin + (end - begin) * np.array([0, 1 / 3, 2 / 3, 1])
            curve = np.stack([xs, y + stray * (0.3, 1, 1, 0.3)], axis=1)
            lines.append(curve @ to_lines.T)
    return lines


def line_colour(area, fill, values):
    if values["paint"] == "chosen":
        return values["colour"]
    colour = fill["colour"] if fill is not None else area["colour"][0]
    if values["paint"] == "area":
        return [float(c) for c in colour]
    dark = 0.45  # of the way to black, which is where all three are 1
    return [float(c) + dark * (1 - float(c)) for c in colour[:3]] + [max(float(colour[3]), 0.85)]


def with_pen(painting, ids, values):
    """The strokes as the pen draws them, in its width."""
    document = suffuse.Document(painting)
    document.select(ids)
    document.apply_brush(values["pen"], "form")
    document.apply_brush(values["pen"], "texture")
    painting = document.painting
    scale = values["width"] / 100
    if scale == 1:
        return painting
    segments = painting.segments.copy()
    drawn = np.isin(painting.strokes["id"][segments["stroke"]], ids)
    segments["diffusion"][drawn] *= scale * scale
    segments["density"][drawn] *= scale
    return painting.replaced(segments=segments)


def lines_of(painting, row, values, random):
    """A painting with the lines of an area, or None: which curves, when they are drawn, and in which colour."""
    stroke = painting.strokes[row]
    segments = painting.segments[painting.segments["stroke"] == row]
    fills = painting.fills[painting.fills["stroke"] == row]
    fill = fills[0] if len(fills) else None
    if fill is None and not is_closed(segments):
        return None
    edges = polygon_edges(segments) + stroke["origin"]
    nonzero = fill is not None and int(fill["rule"]) == WIND_NONZERO
    angle = math.radians(-values["angle"])  # y points down
    lines = hatch_lines(edges, nonzero, angle, values, random)
    if values["cross"]:
        lines += hatch_lines(edges, nonzero, angle + math.pi / 2, values, random)
    if not lines:
        return None
    made = suffuse.new_table("segments", len(lines))
    made["stroke"] = np.arange(len(lines))
    made["bezier"] = lines
    made["colour"] = line_colour(segments, fill, values)
    begin = max(float(segments["born"].max()), float(fill["born"]) if fill is not None else -math.inf)
    made["born"] = begin + LINE_SECONDS * np.arange(1, len(lines) + 1)
    return suffuse.Painting.from_tables(canvas=painting.canvas, segments=made)


def keep_in_group(document, line, around):
    """Puts the group of a line into the group that the area is in."""
    painting = document.painting
    groups = painting.groups.copy()
    own = painting.strokes["group"][painting.strokes["id"] == line][0]
    groups["parent"][groups["id"] == own] = around
    document.apply(painting.replaced(groups=groups), "Group")


def hatched(job):
    painting, values = job.painting, job.values
    random = np.random.default_rng(int(values["seed"]))
    document = suffuse.Document(painting)
    areas = count = 0
    for row, stroke in enumerate(painting.strokes):
        extension.progress(row / len(painting.strokes))
        lines = lines_of(painting, row, values, random)
        if lines is None:
            continue
        lines = with_pen(lines, [int(id) for id in lines.strokes["id"]], values)
        document.add(lines, select=True)
        new = document.selected_strokes
        above = painting.strokes["id"][row + 1] if row + 1 < len(painting.strokes) else 0
        document.reorder(int(above))
        name = str(stroke["name"])
        names = {"de": "Schraffur", "es": "Tramado", "fr": "Hachures", "ja": "ハッチング", "zh_CN": "排线"}
        group = names.get(job.language, "Hatching")
        document.group(group + (f" {name}" if name else ""))
        keep_in_group(document, int(new[0]), int(stroke["group"]))
        areas += 1
        count += len(new)
        if values["replace"]:
            document.select([int(stroke["id"])])
            document.delete()
    if not areas:
        extension.fail("None of the selected strokes is filled or closed, or the lines are too far apart for them.")
    extension.say(
        {
            "de": f"{count} Linien in {areas} Flächen",
            "fr": f"{count} lignes dans {areas} surfaces" if areas > 1 else f"{count} lignes",
            "es": f"{count} líneas en {areas} áreas" if areas > 1 else f"{count} líneas",
            "ja": f"{areas} 個の領域に線 {count} 本",
            "zh_CN": f"{areas} 个区域中的 {count} 条线",
        }.get(job.language, f"{count} lines in {areas} areas" if areas > 1 else f"{count} lines")
    )
    return document.painting


if __name__ == "__main__":
    job = extension.job()
    job.write(hatched(job))
