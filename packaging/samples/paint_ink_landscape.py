#!/usr/bin/env python3
"""Paints ink-landscape: mountains in the mist, two pines, a boat; ink on paper.

    paint_ink_landscape.py OUT.json
    suffuse-cli convert OUT.json ink-landscape.suffuse
"""
import math
import random
import sys

import paintbox as pb

PAPER = "#f4efe2"
INK = "#1c1c1f"
BLUE_INK = "#364352"
OCHRE = "#7a5a36"
WOOD = "#2a2118"
PALE = pb.ryb(PAPER)
VERMILION = pb.ryb("#b5301f")
THIRDS = (1 / 3, 2 / 3, 1)
rng = random.Random(1603)


def between(a, b, t):
    """From '#rrggbb' a (t = 0) to b (t = 1)."""
    return "#" + "".join(f"{round(pb.lerp(int(a[i:i + 2], 16), int(b[i:i + 2], 16), t)):02x}" for i in (1, 3, 5))


def ink(tone, opacity=1.0, base=INK):
    """Ink thinned with water: tone 0 is the paper's colour, 1 the ink's. Mixed as light: as pigment, the yellowish
    paper would turn the greys green."""
    return pb.ryb(between(PAPER, base, tone), opacity)


def hand(painting, name, points, pressure, colour, softness=0.1, granulation=0.6, step=3.0):
    """A brush stroke whose spread follows its half-width, so that it tapers to a crisp point. pressure: half-widths
    along the stroke; colour: one, or a list along the stroke."""
    at = pb.ramp(*[(i / (len(pressure) - 1), w) for i, w in enumerate(pressure)])
    colours = colour if isinstance(colour, list) else [colour, colour]
    shade = pb.ramp(*[(i / (len(colours) - 1), c) for i, c in enumerate(colours)])
    nodes = pb.resampled(pb.curve(points, step=1.5), step)
    n, segments = len(nodes) - 1, []
    for k, bezier in enumerate(pb.smoothed(nodes)):
        w = max(0.3, at((k + 0.5) / n))
        s = max(0.6, 0.85 * w)
        density = 0.5 * pb.ROOT_PI * s * math.exp((w / s) ** 2)
        segments.append((bezier, s, density, granulation, shade((k + 0.5) / n)))
    painting.add(name, segments, pb.uniform(softness), pb.COVER)


# ---------------------------------------------------------------- mountains

def ridge(points, rough, seed, step=3.0):
    """The skyline as heights every `step` units of x: [(x, y)], shaken by a hand's noise, more where steep."""
    path = pb.curve(points, step=2.0)
    n1, n2, n3 = (pb.Noise(seed + k) for k in range(3))
    out, k, x = [], 0, path[0][0]
    while x < path[-1][0]:
        while path[k + 1][0] <= x:
            k += 1
        (x0, y0), (x1, y1) = path[k], path[k + 1]
        y = pb.lerp(y0, y1, (x - x0) / (x1 - x0))
        steep = min(2.0, abs((y1 - y0) / (x1 - x0)))
        shake = n1(x / 31) + 0.7 * (1 - 2 * abs(n2(x / 12))) + 0.4 * n3(x / 6)
        out.append((x, y + rough * (0.6 + steep) * shake))
        x += step
    return out


def softened(line, reach):
    """The skyline averaged over `reach` units to both sides."""
    step, n = line[1][0] - line[0][0], len(line)
    k = int(reach / step)
    if k < 1:
        return line
    sums = [0.0]
    for _, y in line:
        sums.append(sums[-1] + y)
    return [(x, (sums[min(n, i + k + 1)] - sums[max(0, i - k)]) / (min(n, i + k + 1) - max(0, i - k)))
            for i, (x, y) in enumerate(line)]


