#!/usr/bin/env python3
"""Paints moonrise, a lake in the evening in washes:

    paint_moonrise.py OUT.json && suffuse-cli convert OUT.json moonrise.suffuse

Almost all of it is filled areas that spread: the sky leaves the moon out, mountains run into mist, and the letters are
washes, too. The letters come from the outlines of DejaVu Serif, as the Text tool makes them; this takes Debian's
packages python3-fonttools, libharfbuzz-bin and fonts-dejavu-core.
"""
import math
import random
import sys

from letters import lettered
from paintbox import Noise, Painting, edge, feather, lens, oval, paint, rectangle, through, uniform

WIDTH, HEIGHT = 840, 1120
WATER = 742  # where the lake begins
CRISP, WET, RIM = uniform(0.01), feather(1.0, 1.0), edge(0.72, 0.95)
rng = random.Random(11)
p = Painting(WIDTH, HEIGHT, "#f6efdf", {"kind": "procedural", "grain": "tooth", "seed": 5, "scale": 9, "strength": 0.5})


wash = p.washed


def ridge(base, height, length, seed, peaks=(), step=14):
    """A skyline from left to right: noise in octaves, and mountains (x, height, half-width) on it."""
    noise, out, x = Noise(seed), [], -60
    while x <= WIDTH + 60:
        y = sum(noise(x * 2 ** k / length, 7 * k) / 1.9 ** k for k in range(4))
        up = sum(h * max(0.0, 1 - abs(x - at) / half) ** 1.25 for at, h, half in peaks)
        out.append((x, base - height * (0.5 + 0.5 * y) - up * (1 + 0.10 * noise(x / 31, 40))))
        x += step * (0.75 + 0.5 * rng.random())
    return out


def mountain(name, skyline, foot, colours, **more):
    left, right = skyline[0][0], skyline[-1][0]
    wash(name, [through(skyline) + [(right, foot), (left, foot)]], colours, **more)


# ---------------------------------------------------------------- sky and moon

MOON = 588, 306, 92
with p.group("sky"):
    x, y, r = MOON
    frame = rectangle(-60, -60, WIDTH + 60, WATER + 40)
    wash("evening", [frame, oval(x, y, r)], ("#33507ef0", "#f0b9a020"),
         spread=9, rule="evenodd", granulation=0.35)
    wash("warm light", [oval(x + 10, 560, 560, 170)], "#f0a36f66", spread=90)
    wash("veil", [through([(-60, 150), (90, 128), (260, 160), (430, 118), (640, 150), (900, 108)])
                  + [(900, 178), (-60, 216)]], ("#f2cfc800", "#efc6bca8"), spread=30)
    wash("blue from above", [through([(-60, 96), (160, 118), (380, 70), (600, 92), (900, 44)])
                             + [(900, -60), (-60, -60)]], ("#1d2f60f0", "#3c4c8430"), spread=34, granulation=0.6)
with p.group("moon"):
    wash("halo", [oval(x, y, 1.5 * r)], "#fdf3d870", spread=46, granulation=1)
    wash("moon", [oval(x, y, r - 1)], ("#fdf4dcf0", "#f7d9a3f0"), 70, spread=2.2, granulation=0.8)
    for dx, dy, rx, ry, turn in ((-30, -22, 30, 22, -20), (18, 8, 36, 20, 30), (-12, 42, 22, 13, 10), (40, -38, 16, 12, 0)):
        wash("sea on the moon", [oval(x + dx, y + dy, rx, ry, turn)], "#d9a86b3c", spread=9, granulation=0.4)

# ---------------------------------------------------------------- mountains and mist

with p.group("mountains"):
    mountain("farthest", ridge(520, 70, 150, 3, ((170, 150, 150), (690, 90, 190))), 700, ("#7f88ace0", "#c9a7a600"),
             spread=3.5, style=RIM)
    wash("mist", [lens(300, 566, 520, 24)], "#f7e6d29c", spread=24)
    mountain("far", ridge(584, 74, 170, 21, ((330, 136, 170), (40, 60, 130))), 726, ("#55709bf0", "#b5a4ab00"),
             spread=3, style=RIM)
    wash("mist", [lens(560, 628, 560, 22)], "#f5e3d0a8", spread=22)
    mountain("middle", ridge(652, 70, 130, 34, ((700, 150, 200),)), 748, ("#33577ff4", "#8d94a530"), spread=2.6,
             style=RIM)
    wash("mist", [lens(240, 690, 560, 20)], "#f3e0ce9c", spread=20)
    mountain("near", ridge(716, 46, 90, 58, ((120, 96, 220), (860, 30, 160))), 752, ("#1f3f5ff8", "#3e5a70d0"),
             spread=2.2, style=RIM, granulation=0.45)

