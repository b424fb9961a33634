#!/usr/bin/env python3
"""Paints sheet: what each quantity of a stroke does, in the spirit of the paper's Figure 5: paint_sheet.py [OUT.json]

Captions are strokes, too, written with a pen of one line a letter.
"""
import math
import sys

from paintbox import (COVER, ROOT_PI, Painting, curve, edge, ellipse, feather, glaze, lerp, ramp, resampled, ryb,
                      smoothed, uniform, wobbly)

WIDTH, HEIGHT, LEFT, TOP, ROW = 2000, 1830, 290, 110, 236
INDIGO, MADDER, OCHRE = ryb("#2f3f8f", 0.95), ryb("#b5303f", 0.95), ryb("#d9972e", 0.95)
TEAL, PLUM, INK = ryb("#1f6d76", 0.95), ryb("#6b3a78", 0.95), ryb("#3b3a40", 0.9)
PAPER_UNIT = 512  # canvas units of one of the paper's, whose canvas is 2 wide
p = Painting(WIDTH, HEIGHT, "#fffdf7", {"kind": "procedural", "seed": 5, "scale": 10, "strength": 0.9})

# ---------------------------------------------------------------- captions
# A letter is strokes on a grid, x right, y up. Small letters reach from 0 to 4, tall ones to 6.5, tails to -2. A stroke
# is a curve through its points.
LETTERS = {
    "a": ["3,3.6 1.2,4 0,2 1,0 3,1.2", "3,4 3,.6 3.6,0"], "b": ["0,6.5 0,0", "0,2.8 1.4,4 3,2.4 1.6,0 0,.8"],
    "c": ["3,3.4 1.4,4 0,2 1.4,0 3,.6"], "d": ["3,6.5 3,.4 3.4,0", "3,3.2 1.4,4 0,2 1.2,0 3,1.2"],
    "e": ["0,2.1 1.6,2.2 3,2.6 1.6,4 0,2 1.4,0 3,.6"], "f": ["3,6 2,6.5 1.2,5 1.2,0", "0,3.8 2.6,3.8"],
    "g": ["3,3.6 1.4,4 0,2.2 1.2,.4 3,1.6", "3,4 3,0 1.6,-2 0,-1.4"],
    "h": ["0,6.5 0,0", "0,2.6 1.6,4 3,2.8 3,0"], "i": ["0,4 0,0", "0,5.9"],
    "k": ["0,6.5 0,0", "2.6,4 0,1.8", ".9,2.5 2.8,0"],
    "l": ["0,6.5 0,.6 .6,0"], "m": ["0,4 0,0", "0,2.8 1.2,4 2.2,3 2.2,0", "2.2,2.8 3.4,4 4.4,3 4.4,0"],
    "n": ["0,4 0,0", "0,2.6 1.6,4 3,2.8 3,0"], "o": ["1.5,4 0,2 1.5,0 3,2 1.5,4"],
    "p": ["0,4 0,-2", "0,2.8 1.4,4 3,2.2 1.6,0 0,1"], "r": ["0,4 0,0", "0,2.4 1,3.8 2.2,3.8"],
    "s": ["2.6,3.5 1.3,4 .2,3.1 2.5,1 1.3,0 0,.5"], "t": ["1,6 1,.8 2,0 2.6,.3", "0,4 2.4,4"],
    "u": ["0,4 0,1.2 1.4,0 3,1.6", "3,4 3,0"], "v": ["0,4 1.4,0", "1.4,0 2.8,4"],
    "w": ["0,4 1.1,0", "1.1,0 2.1,3.4", "2.1,3.4 3.1,0", "3.1,0 4.2,4"], "x": ["0,4 2.8,0", "2.8,4 0,0"],
    "y": ["0,4 1.5,.2", "3,4 1.2,-1 0,-2"], "D": ["0,6.5 0,0", "0,6.5 2.4,6 3.6,3.2 2.2,.4 0,0"],
    "0": ["1.5,6.5 0,3.2 1.5,0 3,3.2 1.5,6.5"], "1": ["0,5.2 1.4,6.5", "1.4,6.5 1.4,0"],
    "2": [".1,5.3 1.6,6.5 2.9,5 1.8,2.6 0,0", "0,0 3,0"],
    "3": [".2,6.1 2,6.3 2.5,4.6 1,3.6", "1,3.6 3,2.4 2.2,.2 0,.5"],
    "4": ["2.2,6.5 0,2 3,2", "2.2,3.8 2.2,0"], "5": ["2.8,6.5 .4,6.5", ".4,6.5 .2,3.6", ".2,3.6 2,4 3,2 1.8,0 0,.4"],
    "6": ["2.6,6.4 .6,4.4 .2,1.4 1.6,0 3,1.6 1.7,3.4 .2,2"], "7": ["0,6.5 3,6.5", "3,6.5 1,0"],
    "8": ["1.5,3.5 .3,5 1.5,6.5 2.7,5 1.5,3.5 0,1.7 1.5,0 3,1.7 1.5,3.5"],
    "9": ["2.8,5 1.4,3.2 .2,4.8 1.4,6.5 2.8,5 2.4,2 1,0"],
    ".": [".2,.3"], ",": [".3,.4 0,-.9"], "=": ["0,3.6 2.6,3.6", "0,1.8 2.6,1.8"], "-": ["0,2.4 2,2.4"],
    "/": ["0,-.6 2.2,6.6"], "²": [".1,5.9 .8,6.6 1.4,5.9 .9,4.8 0,3.7", "0,3.7 1.5,3.7"],
    "%": ["0,0 3,6.5", ".1,5.3 .8,6.3 1.5,5.3 .8,4.3 .1,5.3", "1.6,1.1 2.3,2.1 3,1.1 2.3,.1 1.6,1.1"],
    "φ": ["1.7,6 1.7,-2", "1.7,4 0,2 1.7,0 3.4,2 1.7,4"],
    "ω": [".8,4 0,1.6 1,0 2,1.4", "2,2.6 2,1.4 3,0 4,1.6 3.2,4"],
    "β": ["0,-2 0,4.6 1.4,6.4 2.6,5 1,3.6", "1,3.6 3,2.2 1.6,0 0,.8"],
    "ξ": ["2.4,6.3 .6,5.4 2.4,4.6", "2.2,4.5 .4,2.9 2.4,2.5", "2.2,2.4 0,.8 2.6,-.4 1.6,-2"],
}


