#!/usr/bin/env python3
"""Paints still-life.json, lemons, a pear and plums in watercolour: paint_still_life.py [OUT.json]"""
import math
import random
import sys

from paintbox import (Painting, curve, edge, fade, feather, glaze, lerp, oval, placed, ramp, ryb, tapered, through,
                      uniform, wobbly)

PAPER = "#fdf9f1"
rng = random.Random(11)
p = Painting(1024, 768, PAPER, {"kind": "procedural", "seed": 5, "scale": 5, "strength": 0.36})

WASH = edge(0.62)           # a wash with its dark edge
SOFT_WASH = edge(0.8)       # the same with an edge that hardly shows
RICH = edge(0.8)            # one of more paint


def between(start, first, end, last):
    """Colours that run from point to point; each is ('#rrggbb', opacity)."""
    return start, end, ryb(*first), ryb(*last)


def hand(points, amount, length, seed):
    """The closed outline through the points, as of a hand that is not a machine."""
    return through(wobbly(curve(points, closed=True, step=0.7 * length), amount, length, seed), True)


def wash(name, outline, colour, s=6, style=WASH, granulation=0.6, **more):
    p.area(name, [outline], colour, spread=s, style=style, granulation=granulation, **more)


def reserve(outline):
    """Paper kept white, as with masking fluid; it ends within the outline, so that the wash over it covers its edge."""
    p.area("reserve", [outline], ryb(PAPER), spread=3, style=uniform(0.04, 0.75))


def spots(name, places, colour):
    """Touches of the brush's tip, in one stroke: (x, y, radius)."""
    p.area(name, [oval(*place, step=180) for place in places], colour, spread=1.2, style=uniform(0.1))


def light(x, y, radius, colour, turn=-35):
    """Where the light falls: the paint lifted out with a damp brush."""
    wash("light", oval(x, y, radius, 0.7 * radius, turn), colour, 0.62 * radius, feather(0.85, 1.2), 0.8)


def side(outline, x, y, start, end, depth, margin=0.05):
    """What of an outline lies between two angles (0 right, 90 down) seen from (x, y), `depth` of its radius deep."""
    ring = sorted((math.degrees(math.atan2(py - y, px - x)) % 360, math.dist((x, y), (px, py)))
                  for px, py in curve([c[0] for c in outline], closed=True))
    far = ramp(*[(a + k, r) for k in (-360, 0, 360) for a, r in ring])
    outer, inner = [], []
    for k in range(9):
        a = lerp(start, end, k / 8)
        at = lambda r: (x + r * far(a) * math.cos(math.radians(a)), y + r * far(a) * math.sin(math.radians(a)))
        outer.append(at(1 - margin))
        inner.append(at(1 - margin - depth * math.sin(math.pi * k / 8) ** 0.8))
    return through(outer) + through(inner[::-1])


def shade(outline, x, y, size, angles, thin, full, glow, beta=0.5, depth=0.6):
    """The side away from the light: a second wash, a wet core in it, and light that comes back from the cloth."""
    start, end = angles
    middle = math.radians((start + end) / 2)
    away = lambda r: (x + r * size * math.cos(middle), y + r * size * math.sin(middle))
    wash("form shadow", side(outline, x, y, start, end, depth), (away(0.1), away(0.9), fade(thin, 0), thin), 4.5,
         SOFT_WASH, mix=glaze(beta))
    wash("core shadow", side(outline, x, y, start + 22, end - 22, 0.2, 0.17),
         (away(0.2), away(0.8), fade(full, 0.5), full), 0.11 * size, feather(1.0, 1.2), 0.7, mix=glaze(beta))
    wash("light from the cloth", side(outline, x, y, start + 30, end - 24, 0.07, 0.05), glow, 3.5,
         feather(1.0, 1.2), 0.8)