# ---------------------------------------------------------------- lake

with p.group("lake"):
    wash("water", [rectangle(-60, WATER, WIDTH + 60, HEIGHT + 60)], ("#c98f7c70", "#2c4a74f0"), spread=5,
         granulation=0.4)
    for name, skyline, colours in (
            ("near mountains, mirrored", [(-60, 752), (60, 806), (150, 838), (250, 800), (380, 770), (520, 764),
                                          (660, 772), (780, 796), (900, 782)], ("#2b4a68b0", "#3b567a00")),
            ("middle mountains, mirrored", [(380, 752), (500, 800), (610, 852), (690, 886), (760, 850), (900, 800)],
             ("#3d5f8578", "#4a658c00"))):
        wash(name, [through(skyline) + [(skyline[-1][0], WATER), (skyline[0][0], WATER)]], colours, spread=11)
    light = []
    y, k = WATER + 26.0, 0
    while y < 1010:
        deep = (y - WATER) / 270
        half = (20 + 66 * math.sin(math.pi * min(1, deep + 0.12)) ** 0.7) * rng.uniform(0.55, 1.0)
        light.append(lens(MOON[0] + rng.uniform(-14, 14) * (0.4 + deep), y, half, 1.6 + 2.6 * deep))
        y += 10 + 9 * deep
        k += 1
    wash("moonlight", light, ("#fbe6bce8", "#f6d8a470"), spread=1.8, granulation=0.7)
    wash("glow on the water", [oval(MOON[0], 872, 96, 130)], "#f8dca850", spread=36)
    ripples = []
    for _ in range(46):
        y = WATER + 24 + 330 * rng.random() ** 1.2
        near = (y - WATER) / 330
        ripples.append(lens(rng.uniform(-20, WIDTH + 20), y, (26 + 60 * near) * rng.uniform(0.5, 1), 0.8 + 1.3 * near))
    wash("ripples", ripples, ("#24456b70", "#16315680"), spread=1.4, granulation=0.8)

# ---------------------------------------------------------------- shore: pines, reeds, a boat

with p.group("boat"):
    bx, by = 250, 868
    wash("shadow", [lens(bx + 4, by + 13, 74, 5)], "#12263ea0", spread=5)
    wash("hull", [[[(bx - 66, by - 5), (bx - 30, by + 4), (bx + 30, by + 5), (bx + 72, by - 11)],
                   [(bx + 72, by - 11), (bx + 56, by + 9), (bx + 36, by + 12), (bx, by + 12)],
                   [(bx, by + 12), (bx - 34, by + 12), (bx - 54, by + 8), (bx - 66, by - 5)]]], ("#3a2a30", "#15202f"),
         spread=0.8, style=RIM)
    wash("someone", [[[(bx - 4, by + 2), (bx - 7, by - 18), (bx - 1, by - 27), (bx + 6, by - 26)],
                      [(bx + 6, by - 26), (bx + 15, by - 22), (bx + 16, by - 8), (bx + 15, by + 2)]]], "#241f2cf6",
         spread=0.8)
    wash("hat", [[[(bx - 12, by - 25), (bx, by - 33), (bx + 4, by - 39), (bx + 7, by - 40)],
                  [(bx + 7, by - 40), (bx + 10, by - 37), (bx + 17, by - 31), (bx + 24, by - 23)],
                  [(bx + 24, by - 23), (bx + 12, by - 26), (bx - 2, by - 27), (bx - 12, by - 25)]]], "#b9824ef4",
         spread=0.6, style=RIM)
    p.line("rod", [(bx + 14, by - 12), (bx + 54, by - 44), (bx + 92, by - 62)], [0.9, 0.7, 0.5], paint("#1c2230"),
           step=12)
    p.line("line", [(bx + 92, by - 62), (bx + 96, by - 24), (bx + 97, by + 10)], 0.35, paint("#1c223090"), step=14)


