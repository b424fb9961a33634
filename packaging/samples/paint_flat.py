#!/usr/bin/env python3
"""Paints flat.json, a harbour town at sunset in flat colours: paint_flat.py [OUT.json]"""
import math
import random
import sys

from paintbox import Painting, curve, ellipse, rectangle, ryb, uniform

CREAM, SAND, ROSE = "#fdf1dc", "#f9e0bd", "#ee9c7c"
CORAL, BRICK, MUSTARD, GOLD = "#e8694c", "#b9452f", "#eeae45", "#f8cd6b"
SEA, DEEP, NIGHT, INK = "#2f7480", "#1f5263", "#173a4a", "#102c3a"
CRISP = uniform(0.008)
WALLS = (("#fbeedb", "#e5cdb4"), ("#f8dcb4", "#dfb88f"), ("#f3b98f", "#d8946f"), ("#fdf3e2", "#e2d3c0"),
         ("#eec46f", "#d19f4d"), ("#f0a183", "#cf7a60"), ("#a9c9bd", "#82aaa1"))
ROOFS = (("#c9553b", "#a8412d"), ("#d76a48", "#b34f35"), ("#b54a38", "#93382b"))
rng = random.Random(7)
p = Painting(1024, 768, "#fbe3c2")


def shape(name, points, colour, s=4.0, opacity=1.0, **more):
    p.fill(name, points, ryb(colour, opacity), s=s, style=CRISP, **more)


def mark(name, points, width, colour, opacity=1.0, **more):
    """colour: '#rrggbb', or a list of them along the stroke."""
    paint = [ryb(c, opacity) for c in colour] if isinstance(colour, list) else ryb(colour, opacity)
    p.line(name, points, width, paint, style=CRISP, **more)


def dot(name, x, y, radius, colour):
    p.dot(name, x, y, radius, ryb(colour), style=CRISP)


# ---------------------------------------------------------------- sky and hills

def cloud(name, x, y, k, colour):
    """One stroke: a flat foot and a row of round heads."""
    heads = [(-92, -3), (-84, -14), (-62, -17), (-50, -30), (-22, -38), (4, -31), (16, -22), (40, -26), (60, -18),
             (66, -12), (84, -12), (92, -3)]
    foot = [(86, 5), (60, 7), (0, 7), (-60, 7), (-86, 5)]
    shape(name, curve([(x + k * a, y + k * b) for a, b in heads + foot], closed=True, step=3), colour, 4.2 * k)


def gull(x, y, k):
    mark("gull", [(x - 22 * k, y - 5 * k), (x - 11 * k, y - 9 * k), (x, y), (x + 12 * k, y - 11 * k),
                  (x + 24 * k, y - 8 * k)],
         [0.1, 1.6 * k, 2.3 * k, 1.6 * k, 0.1], NIGHT, spread=1.4, step=2.5)


def sky():
    with p.group("sky"):
        shape("sky, low", curve([(-40, 232), (120, 214), (300, 236), (500, 196), (700, 172), (880, 206), (1064, 184)],
                                step=12) + [(1064, -40), (-40, -40)], "#f9d6ae", 14)
        shape("sky, middle", curve([(-40, 128), (140, 148), (340, 108), (560, 122), (800, 88), (1064, 120)], step=12)
              + [(1064, -40), (-40, -40)], "#f6c7a0", 14)
        shape("sky, high", curve([(-40, 58), (160, 40), (380, 62), (620, 34), (860, 50), (1064, 24)], step=12)
              + [(1064, -40), (-40, -40)], "#f0b393", 12)
    with p.group("sun"):
        shape("glow, wide", ellipse(640, 372, 268, 268), "#fcdcaa", 14)
        shape("glow", ellipse(640, 372, 200, 200), "#fccf85", 12)
        shape("sun", ellipse(640, 372, 134, 134), CORAL, 9)
    with p.group("clouds"):
        cloud("cloud, left", 300, 208, 0.96, CREAM)
        cloud("cloud, right", 930, 236, 0.82, CREAM)
        cloud("cloud before the sun", 752, 330, 0.66, CREAM)
        cloud("cloud, small", 496, 84, 0.5, "#fbe2c6")
        cloud("cloud, high", 850, 96, 0.6, "#fbe2c6")
    with p.group("gulls"):
        for x, y, k in ((424, 268, 1.0), (472, 244, 0.78), (396, 240, 0.55), (506, 276, 0.5), (868, 164, 0.72),
                        (904, 148, 0.5)):
            gull(x, y, k)