def write(text, x, y, size=3.2, colour=INK):
    """One caption, its base line at y; size: units of a step of the grid."""
    for letter in text:
        if letter == " ":
            x += 2.6 * size
            continue
        right = 0.0
        for points in LETTERS[letter]:
            grid = [tuple(map(float, point.split(","))) for point in points.split()]
            right = max([right] + [a for a, _ in grid])
            if len(grid) == 1:
                p.dot("caption", x + grid[0][0] * size, y - grid[0][1] * size, 0.6 * size, colour)
                continue
            p.line("caption", [(x + a * size, y - b * size) for a, b in grid], 0.5 * size, colour, style=uniform(0.05),
                   spread=0.42 * size, step=0.7 * size)
        x += (right + 1.7) * size


def row(index, title, below=""):
    """Begins a row of the sheet; gives the height of its middle."""
    y = TOP + ROW * (index + 0.5)
    write(title, 50, y, 4.2)
    if below:
        write(below, 50, y + 44, 2.6)
    return y


def cell(column, columns):
    """(left end, length) of a stroke in a row of so many."""
    pitch = (WIDTH - LEFT - 50) / columns
    return LEFT + pitch * column + 0.14 * pitch, 0.72 * pitch


def swash(x, y, length, height=34):
    """A brush stroke's way: up, down and up again."""
    return curve([(x, y + 0.5 * height), (x + 0.3 * length, y - height), (x + 0.66 * length, y + 0.8 * height),
                  (x + length, y - 0.6 * height)], step=3)


def stroke(name, points, spread, peak, colour, style=None, mix=COVER, granulation=1.0):
    """A stroke given by the model's own quantities: spread s at full age, the peak density of a long line, ω. Each may
    be a function of the share of the length: paint that changes along the stroke."""
    at = lambda quantity, u: quantity(u) if callable(quantity) else quantity
    nodes = resampled(points, 9)
    n, segments = len(nodes) - 1, []
    for k, cubic in enumerate(smoothed(nodes)):
        u = (k + 0.5) / n
        s = at(spread, u)
        segments.append((cubic, s, at(peak, u) * ROOT_PI * s, at(granulation, u), at(colour, u)))
    p.add(name, segments, style or uniform(0.06), mix)


def spread_of(paper_diffusion):
    """s = √(4 D t) at t = 1 s for a D in the paper's units."""
    return math.sqrt(4 * paper_diffusion) * PAPER_UNIT


def diffusion(index):
    y = row(index, "D", "u²/s")
    for k in range(5):
        x, length = cell(k, 5)
        s = 0.55 * spread_of(0.001 * (k + 1))
        stroke("D", swash(x, y - 16, length, 22), s, 0.825 * spread_of(0.001) / s, INDIGO, feather(1.2, 1.1))
        write(f"{s * s / 4:.0f}", x + 0.38 * length, y + 100, 2.6)  # as the inspector shows it