def background():
    with p.group("background"):
        left = [(52, 60), (180, 44), (330, 52), (520, 38), (700, 50), (850, 40), (968, 56), (978, 200),
                      (966, 330), (974, 455),
                      (760, 462), (520, 456), (300, 464), (150, 456), (46, 466), (56, 330), (44, 190)]
        sheet = hand(left, 7, 34, 3)
        wash("first wash", sheet, between((130, 180), ("#3c4788", 0.88), (740, 330), ("#c6aec2", 0.42)), 11,
             edge(0.72), 0.45)
        wash("warm wash", sheet, between((500, 300), ("#e6c69a", 0.0), (960, 330), ("#dfae78", 0.62)), 11,
             edge(0.72), 0.45)
        for points, colour, s in (([(390, 90), (440, 200), (360, 250)], "#f3eef2", 24),
                                  ([(640, 230), (720, 250), (690, 330)], "#fbf1e6", 26),
                                  ([(880, 90), (930, 120), (900, 190)], "#fdf2e0", 22)):
            wash("backrun", hand(points, 14, 40, len(p.strokes)), ryb(colour, 0.36), s, feather(0.8, 1.3), 0.5)
        for name, points, colour, s in (
                ("bloom, indigo", [(90, 120), (150, 210), (120, 330), (190, 400)], ryb("#343f7c", 0.5), 44),
                ("bloom, blue", [(230, 90), (330, 130), (300, 220)], ryb("#4a5592", 0.4), 46),
                ("bloom, green", [(250, 300), (180, 360), (110, 410)], ryb("#4f7c86", 0.42), 38),
                ("bloom, mauve", [(470, 90), (560, 150), (640, 110)], ryb("#8d7ba0", 0.3), 48),
                ("bloom, rose", [(690, 170), (760, 110), (830, 160)], ryb("#cf9a92", 0.32), 44),
                ("bloom, ochre", [(850, 230), (910, 330), (880, 410)], ryb("#d79a4e", 0.38), 42),
                ("bloom, warm", [(780, 300), (730, 380)], ryb("#d8b27c", 0.34), 36)):
            p.line(name, points, s * 1.0, lambda x, y, c=colour: c, style=feather(1.6, 1.3), mix=glaze(0.75),
                   spread=s, granulation=0.75)


def cloth():
    with p.group("cloth"):
        sheet = hand([(48, 452), (200, 444), (420, 448), (640, 442), (830, 450), (976, 440), (984, 560), (958, 640),
                      (900, 712), (700, 728), (480, 718), (260, 730), (110, 712), (62, 640), (40, 540)], 6, 30, 9)
        reserve(sheet)
        wash("first wash", sheet, between((150, 460), ("#f7ead0", 0.8), (900, 700), ("#d8c2c4", 0.85)), 10,
             edge(0.7), 0.5)
        for name, points, w, colour in (
                ("fold", [(330, 724), (430, 700), (540, 704), (640, 718)], [2, 12, 15, 2], ryb("#9790b6", 0.44)),
                ("fold", [(690, 716), (800, 690), (900, 640), (960, 560)], [2, 16, 24, 3], ryb("#857cab", 0.46)),
                ("fold", [(900, 466), (925, 500), (970, 520)], [2, 12, 3], ryb("#a096b4", 0.4)),
                ("far edge in shade", [(60, 466), (260, 460), (470, 464), (700, 458), (960, 458)], [6, 12, 16, 12, 6],
                 ryb("#7f7fae", 0.4))):
            p.line(name, points, w, colour, style=feather(1.5, 1.2), mix=glaze(0.6), spread=17, granulation=0.45,
                   step=24)
        stripes()


def stripes():
    """The blue stripes woven into the cloth, which follow its folds."""
    for shift, w, opacity in ((0, 4.6, 0.72), (15, 1.7, 0.66), (-14, 1.7, 0.66)):
        blue = [ryb("#5448b4", k * opacity) for k in (1, 0.75, 1, 0.7, 0.5)]
        left = [(52, 634), (150, 622), (260, 634), (350, 662), (430, 696), (470, 714 - 0.6 * shift)]
        right = [(640, 720 - 1.3 * shift), (740, 712), (850, 680), (930, 632), (970, 596)]
        for way, widths, colours in ((left, (1, 1.1, 0.85, 1, 0.8, 0.4), blue),
                                     (right, (0.5, 1, 0.85, 1, 0.8), blue[::-1])):
            p.line("stripe", [(x, y + shift) for x, y in way], [w * k for k in widths], colours, style=edge(0.7),
                   mix=glaze(0.25), spread=w, granulation=0.5, step=20)