def hills():
    with p.group("hills"):
        shape("far hills", curve([(300, 470), (360, 436), (440, 414), (520, 428), (600, 446), (690, 418), (780, 390),
                                  (870, 356), (950, 368), (1060, 332)], step=10)
              + [(1060, 480), (300, 480)], "#e3a487", 6)
        shape("middle hills", curve([(560, 474), (640, 454), (730, 442), (800, 416), (880, 406), (960, 418),
                                     (1060, 388)], step=10) + [(1060, 484), (560, 484)], "#c4827a", 6)
        shape("near hills", curve([(770, 476), (826, 458), (890, 448), (960, 452), (1060, 428)], step=10)
              + [(1060, 484), (770, 484)], "#8f6b76", 6)


# ---------------------------------------------------------------- sea and boats

def glitter(x, y, half, w, colours):
    """A flake of light, pointed at both ends, warmer towards them."""
    taper = [w * t for t in (0.05, 0.42, 0.72, 0.92, 1, 0.92, 0.72, 0.42, 0.05)]
    mark("glitter", [(x - half, y), (x + half, y)], taper, colours, step=max(2.0, min(4.0, half / 9)), spread=0.8 * w,
         smooth=False)


def sea():
    with p.group("sea"):
        shape("water", [(-40, 468), (1064, 468), (1064, 810), (-40, 810)], "#629e99", 10)
        shape("nearer water", curve([(-40, 540), (260, 546), (520, 534), (760, 546), (1064, 532)], step=12)
              + [(1064, 810), (-40, 810)], "#4a8a8f", 10)
        shape("near water", curve([(-40, 622), (240, 614), (500, 628), (760, 616), (1064, 630)], step=12)
              + [(1064, 810), (-40, 810)], "#387782", 10)
        shape("nearest water", curve([(-40, 700), (300, 712), (600, 700), (820, 712), (1064, 694)], step=12)
              + [(1064, 810), (-40, 810)], "#2b6472", 10)
    warm = (["#ee8a60", "#f4a673", "#ee8a60"], ["#f4a673", "#fbc98a", "#f4a673"], ["#f0966a", "#f8b87d", "#f0966a"])
    with p.group("sun on the water"):
        y, k = 476.0, 0
        while y < 726:
            near = (y - 476) / 266
            half, w = (138 - 82 * near) * rng.uniform(0.74, 1.0), 2.0 + 3.4 * near
            x = 640 + rng.uniform(-9, 9) * (1 + near)
            if k % 4 == 2:
                gap = half * rng.uniform(-0.35, 0.35)
                left, right = (half + gap - 7) / 2, (half - gap - 7) / 2
                glitter(x - half + left, y, left, w, warm[k % 3])
                glitter(x + half - right, y, right, w, warm[(k + 1) % 3])
            else:
                glitter(x, y, half, w, warm[k % 3])
            if y > 528 and rng.random() < 0.7:
                away = rng.choice((-1, 1)) * (half + rng.uniform(26, 52))
                if x + away > 520 or y > 640:
                    glitter(x + away, y + 4 + 4 * near, rng.uniform(9, 15) * (1 + near), 0.7 * w, "#f0966a")
            y += 8.5 + 8 * near
            k += 1
    with p.group("waves"):
        for x, y, k in ((452, 500, 0.6), (800, 520, 0.6), (960, 516, 0.7), (420, 560, 0.8), (930, 560, 0.8),
                        (990, 586, 0.9), (520, 652, 0.9), (790, 576, 0.7), (470, 684, 1.1),
                        (960, 668, 1.1), (768, 662, 1.0), (540, 728, 1.2), (830, 736, 1.2), (990, 730, 1.3)):
            wave(x + rng.uniform(-8, 8), y, k)


