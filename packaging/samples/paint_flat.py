#!/usr/bin/env python3
"""Paints flat.json, a harbour town at sunset in flat colours: paint_flat.py [OUT.json]"""
import math
import random
import sys

from paintbox import Painting, across_box, feather, lens, oval, paint, placed, rectangle, tapered, through, uniform

CREAM, CORAL, SEA, NIGHT, INK = "#fdf1dc", "#e8694c", "#2f7480", "#173a4a", "#102c3a"
CRISP, SOFT = uniform(0.008), feather(1.0, 1.0)
WALLS = "#fdf0dd", "#fadbb4", "#f5bb8f", "#fef3e4", "#f0c873", "#f3a587", "#accdc0"
ROOFS = "#d96446", "#e27a54", "#c8563e"
rng = random.Random(7)
p = Painting(1024, 768, "#fbe3c2")


def mixed(colour, other, share):
    pairs = [(int(colour[i:i + 2], 16), int(other[i:i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def shapes(name, outlines, colour, slant=90, style=CRISP, **more):
    """Outlines in one stroke. colour: one, or a pair that runs through the outlines' box, downwards or aslant."""
    pair = isinstance(colour, tuple)
    colour = across_box(outlines, slant, *map(paint, colour)) if pair else paint(colour)
    p.area(name, outlines, colour, style=style, **more)


def shape(name, outline, colour, slant=90, **more):
    shapes(name, [outline], colour, slant, **more)


# ---------------------------------------------------------------- sky and hills

def cloud(name, x, y, k, colours):
    """A flat foot and round heads."""
    heads = [(-88, -7, 14), (-50, -16, 23), (-8, -24, 31), (34, -17, 24), (66, -10, 17), (96, -4, 11)]
    shapes(name, [oval(x + k * a, y + k * b, k * r) for a, b, r in heads]
           + [rectangle(x - k * 88, y - k * 11, x + k * 96, y + k * 7)], colours)


def gull(x, y, k):
    wings = [[(-22, -5), (-16, -12), (-6, -11), (0, -1.5)], [(0, -1.5), (7, -14), (15, -15), (24, -8)],
             [(24, -8), (15, -10), (7, -7), (0.5, 3)], [(0.5, 3), (-5, -6), (-14, -8), (-22, -5)]]
    return [placed(c, x, y, k) for c in wings]


def sky():
    with p.group("sky"):
        shape("sky", rectangle(-40, -40, 1064, 480), ("#ea957f", "#ffe9c6"))
        for name, low, up, colours in (
                ("veil, low", [(-40, 238), (130, 216), (310, 240), (500, 198), (700, 172), (880, 208), (1064, 184)],
                 120, ("#fbd9ac00", "#f3b78ecc")),
                ("veil, middle", [(-40, 128), (140, 150), (340, 106), (560, 124), (800, 86), (1064, 120)], 40,
                 ("#f4b89400", "#ea9f85c0")),
                ("veil, high", [(-40, 58), (160, 38), (380, 64), (620, 32), (860, 52), (1064, 24)], -40,
                 ("#e0826f60", "#d97f73b8"))):
            shape(name, through(low) + [(1064, up), (-40, up)], colours)
    with p.group("sun"):
        p.dot("light in the sky", 640, 372, 220, paint("#ffe3a8d8"), style=SOFT)
        shape("glow, wide", oval(640, 372, 268), ("#ffe2ab70", "#ffe9b8c0"))
        shape("glow", oval(640, 372, 200), ("#fdc876a0", "#ffd98ee0"))
        shape("sun", oval(640, 372, 134), ("#f9a24c", "#d93c38"), 80)
    with p.group("clouds and gulls"):
        for name, x, y, k in (("cloud, left", 300, 208, 0.92), ("cloud, right", 926, 240, 0.8)):
            cloud(name, x, y, k, ("#fff6e4", "#fbd7b4"))
        cloud("cloud before the sun", 752, 330, 0.62, ("#fffaf0", "#ffd9b0"))
        cloud("cloud, small", 496, 84, 0.46, ("#fbdcc2e0", "#f5b79be0"))
        cloud("cloud, high", 850, 98, 0.56, ("#fbdcc2e0", "#f5b79be0"))
        flock = ((424, 268, 1), (472, 244, 0.78), (396, 240, 0.55), (506, 276, 0.5), (868, 164, 0.72), (904, 148, 0.5))
        shapes("gulls", [gull(*place) for place in flock], NIGHT)


def hills():
    with p.group("hills"):
        for name, ridge, colours in (
                ("far hills", [(300, 474), (360, 436), (440, 414), (520, 428), (600, 446), (690, 418), (780, 390),
                               (870, 356), (950, 368), (1060, 332)], ("#d98f7c", "#f0b791")),
                ("middle hills", [(560, 476), (640, 454), (730, 442), (800, 416), (880, 406), (960, 418), (1060, 388)],
                 ("#b06a70", "#d98f80")),
                ("near hills", [(770, 476), (826, 458), (890, 448), (960, 452), (1060, 428)], ("#74536a", "#a66a74"))):
            shape(name, through(ridge) + [(1060, 484), (ridge[0][0], 484)], colours)


# ---------------------------------------------------------------- sea and boats

def sea():
    with p.group("sea"):
        shape("water", rectangle(-40, 468, 1064, 810), ("#74ada0", "#2a6c7a"))
        for name, edge, colours in (
                ("nearer water", [(-40, 540), (260, 548), (520, 532), (760, 548), (1064, 530)],
                 ("#3c808aa0", "#3c808a00")),
                ("near water", [(-40, 624), (240, 612), (500, 630), (760, 614), (1064, 632)],
                 ("#2b6a78b8", "#2b6a7800")),
                ("nearest water", [(-40, 698), (300, 714), (600, 698), (820, 714), (1064, 692)],
                 ("#1d5466c0", "#1d546680"))):
            shape(name, through(edge) + [(1064, 810), (-40, 810)], colours)
        shape("light on the horizon", rectangle(380, 466, 900, 476), "#fbd3bcb0", style=SOFT, spread=12)
        shape("light on the water", [(516, 470), (764, 470), (700, 740), (590, 740)], ("#f8b8a4d0", "#f2a09c18"),
              style=SOFT, spread=18)
    waves = []
    for x, y, k in ((452, 500, 0.6), (800, 520, 0.6), (960, 516, 0.7), (420, 560, 0.8), (930, 560, 0.8),
                    (990, 586, 0.9), (520, 652, 0.9), (790, 576, 0.7), (470, 684, 1.1), (960, 668, 1.1),
                    (768, 662, 1.0), (540, 728, 1.2), (830, 736, 1.2), (990, 730, 1.3)):
        x += rng.uniform(-8, 8)
        waves += [wave(x, y, k), wave(x + 20 * k, y + 7 * k, 0.6 * k)]
    with p.group("waves"):
        shapes("waves", waves, ("#a8d0c2", "#3f8290"))
    flakes, cores, strays = [], [], []
    y, k = 476.0, 0
    while y < 730:
        near = (y - 476) / 266
        half, w = (138 - 82 * near) * rng.uniform(0.74, 1.0), 1.7 + 3.2 * near
        x = 640 + rng.uniform(-9, 9) * (1 + near)
        if k % 4 == 2:
            gap = half * rng.uniform(-0.35, 0.35)
            left, right = (half + gap - 7) / 2, (half - gap - 7) / 2
            flakes += [lens(x - half + left, y, left, w), lens(x + half - right, y, right, w)]
        else:
            flakes.append(lens(x, y, half, w))
            cores.append(lens(x + rng.uniform(-0.2, 0.2) * half, y, half * rng.uniform(0.4, 0.6), 0.5 * w))
        if y > 520 and rng.random() < 0.8:
            away = rng.choice((-1, 1)) * (half + rng.uniform(26, 52))
            if x + away > 520 or y > 640:
                strays.append(lens(x + away, y + 4 + 4 * near, rng.uniform(9, 15) * (1 + near), 0.6 * w))
        y += 7.5 + 8 * near
        k += 1
    with p.group("sun on the water"):
        shapes("glitter astray", strays, ("#f6b07e", "#ea7f60"))
        shapes("glitter", flakes, ("#fcc27c", "#ee7d58"))
        shapes("glitter's heart", cores, ("#ffe6b4", "#fbb978"))

def wave(x, y, k):
    return [placed(c, x, y, k) for c in ([(-24, 0.5), (-10, -5.5), (6, -1.5), (24, 0.5)],
                                         [(24, 0.5), (8, 1.8), (-8, -1), (-24, 0.5)])]


def boat(name, x, y, k, sails, hull):
    at = lambda points: placed(points, x, y, k)
    side = lambda points: through(at(points))
    with p.group(name):
        shapes("in the water", [[at(c) for c in lens(2 - 3 * (i % 2), 12 + 7.5 * i, 36 - 8 * i, 2.2 - 0.3 * i)]
                                for i in range(4)], (sails[0][1], sails[1][1]))
        shape("main sail", side([(-2, -102), (26, -64), (42, -15)]) + at([(-2, -13)]), sails[0], 10)
        shape("sail's shade", side([(-2, -102), (7, -62), (10, -14)]) + at([(-2, -13)]), sails[2], 0)
        shape("fore sail", side([(-10, -86), (-30, -46), (-46, -13)]) + at([(-10, -15)]), sails[1], 120)
        shape("mast", at([(-6.8, 0), (-6.8, -107), (-5.2, -107), (-5.2, 0)]), INK)
        shape("pennant", side([(-5, -107), (5, -106), (15, -108)]) + side([(15, -108), (5, -101.5), (-5, -102.5)]),
              CORAL)
        shape("hull", at([(-52, -8)]) + side([(50, -8), (44, 3), (34, 9)]) + side([(-30, 9), (-42, 2), (-52, -8)]),
              hull)
        shape("stripe", at([(-49, -4), (47, -4), (46, -1.8), (-47.5, -1.8)]), CREAM)


def dinghy(x, y, k, colours):
    at = lambda points: through(placed(points, x, y, k))
    with p.group("rowing boat"):
        shape("in the water", lens(x, y + 11 * k, 28 * k, 2.4 * k), "#1d5466")
        shape("inside", at([(-30, -8), (0, -3), (30, -8)]) + at([(30, -8), (0, -10), (-30, -8)]), ("#0f2a38", NIGHT))
        shape("hull", at([(-30, -8), (0, -3), (30, -8)]) + at([(30, -8), (22, 6), (0, 8), (-22, 6), (-30, -8)]),
              colours)
        shape("gunwale", at([(-31, -9), (0, -4.2), (31, -9)]) + at([(31, -7), (0, -2), (-31, -7)]), CREAM)


# ---------------------------------------------------------------- trees

def cypress(x, y, h, dark, light, fat=0.14):
    """Dark, and a light flank towards the sun."""
    def crown(right, left, steps):
        half = lambda u: fat * h * 1.1 * u ** 0.72 * (1 - u ** 4) ** 0.5
        down = lambda u: y - h * (1 - 0.95 * u)
        return (through([(x + right(u) * half(u), down(u)) for u in steps])
                + through([(x + left(u) * half(u), down(u)) for u in steps[::-1]]))

    with p.group("cypress"):
        w = 0.012 * h + 0.8
        shape("trunk", [(x - w, y + 2), (x - w, y - 0.12 * h), (x + w, y - 0.12 * h), (x + w, y + 2)], "#3b2d2f")
        shape("crown", crown(lambda u: 1, lambda u: -1, (0, 0.12, 0.45, 0.75, 0.94, 1)), dark)
        shape("light", crown(lambda u: 0.82, lambda u: 0.82 - 0.55 * math.sin(math.pi * (u - 0.14) / 0.72),
                             (0.14, 0.4, 0.65, 0.86)), (light, light + "60"), 90)


def tree(x, y, r):
    with p.group("tree"):
        shape("trunk", rectangle(x - 1.6, y - r, x + 1.6, y), "#3b2d2f")
        shape("crown", oval(x, y - 1.55 * r, r, 1.12 * r), ("#24616c", SEA), 0)
        shape("light", oval(x + 0.3 * r, y - 1.75 * r, 0.52 * r, 0.62 * r), ("#6fb0a4", "#3a8086"))


def bush(x, y, r):
    heads = ((-1, 0.3, 0.7), (-0.2, 0.6, 0.8), (0.9, 0.3, 0.75))
    shapes("bush", [oval(x + a * r, y - b * r, c * r) for a, b, c in heads], ("#5c9184", "#2f6668"))


# ---------------------------------------------------------------- houses

def opening(x, y, half, height):
    """A window or door standing on (x, y), with a round head."""
    top, bow = y - height + half, y - height - 0.3 * half
    return [(x - half, y), [(x - half, top), (x - half, bow), (x + half, bow), (x + half, top)], (x + half, y)]


def house(x, y, w, h, look, before, ground=False):
    """A house whose front foot is at (x, y): a sunny front, a side in the shade to the left of it, a roof. before: the
    houses (x, y, w, h, look) that will stand before it; it has no windows where they would cut them."""
    wall, tiles = WALLS[look % len(WALLS)], ROOFS[look % len(ROOFS)]
    left, right, top = x - 0.34 * w, x + w, y - h
    with p.group("house"):
        shape("side", [(left, top + 3), (x + 1, top), (x + 1, y), (left, y)],
              (mixed(wall, "#6a3a40", 0.26), mixed(wall, "#6a2c3c", 0.45)))
        gable = [((x + right) / 2, top - 0.34 * w)] if look % 3 == 0 else []
        eaves = [(x, top)] + gable + [(right, top)]
        shape("front", eaves + [(right, y), (x, y)], (mixed(wall, "#fffaf0", 0.08), mixed(wall, "#e08a5c", 0.22)))
        shape("shade of the roof", eaves + [(ex, ey + 7) for ex, ey in eaves[::-1]], "#8a3d4a48")
        dark, light = roof(look % 3, x, left, right, top)
        shape("roof in the shade", dark, (mixed(tiles, "#5a1c28", 0.35), mixed(tiles, "#5a1c28", 0.55)))
        shape("roof", light, (tiles, mixed(tiles, "#8a2030", 0.25)))
        windows(x, y, w, h, look, before, ground)


def roof(kind, x, left, right, top):
    """The dark and the light half of a gable, a hip roof or a parapet."""
    middle, ridge, hip = (x + right) / 2, top - 0.34 * (right - x), top - 0.26 * (right - x)
    return (([(left - 4, top + 4), (left + 0.42 * (right - x), ridge - 2), (middle, ridge - 4), (middle, ridge),
              (x - 2, top + 3)],
             [(middle - 2, ridge - 4.5), (right + 6, top + 2), (right + 3, top + 6), (middle - 1, ridge + 2),
              (x - 1, top + 5), (x - 4, top + 2)]),
            ([(left - 4, top + 5), (left + 8, hip), (x + 6, hip), (x, top + 4)],
             [(x - 3, top + 4), (x + 5, hip), (right - 3, hip), (right + 5, top + 4)]),
            ([(left - 2, top + 4), (left - 2, top - 1), (x, top - 4), (x, top + 2)],
             rectangle(x - 1, top - 4, right + 3, top + 2)))[kind]


def behind(x, foot, houses):
    """Whether a window at x, with its foot there, would be cut by one of the houses before it."""
    for left, y, w, h, look in houses:
        slope = min(1, 2 - (x - left) / (0.5 * w))
        roof = (0.34 * w * slope, 0.26 * w, 4)[look % 3]
        if left - 0.34 * w - 9 < x < left + w + 9 and y - h - roof - 3 < foot and foot - 12 < y:
            return True
    return False


def windows(x, y, w, h, look, before, ground):
    panes, lit, sills, door = [], [], [], None
    columns, floors = max(2, round(w / 17)), max(1, round((h - 14) / 22))
    for f in range(floors):
        for c in range(columns):
            cx, foot = x + w * (c + 0.5) / columns, y - h + 18 + f * (h - 10) / floors
            is_door = f == floors - 1 and c == look % columns
            if behind(cx, y if is_door else foot, before):
                continue
            if is_door:
                door = cx
            elif (look * 7 + f * 5 + c * 3) % 11 < 10:
                (panes if (look + f * 3 + c * 5) % 7 else lit).append(opening(cx, foot, 2.6, 9))
                sills.append(rectangle(cx - 3.8, foot, cx + 3.8, foot + 1.3))
    for name, outlines, colour in (("windows", panes, ("#123c4c", "#2a6570") if look % 3 else ("#642c2b", "#8a4438")),
                                   ("windows with light", lit, ("#ffdf86", "#f3b24e")),
                                   ("sills", sills, "#d2a78c" if look % 7 in (0, 3) else "#fff2dc")):
        if outlines:
            shapes(name, outlines, colour)
    if door:
        shape("door", opening(door, y, 3.8, 15), ("#8f3227", "#c4513a") if look % 3 else ("#163f50", SEA))
        if ground:
            awning(door, y - 19, CORAL if look % 2 else SEA)


def awning(x, y, colour):
    shape("awning", [(x - 8.5, y - 4), (x + 8.5, y - 4), (x + 11, y + 4.5), (x - 11, y + 4.5)], ("#fff8ea", "#f0d9b8"))
    ends = [(-8.5 + 6.8 * k, -5.1 + 6.8 * k) for k in range(3)]
    shapes("stripes", [[(x + a, y - 4), (x + b, y - 4), (x + 1.3 * b, y + 4.5), (x + 1.3 * a, y + 4.5)]
                       for a, b in ends], colour)


def church(x, y):
    sunny, shady = ("#fff8ea", "#f7dfc0"), ("#e0c9b2", "#bf9f90")
    box = lambda a, b, c, d: rectangle(x + a, y + b, x + c, y + d)
    with p.group("church"):
        shape("nave", box(-70, -54, 4, 0), ("#ecd5bc", "#cdae98"))
        shape("roof of the nave", [(x - 77, y - 52), (x - 62, y - 80), (x + 2, y - 80), (x + 2, y - 52)],
              ("#c8563e", "#a94032"))
        shapes("in the shade", [box(-11, -127, 2, 0), box(-7, -158, 4, -134)], shady)
        shapes("tower", [box(0, -128, 36, 0), box(2, -158, 32, -134)], sunny)
        shapes("shade of the ledges", [box(0, -127, 36, -122), box(2, -157, 32, -153)], "#a0605848")
        shapes("ledges", [box(-15, -134, 40, -127), box(-11, -162, 36, -157)], ("#f7c15a", "#e09a3c"))
        shape("dome", oval(x + 12.5, y - 162, 20, 25, start=180, end=360), ("#1f5b69", "#3c8890"), 20)
        shape("dome's light", tapered([(x + 20, y - 165), (x + 24, y - 174), (x + 17, y - 182)], [0, 2.2, 0]),
              "#a5d0c3")
        shapes("spire", [[(x + 12, y - 209), (x + 13, y - 209), (x + 14, y - 186), (x + 11, y - 186)],
                         oval(x + 12.5, y - 196, 2.8)], INK)
        shapes("windows", [opening(x + 17, y - 138, 4.6, 15), opening(x + 18, y - 92, 4.2, 19),
                           opening(x - 16, y - 32, 3, 13)], ("#123c4c", "#2f7480"))
        shapes("clock's rim", [oval(x + 18, y - 68, 8.5), oval(x + 18, y - 68, 6.4)], ("#f7c15a", "#d9933a"),
               rule="evenodd")
        shape("clock's hands", [(x + 17.4, y - 73), (x + 18.6, y - 73), (x + 18.6, y - 68.3), (x + 22, y - 66.3),
                                (x + 21.5, y - 65.3), (x + 17.4, y - 67.6)], INK)


def town():
    with p.group("hill"):
        shape("hill", through([(-40, 232), (40, 222), (120, 240), (200, 280), (280, 344), (345, 420), (405, 500),
                                (458, 574)]) + [(458, 590), (-40, 590)], ("#9dba94", "#4f8678"), 100)
        shape("hill's foot", through([(-40, 400), (120, 404), (250, 440), (340, 500), (420, 570)])
              + [(430, 590), (-40, 590)], ("#5a9080", "#2f6668"), 100)
    with p.group("town"):
        for x, y, h in ((18, 244, 66), (42, 236, 90), (68, 246, 60)):
            cypress(x, y, h, "#1d4a55", "#4a857c")
        church(150, 330)
        look, rng = 3, random.Random(29)
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
                    cypress(x, y + 2, rng.uniform(58, 74), "#184651", "#458079")
                elif kind == 1:
                    tree(x, y, rng.uniform(14, 17))
                else:
                    bush(x, y + 2, rng.uniform(8, 10))


def quay():
    with p.group("quay"):
        shape("shade on the water", rectangle(-40, 622, 476, 636), ("#123c4cc0", "#123c4c50"), style=SOFT, spread=6)
        shapes("town on the water", [lens(x, y, half, w) for x, y, half, w in (
            (90, 634, 60, 1.9), (250, 632, 90, 1.8), (400, 634, 66, 1.8), (330, 643, 44, 1.6), (446, 645, 26, 1.4),
            (180, 644, 40, 1.6))], ("#f6c594d0", "#d98a70d0"))
        shape("quay wall", [(-40, 589), (486, 589), (482, 624), (-40, 624)], ("#a97863", "#6d4b4b"))
        shape("quay", [(-40, 570), (475, 570), (483, 573), (487, 580), (487, 592), (-40, 592)], ("#f3d9b0", "#d9b186"))
        for colour, odd in (("#c08f78", 0), ("#6b4645", 1)):
            shapes("stones", [rectangle(x - 8, y - 1.1, x + 8, y + 1.1) for x, y in
                              ((10 + 29 * k, (601, 609, 617)[(k * 2) % 3]) for k in range(odd, 17, 2))], colour)
        lamps = (133, 213, 281, 354, 436)
        shapes("posts", [[(x - 3, 585), (x - 1, 582), (x - 0.9, 546), (x + 0.9, 546), (x + 1, 582), (x + 3, 585)]
                         for x in lamps], INK)
        shapes("light of the lamps", [oval(x, 543, 9) for x in lamps], "#fff6e0a0", style=SOFT, spread=5)
        shapes("lamps", [oval(x, 543, 4.2) for x in lamps], ("#fff0b8", "#f6b84e"))
        shapes("bollards", [[(x - 2.2, 591), (x - 2.8, 584)] + oval(x, 584, 2.8, 1.6, start=180, end=360)
                            + [(x + 2.2, 591)] for x in (170, 245, 318, 394, 468)], INK)
    dinghy(284, 645, 0.92, ("#cf5538", "#96352a"))
    dinghy(386, 662, 1.0, ("#fff6e6", "#e0c3a2"))


# ---------------------------------------------------------------- foreground

def blade(x, y, h, lean):
    tip = (x + lean, y - h)
    return [[(x, y), (x - 2.4, y - 0.4 * h), (x + 0.2 * lean - 1.4, y - 0.7 * h), tip],
            [tip, (x + 0.2 * lean + 1.6, y - 0.66 * h), (x + 2.2, y - 0.36 * h), (x, y)]]


def foreground():
    land = [(-40, 676), (60, 660), (170, 676), (290, 712), (400, 748), (500, 800)]
    top = lambda x: next(a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) for a, b in zip(land, land[1:]) if x <= b[0])
    with p.group("shore"):
        for x, h, fat in ((36, 218, 0.14), (92, 154, 0.15), (138, 102, 0.16)):
            cypress(x, top(x) + 14, h, "#0b2530", "#2a6470", fat)
        tufts = [150 + 11.5 * k + rng.uniform(-4, 4) for k in range(26)]
        shapes("grass at the edge", [blade(x, top(x) + 12, rng.uniform(26, 46), rng.uniform(-14, 18)) for x in tufts],
               ("#2d6b74", "#164152"), 105)
        shape("shore", through(land) + [(500, 820), (-40, 820)], ("#1f4c5b", "#0c2430"), 105)
        poppies = [(x, top(x) - up, r, lean, look) for x, up, r, lean, look in (
            (186, 34, 7, 6, 0), (206, 18, 6, -3, 1), (246, 36, 7.5, 5, 0), (268, 14, 5.5, 8, 2), (300, 34, 7, -4, 1),
            (322, 22, 6, 6, 0), (362, 30, 6.5, 4, 2), (384, 16, 5.5, -3, 0))]
        shapes("stems", [tapered([(x - lean, y + rng.uniform(46, 66)), (x - 0.2 * lean, y + 20), (x, y)], [0, 1.2, 0.9])
                         for x, y, _, lean, _ in poppies], ("#8cc0a0", "#2a6068"), 105)
        for x, y, r, _, look in poppies:
            light, dark = (("#f58a64", "#c8452f"), ("#f9b796", "#d9765a"), ("#ffdd86", "#e0993a"))[look]
            shape("far petal", oval(x, y - 0.35 * r, 0.86 * r, 0.62 * r), dark)
            half = [(0, 0.85), (0.8, 0.5), (1.1, -0.55), (0.45, -0.2), (0, -0.5)]
            cup = half + [(-a, b) for a, b in half[-2:0:-1]]
            shape("cup", through(placed(cup, x, y, r), True), (light, dark))
        tufts = [168 + 13 * k + rng.uniform(-5, 5) for k in range(20)]
        shapes("grass", [blade(x, top(x) + rng.uniform(24, 52), rng.uniform(20, 34), rng.uniform(-12, 14))
                         for x in tufts], ("#4a9290", "#205062"), 105)


sky()
hills()
sea()
boat("sailing boat, far", 890, 504, 0.42, (("#fff6e4", "#f6d8b0"), ("#fbe3c0", "#e9bd92"), ("#e6c6a2", "#f6dcb8")),
     ("#c9553b", "#8d332b"))
boat("sailing boat, small", 486, 516, 0.46, (("#fbd27a", "#e9a548"), ("#fff6e4", "#f3d6b2"), ("#dc9a40", "#f0b557")),
     ("#2a6876", INK))
town()
quay()
boat("sailing boat", 846, 648, 1.2, (("#fffaf0", "#f8dcb8"), ("#f0805c", "#cf4a38"), ("#e3c8ae", "#f6e0c4")),
     ("#235566", "#0d2733"))
foreground()
p.write(sys.argv[1] if len(sys.argv) > 1 else "flat.json")