def pine(x, foot, height, lean, seed, tone):
    """A trunk and clouds of needles, each of them a wash with a dark rim."""
    noise, tufts = Noise(seed), []
    place = lambda t: (x + lean * height * t ** 1.6 + 7 * noise(3 * t), foot - height * t)
    p.line("trunk", [place(k / 8) for k in range(9)], [7.5, 6, 5, 4, 3, 2.2, 1.5, 1], paint("#2a2530"), step=9)
    for k in range(15):
        t = 0.30 + 0.70 * k / 14
        bx, by = place(t)
        reach = height * (0.27 - 0.19 * t) * (0.7 + 0.5 * rng.random())
        side = (1 if k % 2 else -1) * (1 - t) ** 0.5
        n, cx, cy = 12, bx + side * 0.8 * reach, by + 6 * rng.uniform(-1, 1)
        points = []
        for i in range(n):
            a = 2 * math.pi * i / n
            wide = 1 + 0.34 * noise(9 * t + 3 * math.cos(a), 3 * math.sin(a))
            deep = 0.13 if math.sin(a) > 0 else 0.32 # a flat foot, a round head
            points.append((cx + reach * wide * math.cos(a), cy + (deep * reach + 3) * wide * math.sin(a)
                           - 0.12 * reach * math.cos(a) * side))
        tufts.append(through(points, True))
    for k, tuft in enumerate(tufts):
        wash("needles", [tuft], tone[k % len(tone)], spread=2.4, style=edge(0.9, 0.95), granulation=0.8)


with p.group("shore"):
    bank = [(-60, 918), (20, 930), (70, 962), (128, 990), (170, 1040), (196, 1090), (214, 1180)]
    wash("bank", [through(bank) + [(-60, 1180)]], ("#22384a", "#0f1b2b"), spread=3, granulation=0.9)
    pine(20, 940, 268, -0.06, 83, (("#3c6663f4", "#254a50f8"), ("#335c5af4", "#1d4148f8")))
    pine(78, 968, 352, 0.15, 71, (("#1f4c4df8", "#10303cfc"), ("#2b5c55f8", "#173c44fc")))
    for k in range(26):
        x0 = 120 + 128 * k / 26 + rng.uniform(-8, 8)
        y0, h, bend = 1010 + 3.2 * k + rng.uniform(-6, 14), rng.uniform(44, 104), rng.uniform(-20, 34)
        p.line("reed", [(x0, y0), (x0 + 0.3 * bend, y0 - 0.6 * h), (x0 + bend, y0 - h)], [1.6, 1.1, 0.4],
               paint("#1b3338e0"), step=16)
with p.group("birds"):
    for bx, by, k in ((330, 282, 1.0), (374, 262, 0.8), (300, 254, 0.62), (414, 290, 0.55)):
        wash("bird", [[[(bx - 20 * k, by - 5 * k), (bx - 12 * k, by - 12 * k), (bx - 4 * k, by - 9 * k), (bx, by - k)],
                       [(bx, by - k), (bx + 6 * k, by - 12 * k), (bx + 13 * k, by - 13 * k), (bx + 21 * k, by - 7 * k)],
                       [(bx + 21 * k, by - 7 * k), (bx + 10 * k, by - 8 * k), (bx + 5 * k, by - 4 * k), (bx, by + 3 * k)],
                       [(bx, by + 3 * k), (bx - 4 * k, by - 4 * k), (bx - 11 * k, by - 7 * k), (bx - 20 * k, by - 5 * k)]]],
             "#20304ce8", spread=0.5, granulation=1)

# ---------------------------------------------------------------- letters

lettered(p, "title", "SUFFUSE", WIDTH / 2, 112, 72, spacing=0.26, colour=paint("#fff6e4"), spread=1.2, style=WET,
         granulation=0.8)
lettered(p, "line below", "washes that never dry out", WIDTH / 2, 152, 23, spacing=0.12, colour=paint("#f6e3cdf4"),
         spread=0.35, style=WET)

p.write(sys.argv[1] if len(sys.argv) > 1 else "moonrise.json")