def shadow(name, points, start, first, end, last, s=8):
    """A cast shadow: a hard-edged wash that grows paler with its distance."""
    wash(name, hand(points, 3, 26, len(p.strokes)), between(start, first, end, last), s, edge(0.72), 0.5,
         mix=glaze(0.8))


def shadows():
    with p.group("cast shadows"):
        shadow("shadow of the bowl", [(350, 622), (480, 634), (600, 628), (720, 596), (830, 560), (870, 574),
                                      (850, 604), (730, 642), (600, 664), (470, 664), (380, 648)],
               (420, 0), ("#34387a", 0.85), (860, 0), ("#8579a6", 0.4), 7)
        shadow("shadow of the pear", [(762, 556), (860, 540), (940, 528), (962, 540), (940, 560), (860, 584),
                                      (790, 592)],
               (760, 0), ("#3c4078", 0.82), (960, 0), ("#8378a2", 0.4))
        p.line("wet shadow under the bowl", [(390, 634), (480, 644), (580, 642), (640, 632)], [4, 16, 16, 4],
               ryb("#37386a", 0.5), style=feather(1.4, 1.3), mix=glaze(0.7), spread=12, granulation=0.5)


LEMON = [(-1.14, 0.02), (-1.02, -0.13), (-0.74, -0.49), (-0.05, -0.74), (0.66, -0.52), (0.97, -0.18), (1.2, -0.05),
         (1.19, 0.07), (0.98, 0.2),
         (0.66, 0.55), (0, 0.75), (-0.7, 0.53), (-1.0, 0.17)]


def lemon(name, x, y, size, turn, mirror=False):
    with p.group(name):
        outline = through(placed(LEMON, x, y, size, turn, mirror), True)
        hx, hy = x - 0.32 * size, y - 0.3 * size
        reserve(outline)
        wash("first wash", outline, between((x - 0.5 * size, y - 0.5 * size), ("#fde23c", 1),
                                            (x + 0.6 * size, y + 0.6 * size), ("#f0a010", 1)), 6, RICH)
        shade(outline, x, y, size, (-40, 185), ryb("#d9861a", 0.8), ryb("#a8681e", 0.62), ryb("#ffd98a", 0.55))
        light(hx, hy, 0.34 * size, ryb("#fffbe2", 0.95))
        around = [(rng.uniform(-0.4, 3.0), rng.uniform(0.2, 0.6) * size) for _ in range(13)]
        spots("pores", [(x + r * math.cos(a), y + 0.62 * r * math.sin(a), rng.uniform(0.9, 1.5)) for a, r in around],
              ryb("#b97d16", 0.42))
        tip = placed([(1.17, 0.0)], x, y, size, turn, mirror)[0]
        p.dot("tip", tip[0], tip[1], 3.0, ryb("#8a6a24", 0.75), style=uniform(0.12))


def leaf(points, width, dark, light):
    """A leaf, its half in the shade (the other one, if its width is negative), and its vein left light."""
    whole, start, end = tapered(points, [0, 0.75 * width, width, 0]), points[0], points[-1]
    p.area("leaf", [whole], between(start, (dark, 0.95), end, (light, 0.95)), spread=2.5, style=edge(0.66),
           granulation=0.8)
    p.area("half in the shade", [whole[3:] + through(points)], ryb(dark, 0.5), spread=2, style=SOFT_WASH,
           mix=glaze(0.4), granulation=0.7)
    p.area("vein", [tapered(points, [1.3, 1.1, 0.8, 0])], ryb("#e9ecb4", 0.85), spread=1.2, style=uniform(0.1))


