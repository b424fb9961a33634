#!/usr/bin/env python3
"""Writes a painting of many short strokes, as imports of diffusion curves give them, in the text form.

    import_curves.py CURVES.xml OUT.json [--strokes N] [--width UNITS]

CURVES.xml holds chains of cubic Bézier curves with colours on their left and on their right, as the diffusion curves of
Orzan et al. (2008) are stored. Each curve is cut into short pieces; a piece gives two strokes of four or five segments,
one at either side, so that together there are about N. A stroke spreads as far as its curve is blurred, and at least so
far that the two sides touch. Times of such a painting are what short strokes cost: few segments of a stroke can share
nodes, and every place is covered by many strokes.
"""
import argparse
import json
import math
import xml.etree.ElementTree as ElementTree

PARAMETERS_A_CUBIC = 10  # the "globalID" of colours and blurs counts tenths of a cubic


def ryb(red, green, blue):
    """About the pigments of a colour of light: white is none of them. Good to look at, no more is needed here."""
    white, black = min(red, green, blue), 1 - max(red, green, blue)
    red, green, blue = red - white, green - white, blue - white
    yellow = min(red, green)
    pigments = red - yellow, (green + yellow) / 2, (blue + green - yellow) / 2
    most = max(pigments)
    scale = max(red, green, blue) / most if most > 0 else 0
    return tuple(min(1, scale * p + black) for p in pigments)


def read_curves(path):
    """The size of the picture, and (control points, colours left, colours right, blurs) of each chain."""
    root = ElementTree.parse(path).getroot()

    def keyed(curve, name, value):
        return sorted((float(e.get("globalID")) / PARAMETERS_A_CUBIC, value(e)) for e in curve.iter(name))

    def colour(e):
        return ryb(*(float(e.get(c)) / 255 for c in "BGR"))  # as OpenCV orders them

    curves = []
    for curve in root.iter("curve"):
        # Rows come first.
        points = [(float(p.get("y")), float(p.get("x"))) for p in curve.iter("control_point")]
        left, right = keyed(curve, "left_color", colour), keyed(curve, "right_color", colour)
        blurs = keyed(curve, "best_scale", lambda e: (float(e.get("value")),))
        if len(points) >= 4 and left and right:
            curves.append((points, left, right, blurs or [(0.0, (0.0,))]))
    return float(root.get("image_width")), float(root.get("image_height")), curves


def between(keys, t):
    """Values at `t`, linear between sorted keys, constant beyond them."""
    if t <= keys[0][0]:
        return keys[0][1]
    for (a, u), (b, v) in zip(keys, keys[1:]):
        if t <= b:
            f = (t - a) / (b - a) if b > a else 1
            return tuple(x + f * (y - x) for x, y in zip(u, v))
    return keys[-1][1]


def at(points, t):
    """Place and unit normal of a chain at `t`, in cubics."""
    cubics = (len(points) - 1) // 3
    k = min(int(t), cubics - 1)
    t, u = t - k, 1 - (t - k)
    p = points[3 * k:3 * k + 4]
    place = [sum(w * q[c] for w, q in zip((u**3, 3 * u * u * t, 3 * u * t * t, t**3), p)) for c in (0, 1)]
    dx, dy = [sum(w * (q[c] - o[c]) for w, o, q in zip((u * u, 2 * u * t, t * t), p, p[1:])) for c in (0, 1)]
    length = math.hypot(dx, dy)
    return place, (-dy / length, dx / length) if length > 1e-9 else (0, 0)


def stroke(number, chain, side, begin, end, segments, scale):
    points, left, right, blurs = chain
    spread = max(1.5, between(blurs, (begin + end) / 2)[0] / 2) * scale
    colours = left if side < 0 else right
    nodes = []
    for i in range(segments + 1):
        (x, y), (nx, ny) = at(points, begin + (end - begin) * i / segments)
        nodes.append((scale * x + side * spread * nx, scale * y + side * spread * ny))
    parts = []
    for i, (a, b) in enumerate(zip(nodes, nodes[1:])):
        thirds = [[round(p + f * (q - p), 4) for p, q in zip(a, b)] for f in (0, 1 / 3, 2 / 3, 1)]
        colour = between(colours, begin + (end - begin) * (i + 0.5) / segments)
        parts.append({"bezier": thirds, "diffusion": round(spread * spread / 4, 4),
                      "density": round(1.1 * math.sqrt(math.pi) * spread, 4), "granulation": 1.0, "maxAge": 1.0,
                      "born": round(number / 100 + i / 1000, 3), "colour": [round(c, 4) for c in colour] + [1.0]})
    return {"id": number, "name": "", "group": None, "visible": True, "locked": False,
            "style": {"kind": "feathering", "xi": [1.1, 1.5]}, "mix": {"mode": "alpha"}, "segments": parts}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("curves")
    options.add_argument("out")
    options.add_argument("--strokes", type=int, default=8000)
    options.add_argument("--width", type=float, default=800)
    given = options.parse_args()
    width, height, chains = read_curves(given.curves)
    if not chains:
        options.error(f"{given.curves}: no curve with four points and colours on both sides")
    scale = given.width / width
    cubics = sum((len(points) - 1) // 3 for points, *_ in chains)
    strokes = []
    for chain in chains:
        length = (len(chain[0]) - 1) // 3
        pieces = max(1, round(given.strokes / 2 * length / cubics))
        for k in range(pieces):
            for side in (-1, 1):
                segments = 4 + (len(strokes) // 2) % 2
                strokes.append(stroke(len(strokes) + 1, chain, side, k * length / pieces, (k + 1) * length / pieces, segments, scale))
    painting = {"format": "suffuse-text", "version": 1,
                "canvas": {"width": given.width, "height": round(height * scale), "background": [0, 0, 0, 1],
                           "paper": {"kind": "none"}},
                "strokes": strokes}
    with open(given.out, "w", encoding="utf-8") as out:
        json.dump(painting, out, separators=(",", ":"))
    print(f"{given.out}: {len(strokes)} strokes, {sum(len(s['segments']) for s in strokes)} segments")


main()