def mountain(painting, name, skyline, depth, shade, crisp=3.0, broad=15.0, granulation=1.0, softness=0.06,
             grown=1.16):
    """One wash below a skyline: passes of the brush that follow it, ever broader and paler towards the mist.
    shade(x, y, d): the colour d units below the skyline."""
    offsets, spreads, d, s = [], [], 0.0, crisp
    while d < depth:
        pitch = 1.05 * s
        offsets.append(d + pitch / 2)
        spreads.append(s)
        d, s = d + pitch, min(broad, s * grown)
    levels = [[(x, y + o) for x, y in softened(skyline, 0.22 * o)] for o in offsets]
    segments, last = [], None
    for i, s in enumerate(spreads):
        line = levels[i]
        stride = max(1, round(1.3 * s / (skyline[1][0] - skyline[0][0])))
        picks = list(range(0, len(line) - 1, stride)) + [len(line) - 1]
        if i % 2:
            picks.reverse()
        nodes = [line[k] for k in picks]
        if last:
            segments.append(([last] + [tuple(pb.lerp(last[a], nodes[0][a], t) for a in (0, 1)) for t in THIRDS],
                             s, 0.0, granulation, shade(*nodes[0], offsets[i])))
        for (k0, k1), points in zip(zip(picks, picks[1:]), pb.smoothed(nodes)):
            k = (k0 + k1) // 2
            above = levels[i - 1][k][1] if i else skyline[k][1] - (line[k][1] - skyline[k][1])
            below = levels[i + 1][k][1] if i + 1 < len(levels) else 2 * line[k][1] - above
            run, rise = points[3][0] - points[0][0], points[3][1] - points[0][1]
            density = (below - above) / 2 * abs(run) / math.hypot(run, rise)
            x, y = line[k]
            segments.append((points, s, density, granulation, shade(x, y, y - skyline[k][1])))
        last = nodes[-1]
    painting.add(name, segments, pb.uniform(softness), pb.COVER)


def mist_shade(tone, fall, depth, seed, base=INK, streak=0.3, ends=None, grain=(16, 70), warm=0.0):
    """Dark along the skyline, paler below (1/e after `fall` units), mist at `depth`; streaks run down the slope.
    ends: (x where it begins, x where it is full) at the left and the right; warm: how much ochre is in it, inside."""
    noise, slow = pb.Noise(seed), pb.Noise(seed + 9)

    def shade(x, y, d):
        fade_out = pb.ramp((0.0, 1.0), (1.0, 0.0))
        t = tone * (0.25 + 0.75 * math.exp(-d / fall)) * fade_out(d / (0.8 * depth))
        t *= 1 + streak * noise(x / grain[0] + d / 90, d / grain[1]) + 0.2 * slow(x / 110, d / 60)
        cover = fade_out(max(0.0, (d / depth - 0.55) / 0.45))
        if ends:
            (l0, l1), (r0, r1) = ends
            side = pb.ramp((0, 0.0), (1, 1.0))
            share = side((x - l0) / (l1 - l0)) * side((r0 - x) / (r0 - r1))
            t, cover = t * share, cover * share
        tint = warm * min(1.0, d / fall)
        return ink(max(0.0, min(1.0, t)), cover, between(base, OCHRE, tint) if warm else base)
    return shade


def wash(painting, name, points, width, colour, power=1.2, granulation=1.0):
    """A feathering veil: one broad wet stroke that fades on all sides."""
    n = 7
    swell = [width * (0.35 + 0.65 * math.sin(math.pi * (k + 0.5) / n)) for k in range(n)]
    s = 0.7 * width
    painting.line(name, points, swell, colour, pb.feather(1.1, power), spread=s, step=0.8 * s, granulation=granulation)


def moss(painting, skyline, spots, seed, tone=0.85, size=2.0):
    """Clusters of dabs on a skyline: trees and moss seen from afar. spots: (x, number of dabs, reach)."""
    r = random.Random(seed)
    for x0, count, reach in spots:
        for _ in range(count):
            away = r.gauss(0, 0.55)
            k = min(len(skyline) - 1, max(0, round((x0 + away * reach - skyline[0][0]) / 3)))
            x, y = skyline[k][0] + r.uniform(-1.5, 1.5), skyline[k][1]
            y += size * (r.uniform(-1.3, 1.4) + 0.8 * abs(away))
            w, h = size * r.uniform(0.55, 1.15), size * r.uniform(0.25, 0.8)
            tilt = r.uniform(-0.25, 0.5) * h
            painting.line("dab", [(x - h, y - tilt), (x, y), (x + h, y + tilt)], [0.7 * w, w, 0.8 * w],
                          ink(tone * r.uniform(0.7, 1), r.uniform(0.5, 0.95)), pb.uniform(0.15), step=h,
                          granulation=0.6)