def wave(x, y, k):
    colour = "#8cbbb1" if y < 534 else "#70a8a7" if y < 616 else "#5896a0" if y < 700 else "#47848f"
    for dx, dy, size in ((0, 0, 1.0), (20, 7, 0.6)):
        half = 22 * k * size
        mark("wave", [(x + dx * k - half, y + dy * k), (x + dx * k - 0.4 * half, y + (dy - 2.4) * k),
                      (x + dx * k + 0.3 * half, y + (dy - 0.6) * k), (x + dx * k + half, y + (dy + 0.4) * k)],
             [0.05, 1.7 * k, 1.5 * k, 0.05], colour, spread=1.2 + 0.4 * k)


def boat(name, x, y, k, sails, hull):
    with p.group(name):
        for i in range(4):
            sway, half = 2 - 3 * (i % 2), 36 - 8 * i
            glitter(x + sway * k, y + (12 + 7.5 * i) * k, half * k, (2.5 - 0.3 * i) * k, sails[i % 2])
        small = 2.4 * k ** 0.5
        shape("main sail", curve([(x - 2 * k, y - 102 * k), (x + 26 * k, y - 64 * k), (x + 42 * k, y - 15 * k)], step=4)
              + [(x - 2 * k, y - 13 * k)], sails[0], small)
        shape("sail's shade", curve([(x - 2 * k, y - 102 * k), (x + 7 * k, y - 62 * k), (x + 10 * k, y - 14 * k)],
                                    step=4) + [(x - 2 * k, y - 13 * k)], sails[2], small)
        shape("fore sail", curve([(x - 10 * k, y - 86 * k), (x - 30 * k, y - 46 * k), (x - 46 * k, y - 13 * k)], step=4)
              + [(x - 10 * k, y - 15 * k)], sails[1], small)
        mark("mast", [(x - 6 * k, y - 106 * k), (x - 6 * k, y)], 1.3 * k, NIGHT, step=12)
        mark("pennant", [(x - 5 * k, y - 105 * k), (x + 5 * k, y - 104 * k), (x + 14 * k, y - 107 * k)],
             [2.4 * k, 2 * k, 0.1], CORAL, step=2)
        shape("hull", [(x - 52 * k, y - 8 * k), (x + 50 * k, y - 8 * k)]
              + curve([(x + 44 * k, y + 3 * k), (x + 34 * k, y + 9 * k), (x - 30 * k, y + 9 * k),
                       (x - 42 * k, y + 2 * k)], step=3), hull, small)
        mark("stripe", [(x - 45 * k, y - 3 * k), (x + 44 * k, y - 3 * k)], 1.1 * k, CREAM, step=14)


def dinghy(x, y, k, colour):
    with p.group("rowing boat"):
        glitter(x, y + 11 * k, 26 * k, 1.8 * k, "#2b6472")
        shape("inside", curve([(x - 27 * k, y - 6 * k), (x, y - 3 * k), (x + 27 * k, y - 6 * k), (x, y - 9 * k)],
                              closed=True, step=3), NIGHT, 1.6)
        shape("hull", curve([(x - 30 * k, y - 8 * k), (x, y - 3 * k), (x + 30 * k, y - 8 * k)], step=3)
              + curve([(x + 22 * k, y + 6 * k), (x, y + 8 * k), (x - 22 * k, y + 6 * k)], step=3), colour, 1.8)
        mark("gunwale", [(x - 30 * k, y - 8 * k), (x, y - 3 * k), (x + 30 * k, y - 8 * k)], 1.1 * k, CREAM)