PEAR = [(0.02, -1.06), (0.2, -1.0), (0.31, -0.74), (0.37, -0.42), (0.57, -0.08), (0.74, 0.3), (0.7, 0.66),
        (0.46, 0.93), (0.08, 1.0), (-0.3, 0.97),
        (-0.63, 0.78), (-0.77, 0.4), (-0.66, 0.02), (-0.42, -0.34), (-0.28, -0.72), (-0.17, -0.99)]


def pear(x, y, size):
    with p.group("pear"):
        outline = through(placed(PEAR, x, y, size, 6), True)
        reserve(outline)
        wash("first wash", outline, between((x - 0.6 * size, y - 0.3 * size), ("#e6e06a", 0.95),
                                            (x + 0.6 * size, y + 0.7 * size), ("#8a9a30", 1)), 6.5, RICH, 0.55)
        p.line("blush", [(x + 0.1 * size, y - 0.5 * size), (x + 0.34 * size, y - 0.02 * size),
                         (x + 0.45 * size, y + 0.42 * size)], [6, 20, 16],
               ryb("#d0572f", 0.5), style=feather(1.5, 1.3), mix=glaze(0.45), spread=17, granulation=0.45)
        shade(outline, x, y + 0.25 * size, 0.85 * size, (-75, 170), ryb("#86953a", 0.75), ryb("#5f6430", 0.62),
              ryb("#e2dc86", 0.5))
        light(x - 0.28 * size, y + 0.16 * size, 0.34 * size, ryb("#fdfde0", 0.92), -70)
        light(x - 0.02 * size, y - 0.62 * size, 0.13 * size, ryb("#fbfbd8", 0.7), -75)
        around = [(rng.uniform(0, 6.28), rng.uniform(0.1, 0.55) * size) for _ in range(18)]
        spots("speckles", [(x + r * math.cos(a), y + 0.3 * size + r * math.sin(a), rng.uniform(0.9, 1.5))
                           for a, r in around], ryb("#6c5a24", 0.5))
        p.line("stem", [(x + 0.12 * size, y - 1.0 * size), (x + 0.17 * size, y - 1.2 * size),
                        (x + 0.32 * size, y - 1.38 * size)], [3.2, 2.4, 3.6],
               [ryb("#5f4327", 0.95), ryb("#3a2a1e", 0.95)], spread=2.8, step=3)
        p.line("hollow at the stem", [(x - 0.02 * size, y - 0.96 * size), (x + 0.12 * size, y - 0.93 * size),
                                      (x + 0.25 * size, y - 0.95 * size)], [0.4, 3, 0.4],
               ryb("#5b5c2a", 0.6), style=uniform(0.12), spread=3)


def plum(name, x, y, size, turn):
    with p.group(name):
        angles = [k * math.pi / 5 for k in range(10)]
        outline = through([(x + size * 1.04 * math.cos(a),
                            y + size * (0.93 * math.sin(a) + 0.05 * math.cos(2 * a + turn))) for a in angles], True)
        reserve(outline)
        wash("first wash", outline, between((x - 0.6 * size, y - 0.6 * size), ("#6f67b4", 1),
                                            (x + 0.5 * size, y + 0.6 * size), ("#32103e", 1)), 5, RICH, 0.5)
        shade(outline, x, y, size, (-50, 195), ryb("#42205e", 0.75), ryb("#221236", 0.75), ryb("#a85a86", 0.5), 0.35)
        light(x - 0.34 * size, y - 0.36 * size, 0.32 * size, ryb("#e4e8fa", 0.9))
        p.line("cleft", [(x - 0.1 * size, y - 0.9 * size), (x + 0.16 * size, y - 0.45 * size),
                         (x + 0.14 * size, y + 0.1 * size), (x - 0.02 * size, y + 0.5 * size)],
               [1.0, 2.2, 1.4, 0.3], ryb("#2c1840", 0.6), style=uniform(0.15), spread=2.4, step=4)
        p.line("bloom on the skin", [(x - 0.52 * size, y - 0.1 * size), (x - 0.4 * size, y - 0.42 * size),
                                     (x - 0.12 * size, y - 0.6 * size)], [3, 7, 3],
               ryb("#dfe2f2", 0.5), style=feather(1.5, 1.5), spread=7, granulation=0.3)
        p.line("stem", [(x - 0.08 * size, y - 0.86 * size), (x - 0.02 * size, y - 1.1 * size),
                        (x + 0.1 * size, y - 1.24 * size)], [2.2, 1.5, 2.2], ryb("#4a3524", 0.95), spread=1.8, step=3)