def rock_folds(painting, folds, seed, tone, width, opacity=0.8, shade=11):
    """The edges inside a rock: a wet shadow on the shaded side, the fold itself with a loaded brush, dry strokes
    across the shadow. folds: (points, side); shade: the shadow's breadth."""
    r = random.Random(seed)
    for points, side in folds:
        path = pb.wobbly(pb.curve(points, step=3.0), 2.6, 11, r.randrange(999))
        n = len(path)
        veil = [(x + side * 0.55 * shade * math.sin(math.pi * (i + 2) / (n + 3)), y + 3)
                for i, (x, y) in enumerate(path)]
        painting.line("fold shadow", veil[::4], [0.35 * shade, 0.75 * shade, 0.6 * shade, 0.3 * shade],
                      [ink(0.8 * tone, 0.34 * opacity), ink(0.7 * tone, 0.3 * opacity), ink(0.6 * tone, 0.0)],
                      pb.feather(1.2, 1.3), spread=0.6 * shade, step=0.5 * shade, granulation=0.7)
        hand(painting, "fold", path[::3], [0.3, 0.9 * width, 0.5 * width, width, 0.45 * width, 0.3],
             [ink(tone, opacity), ink(tone, 0.9 * opacity), ink(0.8 * tone, 0.3 * opacity)], 0.14, 0.35, 4)
        k = r.randrange(3, 6)
        while k < n - 3:
            x, y = path[k]
            size = r.uniform(12, 34) * math.sin(math.pi * (k + 4) / (n + 6))
            line = [(x, y), (x + side * 0.2 * size, y + 0.5 * size), (x + side * r.uniform(0.2, 0.45) * size, y + size)]
            w = width * r.uniform(0.7, 1.7)
            painting.line("dry stroke", line, [0.5 * w, w, 0.2], ink(0.8 * tone, opacity * r.uniform(0.14, 0.32)),
                          pb.uniform(0.22), step=5, granulation=0.1)
            k += r.randrange(3, 8)


def trees(painting, skyline, groves, seed, tone, tall):
    """Firs seen from afar, each one zigzag from the tip down. groves: (x, number, reach)."""
    r = random.Random(seed)
    for x0, count, reach in groves:
        for _ in range(count):
            away = r.gauss(0, 0.6)
            k = min(len(skyline) - 1, max(0, round((x0 + away * reach - skyline[0][0]) / 3)))
            below = abs(r.gauss(0, 0.5)) * tall
            x, y, h = skyline[k][0] + r.uniform(-1.5, 1.5), skyline[k][1] + 2 + below, tall * r.uniform(0.55, 1.15)
            h *= 1 - 0.35 * min(1.0, abs(away))
            points, pressure = [(x, y - h)], [0.2]
            for i in range(1, 11):
                t = i / 10
                points.append((x + (-1) ** i * 0.2 * h * t * r.uniform(0.7, 1.2), y - h * (1 - t) + r.uniform(-.4, .4)))
                pressure.append(0.45 + 0.055 * h * t * r.uniform(0.7, 1.2))
            thin = math.exp(-below / tall)
            painting.line("fir", points, pressure, ink(tone * r.uniform(0.75, 1), r.uniform(0.6, 0.9) * thin),
                          pb.uniform(0.14), spread=0.05 * h + 0.3, step=2.4, granulation=0.7, smooth=False)