# ---------------------------------------------------------------- trees

def cypress(x, y, h, dark, light, fat=0.14):
    def half(u):
        """Half the width of the crown; u runs from its tip to its foot."""
        return fat * h * 1.1 * u ** 0.72 * (1 - u ** 4) ** 0.5

    down = lambda u: y - h * (1 - 0.95 * u)
    steps, inner = [k / 24 for k in range(25)], [0.16 + 0.7 * k / 16 for k in range(17)]
    with p.group("cypress"):
        mark("trunk", [(x, y + 2), (x, y - 0.12 * h)], 0.012 * h + 0.8, "#3b2d2f", smooth=False)
        shape("crown", [(x + half(u), down(u)) for u in steps] + [(x - half(u), down(u)) for u in steps[-2:0:-1]], dark,
              max(1.6, 0.02 * h))
        shape("light", [(x + 0.8 * half(u), down(u)) for u in inner]
              + [(x + (0.8 - 0.5 * math.sin(math.pi * (u - 0.16) / 0.7)) * half(u), down(u)) for u in inner[-2:0:-1]],
              light, max(1.1, 0.012 * h))


def tree(x, y, r, dark=SEA, light="#4a8f8e"):
    with p.group("tree"):
        mark("trunk", [(x, y), (x, y - r)], 1.6, "#3b2d2f", smooth=False)
        shape("crown", ellipse(x, y - 1.55 * r, r, 1.12 * r), dark, 0.16 * r + 0.8)
        shape("light", ellipse(x + 0.3 * r, y - 1.75 * r, 0.52 * r, 0.62 * r), light, 0.1 * r + 0.6)


def bush(x, y, r, colour="#3f7470"):
    heads = [(-1.7, 0), (-1.72, -0.5), (-1.1, -0.78), (-0.55, -1.3), (0.1, -1.18), (0.45, -0.9), (1.05, -0.95),
             (1.55, -0.5), (1.6, 0)]
    shape("bush", [(x + r * a, y + r * b) for a, b in curve(heads, step=0.25)], colour, 1.6)


# ---------------------------------------------------------------- houses

def opening(name, x, y, half, height, colour, s=1.0):
    """A window or door standing on (x, y), with a round head."""
    top = y - height + half
    shape(name, [(x - half, y), (x - half, top)] + ellipse(x, top, half, half, start=200, end=340)
          + [(x + half, top), (x + half, y)], colour, s)


def house(x, y, w, h, look, before, ground=False):
    """A house whose front foot is at (x, y): a sunny front, a side in the shade to the left of it, a roof. before: the
    houses (x, y, w, h, look) that will stand before it; it has no windows where they would cut them."""
    wall, shade = WALLS[look % len(WALLS)]
    left, right, top = x - 0.34 * w, x + w, y - h
    with p.group("house"):
        shape("side", [(left, top + 3), (x + 2, top), (x + 2, y), (left, y)], shade, 2.7, rims=2)
        shape("front", rectangle(x, top, right, y), wall, 2.7, rims=2)
        (gable_roof, hip_roof, parapet)[look % 3](x, left, right, top, wall, *ROOFS[look % len(ROOFS)])
        windows(x, y, w, h, look, before, ground)


def gable_roof(x, left, right, top, wall, roof, dark):
    middle, ridge = (x + right) / 2, top - 0.34 * (right - x)
    shape("gable", [(x, top + 2), (x, top), (middle, ridge), (right, top), (right, top + 2)], wall, 1.8, rims=2)
    shape("roof in the shade", [(left - 4, top + 4), (left + 0.42 * (right - x), ridge - 2), (middle, ridge - 4),
                                (middle, ridge), (x - 2, top + 3)], dark, 1.6, rims=2)
    shape("eave", [(middle - 2, ridge - 4.5), (right + 6, top + 2), (right + 3, top + 6), (middle - 3, ridge + 2),
                   (x - 1, top + 4), (x - 4, top + 2)], roof, 1.4)


