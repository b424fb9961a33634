"""Moves, turns, bends and scales strokes at random, and lets their paint vary."""

import math

import numpy as np
import suffuse
from suffuse import extension


def changed_strokes(job):
    """The selected strokes, or all; those that are locked or hidden stay as they are, and so do the letters of texts."""
    painting = job.painting
    groups = {int(group["id"]): group for group in painting.groups}
    texts = {int(group) for group in painting.texts["group"]}

    def is_open(stroke):
        if stroke["locked"] or not stroke["visible"]:
            return False
        group = int(stroke["group"])
        while group:
            if groups[group]["locked"] or not groups[group]["visible"] or group in texts:
                return False
            group = int(groups[group]["parent"])
        return True

    return [
        int(stroke["id"])
        for stroke in painting.strokes
        if is_open(stroke) and (not job.selection or int(stroke["id"]) in job.selection)
    ]


def bent(segments, rows, amount, random):
    """Moves each node, with its handles, so that chains stay whole and closed ones closed."""
    first = np.ones(len(rows), bool)
    first[1:] = segments["start"][rows[1:]]
    begins = np.flatnonzero(first)
    for begin, end in zip(begins, [*begins[1:], len(rows)]):
        chain = rows[begin:end]
        curves = segments["bezier"][chain]
        shifts = random.normal(0, amount, (len(chain) + 1, 2)).astype(np.float32)
        if np.array_equal(curves[0, 0], curves[-1, 3]):
            shifts[-1] = shifts[0]
        nodes = np.concatenate([curves[:, 0], curves[-1:, 3]]) + shifts
        curves[:, 1] += shifts[:-1]
        curves[:, 2] += shifts[1:]
        curves[:, 0], curves[:, 3] = nodes[:-1], nodes[1:]
        segments["bezier"][chain] = curves


def centres_of(painting):
    """The middle of each stroke's box."""
    segments, strokes = painting.segments, painting.strokes
    low = np.full((len(strokes), 2), np.inf)
    high = np.full((len(strokes), 2), -np.inf)
    np.minimum.at(low, segments["stroke"], segments["bezier"].min(axis=1))
    np.maximum.at(high, segments["stroke"], segments["bezier"].max(axis=1))
    return strokes["origin"] + (low + high) / 2


def jittered(job):
    painting, values = job.painting, job.values
    random = np.random.default_rng(int(values["seed"]))
    ids = changed_strokes(job)
    if not ids:
        extension.fail("Nothing that can be changed is selected.")
    row_of = {int(id): row for row, id in enumerate(painting.strokes["id"])}
    centres = centres_of(painting)
    document = suffuse.Document(painting)
    for k, id in enumerate(ids):
        if k % 50 == 0:
            extension.progress(0.8 * k / len(ids))
        dx, dy = random.normal(0, values["move"] / math.sqrt(2), 2) if values["move"] else (0.0, 0.0)
        angle = math.radians(random.uniform(-values["turn"], values["turn"]))
        scale = math.exp(random.normal(0, math.log1p(values["size"] / 100)))
        a, b = scale * math.cos(angle), scale * math.sin(angle)
        x, y = centres[row_of[id]]
        document.select([id])
        document.transform((a, -b, b, a, x + dx - a * x + b * y, y + dy - b * x - a * y), scale_spread=True)
    painting = document.painting

    segments, fills = painting.segments.copy(), painting.fills.copy()
    rows = np.argsort(segments["stroke"], kind="stable")
    spans = np.searchsorted(segments["stroke"][rows], np.arange(len(painting.strokes) + 1))
    factors = {
        name: np.exp(random.normal(0, np.log1p(values[name] / 100), len(painting.strokes))) for name in ("density", "diffusion")
    }
    chosen = np.zeros(len(painting.strokes), bool)
    chosen[[row_of[id] for id in ids]] = True
    for table in (segments, fills):
        for name, factor in factors.items():
            where = chosen[table["stroke"]]
            values_now = table[name][where] * factor[table["stroke"][where]]
            table[name][where] = np.clip(values_now, 1e-6, 1e12)
    if values["bend"]:
        for id in ids:
            row = row_of[id]
            bent(segments, rows[spans[row] : spans[row + 1]], values["bend"] / math.sqrt(2), random)
    extension.progress(1)
    return painting.replaced(segments=segments, fills=fills)


if __name__ == "__main__":
    job = extension.job()
    job.write(jittered(job))