def granulation(index):
    y = row(index, "ω", "granulation")
    for k, omega in enumerate((0, 0.1, 0.2, 0.3, 0.5)):
        x, length = cell(k, 5)
        stroke("ω", swash(x, y - 14, length, 22), 34, 1.25, TEAL, uniform(0.06), granulation=omega)
        write(f"{100 * (1 - omega):.0f} %", x + 0.34 * length, y + 100, 2.6)  # as the inspector shows it


def styles(index):
    y = row(index, "styles")
    for k, (name, style, peak) in enumerate((("uniform", uniform(0.03), 1.4), ("uniform, soft", uniform(0.12), 1.4),
                                              ("feathering", feather(1.5, 1.2), 1.6),
                                              ("dark edge", edge(0.55), 1.5), ("dark, pale", edge(0.3, 0.97), 1.5))):
        x, length = cell(k, 5)
        stroke(name, swash(x, y - 14, length, 22), 32, peak, PLUM, style)
        write(name, x + 0.12 * length, y + 100, 2.6)


def gradual(index):
    y = row(index, "along", "the stroke")
    x, length = cell(0, 4)
    stroke("D along", swash(x, y - 14, length, 22), lambda u: lerp(12, 44, u), lambda u: lerp(2.4, 0.9, u), MADDER)
    write("D", x + 0.45 * length, y + 100, 2.6)
    x, length = cell(1, 4)
    stroke("φ along", swash(x, y - 14, length, 22), 26, lambda u: lerp(0.35, 3.2, u), MADDER, uniform(0.05))
    write("φ", x + 0.45 * length, y + 100, 2.6)
    x, length = cell(2, 4)
    stroke("ω along", swash(x, y - 14, length, 22), 32, 1.25, MADDER, granulation=lambda u: lerp(0, 1, u))
    write("ω", x + 0.45 * length, y + 100, 2.6)
    x, length = cell(3, 4)
    stroke("colour along", swash(x, y - 14, length, 22), 32, 1.5,
           ramp((0, MADDER), (0.5, OCHRE), (1, TEAL)))
    write("colour", x + 0.36 * length, y + 100, 2.6)


def areas(index):
    y = row(index, "areas", "dark edges")
    washes = (0.75, 1, TEAL), (0.5, 1, INDIGO), (0.4, 0.8, PLUM), (0.6, 0.55, OCHRE)
    for k, (inside, omega, colour) in enumerate(washes):
        x, length = cell(k, 4)
        leaf = wobbly(ellipse(x + 0.5 * length, y - 12, 0.48 * length, 78), 16, 60, 3 * k)
        p.fill("area", leaf, colour, s=11, style=edge(inside), granulation=omega)


def widths(index):
    y = row(index, "width", "the same D")
    for k, peak in enumerate((0.55, 0.75, 1.2, 2.6, 6.5)):
        x, length = cell(k, 5)
        stroke("width", swash(x, y - 14, length, 22), 24, peak, INDIGO, uniform(0.03))
        write(f"φ {peak * ROOT_PI * 24:.0f}", x + 0.36 * length, y + 100, 2.6)


def mixings(index):
    y = row(index, "mixing")
    for k, (name, mix) in enumerate((("alpha", COVER), ("β = 0.5", glaze(0.5)), ("β = 1", glaze(1)))):
        x, length = cell(k, 3)
        for j, colour in enumerate((OCHRE, MADDER, INDIGO)):
            bar = curve([(x + 0.04 * length, y - 58 + 48 * j), (x + 0.4 * length, y - 66 + 48 * j),
                         (x + 0.72 * length, y - 54 + 48 * j)], step=4)
            stroke(name, bar, 22, 1.3, colour[:3] + (0.8,), uniform(0.05), mix)
        for j, colour in enumerate((OCHRE, MADDER, INDIGO)):
            cx = x + (0.16 + 0.22 * j) * length
            stroke(name, curve([(cx, y - 96), (cx + 12, y - 10), (cx, y + 72)], step=4), 22, 1.3, colour[:3] + (0.8,),
                   uniform(0.05), mix)
        write(name, x + 0.28 * length, y + 112, 2.6)


for index, section in enumerate((diffusion, granulation, styles, gradual, areas, widths, mixings)):
    with p.group(section.__name__):
        section(index)
with p.group("title"):
    write("what a stroke can do", 50, 84, 6)
p.write(sys.argv[1] if len(sys.argv) > 1 else "sheet.json")