def hip_roof(x, left, right, top, _wall, roof, dark):
    ridge = top - 0.26 * (right - x)
    shape("roof in the shade", [(left - 4, top + 5), (left + 8, ridge), (x + 6, ridge), (x, top + 4)], dark,
          1.8, rims=2)
    shape("roof", [(x - 3, top + 3), (x + 5, ridge), (right - 3, ridge), (right + 5, top + 3)], roof, 1.8, rims=2)


def parapet(x, left, right, top, _wall, roof, _dark):
    shape("parapet", [(left - 2, top + 4), (left - 2, top - 1), (x, top - 4), (right + 3, top - 4),
                      (right + 3, top + 1), (x, top + 1)], roof, 1.5)


def behind(x, foot, houses):
    """Whether a window at x, with its foot there, would be cut by one of the houses before it."""
    for left, y, w, h, look in houses:
        slope = min(1, 2 - (x - left) / (0.5 * w))
        roof = (0.34 * w * slope, 0.26 * w, 4)[look % 3]
        if left - 0.34 * w - 9 < x < left + w + 9 and y - h - roof - 3 < foot and foot - 12 < y:
            return True
    return False


def windows(x, y, w, h, look, before, ground):
    glass = DEEP if look % 3 else "#7a3b34"
    columns, floors = max(2, round(w / 17)), max(1, round((h - 14) / 22))
    for f in range(floors):
        for c in range(columns):
            cx, foot = x + w * (c + 0.5) / columns, y - h + 18 + f * (h - 10) / floors
            is_door = f == floors - 1 and c == look % columns
            if behind(cx, y if is_door else foot, before):
                continue
            if is_door:
                opening("door", cx, y - 0.5, 3.8, 15, BRICK if look % 3 else DEEP, 1.2)
                if ground:
                    awning(cx, y - 19, CORAL if look % 2 else SEA)
            elif (look * 7 + f * 5 + c * 3) % 11 < 9:
                opening("window", cx, foot, 2.6, 9, GOLD if (look + f * 3 + c * 5) % 7 == 0 else glass)


def awning(x, y, colour):
    with p.group("awning"):
        shape("cloth", [(x - 8.5, y - 4), (x + 8.5, y - 4), (x + 11, y + 4.5), (x - 11, y + 4.5)], CREAM, 1.1)
        for k in range(3):
            a = -8.5 + 6.8 * k
            b = a + 3.4
            shape("stripe", [(x + a, y - 4.3), (x + b, y - 4.3), (x + 1.3 * b, y + 5), (x + 1.3 * a, y + 5)],
                  colour, 0.9)


def church(x, y):
    with p.group("church"):
        shape("nave", rectangle(x - 70, y - 54, x + 4, y), "#ecd9c2", 2.6, rims=2)
        shape("roof of the nave", [(x - 77, y - 52), (x - 62, y - 80), (x + 2, y - 80), (x + 2, y - 52)],
              "#b54a38", 2.6, rims=2)
        shape("tower in the shade", rectangle(x - 11, y - 127, x + 2, y), "#dcc6af", 2.4, rims=2)
        shape("tower", rectangle(x, y - 128, x + 36, y), CREAM, 2.4, rims=2)
        shape("cornice", rectangle(x - 15, y - 134, x + 40, y - 127), MUSTARD, 1.8)
        shape("belfry in the shade", rectangle(x - 7, y - 158, x + 4, y - 134), "#dcc6af", 1.8, rims=2)
        shape("belfry", rectangle(x + 2, y - 158, x + 32, y - 134), CREAM, 1.8, rims=2)
        shape("ledge", rectangle(x - 11, y - 162, x + 36, y - 157), MUSTARD, 1.4)
        shape("dome", ellipse(x + 12.5, y - 161, 20, 25, start=180, end=360), SEA, 2.2, rims=2)
        mark("dome's light", [(x + 21, y - 166), (x + 23, y - 174), (x + 17, y - 181)], [0.1, 2.2, 0.1],
             "#7fb5ad", spread=1.6)
        mark("spire", [(x + 12.5, y - 208), (x + 12.5, y - 186)], [0.5, 1.9], NIGHT, step=3)
        dot("ball", x + 12.5, y - 196, 2.8, NIGHT)
        opening("bell window", x + 17, y - 138, 4.6, 15, DEEP, 1.3)
        opening("window", x + 18, y - 92, 4.2, 19, DEEP, 1.3)
        dot("clock", x + 18, y - 68, 8.5, MUSTARD)
        dot("clock's face", x + 18, y - 68, 6.2, CREAM)
        mark("clock's hands", [(x + 18, y - 73), (x + 18, y - 68), (x + 21.5, y - 66)], 0.7, NIGHT, smooth=False,
             spread=0.6, step=1.5)
        opening("window", x - 21, y - 26, 3.4, 15, "#8a5a4e", 1.2)