BOWL_X, RIM_Y, RIM_RX, RIM_RY = 452, 420, 206, 46


def profile(t, side):
    """A point of the bowl's wall: t from the rim (0) to the foot (1), side from left (-1) to right (1)."""
    half = lerp(RIM_RX, 82, 1 - math.sqrt(max(0.0, 1 - t ** 2.2)) * 0.98)
    sag = lerp(RIM_RY, 16, t)
    return (BOWL_X + half * side, RIM_Y + 196 * t + sag * math.sqrt(max(0.0, 1 - side * side)))


def bowl_back():
    with p.group("bowl, inside"):
        outline = oval(BOWL_X, RIM_Y, RIM_RX, RIM_RY)
        reserve(outline)
        wash("inside", outline, between((BOWL_X - 200, 0), ("#343c7c", 0.9), (BOWL_X + 200, 0), ("#a9abd0", 0.6)), 7,
             granulation=0.55)
        p.line("shade under the lemons", [(BOWL_X - 150, 432), (BOWL_X - 40, 440), (BOWL_X + 60, 442),
                                          (BOWL_X + 140, 434)], [4, 15, 15, 4],
               ryb("#22245a", 0.7), style=feather(1.4, 1.3), mix=glaze(0.5), spread=13, granulation=0.6)


def contact(x0, x1, y, sag, w=5):
    """The dark line where a thing stands on the cloth."""
    p.line("contact", [(x0, y), ((x0 + x1) / 2, y + sag), (x1, y)], [0.3, w, w, 0.3], ryb("#2a2850", 0.62),
           style=feather(1.2, 1.3), mix=glaze(0.5), spread=w, granulation=0.6, step=7)


def bowl_front():
    def wall(rim, top):
        """The outline from the rim's angle `rim` on; the wash leaves the rim's sharp horns out."""
        along = lambda t, angles: through([profile(t, math.cos(math.radians(a))) for a in angles])
        down = [lerp(top, 1, math.sin(k * math.pi / 12)) for k in range(7)]
        return (along(0, [lerp(180 - rim, rim, k / 8) for k in range(9)]) + through([profile(t, 1) for t in down])
                + along(1, [8, 50, 90, 130, 172]) + through([profile(t, -1) for t in down[::-1]]))

    with p.group("bowl"):
        foot_ring = [(BOWL_X - 84, 604), (BOWL_X + 84, 604)] + oval(BOWL_X, 624, 86, 20, start=0, end=180)
        reserve(foot_ring)
        wash("foot", foot_ring, between((BOWL_X - 80, 0), ("#c4c8e2", 0.75), (BOWL_X + 86, 0), ("#343c74", 0.95)), 4.5)
        reserve(wall(12, 0.04))
        outline = wall(25, 0.12)
        wash("first wash", outline, between((BOWL_X - 60, 470), ("#f4f3f4", 0.35), (BOWL_X + 210, 560),
                                            ("#545ca0", 0.9)))
        wash("shade on the left", outline, between((BOWL_X - 215, 500), ("#9da3cc", 0.7), (BOWL_X - 120, 520),
                                                   ("#e6e7f2", 0.0)), 6, SOFT_WASH)
        p.line("wet shade", [profile(t, s) for t, s in ((0.12, 0.82), (0.4, 0.76), (0.7, 0.62), (0.93, 0.3))],
               [8, 24, 24, 8], ryb("#3d478a", 0.4),
               style=feather(1.6, 1.3), mix=glaze(0.6), spread=22, granulation=0.5)
        p.line("light from the cloth", [profile(0.96, s) for s in (0.1, 0.4, 0.7, 0.92)], [3, 9, 8, 3],
               ryb("#e2b890", 0.4), style=feather(1.4, 1.3), spread=9, mix=glaze(0.6))
        decoration()