def contour(painting, skyline, x0, x1, seed, tone, heavy):
    """A broken line of ink along a part of a skyline."""
    r = random.Random(seed)
    part = [p for p in skyline if x0 <= p[0] <= x1]
    pressure = [0.2] + [heavy * r.choice((0.25, 0.6, 1.0, 1.2)) for _ in range(max(3, len(part) // 4))] + [0.2]
    hand(painting, "contour", [(x, y + 0.8) for x, y in part], pressure, ink(tone, 0.6), 0.16, 0.35, 4)


def far_mountains(painting):
    with painting.group("far shore"):
        shore = ridge([(-40, 512), (20, 500), (70, 488), (110, 496), (150, 508), (200, 514), (260, 522)], 1.2, 17)
        mountain(painting, "far shore", shore, 46,
                 mist_shade(0.2, 16, 46, 27, BLUE_INK, 0.1, ((-900, -800), (262, 150))), 4, 10, softness=0.14)
    with painting.group("far mountains"):
        far = ridge([(250, 420), (330, 372), (400, 345), (450, 338), (520, 352), (600, 318), (700, 300), (790, 262),
                     (850, 240), (900, 262), (950, 268), (1000, 240), (1070, 222)], 2.6, 11)
        for name, part, ends in (("western range", far[:122], ((250, 440), (616, 540))),
                                 ("eastern range", far[122:], ((640, 720), (2000, 1500)))):
            mountain(painting, name, part, 160, mist_shade(0.27, 60, 160, 21, BLUE_INK, 0.1, ends), 7, 18,
                     softness=0.14)
    with painting.group("great peak"):
        hero = ridge([(470, 440), (510, 402), (530, 350), (548, 318), (556, 262), (566, 222), (574, 206),
                      (588, 200), (594, 160), (600, 124), (611, 112), (620, 116), (628, 92), (638, 84), (648, 94),
                      (653, 118), (664, 126), (670, 168), (678, 188), (692, 196), (700, 252), (722, 300),
                      (742, 352), (780, 400), (840, 430)], 3.4, 12)
        mountain(painting, "summit", hero, 330,
                 mist_shade(0.66, 70, 330, 22, BLUE_INK, 0.45, ((470, 540), (840, 750)), (9, 120), 0.5),
                 2.6, 12, softness=0.09)
        rock_folds(painting, [([(624, 112), (618, 150), (604, 190), (598, 236), (584, 280)], 1),
                              ([(650, 114), (652, 156), (642, 196), (646, 240)], 1),
                              ([(664, 186), (672, 220), (668, 256)], 1),
                              ([(584, 220), (574, 262), (562, 300), (556, 340)], 1),
                              ([(628, 190), (622, 226), (626, 262)], 1)], 61, 0.62, 1.9)
        for x0, x1 in ((553, 572), (588, 606), (626, 656), (664, 694)):
            contour(painting, hero, x0, x1, x0, 0.7, 1.5)
        trees(painting, hero, [(606, 4, 4), (686, 6, 4), (578, 4, 4)], 71, 0.8, 9)
        spur = ridge([(640, 420), (664, 372), (676, 316), (690, 268), (704, 246), (722, 236), (738, 246), (748, 282),
                      (764, 300), (776, 340), (800, 372), (840, 384), (890, 430)], 3.2, 15)
        mountain(painting, "eastern spire", spur, 230,
                 mist_shade(0.66, 60, 230, 25, BLUE_INK, 0.45, ((630, 672), (880, 800)), (9, 100), 0.5),
                 2.4, 11, softness=0.08)
        rock_folds(painting, [([(716, 246), (712, 286), (698, 322), (694, 360)], 1),
                              ([(740, 272), (742, 308), (736, 338)], 1)], 62, 0.66, 1.8)
        for x0, x1 in ((690, 742), (746, 778)):
            contour(painting, spur, x0, x1, x0, 0.75, 1.5)
        trees(painting, spur, [(759, 7, 6), (812, 8, 14)], 72, 0.82, 11)
        west = ridge([(470, 470), (498, 428), (510, 384), (522, 356), (536, 344), (552, 352), (562, 380), (580, 400),
                      (596, 440), (640, 470)], 2.6, 16)
        mountain(painting, "western spire", west, 170,
                 mist_shade(0.55, 46, 170, 26, BLUE_INK, 0.4, ((462, 506), (640, 585)), (9, 90), 0.5),
                 2.6, 11, softness=0.09)
        rock_folds(painting, [([(534, 350), (528, 382), (518, 410)], 1), ([(554, 366), (556, 392), (550, 414)], 1)],
                   63, 0.58, 1.6)
        contour(painting, west, 519, 566, 5, 0.6, 1.4)
        trees(painting, west, [(577, 7, 8)], 73, 0.75, 10)


def near_mountains(painting):
    with painting.group("wooded ridge"):
        near = ridge([(600, 520), (660, 486), (710, 462), (760, 440), (800, 414), (840, 408), (880, 376), (915, 352),
                      (950, 356), (985, 330), (1070, 290)], 2.8, 13)
        mountain(painting, "ridge wash", near, 190,
                 mist_shade(0.62, 44, 190, 23, INK, 0.35, ((600, 800), (2000, 1500)), (12, 90)), 2.8, 13, softness=0.08)
        rock_folds(painting, [([(912, 360), (900, 392), (880, 416)], 1), ([(984, 340), (976, 376), (984, 410)], 1)],
                   64, 0.7, 1.8)
        trees(painting, near, [(812, 5, 12), (846, 6, 12), (884, 7, 12), (908, 4, 8), (944, 7, 12), (976, 5, 9),
                               (1004, 9, 12)], 74, 0.88, 21)


# ---------------------------------------------------------------- pines

def needles(painting, x, y, size, tone, lean=0.0):
    """A fan of needles: the brush goes out and comes back without pressure."""
    segments, count = [], rng.randint(7, 9)
    s, root = 0.8, 0.16
    for i in range(count):
        a = math.radians(-90 + lean + pb.lerp(-84, 84, (i + rng.uniform(0.2, 0.8)) / count))
        reach = size * rng.uniform(0.8, 1.2) * (0.85 + 0.15 * math.cos(a + math.pi / 2))
        bow = rng.uniform(-0.1, 0.1)
        at = lambda t: (x + reach * t * math.cos(a + bow * t), y + reach * t * math.sin(a + bow * t))
        for t0, t1, w in ((root, 0.55, 0.68), (0.55, 0.85, 0.6), (0.85, 1.0, 0.36)):
            points = [at(pb.lerp(t0, t1, k / 3)) for k in range(4)]
            if t0 == root and segments:
                tip, foot = segments[-1][0][3], points[0]
                back = [tip] + [(pb.lerp(tip[0], foot[0], t), pb.lerp(tip[1], foot[1], t)) for t in THIRDS]
                segments.append((back, s, 0.0, 1.0, ink(tone, 0.95)))
            segments.append((points, s, 0.5 * pb.ROOT_PI * s * math.exp((w / s) ** 2), 1.0, ink(tone, 0.95)))
    painting.add("needles", segments, pb.uniform(0.08), pb.COVER)


def branch(painting, points, width, tone=0.95):
    hand(painting, "branch", points, [0.8 * width, 0.8 * width, 0.5 * width, 0.45 * width, 0.3],
         [ink(0.78), ink(0.88), ink(tone)], 0.1, 0.5)


def clouds(painting, points, size, tone=0.95):
    """The needles along the outer part of a branch: a wet grey cloud, then fans, pale ones behind, dark ones before."""
    path = pb.resampled(pb.curve(points), 5.5)
    pad = path[len(path) * 2 // 5:]
    mid, n = pad[len(pad) // 2], len(pad)
    span = math.dist(pad[0], pad[-1])
    veil = [(pad[k][0], pad[k][1] - 0.42 * size) for k in (0, n // 3, 2 * n // 3, n - 1)]
    wash(painting, "needle cloud", veil, 0.6 * size, ink(0.72, 0.62), granulation=0.6)
    for behind in (True, False):
        for i, (x, y) in enumerate(pad):
            swell = math.sin(math.pi * (i + 0.6) / (n + 0.2))
            if behind and (swell < 0.5 or i % 2):
                continue
            lean = (x - mid[0]) / max(20, span) * 60
            lift = (0.75 if behind else 0.28) * size * swell
            needles(painting, x + rng.uniform(-2, 2), y - lift + rng.uniform(-2, 2), size * (0.7 + 0.3 * swell),
                    (0.72 if behind else 0.96) * tone, lean)


def trunk(painting, points, widths, tone=0.92):
    """A pine's trunk: a grey wash, darker upwards and on its shaded side, and dry strokes of bark along it."""
    hand(painting, "trunk", points, widths, [ink(0.5, 1, WOOD), ink(0.56, 1, WOOD), ink(0.8)], 0.08, 0.75, 4)
    path = pb.resampled(pb.curve(points), 3.0)
    at = pb.ramp(*[(i / (len(widths) - 1), w) for i, w in enumerate(widths)])

    def beside(i, share):
        (ax, ay), (bx, by) = path[i - 1], path[i + 1]
        u, w = math.hypot(bx - ax, by - ay), share * at(i / len(path))
        return (path[i][0] - (by - ay) / u * w, path[i][1] + (bx - ax) / u * w)

    thick = max(widths)
    for share, heavy in ((0.72, 0.24), (0.4, 0.12), (-0.9, 0.1)):
        nodes = [beside(i, share * rng.uniform(0.93, 1.05)) for i in range(1, len(path) - 1, 4)]
        pressure = [heavy * at(k / 8) * rng.uniform(0.6, 1.1) for k in range(9)]
        painting.line("bark line", nodes, [max(0.6, p) for p in pressure], ink(tone, 0.92), pb.uniform(0.12),
                      spread=max(0.9, 0.6 * heavy * thick), step=4, granulation=0.4)
    for i in range(3, len(path) - 8, 2):
        w, share = at(i / len(path)), rng.uniform(-0.6, 0.7)
        if w < 4:
            continue
        reach = rng.randint(2, 4)
        nodes = [beside(i + k, share + rng.uniform(-0.08, 0.08)) for k in range(reach + 1)]
        painting.line("bark", nodes, [0.3, 0.5 + 0.07 * w, 0.2], ink(tone, rng.uniform(0.4, 0.8)), pb.uniform(0.12),
                      spread=0.9, step=3, granulation=0.3)


def pine(painting, name, stem, widths, boughs):
    with painting.group(name):
        for points, width, _ in boughs:
            branch(painting, points, width)
        trunk(painting, stem, widths)
        for points, _, size in boughs:
            clouds(painting, points, size)


def pines(painting):
    pine(painting, "old pine",
         [(868, 654), (878, 612), (872, 580), (886, 545), (870, 500), (838, 464), (830, 428), (806, 400), (784, 388)],
         [17, 11.5, 10, 9.5, 8, 6.5, 5, 3.6, 1.4],
         (([(884, 548), (908, 520), (945, 510), (990, 514)], 4, 15),
          ([(872, 502), (840, 516), (796, 524), (750, 516), (706, 524)], 4.4, 16),
          ([(846, 514), (824, 502), (796, 496), (768, 503)], 2.0, 12),
          ([(900, 526), (922, 500), (944, 488), (966, 488)], 2.0, 12),
          ([(848, 474), (880, 452), (912, 446), (948, 450)], 3.2, 14),
          ([(840, 466), (800, 474), (770, 468), (738, 476)], 3.0, 14),
          ([(824, 470), (806, 456), (782, 448), (760, 452)], 1.8, 12),
          ([(828, 425), (850, 408), (892, 404)], 2.6, 13),
          ([(816, 410), (784, 424), (752, 418), (716, 428)], 2.6, 14),
          ([(806, 400), (818, 382), (842, 372), (866, 374)], 2.2, 12),
          ([(790, 392), (776, 376), (752, 370), (728, 376)], 1.8, 12),
          ([(794, 394), (788, 368), (800, 352), (822, 350)], 1.7, 12)))
    pine(painting, "young pine", [(944, 684), (952, 646), (958, 604), (950, 570), (962, 546)], [9, 6.5, 5.2, 4, 1.5],
         (([(955, 592), (976, 580), (1004, 578), (1036, 584)], 2.2, 12),
          ([(952, 584), (932, 576), (908, 578)], 2.0, 11),
          ([(956, 558), (974, 548), (998, 548)], 1.8, 11),
          ([(960, 550), (956, 540), (938, 534)], 1.6, 10)))


# ---------------------------------------------------------------- foreground

def rock(painting, points, depth, seed, folds=(), tone=0.85, mossy=()):
    """A boulder: wash, a broken outline of changing pressure, folds, moss."""
    with painting.group("rock"):
        top = ridge(points, 1.3, 200 + seed, 3.0)
        x0, x1 = top[0][0], top[-1][0]
        mountain(painting, "rock wash", top, depth,
                 mist_shade(tone, 0.36 * depth, depth, 240 + seed, INK, 0.4, ((x0 - 2, x0 + 16), (x1 + 2, x1 - 16)),
                            (9, 40), 0.5),
                 2.2, 9, softness=0.1, granulation=0.8)
        r = random.Random(seed)
        pressure = [0.4] + [r.uniform(0.6, 2.9) for _ in range(max(4, len(top) // 8))] + [0.4]
        hand(painting, "outline", top[::2], pressure, ink(0.98), 0.1, 0.4, 3.5)
        rock_folds(painting, folds, 280 + seed, 0.95, 2.2, 0.85, 12)
        moss(painting, top, mossy, 320 + seed, 0.98, 2.3)


def back_rocks(painting):
    rock(painting, [(822, 668), (846, 616), (872, 602), (910, 604), (940, 622), (972, 606), (1000, 588), (1036, 584),
                    (1070, 590)], 130, 1,
         [([(912, 612), (920, 644), (912, 676)], 1), ([(966, 614), (954, 640), (958, 680)], -1),
          ([(1004, 596), (998, 636), (1008, 672)], 1)], 0.82, ((1004, 12, 14), (862, 8, 7)))


def front_rocks(painting):
    rock(painting, [(760, 690), (776, 656), (806, 636), (842, 630), (872, 642), (896, 668), (930, 690)], 96, 2,
         [([(808, 644), (800, 668), (806, 694)], -1), ([(846, 638), (856, 666), (850, 696)], 1)], 0.85,
         ((780, 9, 9), (884, 10, 9)))
    rock(painting, [(900, 716), (918, 682), (950, 668), (990, 672), (1030, 660), (1070, 666)], 92, 3,
         [([(950, 676), (944, 704), (952, 730)], -1), ([(996, 680), (1002, 712), (996, 738)], 1)], 0.9,
         ((922, 8, 8), (992, 10, 9)))
    rock(painting, [(672, 706), (684, 690), (706, 680), (734, 684), (756, 698), (772, 712)], 44, 4,
         [([(710, 686), (706, 700), (712, 714)], 1)], 0.8, ((690, 6, 6),))
    rock(painting, [(620, 716), (630, 708), (644, 706), (658, 712), (664, 718)], 18, 5, (), 0.75)


def grass(painting):
    with painting.group("reeds"):
        for x, y, count, tall, reach in ((660, 716, 8, 34, 9), (766, 712, 7, 40, 8), (908, 722, 8, 40, 10)):
            for _ in range(count):
                foot, base = x + rng.gauss(0, reach), y + rng.uniform(-4, 4)
                lean, size = rng.uniform(-0.85, 0.35), tall * rng.uniform(0.55, 1.2)
                hand(painting, "blade", [(foot, base), (foot + 0.12 * lean * size, base - 0.5 * size),
                                        (foot + 0.45 * lean * size, base - 0.85 * size),
                                        (foot + 0.95 * lean * size, base - size * (1.02 - 0.4 * lean * lean))],
                     [0.4, 1.0, 0.8, 0.3], ink(rng.uniform(0.6, 0.95), 0.9), 0.1, 0.8, 5)


# ---------------------------------------------------------------- water, boat, birds, seal

def water(painting):
    with painting.group("water"):
        for x, y, length, w, o in ((640, 716, 150, 2.0, 0.3), (560, 700, 90, 1.4, 0.25), (760, 730, 180, 2.4, 0.35),
                                   (330, 668, 110, 1.4, 0.28), (250, 690, 70, 1.2, 0.2), (430, 640, 60, 1.0, 0.18),
                                   (150, 640, 90, 1.2, 0.16), (880, 748, 160, 2.4, 0.35)):
            points = [(x + length * (t - 0.5), y + 1.5 * math.sin(7 * t + x)) for t in (0, 0.25, 0.5, 0.75, 1)]
            painting.line("ripple", points, [0.1, w, 0.5 * w, w, 0.1], ink(0.6, o), pb.uniform(0.15),
                          spread=1.6, step=8)


def shallows(painting):
    """Wet strokes where the rocks stand in the water."""
    with painting.group("shallows"):
        for x, y, length, w, o in ((650, 719, 62, 1.5, 0.5), (724, 716, 104, 1.8, 0.5), (812, 724, 120, 2.2, 0.5),
                                   (868, 733, 90, 1.8, 0.4), (950, 744, 140, 2.6, 0.5), (1000, 756, 120, 2.2, 0.4),
                                   (700, 730, 70, 1.3, 0.3)):
            points = [(x + length * (t - 0.5), y + 1.2 * math.sin(8 * t + x)) for t in (0, 0.2, 0.4, 0.6, 0.8, 1)]
            painting.line("wet edge", points, [0.1, w, 0.4 * w, w, 0.6 * w, 0.1], ink(0.75, o), pb.uniform(0.2),
                          spread=1.8, step=8, granulation=0.6)


def fisherman(painting, at, k):
    hand(painting, "cloak", at([(-44, -2), (-44, -8), (-42, -15)]), [5.4 * k, 4.6 * k, 2.0 * k], ink(0.62), 0.1, 0.8, 2)
    hand(painting, "cloak edge", at([(-40, -1), (-39, -8), (-41, -15)]), [1.2, 1.0, 0.4], ink(0.95))
    painting.fill("hat", at([(-52, -15), (-46, -19), (-42, -23), (-38, -19.5), (-32, -15.5), (-42, -16.8)]), ink(0.97),
                  s=1.0 * k, style=pb.uniform(0.1))
    hand(painting, "rod", at([(-47, -9), (-70, -25), (-98, -36)]), [0.9, 0.7, 0.4], ink(0.9), 0.1, 0.9, 6)
    painting.line("fishing line", at([(-98, -36), (-99, -14), (-99, 10)]), [0.45, 0.4, 0.35], ink(0.5, 0.7), spread=0.7,
                  step=8)
    painting.line("ring", at([(-108, 11), (-99, 12.6), (-90, 11)]), [0.2, 0.8, 0.2], ink(0.6, 0.5), spread=1, step=4)


def boat(painting, x, y, k):
    def at(points):
        return pb.placed(points, x, y, k)

    with painting.group("boat"):
        wash(painting, "reflection", at([(-40, 13), (0, 16), (38, 13)]), 4.5 * k, ink(0.5, 0.4))
        arch = [(-26, 1), (-24, -8), (-15, -14.5), (0, -17), (13, -15), (21, -9), (24, 1)]
        painting.fill("canopy", at(pb.curve(arch, step=3)),
                      pb.across(*at([(-26, -8)])[0], *at([(24, 0)])[0], [(0, ink(0.35)), (1, ink(0.72))]),
                      s=1.8 * k, style=pb.uniform(0.09), granulation=0.8)
        hand(painting, "canopy edge", at([(px, py - 0.6) for px, py in arch]), [0.5, 1.2, 0.8, 1.3, 0.7, 1.4, 0.6],
             ink(0.95))
        for t in (-15, -6, 3, 12):
            top = -16.5 + 0.012 * (t + 1) ** 2
            hand(painting, "mat", at([(t - 1.5, -1), (t - 1, 0.55 * top), (t + 1, top + 1)]), [0.8, 0.6, 0.3],
                 ink(0.9, 0.85), 0.1, 0.5, 4)
        fisherman(painting, at, k)
        hull = [(-64, -12), (-44, -3.5), (-20, 0), (10, 0.5), (36, -2), (62, -12), (50, 3), (30, 8), (0, 9.5), (-30, 8),
                (-50, 3)]
        painting.fill("hull", at(pb.curve(hull, True, 3)), ink(0.82), s=1.6 * k, style=pb.uniform(0.1),
                      granulation=0.85)
        hand(painting, "gunwale", at([(-68, -15), (-46, -4), (-10, 0.5), (20, 0), (42, -3.5), (66, -15)]),
             [0.3, 1.5, 1.1, 0.9, 1.5, 0.4], ink(1), 0.08, 0.8, 4)


def birds(painting):
    """Geese on their way, each two wing strokes in one."""
    with painting.group("birds"):
        for x, y, k, turn, flap in ((344, 222, 0.95, -10, 1.0), (374, 208, 0.85, -14, 0.4), (402, 199, 0.75, -8, 1.2),
                                    (318, 242, 0.8, -6, 0.2), (428, 194, 0.6, -12, 0.7), (366, 240, 0.65, -4, 0.9)):
            wings = [(-14, -3 - 4 * flap), (-8, -4 - 3 * flap), (-2, -1), (0, 0.6), (3, -1), (9, -5 - 2 * flap),
                     (15, -4 - 2 * flap)]
            hand(painting, "goose", pb.placed(wings, x, y, k, turn), [0.3, 0.9, 1.1, 1.8, 1.1, 0.9, 0.3], ink(0.85),
                 0.1, 0.9, 2)


def brush(painting, name, x, y, k, strokes):
    """A character: strokes as (points, pressures) in a square of 100 units."""
    with painting.group(name):
        for points, pressure in strokes:
            hand(painting, "stroke", pb.placed(points, x, y, k), [p * k for p in pressure], ink(0.98), 0.06, 0.6, 2.0)


def inscription(painting, x, y, size):
    """山水, mountains and water: what the picture shows, and what its genre is called."""
    k = size / 100
    brush(painting, "山", x, y, k, (
        ([(50, 8), (52, 30), (50, 60), (51, 80)], [7, 6, 5, 6]),
        ([(15, 42), (17, 62), (18, 83), (24, 85), (50, 81), (84, 79)], [6, 5, 5.5, 4.5, 4, 5]),
        ([(85, 36), (87, 58), (85, 84), (84, 92)], [7, 5.5, 5, 2])))
    brush(painting, "水", x, y + 1.25 * size, k, (
        ([(50, 4), (52, 30), (51, 62), (50, 92), (44, 92), (35, 84)], [7, 5.5, 5.5, 6, 3, 0.4]),
        ([(12, 34), (26, 32), (40, 29), (36, 44), (24, 62), (8, 76)], [4, 4, 5.5, 4.5, 3.5, 0.6]),
        ([(84, 20), (76, 30), (66, 38), (57, 42)], [5.5, 4.5, 3, 0.6]),
        ([(55, 42), (66, 56), (80, 70), (95, 79), (100, 78)], [2, 3.5, 5.5, 7.5, 0.6])))


def seal(painting, x, y, size):
    """A square of cinnabar paste with the character 心 (heart) cut out of it, in the manner of old seals."""
    with painting.group("seal"):
        corner = pb.resampled(pb.rectangle(0, 0, size, size) + [(0, 0)], 4)[:-1]
        square = [(x + px, y + py) for px, py in pb.wobbly(corner, 1.3, 7, 3)]
        painting.fill("seal", square, VERMILION, s=2.0, style=pb.uniform(0.08), granulation=0.5, level=1.35)
        k = size / 100
        k, x, y = 1.18 * k, x - 0.09 * size, y - 0.08 * size
        for points in ([(24, 30), (22, 60), (30, 78), (40, 70), (41, 44)],
                       [(41, 44), (41, 22), (50, 15), (59, 22), (59, 44)],
                       [(59, 44), (60, 70), (70, 78), (78, 60), (76, 30)], [(50, 40), (50, 84)]):
            painting.line("cut", pb.placed(points, x, y, k), [4.2 * k, 4.8 * k, 4.2 * k], PALE, pb.uniform(0.1), step=2,
                          granulation=0.7)


def main(path):
    painting = pb.Painting(1024, 768, PAPER, {"kind": "procedural", "seed": 7, "scale": 9, "strength": 0.75})
    far_mountains(painting)
    near_mountains(painting)
    water(painting)
    back_rocks(painting)
    pines(painting)
    front_rocks(painting)
    grass(painting)
    shallows(painting)
    boat(painting, 300, 640, 0.9)
    birds(painting)
    inscription(painting, 92, 92, 44)
    seal(painting, 98, 206, 31)
    painting.write(path)


if __name__ == "__main__":
    main(sys.argv[1])