def town():
    with p.group("hill"):
        shape("hill", curve([(-40, 232), (40, 222), (120, 240), (200, 280), (280, 344), (345, 420), (405, 500),
                             (458, 574)], step=10) + [(458, 590), (-40, 590)], "#79a189", 8)
        shape("hill's foot", curve([(-40, 400), (120, 404), (250, 440), (340, 500), (420, 570)], step=10)
              + [(430, 590), (-40, 590)], "#568679", 8)
    with p.group("town"):
        for x, y, h in ((18, 244, 66), (42, 236, 90), (68, 246, 60)):
            cypress(x, y, h, "#24525a", "#3d7476")
        church(150, 330)
        look = 3
        terraces = ((338, (18, 74), ((216, 0),)), (392, (20, 92, 158), ((250, 0),)),
                    (448, (14, 78, 150, 226), ((294, 0), (324, 1))), (508, (24, 102, 176, 246, 318), ((384, 2),)),
                    (572, (12, 80, 158, 230, 304, 376), ((440, 2),)))
        rows = []
        for y, xs, _ in terraces:
            rows.append([])
            for x in xs:
                look += 1
                lift = 0 if y == 572 else rng.randrange(-3, 4)
                rows[-1].append((x, y + lift, rng.randrange(38, 52), rng.randrange(44, 66), look))
        for k, (y, _, trees) in enumerate(terraces):
            for n, (x, foot, w, h, look) in enumerate(rows[k]):
                before = sum(rows[k + 1:], rows[k][n + 1:])
                house(x, foot, w, h, look, before, ground=y == 572 and look % 2 == 0)
            for x, kind in trees:
                if kind == 0:
                    cypress(x, y + 2, rng.uniform(58, 74), "#1f4f58", "#37757a")
                elif kind == 1:
                    tree(x, y, rng.uniform(14, 17))
                else:
                    bush(x, y + 2, rng.uniform(8, 10))


def quay():
    with p.group("quay"):
        for x, y, half, w, colour in ((90, 634, 60, 2.6, "#d9b48c"), (250, 632, 90, 2.4, "#e0a884"),
                                      (400, 634, 66, 2.4, "#d9b48c"), (330, 643, 44, 2.2, "#f0c9a0"),
                                      (446, 645, 26, 1.8, "#e0a884"), (180, 644, 40, 2.2, "#c98a70")):
            glitter(x, y, half, w, colour)
        shape("quay", [(-40, 570), (477, 570), (485, 577), (485, 596), (-40, 600)], "#e2c199", 3.4, rims=2)
        shape("quay wall", [(-40, 589), (487, 589), (482, 624), (-40, 624)], "#936a59", 3.4, rims=2)
        for k in range(17):
            x, y = 10 + 29 * k, (600, 609, 617)[(k * 2) % 3]
            mark("stone", [(x - 8, y), (x + 8, y)], 1.2, "#7b5549" if k % 2 else "#a67c68", smooth=False)
        for x in (133, 213, 281, 354, 436):
            with p.group("lamp"):
                mark("post", [(x, 584), (x, 548)], 1.1, NIGHT, smooth=False)
                mark("foot", [(x - 2, 584), (x + 2, 584)], 1.6, NIGHT, smooth=False, step=1)
                dot("light", x, 543, 4.2, GOLD)
        for x in (170, 245, 318, 394, 468):
            mark("bollard", [(x, 590), (x, 585)], [2.2, 2.8], NIGHT, smooth=False)
    dinghy(284, 645, 0.92, BRICK)
    dinghy(386, 662, 1.0, CREAM)


