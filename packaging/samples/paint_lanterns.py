#!/usr/bin/env python3
"""Paints lanterns, a river at night in layers:

    paint_lanterns.py OUT.json && suffuse-cli convert OUT.json lanterns.suffuse

What groups can do carries it: the sky is one wash of many strokes, shade and ribs are clipped to the lanterns and
multiply them, their light is put on everything by screen, and a mask keeps the reflections in the water.
"""
import math
import random
import sys

from paintbox import Noise, Painting, edge, feather, lens, oval, paint, rectangle, tapered, through, uniform

WIDTH, HEIGHT = 840, 1120
WATER = 764
LANTERNS = ((580, 330, 118), (250, 476, 78), (722, 566, 46), (404, 634, 34)) # x, y and radius
CRISP, WET, RIM = uniform(0.01), feather(1.0, 1.0), edge(0.72, 0.95)
rng = random.Random(29)
p = Painting(WIDTH, HEIGHT, "#141a33", {"kind": "procedural", "grain": "tooth", "seed": 8, "scale": 8, "strength": 0.35})


area = p.washed


# ---------------------------------------------------------------- the sky: one wash of many strokes

SKY = (("#1b2450f0", 40, 96), ("#22306af4", 150, 92), ("#33407cf4", 262, 88), ("#5a5590f0", 366, 80),
       ("#8d6a94ee", 458, 72), ("#c98a86ea", 540, 62), ("#e9b184e8", 612, 54), ("#f0c690e4", 672, 44))
with p.group("sky, wet into wet", wash={"style": feather(1.1, 1.4), "mix": {"mode": "alpha"}}, tag="blue"):
    for k, (colour, y, width) in enumerate(SKY):
        noise = Noise(60 + k)
        points = [(x, y + 26 * noise(x / 260)) for x in range(-120, WIDTH + 121, 60)]
        p.line("passage", points if k % 2 else points[::-1], width, paint(colour), spread=0.9 * width, step=36,
               granulation=0.8)
    for x, y, r, colour in ((640, 226, 60, "#6a5c9cd8"), (540, 196, 44, "#5b5797c8"), (226, 322, 66, "#755f98d0"),
                            (120, 300, 46, "#675b98c4"), (720, 418, 52, "#b27c90c0"), (330, 476, 58, "#c58c8cb8")):
        p.line("cloud", [(x - 1.6 * r, y + 8), (x, y - 6), (x + 1.8 * r, y + 4)], r, paint(colour), spread=r, step=30,
               granulation=0.4)
with p.group("stars", blend="screen"):
    for _ in range(80):
        x, y = rng.uniform(0, WIDTH), 360 * rng.random() ** 1.4
        if any(math.hypot(x - cx, y - cy) < 1.1 * r for cx, cy, r in LANTERNS):
            continue
        p.dot("star", x, y, rng.choice((0.8, 1.0, 1.4)), paint("#fdf3d8c0"), granulation=1)

# ---------------------------------------------------------------- hills, and the last light clipped to them


def ridge(base, height, length, seed, step=16):
    noise, out, x = Noise(seed), [], -60
    while x <= WIDTH + 60:
        out.append((x, base - height * (0.5 + 0.5 * sum(noise(x * 2 ** k / length, 7 * k) / 2 ** k for k in range(3)))))
        x += step
    return out


with p.group("hills", isolated=True):
    for name, base, height, seed, colours in (("far", 690, 110, 4, ("#6d6591f4", "#a98a97d0")),
                                              ("middle", 728, 84, 17, ("#453f6cfa", "#6f5f85f0")),
                                              ("near", 766, 62, 41, ("#231f40ff", "#332a52ff"))):
        line = ridge(base, height, 190, seed)
        area(name, [through(line) + [(line[-1][0], WATER + 8), (line[0][0], WATER + 8)]], colours, spread=2.4,
             style=RIM, granulation=0.5)
with p.group("last light on the hills", clips=True, blend="screen", opacity=0.7):
    area("light", [oval(600, 640, 230, 120)], "#f2a066c0", spread=70, granulation=1)
    area("light", [oval(90, 700, 160, 80)], "#e58f7090", spread=60, granulation=1)

# ---------------------------------------------------------------- the river; a mask keeps in it what shines there

with p.group("river"):
    area("water", [rectangle(-60, WATER, WIDTH + 60, HEIGHT + 60)], ("#7c5f82ff", "#141a3cff"), spread=2,
         granulation=0.4)
    for _ in range(60):
        y = WATER + 10 + 350 * rng.random() ** 1.2
        near = (y - WATER) / 350
        area("ripple", [lens(rng.uniform(-20, WIDTH + 20), y, (26 + 76 * near) * rng.uniform(0.5, 1), 0.8 + 1.6 * near)],
             rng.choice(("#2b2c5c70", "#10142f80", "#94718c50")), spread=1.4, granulation=0.8)
