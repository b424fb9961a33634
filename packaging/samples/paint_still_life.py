#!/usr/bin/env python3
"""Paints still-life.json, lemons, a pear and plums in watercolour: paint_still_life.py [OUT.json]"""
import math
import random
import sys

from paintbox import (Noise, Painting, across, around, curve, edge, ellipse, fade, feather, glaze, inset, lerp,
                      placed, ryb, uniform, wobbly)

PAPER = "#fdf9f1"
rng = random.Random(11)
p = Painting(1024, 768, PAPER, {"kind": "procedural", "seed": 5, "scale": 5, "strength": 0.36})

WASH = edge(0.62)           # a wash with its dark edge
SOFT_WASH = edge(0.8)       # the same with an edge that hardly shows
WET = feather(1.15, 1.25)   # paint dropped into wet paper


def reserve(name, points):
    """Paper kept white, as with masking fluid."""
    p.fill(name, inset(points, 1.6), ryb(PAPER), s=4, style=uniform(0.03))


def clouded(field, amount, length, seed):
    """The colours of a field with the opacity of uneven pigment."""
    noise = Noise(seed)

    def at(x, y):
        u, v = x / length, y / length
        return fade(field(x, y), 1 + amount * (noise(u, v) + 0.5 * noise(2.3 * u, 2.3 * v)))

    return at


def crescent(outline, cx, cy, start, end, depth, margin=0.05):
    """The part of an outline between two angles (0 right, 90 down), as deep as `depth` of its radius."""
    polar = sorted((math.degrees(math.atan2(y - cy, x - cx)) % 360, x - cx, y - cy) for x, y in outline)
    bite = lambda a: depth * max(0.0, math.sin(math.pi * (a - start) / (end - start)))
    arc = [(a + k, x, y) for k in (-360, 0, 360) for a, x, y in polar
           if start <= a + k <= end and bite(a + k) > 0.3 * depth]
    outer = [(cx + (1 - margin) * x, cy + (1 - margin) * y) for _, x, y in arc]
    inner = [(cx + (1 - margin - bite(a)) * x, cy + (1 - margin - bite(a)) * y) for a, x, y in arc]
    return outer + inner[::-1]