def cobalt(side, strength=1.0):
    """The glaze's blue, paler in the light and darker in the shade."""
    return ryb("#2c409c" if side < 0.4 else "#22307a", (0.72 + 0.2 * max(0.0, side)) * strength)


def petal(name, points, width, side):
    c = cobalt(side)
    p.area(name, [tapered(points, [0, width, 0])], fade(c, 0.95), spread=1.3, style=edge(0.68), mix=glaze(0.3),
           granulation=0.7)


def decoration():
    with p.group("cobalt painting"):
        wall = lambda t, a: profile(t, math.sin(math.radians(a)))
        for t, w, far in ((0.055, 3.2, 84), (0.115, 1.2, 84), (0.93, 1.5, 45), (0.98, 2.2, 38)):
            p.line("band", [wall(t, a) for a in range(-far, far + 1, far // 6)], [w, 0.8 * w, w, 1.1 * w, w],
                   [cobalt(-1, 0.85), cobalt(0, 0.7), cobalt(1)],
                   style=uniform(0.12), mix=glaze(0.75), spread=w, granulation=0.75, step=16)
        vine = [wall(0.46 + 0.12 * math.sin(math.radians(4.4 * a)), a) for a in range(-78, 79, 6)]
        p.line("vine", vine, [1.6, 1.2, 1.8, 1.2, 1.6], [cobalt(-1), cobalt(0), cobalt(1)], style=uniform(0.12),
               mix=glaze(0.75), spread=1.6, granulation=0.75, step=9)
        for k, a in enumerate(range(-72, 73, 12)):
            side = math.sin(math.radians(a))
            at = 0.46 + 0.12 * math.sin(math.radians(4.4 * a))
            up = -1 if k % 2 else 1
            wide = 5.4 * (0.45 + 0.55 * math.cos(math.radians(a)))
            petal("leaf", [wall(at, a), wall(at + up * 0.09, a + 3), wall(at + up * 0.22, a + 5)], wide, side)
            petal("leaf", [wall(at, a), wall(at + up * 0.05, a - 4), wall(at + up * 0.15, a - 8)], 0.75 * wide, side)
        for a in (-48, 0, 48):
            flower(wall, a)
        spots("dots", [(*wall(0.845, a), 2 + math.cos(math.radians(a))) for a in range(-60, 61, 10)],
              between((BOWL_X - 180, 0), ("#2c409c", 0.75), (BOWL_X + 180, 0), ("#22307a", 0.95)))


def flower(wall, a):
    squeeze = math.cos(math.radians(a))
    cx, cy = wall(0.47, a)
    for k in range(6):
        b = math.radians(60 * k + 20)
        reach = [(cx + r * squeeze * math.cos(b + bend), cy + r * math.sin(b + bend)) for r,
                 bend in ((4, 0), (13, 0.14), (23, 0))]
        petal("petal", reach, 6.6, math.sin(math.radians(a)))
    p.dot("heart", cx, cy, 3.6, ryb("#1c2f6c", 0.85), style=uniform(0.12), mix=glaze(0.6))


def half_lemon(x, y, rx, ry):
    with p.group("half lemon"):
        body = through([(x - 0.98 * rx, y + 0.1 * ry), (x - 0.8 * rx, y + 0.95 * ry), (x - 0.1 * rx, y + 1.42 * ry),
                        (x + 0.66 * rx, y + 1.06 * ry), (x + 0.99 * rx, y - 0.06 * ry), (x, y - 0.6 * ry)], True)
        cut = lambda k: oval(x, y, k * rx, k * ry, -8)
        reserve(body)
        wash("skin", body, between((x - rx, y), ("#fbdb50", 0.95), (x + rx, y + ry), ("#c08a24", 1)), 5)
        reserve(cut(1))
        wash("rind", cut(1), between((x - rx, y), ("#fbe67a", 0.85), (x + rx, y), ("#f0c53a", 0.9)), 4, edge(0.45), 0.7)
        reserve(cut(0.87))
        wedges = []
        for k in range(9):
            a, b = math.radians(40 * k + 3), math.radians(40 * k + 37)
            at = lambda r, t: (x + r * rx * math.cos(lerp(a, b, t)), y + r * ry * math.sin(lerp(a, b, t)))
            wedges.append(through([at(0.14, 0.5), at(0.5, 0.05), at(0.79, 0.07), at(0.84, 0.5), at(0.79, 0.93),
                                   at(0.5, 0.95)], True))
        p.area("flesh", wedges, between((x - rx, y - ry), ("#fde268", 1), (x + rx, y + ry), ("#f3b41e", 1)), spread=2.4,
               style=edge(0.7), granulation=0.75)
        light(x - 0.3 * rx, y - 0.3 * ry, 0.24 * rx, ryb("#fffdf0", 0.7))
        p.line("shade", [(x - 0.5 * rx, y + 1.12 * ry), (x, y + 1.26 * ry), (x + 0.6 * rx, y + 0.92 * ry)], [3, 8, 3],
               ryb("#9a7a30", 0.55), style=feather(1.3, 1.3), mix=glaze(0.5), spread=8, granulation=0.5)


def splashes():
    with p.group("splashes"):
        for x, y, r, c in ((92, 742, 4, "#5c66a4"), (112, 748, 2.2, "#5c66a4"), (936, 738, 4.6, "#d79a4e"),
                           (918, 750, 2.4, "#d79a4e"), (1000, 300, 3, "#d9ab78"),
                           (24, 280, 3.4, "#5c66a4"), (30, 296, 1.8, "#5c66a4"), (560, 746, 2.6, "#8d7ba0"),
                           (874, 22, 3, "#b9aebb"), (610, 20, 2.2, "#8d7ba0")):
            p.dot("splash", x, y, r, ryb(c, 0.55), style=edge(0.7), granulation=0.7)


background()
cloth()
shadows()
bowl_back()
with p.group("sprig"):
    leaf([(318, 372), (262, 330), (214, 318), (160, 336)], -17, "#3d6a34", "#93b04a")
    leaf([(560, 352), (612, 300), (660, 286), (716, 300)], 17, "#44703a", "#a3b850")
    leaf([(420, 300), (392, 250), (396, 206), (424, 168)], 15, "#4a7840", "#a2b854")
lemon("lemon at the back", 462, 336, 82, -14)
lemon("lemon on the left", 356, 384, 84, 24)
lemon("lemon on the right", 562, 386, 84, -32, True)
bowl_front()
contact(738, 880, 566, 14, 6)
pear(792, 470, 112)
with p.group("shadows in front"):
    shadow("shadow of the plums", [(600, 676), (690, 690), (790, 676), (850, 664), (870, 676), (820, 700), (720, 716),
                                   (620, 706)], (600, 0), ("#383468", 0.8), (870, 0), ("#8d80aa", 0.4), 7)
    shadow("shadow of the half lemon", [(190, 676), (260, 694), (330, 684), (400, 664), (410, 676), (350, 704),
                                        (260, 716), (200, 700)], (190, 0), ("#4c4880", 0.75), (400, 0),
           ("#9a8cb0", 0.4), 7)
contact(690, 790, 680, 12)
contact(600, 700, 696, 14)
contact(196, 340, 684, 16)
plum("plum", 724, 646, 46, 0.3)
plum("plum in front", 634, 660, 50, 1.2)
half_lemon(246, 640, 74, 42)
splashes()
p.write(sys.argv[1] if len(sys.argv) > 1 else "still-life.json")