with p.group("what shines in it", blend="screen", opacity=0.9):
    for x, y, r in LANTERNS:
        deep, k = WATER + 12 + 0.16 * r, 0
        while deep < WATER + 60 + 2.3 * r:
            t = (deep - WATER) / (60 + 2.3 * r)
            half = r * (0.62 - 0.30 * t) * rng.uniform(0.55, 1.05)
            area("shine", [lens(x + rng.uniform(-9, 9) * (0.3 + t), deep, half, 2 + 0.03 * r)],
                 rng.choice(("#ffb45cd0", "#ff9a44c4", "#ffcf80c8")), spread=1.8, granulation=0.7)
            deep += 8 + 0.05 * r + 6 * t
        area("glow", [oval(x, WATER + 40 + 0.9 * r, 0.8 * r, 1.3 * r)], "#ff9a4a60", spread=0.4 * r)
    with p.group("only where the water is", mask=True, tag="green"):
        area("water", [rectangle(-60, WATER + 3, WIDTH + 60, HEIGHT + 60)], "#000000ff", spread=3, granulation=1)

# ---------------------------------------------------------------- lanterns


def body(x, y, r):
    """A round paper lantern, a little flattened, with a mouth above and below."""
    return [oval(x, y, r, 0.86 * r)]


STEM = [(-40, 60), (120, 96), (280, 92), (430, 130), (600, 118), (760, 158), (880, 150)]


def on_stem(x):
    """The height of the branch at x, where the lanterns hang."""
    for (x0, y0), (x1, y1) in zip(STEM, STEM[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


for number, (x, y, r) in enumerate(LANTERNS):
    with p.group("lantern %d" % (number + 1)):
        top = on_stem(x + 10)
        p.line("cord", [(x + 10, top), (x + 3, (top + y - 0.9 * r) / 2), (x, y - 0.9 * r)], 0.006 * r + 0.7,
               paint("#0c0f22f0"), step=14)
        with p.group("paper", tag="orange"):
            area("paper", body(x, y, r), ("#f9a13cff", "#d8452eff"), spread=0.012 * r + 0.4, style=RIM, granulation=0.75)
        with p.group("shade and ribs", clips=True, blend="multiply", opacity=0.85):
            area("shade", [oval(x - 0.9 * r, y + 0.2 * r, 0.7 * r, 1.2 * r)], "#a03a3cb0", spread=0.28 * r)
            area("shade", [oval(x + 1.0 * r, y + 0.35 * r, 0.5 * r, 1.1 * r)], "#8c3040b8", spread=0.24 * r)
            for k in range(-4, 5):
                h = y + 0.19 * r * k
                p.line("rib", [(x - 1.15 * r, h - 0.05 * r), (x - 0.5 * r, h + 0.05 * r), (x + 0.5 * r, h + 0.05 * r),
                               (x + 1.15 * r, h - 0.05 * r)], 0.012 * r + 0.25, paint("#8a3a2ac0"), step=max(6, 0.12 * r))
        with p.group("light within", clips=True, blend="color-dodge", opacity=0.75):
            area("light", [oval(x + 0.05 * r, y + 0.08 * r, 0.42 * r, 0.40 * r)], "#c8a060c0", spread=0.34 * r,
                 granulation=1)
        with p.group("rims"):
            for top in (-1, 1):
                area("rim", [oval(x, y + 0.84 * top * r, 0.36 * r, 0.085 * r)], "#1a1428ff", spread=0.5, style=RIM)
            for k in range(5):
                dx = (k - 2) * 0.07 * r
                p.line("tassel", [(x + dx, y + 0.9 * r), (x + 1.3 * dx, y + 1.14 * r), (x + 1.1 * dx, y + 1.42 * r)],
                       [0.016 * r + 0.3, 0.02 * r + 0.3, 0.008 * r + 0.2], paint("#c23a2ef0"), step=10)
with p.group("their light", blend="screen", opacity=0.8, tag="yellow"):
    for x, y, r in LANTERNS:
        area("halo", [oval(x, y, 1.2 * r)], "#ff9a4070", spread=0.9 * r, granulation=1)

# ---------------------------------------------------------------- a branch before all

with p.group("branch"):
    area("stem", [tapered(STEM, [11, 9.5, 8, 6.5, 5, 3.6, 2.4])], "#0d1024ff", spread=0.8, style=RIM)
    for k in range(46):
        t = rng.random()
        i = min(int(t * (len(STEM) - 1)), len(STEM) - 2)
        f = t * (len(STEM) - 1) - i
        x, y = (STEM[i][c] * (1 - f) + STEM[i + 1][c] * f for c in (0, 1))
        turn, size = rng.uniform(20, 160), rng.uniform(20, 40)
        a = math.radians(turn)
        x, y = x + 0.9 * size * math.cos(a), y + 0.9 * size * math.sin(a)
        c, s = math.cos(a), math.sin(a)
        leaf = [tuple((x + c * u - s * v, y + s * u + c * v) for u, v in piece) for piece in lens(0, 0, size, 0.2 * size)]
        area("leaf", [leaf], rng.choice(("#12183af4", "#1b2046f0", "#0c1028f8", "#2a2850ec")), spread=0.7, style=RIM)

p.write(sys.argv[1] if len(sys.argv) > 1 else "lanterns.json")