def shade(outline, x, y, light, size, start, end, depth, colours, s=4, beta=0.5, seed=7):
    """The side away from the light: a second wash that grows darker away from `light`, and a wet core."""
    part = crescent(outline, x, y, start, end, depth)
    thin, full, far = colours
    dark = around(*light, size, size, [(0.85, fade(thin, 0.3)), (1.15, thin), (1.4, full), (1.9, far)])

    def field(px, py):
        a = math.degrees(math.atan2(py - y, px - x))
        t = ((a - start) % 360) / (end - start)
        return fade(dark(px, py), 1.5 * math.sin(math.pi * min(1.0, t)) ** 1.5)

    p.fill("form shadow", part, clouded(field, 0.12, 24, seed), s=s, style=SOFT_WASH, mix=glaze(beta),
           granulation=0.6, piece=1.5 * s)
    third = (end - start) / 3
    middle = crescent(outline, x, y, start + 0.55 * third, end - 0.55 * third, 0.16, 0.2)
    core = middle[:len(middle) // 2 + 1]
    w = 0.16 * size
    p.line("core shadow", core[::max(1, len(core) // 6)], [0.3 * w, w, w, 0.3 * w], fade(full, 0.75),
           style=feather(1.5, 1.3), mix=glaze(beta), spread=w, granulation=0.7)


def background():
    with p.group("background"):
        left = curve([(52, 60), (180, 44), (330, 52), (520, 38), (700, 50), (850, 40), (968, 56), (978, 200),
                      (966, 330), (974, 455),
                      (760, 462), (520, 456), (300, 464), (150, 456), (46, 466), (56, 330), (44, 190)], closed=True,
                     step=8)
        tone = across(80, 120, 960, 420, [(0, ryb("#4c568e", 0.8)), (0.3, ryb("#6d74a8", 0.7)),
                                          (0.55, ryb("#ab9bb4", 0.55)),
                                           (0.8, ryb("#e0c3a0", 0.52)), (1, ryb("#d9ab78", 0.6))])
        p.fill("first wash", wobbly(left, 7, 34, 3), clouded(tone, 0.22, 90, 21), s=12, style=edge(0.72),
               granulation=0.45, piece=26)
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
        sheet = curve([(48, 452), (200, 444), (420, 448), (640, 442), (830, 450), (976, 440), (984, 560), (958, 640),
                       (900, 712), (700, 728),
                       (480, 718), (260, 730), (110, 712), (62, 640), (40, 540)], closed=True, step=8)
        reserve("reserved sheet", sheet)
        tone = across(120, 460, 900, 720, [(0, ryb("#f3e6cf", 0.75)), (0.5, ryb("#efe0cc", 0.7)),
                                           (1, ryb("#dccbc2", 0.8))])
        p.fill("first wash", wobbly(sheet, 6, 30, 9), clouded(tone, 0.2, 80, 33), s=11, style=edge(0.7),
               granulation=0.5, piece=26)
        for name, points, w, colour in (
                ("fold", [(330, 724), (430, 700), (540, 704), (640, 718)], [2, 12, 15, 2], ryb("#9790b6", 0.44)),
                ("fold", [(690, 716), (800, 690), (900, 640), (960, 560)], [2, 16, 24, 3], ryb("#857cab", 0.46)),
                ("fold", [(900, 466), (925, 500), (970, 520)], [2, 12, 3], ryb("#a096b4", 0.4)),
                ("far edge in shade", [(60, 466), (260, 460), (470, 464), (700, 458), (960, 458)], [6, 12, 16, 12, 6],
                 ryb("#7f7fae", 0.4))):
            p.line(name, points, w, colour, style=feather(1.5, 1.2), mix=glaze(0.6), spread=17, granulation=0.45)
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
                   mix=glaze(0.25), spread=w, granulation=0.5, step=8)


def shadow(name, points, colours, s=10):
    """A cast shadow: a hard-edged wash, and something wetter where it meets the thing."""
    p.fill(name, wobbly(points, 3, 26, len(p.strokes)), clouded(colours, 0.12, 50, len(p.strokes)), s=s,
           style=edge(0.72), mix=glaze(0.8), granulation=0.5, piece=20)


def shadows():
    with p.group("cast shadows"):
        violet = across(420, 0, 900, 0, [(0, ryb("#3c3f7c", 0.78)), (0.5, ryb("#5a568f", 0.62)),
                                         (1, ryb("#8579a6", 0.42))])
        shadow("shadow of the bowl", curve([(350, 622), (480, 634), (600, 628), (720, 596), (830, 560), (870, 574),
                                            (850, 604), (730, 642),
                                            (600, 664), (470, 664), (380, 648)], closed=True, step=8), violet, s=7)
        shadow("shadow of the pear", curve([(762, 556), (860, 540), (940, 528), (962, 540), (940, 560), (860, 584),
                                            (790, 592)], closed=True, step=8),
               across(760, 0, 960, 0, [(0, ryb("#43467c", 0.76)), (1, ryb("#8378a2", 0.44))]), s=8)
        p.line("wet shadow under the bowl", [(390, 634), (480, 644), (580, 642), (640, 632)], [4, 16, 16, 4],
               ryb("#37386a", 0.5), style=feather(1.4, 1.3), mix=glaze(0.7), spread=12, granulation=0.5)


LEMON = [(-1.14, 0.02), (-1.02, -0.13), (-0.74, -0.49), (-0.05, -0.74), (0.66, -0.52), (0.97, -0.18), (1.2, -0.05),
         (1.19, 0.07), (0.98, 0.2),
         (0.66, 0.55), (0, 0.75), (-0.7, 0.53), (-1.0, 0.17)]


def lemon(name, x, y, size, turn, mirror=False):
    with p.group(name):
        outline = curve(placed(LEMON, x, y, size, turn, mirror), closed=True, step=5)
        reserve("reserve", outline)
        hx, hy = x - 0.34 * size, y - 0.32 * size
        skin = around(hx, hy, 1.5 * size, 1.25 * size, [
            (0, ryb("#fff6bd", 0.1)), (0.14, ryb("#fff1a0", 0.45)), (0.32, ryb("#fad830", 1)),
            (0.65, ryb("#f3b81a", 1)), (1, ryb("#dc9014", 1))])
        p.fill("first wash", wobbly(outline, 1.2, 20, x), clouded(skin, 0.07, 22, 5), s=6, style=WASH,
               granulation=0.6, piece=9)
        shade(outline, x, y, (hx, hy), 0.8 * size, -50, 195, 0.6,
              (ryb("#e2a428", 0.5), ryb("#bd8630", 0.62), ryb("#a38a48", 0.6)))
        for _ in range(13):
            a, r = rng.uniform(-0.4, 3.0), rng.uniform(0.2, 0.6)
            p.dot("pore", x + r * size * math.cos(a), y + 0.62 * r * size * math.sin(a), rng.uniform(1.0, 1.7),
                  ryb("#c98f1e", 0.32), style=uniform(0.1))
        tip = placed([(1.17, 0.0)], x, y, size, turn, mirror)[0]
        p.dot("tip", tip[0], tip[1], 3.0, ryb("#8a6a24", 0.75), style=uniform(0.12))


def leaf(name, points, width, dark="#2f6148", light="#7fa05a", opacity=0.9):
    """A leaf in two strokes, and its vein left light."""
    body = [0.3, 0.75 * width, width, 0.85 * width, 0.45 * width, 0.3]
    p.line(name, points, body, [ryb(light, opacity), ryb(dark, opacity), ryb(dark, opacity * 0.9),
                                ryb(light, opacity)], style=edge(0.66), follow=True, granulation=0.8, step=4)
    p.line(name + ", vein", points, [0.9, 1.1, 0.5], ryb("#e3e3ae", 0.75), spread=1.3, step=7)


PEAR = [(0.02, -1.06), (0.2, -1.0), (0.31, -0.74), (0.37, -0.42), (0.57, -0.08), (0.74, 0.3), (0.7, 0.66),
        (0.46, 0.93), (0.08, 1.0), (-0.3, 0.97),
        (-0.63, 0.78), (-0.77, 0.4), (-0.66, 0.02), (-0.42, -0.34), (-0.28, -0.72), (-0.17, -0.99)]


def pear(x, y, size):
    with p.group("pear"):
        outline = curve(placed(PEAR, x, y, size, 6), closed=True, step=5)
        reserve("reserve", outline)
        body = around(x - 0.26 * size, y + 0.2 * size, 1.05 * size, 1.35 * size, [
            (0, ryb("#fdfbd2", 0.12)), (0.13, ryb("#f3efa0", 0.5)), (0.3, ryb("#d6d44e", 0.95)),
            (0.6, ryb("#aeb63a", 1)), (1, ryb("#7f8f30", 1))])
        p.fill("first wash", wobbly(outline, 1.2, 22, 41), clouded(body, 0.08, 24, 15), s=6.5, style=WASH,
               granulation=0.55, piece=10)
        p.line("blush", [(x + 0.1 * size, y - 0.5 * size), (x + 0.34 * size, y - 0.02 * size),
                         (x + 0.45 * size, y + 0.42 * size)], [6, 20, 16],
               ryb("#d0572f", 0.5), style=feather(1.5, 1.3), mix=glaze(0.45), spread=17, granulation=0.45)
        shade(outline, x, y + 0.25 * size, (x - 0.26 * size, y + 0.1 * size), 0.72 * size, -110, 180, 0.5,
              (ryb("#9aa23c", 0.4), ryb("#6f7430", 0.6), ryb("#6d5c48", 0.6)))
        for _ in range(16):
            a, r = rng.uniform(0, 6.28), rng.uniform(0.1, 0.55)
            p.dot("speckle", x + r * size * math.cos(a), y + 0.3 * size + r * size * math.sin(a),
                  rng.uniform(1.0, 1.7), ryb("#7c6a2c", 0.5), style=uniform(0.1))
        p.line("stem", [(x + 0.12 * size, y - 1.0 * size), (x + 0.17 * size, y - 1.2 * size),
                        (x + 0.32 * size, y - 1.38 * size)], [3.2, 2.4, 3.6],
               [ryb("#5f4327", 0.95), ryb("#3a2a1e", 0.95)], spread=2.8, step=3)
        p.line("hollow at the stem", [(x - 0.02 * size, y - 0.96 * size), (x + 0.12 * size, y - 0.93 * size),
                                      (x + 0.25 * size, y - 0.95 * size)], [0.4, 3, 0.4],
               ryb("#5b5c2a", 0.6), style=uniform(0.12), spread=3)


def plum(name, x, y, size, turn):
    with p.group(name):
        angles = [k * math.pi / 7 for k in range(14)]
        outline = curve([(x + size * 1.04 * math.cos(a),
                          y + size * 0.93 * math.sin(a) + 0.05 * size * math.cos(2 * a + turn)) for a in angles],
                        closed=True, step=4)
        reserve("reserve", outline)
        skin = around(x - 0.34 * size, y - 0.36 * size, 1.6 * size, 1.5 * size, [
            (0, ryb("#b9bfe0", 0.35)), (0.14, ryb("#7f78bc", 0.8)), (0.38, ryb("#5a3a80", 1)),
            (0.75, ryb("#45204f", 1)), (1, ryb("#6c2a52", 1))])
        p.fill("first wash", wobbly(outline, 1.0, 18, x), clouded(skin, 0.1, 18, 25), s=5, style=edge(0.72),
               granulation=0.5, piece=8)
        shade(outline, x, y, (x - 0.34 * size, y - 0.36 * size), 0.85 * size, -60, 205, 0.55,
              (ryb("#4a2a66", 0.5), ryb("#2c1840", 0.75), ryb("#4d2448", 0.5)), s=5, beta=0.35)
        p.line("cleft", [(x - 0.1 * size, y - 0.9 * size), (x + 0.16 * size, y - 0.45 * size),
                         (x + 0.14 * size, y + 0.1 * size), (x - 0.02 * size, y + 0.5 * size)],
               [1.0, 2.2, 1.4, 0.3], ryb("#2c1840", 0.6), style=uniform(0.15), spread=2.4)
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
        outline = ellipse(BOWL_X, RIM_Y, RIM_RX, RIM_RY)
        reserve("reserve", outline)
        p.fill("inside", outline, clouded(across(BOWL_X - 200, 0, BOWL_X + 200, 0, [
            (0, ryb("#3f4680", 0.85)), (0.5, ryb("#5c629a", 0.75)), (1, ryb("#9c9cc0", 0.55))]), 0.12, 40, 51), s=8,
               style=WASH, granulation=0.55, piece=14)
        p.line("shade under the lemons", [(BOWL_X - 150, 432), (BOWL_X - 40, 440), (BOWL_X + 60, 442),
                                          (BOWL_X + 140, 434)], [4, 15, 15, 4],
               ryb("#2a2a5e", 0.62), style=feather(1.4, 1.3), mix=glaze(0.5), spread=13, granulation=0.6)


def contact(x0, x1, y, sag, w=5):
    """The dark line where a thing stands on the cloth."""
    p.line("contact", [(x0, y), ((x0 + x1) / 2, y + sag), (x1, y)], [0.3, w, w, 0.3], ryb("#2a2850", 0.62),
           style=feather(1.2, 1.3), mix=glaze(0.5), spread=w, granulation=0.6)


def bowl_front():
    def wall(first, rim):
        """The outline from the rim's angle `rim` on; the wash leaves the rim's sharp horns out."""
        front = [profile(0, math.cos(math.radians(a))) for a in range(180 - rim, rim - 1, -4)]
        foot = [profile(1, math.cos(math.radians(a))) for a in range(8, 173, 8)]
        right = [profile(k / 24, 1) for k in range(first, 25)]
        left = [profile(k / 24, -1) for k in range(24, first - 1, -1)]
        return front + right + foot + left

    outline = wall(3, 25)
    with p.group("bowl"):
        foot_ring = [(BOWL_X - 84, 604), (BOWL_X + 84, 604)] + ellipse(BOWL_X, 624, 86, 20, start=0, end=180)
        reserve("reserve of the foot", foot_ring)
        p.fill("foot", foot_ring, across(BOWL_X - 90, 0, BOWL_X + 90, 0,
                                         [(0, ryb("#b4b8d6", 0.7)), (0.3, ryb("#8088b8", 0.75)),
                                          (1, ryb("#40487e", 0.9))]), s=4.5, style=WASH, granulation=0.6, piece=8)
        reserve("reserve", wall(1, 12))
        porcelain = across(BOWL_X - 210, 470, BOWL_X + 190, 560, [
            (0, ryb("#b9bcdc", 0.5)), (0.2, ryb("#f1f0f2", 0.35)), (0.42, ryb("#d3d6ea", 0.5)),
            (0.72, ryb("#8f95c2", 0.7)), (0.93, ryb("#6068a4", 0.82)), (1, ryb("#8583b0", 0.75))])
        p.fill("first wash", outline, clouded(porcelain, 0.08, 50, 53), s=6, style=WASH, granulation=0.6, piece=14)
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
    p.line(name, points, [0.3, width, 0.85 * width, 0.3], [fade(c, 0.7), c, c], style=edge(0.68), mix=glaze(0.3),
           spread=0.85 * width, granulation=0.7, step=4)


def decoration():
    with p.group("cobalt painting"):
        wall = lambda t, a: profile(t, math.sin(math.radians(a)))
        for t, w, far in ((0.055, 3.2, 84), (0.115, 1.2, 84), (0.93, 1.5, 57), (0.98, 2.2, 45)):
            p.line("band", [wall(t, a) for a in range(-far, far + 1, far // 6)], [w, 0.8 * w, w, 1.1 * w, w],
                   [cobalt(-1, 0.85), cobalt(0, 0.7), cobalt(1)],
                   style=uniform(0.12), mix=glaze(0.75), spread=w, granulation=0.75, step=10)
        vine = [wall(0.46 + 0.12 * math.sin(math.radians(4.4 * a)), a) for a in range(-78, 79, 6)]
        p.line("vine", vine, [1.6, 1.2, 1.8, 1.2, 1.6], [cobalt(-1), cobalt(0), cobalt(1)], style=uniform(0.12),
               mix=glaze(0.75), spread=1.6, granulation=0.75, step=6)
        for k, a in enumerate(range(-72, 73, 12)):
            side = math.sin(math.radians(a))
            at = 0.46 + 0.12 * math.sin(math.radians(4.4 * a))
            up = -1 if k % 2 else 1
            wide = 5.4 * (0.45 + 0.55 * math.cos(math.radians(a)))
            petal("leaf", [wall(at, a), wall(at + up * 0.09, a + 3), wall(at + up * 0.22, a + 5)], wide, side)
            petal("leaf", [wall(at, a), wall(at + up * 0.05, a - 4), wall(at + up * 0.15, a - 8)], 0.75 * wide, side)
        for a in (-48, 0, 48):
            flower(wall, a)
        for a in range(-60, 61, 10):
            x, y = wall(0.845, a)
            p.dot("dot", x, y, 2.1 + 0.9 * math.cos(math.radians(a)), cobalt(math.sin(math.radians(a))),
                  style=uniform(0.12), mix=glaze(0.75))


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
        rind = ellipse(x, y, rx, ry, turn=-8)
        body = curve([(x - 0.98 * rx, y + 0.1 * ry), (x - 0.8 * rx, y + 0.95 * ry), (x - 0.1 * rx, y + 1.42 * ry),
                      (x + 0.66 * rx, y + 1.06 * ry),
                      (x + 0.99 * rx, y - 0.06 * ry), (x, y - 0.6 * ry)], closed=True, step=4)
        reserve("reserve", body)
        p.fill("skin", body, across(x - rx, y, x + rx, y + ry, [(0, ryb("#f9d64a", 0.9)), (0.6, ryb("#eeb524", 0.95)),
            (1, ryb("#b98a2c", 0.95))]), s=5, style=WASH, granulation=0.6, piece=8)
        reserve("reserve of the cut", rind)
        p.fill("rind", rind, ryb("#f8dd5c", 0.75), s=4, style=edge(0.45), granulation=0.7)
        reserve("pith", ellipse(x, y, 0.88 * rx, 0.86 * ry, turn=-8))
        for k in range(9):
            a0, a1 = math.radians(40 * k + 6), math.radians(40 * k + 35)
            wedge = [(0.10 * math.cos((a0 + a1) / 2), 0.10 * math.sin((a0 + a1) / 2))]
            wedge += [(0.80 * math.cos(lerp(a0, a1, t / 6)), 0.80 * math.sin(lerp(a0, a1, t / 6))) for t in range(7)]
            flesh = placed([(q[0] * rx, q[1] * ry) for q in wedge], x, y, 1, -8)
            cx, cy = sum(q[0] for q in flesh) / 8, sum(q[1] for q in flesh) / 8
            p.fill("flesh", flesh, around(cx, cy, 0.35 * rx, 0.35 * ry,
                                          [(0, ryb("#fdf0a4", 0.6)), (1, ryb("#f4c93a", 0.9))]), s=2.6, style=WASH,
                   granulation=0.75, piece=6)
        p.line("shade", [(x - 0.5 * rx, y + 1.12 * ry), (x, y + 1.26 * ry), (x + 0.6 * rx, y + 0.92 * ry)], [3, 8, 3],
               ryb("#9a7a30", 0.5), style=feather(1.3, 1.3), mix=glaze(0.5), spread=8, granulation=0.5)


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
    leaf("leaf", [(318, 372), (262, 330), (214, 318), (160, 336)], 19, "#3d6a34", "#93b04a")
    leaf("leaf", [(560, 352), (612, 300), (660, 286), (716, 300)], 19, "#44703a", "#a3b850")
    leaf("leaf", [(420, 300), (392, 250), (396, 206), (424, 168)], 17, "#4a7840", "#a2b854")
lemon("lemon at the back", 462, 336, 82, -14)
lemon("lemon on the left", 356, 384, 84, 24)
lemon("lemon on the right", 562, 386, 84, -32, True)
bowl_front()
contact(738, 880, 566, 14, 6)
pear(792, 470, 112)
with p.group("shadows in front"):
    shadow("shadow of the plums", curve([(600, 676), (690, 690), (790, 676), (850, 664), (870, 676), (820, 700),
                                         (720, 716), (620, 706)], closed=True, step=7),
           across(600, 0, 870, 0, [(0, ryb("#403a72", 0.7)), (1, ryb("#8d80aa", 0.4))]), s=7)
    shadow("shadow of the half lemon", curve([(190, 676), (260, 694), (330, 684), (400, 664), (410, 676), (350, 704),
                                              (260, 716), (200, 700)], closed=True, step=7),
           across(190, 0, 400, 0, [(0, ryb("#5a5488", 0.66)), (1, ryb("#9a8cb0", 0.4))]), s=7)
contact(690, 790, 680, 12)
contact(600, 700, 696, 14)
contact(196, 340, 684, 16)
plum("plum", 724, 646, 46, 0.3)
plum("plum in front", 634, 660, 50, 1.2)
half_lemon(246, 640, 74, 42)
splashes()
p.write(sys.argv[1] if len(sys.argv) > 1 else "still-life.json")