# ---------------------------------------------------------------- foreground

def poppy(x, y, r, lean, colour, dark):
    with p.group("poppy"):
        foot = y + 46 + 20 * rng.random()
        mark("stem", [(x - lean, foot), (x - 0.2 * lean, y + 20), (x, y + 2)], [1.2, 1.0, 0.9],
             [NIGHT, "#2f6a72", "#3b7f82"], spread=1.0, step=5)
        shape("far petal", ellipse(x, y - 0.35 * r, 0.86 * r, 0.62 * r), dark, 1.3)
        half = [(0, 0.85), (0.8, 0.5), (1.1, -0.55), (0.45, -0.2), (0, -0.5)]
        cup = [(x + r * a, y + r * b) for a, b in half] + [(x - r * a, y + r * b) for a, b in half[-2:0:-1]]
        shape("cup", curve(cup, closed=True, step=1.5), colour, 1.3)


def foreground():
    land = [(-40, 676), (60, 660), (170, 676), (290, 712), (400, 748), (500, 800)]
    top = lambda x: next(a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) for a, b in zip(land, land[1:]) if x <= b[0])
    with p.group("shore"):
        for x, h, fat in ((36, 218, 0.14), (92, 154, 0.15), (138, 102, 0.16)):
            cypress(x, top(x) + 14, h, INK, "#215062", fat)
        for k in range(26):
            x = 150 + 11.5 * k + rng.uniform(-4, 4)
            blade(x, top(x) + 12, rng.uniform(26, 46), rng.uniform(-14, 18), "#1b4656")
        shape("shore", curve(land, step=10) + [(500, 820), (-40, 820)], NIGHT, 7)
        for x, up, r, lean, look in ((186, 34, 7, 6, 0), (206, 18, 6, -3, 1), (246, 36, 7.5, 5, 0),
                                     (268, 14, 5.5, 8, 2), (300, 34, 7, -4, 1), (322, 22, 6, 6, 0),
                                     (362, 30, 6.5, 4, 2), (384, 16, 5.5, -3, 0)):
            colour, dark = ((CORAL, "#c24a35"), (ROSE, "#d27a5e"), (GOLD, "#e0a646"))[look]
            poppy(x, top(x) - up, r, lean, colour, dark)
        for k in range(20):
            x = 168 + 13 * k + rng.uniform(-5, 5)
            blade(x, top(x) + rng.uniform(24, 52), rng.uniform(20, 34), rng.uniform(-12, 14),
                  [NIGHT, "#245666", "#2a6070"])


def blade(x, y, h, lean, colour):
    mark("grass", [(x, y), (x + 0.25 * lean, y - 0.55 * h), (x + lean, y - h)], [1.6, 1.7, 0.1], colour,
         spread=1.4, step=3)


sky()
hills()
sea()
boat("sailing boat, far", 890, 504, 0.42, (CREAM, SAND, SAND), BRICK)
boat("sailing boat, small", 486, 516, 0.46, (GOLD, CREAM, MUSTARD), DEEP)
town()
quay()
boat("sailing boat", 846, 648, 1.2, (CREAM, CORAL, "#f0dcc0"), NIGHT)
foreground()
p.write(sys.argv[1] if len(sys.argv) > 1 else "flat.json")
