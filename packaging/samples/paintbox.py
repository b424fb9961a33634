"""What the sample paintings are painted with: colours, shapes, brushes, and the text form they are written in.

Lengths are canvas units, times seconds, angles degrees. A colour is (red, yellow, blue, opacity), RYB. Where a
parameter says *field*, it takes a value or a function of (x, y) that gives one: paint that changes along the stroke.
"""
import json
import math
import random

SEGMENT_TIME = 1 / 60  # the hand's pace: a segment takes this long
OUTLINE_TIME = 0.04    # a cubic of an outline takes this long
PAUSE = 0.3            # between two strokes
ROOT_PI = math.sqrt(math.pi)


# ---------------------------------------------------------------- colours

def ryb(text, opacity=1.0):
    """The RYB colour of '#rrggbb' (Sugita & Takahashi; exact inverse of the renderer's)."""
    rgb = [int(text[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    white, black = min(rgb), 1 - max(rgb)
    r, g, b = (v - white for v in rgb)
    m = min(r, g)
    red, yellow, blue = r - m, (g + m) / 2, (b + g - m) / 2
    top, most = max(r, g, b), max(red, yellow, blue)
    n = most / top if top > 0 and most > 0 else 1
    return (red / n + black, yellow / n + black, blue / n + black, opacity)


def paint(text):
    """'#rrggbb', or '#rrggbbaa' with its opacity."""
    return ryb(text[:7], int(text[7:] or "ff", 16) / 255)


def lerp(a, b, t):
    return a + (b - a) * t


def blend(a, b, t):
    """From colour a (t = 0) to colour b (t = 1), channel by channel."""
    t = min(1.0, max(0.0, t))
    return tuple(lerp(x, y, t) for x, y in zip(a, b))


def fade(colour, factor):
    """The colour with its opacity multiplied."""
    return colour[:3] + (colour[3] * min(1.0, max(0.0, factor)),)


def ramp(*stops):
    """A function of t from (t, value) stops; values are numbers or colours; smooth between them."""
    def at(t):
        if t <= stops[0][0]:
            return stops[0][1]
        for (t0, a), (t1, b) in zip(stops, stops[1:]):
            if t <= t1:
                f = (t - t0) / (t1 - t0) if t1 > t0 else 1.0
                f = f * f * (3 - 2 * f)
                return blend(a, b, f) if isinstance(a, tuple) else lerp(a, b, f)
        return stops[-1][1]
    return at


def across(x0, y0, x1, y1, stops):
    """A field that runs through the stops from point 0 to point 1."""
    at, dx, dy = ramp(*stops), x1 - x0, y1 - y0
    return lambda x, y: at(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy))


# ---------------------------------------------------------------- styles and mixing

def uniform(softness=0.05, cut=0.5):
    return {"kind": "uniform", "xi": [cut, softness]}


def feather(full=1.0, power=1.2):
    return {"kind": "feathering", "xi": [full, power]}


def edge(inside=0.6, shape=0.95, cut=0.5):
    """Edge darkening whose paint ends at density `cut`; `inside` is the tone far in, as a share of the rim's."""
    x = (shape ** 3 + math.sqrt(shape ** 6 + 4 * (1 / inside - 1))) / 2
    dark = cut * x ** (1 / 3)
    return {"kind": "edge", "xi": [round(dark, 4), round(shape * dark, 4), inside]}


def glaze(beta=1.0):
    """Mixes like pigment: 1 adds the colour to what lies below, 0 covers it."""
    return {"mode": "beta", "beta": beta}


COVER = {"mode": "alpha"}


# ---------------------------------------------------------------- shapes: lists of points

def curve(points, closed=False, step=4.0):
    """The Catmull-Rom curve through the points, as points about `step` apart."""
    n, out = len(points), []
    for i in range(n if closed else n - 1):
        p = [points[(i + k) % n] if closed else points[min(n - 1, max(0, i + k))] for k in (-1, 0, 1, 2)]
        pieces = max(1, round(math.dist(p[1], p[2]) / step))
        for k in range(pieces):
            t = k / pieces
            out.append(tuple(0.5 * (2 * p[1][a] + (p[2][a] - p[0][a]) * t
                                    + (2 * p[0][a] - 5 * p[1][a] + 4 * p[2][a] - p[3][a]) * t * t
                                    + (3 * p[1][a] - p[0][a] - 3 * p[2][a] + p[3][a]) * t ** 3) for a in (0, 1)))
    return out if closed else out + [tuple(points[-1])]


def ellipse(cx, cy, rx, ry, turn=0.0, start=0.0, end=360.0):
    n = max(12, int((rx + ry) * abs(end - start) / 360))
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    out = []
    for i in range(n + (end - start < 360)):
        a = math.radians(lerp(start, end, i / n))
        x, y = rx * math.cos(a), ry * math.sin(a)
        out.append((cx + c * x - s * y, cy + s * x + c * y))
    return out


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def placed(points, x=0.0, y=0.0, scale=1.0, turn=0.0, mirror=False):
    """The points scaled, turned and moved, in this order."""
    c, s, m = math.cos(math.radians(turn)) * scale, math.sin(math.radians(turn)) * scale, -1 if mirror else 1
    return [(x + c * m * px - s * py, y + s * m * px + c * py) for px, py in points]


class Noise:
    """Smooth value noise in one and two dimensions, in [-1, 1]."""

    def __init__(self, seed):
        rng = random.Random(seed)
        self.table = [rng.uniform(-1, 1) for _ in range(4096)]

    def corner(self, i, j):
        return self.table[(i * 73 + j * 1579 + ((i * j) & 255) * 31) & 4095]

    def __call__(self, x, y=0.0):
        i, j = math.floor(x), math.floor(y)
        u, v = x - i, y - j
        u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
        low = lerp(self.corner(i, j), self.corner(i + 1, j), u)
        return lerp(low, lerp(self.corner(i, j + 1), self.corner(i + 1, j + 1), u), v)


def wobbly(points, amount, length, seed):
    """The points moved by smooth noise: the outline of a hand that is not a machine."""
    nx, ny = Noise(seed), Noise(seed + 1)
    return [(x + amount * nx(x / length, y / length), y + amount * ny(x / length, y / length)) for x, y in points]


def resampled(points, step):
    """The open polyline in steps of equal length, at most `step`."""
    lengths = [math.dist(a, b) for a, b in zip(points, points[1:])]
    total = sum(lengths)
    n = max(1, math.ceil(total / step))
    out, k, done = [tuple(points[0])], 0, 0.0
    for i in range(1, n):
        at = total * i / n
        while k < len(lengths) - 1 and done + lengths[k] < at:
            done += lengths[k]
            k += 1
        f = (at - done) / lengths[k] if lengths[k] else 0.0
        out.append((lerp(points[k][0], points[k + 1][0], f), lerp(points[k][1], points[k + 1][1], f)))
    return out + [tuple(points[-1])]


def area(points):
    """Twice the signed area; positive where the points go clockwise on the screen."""
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]))


def inset(points, distance):
    """The closed outline moved inwards; mitred corners, at most 2.5 distances long."""
    points = [p for p, q in zip(points, points[1:] + points[:1]) if math.dist(p, q) > 1e-6]
    side, out = math.copysign(distance, area(points)), []
    for (ax, ay), (bx, by), (cx, cy) in zip(points[-1:] + points[:-1], points, points[1:] + points[:1]):
        u, v = math.hypot(bx - ax, by - ay), math.hypot(cx - bx, cy - by)
        nx, ny = -(by - ay) / u - (cy - by) / v, (bx - ax) / u + (cx - bx) / v
        size = math.hypot(nx, ny)
        reach = side * min(2.5, 2 / size) / size if size > 1e-9 else 0.0
        out.append((bx + nx * reach, by + ny * reach))
    return out


def corners(points, bend=35.0):
    """Where the closed outline turns sharply: positions in the list."""
    out, n = [], len(points)
    for i, (bx, by) in enumerate(points):
        (ax, ay), (cx, cy) = points[i - 1], points[(i + 1) % n]
        turn = math.degrees(math.atan2(cy - by, cx - bx) - math.atan2(by - ay, bx - ax))
        if abs((turn + 180) % 360 - 180) > bend:
            out.append(i)
    return out


def runs(points):
    """The closed outline as open runs between its corners, each to be drawn as one smooth curve."""
    at = corners(points) or [0]
    loop = points + points
    return [loop[i:j + 1] for i, j in zip(at, at[1:] + [at[0] + len(points)])]


def smoothed(nodes, closed=False):
    """The nodes' polyline as cubics (lists of four points) that pass through them."""
    n, out = len(nodes) - 1, []
    for k in range(n):
        a, b = nodes[k], nodes[k + 1]
        before = nodes[k - 1] if k else (nodes[-2] if closed and n > 2 else a)
        after = nodes[k + 2] if k + 2 <= n else (nodes[1] if closed and n > 2 else b)
        out.append([a, (a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6),
                    (b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6), b])
    return out


# ---------------------------------------------------------------- outlines: lists of cubics, and of points to go to

def on_grid(point):
    """Tenths of a unit: no eye sees more of an outline, and a file of them is a fifth smaller."""
    return [round(v, 1) for v in point]


def flat(outline):
    """The points of an outline, in order."""
    return [q for e in outline for q in ([e] if isinstance(e[0], (int, float)) else e)]


def oval(cx, cy, rx, ry=None, turn=0.0, start=0.0, end=360.0, step=90):
    """A circle, an ellipse or an arc of one: a cubic for each `step` degrees."""
    ry, n = ry or rx, math.ceil(abs(end - start) / step)
    pull = 4 / 3 * math.tan(math.radians((end - start) / n / 4))
    out = []
    for k in range(n):
        a, b = (math.radians(lerp(start, end, i / n)) for i in (k, k + 1))
        ends = [(math.cos(t), math.sin(t)) for t in (a, b)]
        (ax, ay), (bx, by) = ends
        unit = [ends[0], (ax - pull * ay, ay + pull * ax), (bx + pull * by, by - pull * bx), ends[1]]
        out.append(placed([(rx * px, ry * py) for px, py in unit], cx, cy, 1.0, turn))
    return out


def across_box(outlines, angle, first, last):
    """The colours of an area that run through the box of its outlines, in that direction (90: downwards)."""
    xs, ys = zip(*[q for outline in outlines for q in flat(outline)])
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    reach = (abs(c) * (max(xs) - min(xs)) + abs(s) * (max(ys) - min(ys))) / 2
    x, y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    return (x - reach * c, y - reach * s), (x + reach * c, y + reach * s), first, last


def through(points, closed=False):
    """The smooth outline through the points, rounded first: handles that follow from nodes take no room in a file."""
    points = [on_grid(q) for q in points]
    return smoothed(points + points[:1] if closed else points, closed)


def lens(x, y, half, thick):
    """Level, pointed at both ends, `thick` to each side of its middle."""
    a, b, bow = (x - half, y), (x + half, y), 4 / 3 * thick
    return [[a, (x - half / 3, y - bow), (x + half / 3, y - bow), b],
            [b, (x + half / 3, y + bow), (x - half / 3, y + bow), a]]


def tapered(points, widths):
    """The outline of a brush stroke through the points with such half-widths."""
    sides = [], []
    for k, ((x, y), w) in enumerate(zip(points, widths)):
        (ax, ay), (bx, by) = points[max(0, k - 1)], points[min(len(points) - 1, k + 1)]
        size = math.hypot(bx - ax, by - ay)
        for side, sign in zip(sides, (w / size, -w / size)):
            side.append((x + sign * (by - ay), y - sign * (bx - ax)))
    return through(sides[0]) + through(sides[1][::-1])


# ---------------------------------------------------------------- filling a shape with one stroke

def crossings(outlines, y):
    """The intervals of x where the line at height y is inside (even-odd)."""
    xs = []
    for points in outlines:
        for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
            if (y0 <= y) != (y1 <= y):
                xs.append(x0 + (x1 - x0) * (y - y0) / (y1 - y0))
    xs.sort()
    return list(zip(xs[::2], xs[1::2]))


def rows_of(outlines, spacing):
    """Chains of rows [(y, x0, x1), …]: each chain is filled by going to and fro. Gives (chains, spacing used)."""
    ys = [y for points in outlines for _, y in points]
    low, high = min(ys), max(ys)
    n = max(1, round((high - low) / spacing))
    pitch = (high - low) / n
    chains, open_chains = [], []
    for k in range(n):
        y = low + (k + 0.5) * pitch
        still_open = []
        for x0, x1 in crossings(outlines, y):
            if x1 - x0 < 0.2 * pitch:
                continue
            above = [c for c in open_chains if c[-1][1] < x1 and c[-1][2] > x0 and c not in still_open]
            chain = above[0] if above else []
            if not above:
                chains.append(chain)
            chain.append((y, x0, x1))
            still_open.append(chain)
        open_chains = still_open
    return chains, pitch


def value(field, x, y):
    return field(x, y) if callable(field) else field


class Painting:
    """Strokes in the order of painting, on a clock that the hand drives."""

    def __init__(self, width, height, background="#ffffff", paper=None):
        self.canvas = {"width": width, "height": height, "background": self.rounded(ryb(background)),
                       "paper": paper or {"kind": "none"}}
        self.groups, self.open_groups, self.strokes = [], [], []
        self.clock = 0.0

    @staticmethod
    def rounded(colour):
        return [round(min(1.0, max(0.0, v)), 3) for v in colour]

    # -- groups: with painting.group("lemon"): … or painting.group("shade", blend="multiply", clips=True): …
    def group(self, name, **how):
        parent = self.open_groups[-1] if self.open_groups else None
        self.groups.append({"id": len(self.groups) + 1, "name": name, "parent": parent,
                            "visible": True, "locked": False, **how})
        self.open_groups.append(len(self.groups))
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.open_groups.pop()

    # -- strokes
    def add(self, name, segments, style, mix):
        """segments: (four points, spread s, density, granulation, colour); zero-length ones are left out."""
        out, clean = [], lambda p: [round(p[0], 2), round(p[1], 2)]
        for points, s, density, granulation, colour in segments:
            bezier = [clean(p) for p in points]
            if all(p == bezier[0] for p in bezier):
                continue
            out.append({"bezier": bezier, "diffusion": round(s * s / 4, 3), "density": float(f"{density:.4g}"),
                        "granulation": granulation, "maxAge": 1, "born": round(self.clock, 6),
                        "colour": self.rounded(colour)})
            self.clock += SEGMENT_TIME
        self.finish(name, out, style, mix)
        self.clock += PAUSE

    def finish(self, name, out, style, mix, **fill):
        if not out:
            raise ValueError(f"the stroke “{name}” is empty")
        self.strokes.append({"id": len(self.strokes) + 1, "name": name,
                             "group": self.open_groups[-1] if self.open_groups else None,
                             "visible": True, "locked": False, "style": style, "mix": mix, **fill, "segments": out})

    def area(self, name, outlines, colour, spread=0.0, level=1.0, style=None, mix=COVER, granulation=1.0,
             rule="nonzero"):
        """What the outlines enclose, filled at once, `level` dense far inside; without a spread the edge is crisp.
        colour: one, or (from, to, colour there, colour there), which runs evenly from point to point."""
        out = []
        for outline in outlines:
            here = None
            for e in outline:
                piece = [on_grid(q) for q in ([e] if isinstance(e[0], (int, float)) else e)]
                pieces = [piece] if len(piece) > 1 else []
                if here and here != piece[0]:
                    pieces.insert(0, [[round(lerp(a, b, k / 3), 1) for a, b in zip(here, piece[0])] for k in range(4)])
                for bezier in pieces:
                    out.append({"bezier": bezier, "diffusion": 1, "density": 0, "born": round(self.clock, 6)})
                    self.clock += OUTLINE_TIME
                here = piece[-1]
        for before, after in zip([None] + out, out):
            if before is None or before["bezier"][3] != after["bezier"][0]:
                after["start"] = True
        # Numbers of few bits make small files.
        halves = lambda point: [round(2 * v) / 2 for v in point]
        bytewise = lambda colour: [round(256 * min(1.0, max(0.0, v))) / 256 for v in colour]
        fill = {"diffusion": round(spread * spread / 4, 3), "density": level, "granulation": granulation,
                "born": round(self.clock, 6), "rule": rule}
        if isinstance(colour[0], tuple):
            start, end, colour, other = colour
            fill["gradient"] = {"from": halves(start), "to": halves(end), "colour": bytewise(other)}
        fill["colour"] = bytewise(colour)
        self.finish(name, out, style or uniform(), mix, fill=fill)

    def washed(self, name, outlines, colour, slant=90, **more):
        """An area that spreads. colour: text (see paint), or a pair that runs through the outlines' box, downwards or
        aslant."""
        colour = across_box(outlines, slant, *map(paint, colour)) if isinstance(colour, tuple) else paint(colour)
        self.area(name, outlines, colour, **{"style": feather(1.0, 1.0), "granulation": 0.6, **more})

    def line(self, name, points, width, colour, style=None, mix=COVER, spread=None, step=None, granulation=1.0,
             smooth=True, follow=False):
        """A brush stroke through the points. width: half-width, or a list of them along the stroke (the pressure, which
        sets the density). colour: a field, or a list of colours along the stroke. spread: s, default 0.8 of the
        greatest width; follow: of the width at each place, which keeps thin ends crisp."""
        style = style or uniform()
        widths = width if isinstance(width, (list, tuple)) else [width]
        s = spread or 0.8 * max(widths)
        cut = style["xi"][0] if style["kind"] == "uniform" else 0.5
        at = ramp(*[(i / max(1, len(widths) - 1), w) for i, w in enumerate(widths)])
        shade = None
        if isinstance(colour, list):
            shade = ramp(*[(i / max(1, len(colour) - 1), c) for i, c in enumerate(colour)])
        nodes = resampled(curve(points, step=min(2.0, s)) if smooth else points, step or max(1.5, 0.9 * s))
        n, segments = len(nodes) - 1, []
        for k, points in enumerate(smoothed(nodes)):
            w = at((k + 0.5) / n)
            s = 0.8 * max(w, 0.25 * max(widths)) if follow else s
            density = cut * ROOT_PI * s * math.exp(min(3.5, (w / s) ** 2)) if w > 0 else 0.0
            x, y = (points[0][0] + points[3][0]) / 2, (points[0][1] + points[3][1]) / 2
            segments.append((points, s, density, granulation, shade((k + 0.5) / n) if shade else value(colour, x, y)))
        self.add(name, segments, style, mix)

    def dot(self, name, x, y, radius, colour, style=None, mix=COVER, granulation=1.0):
        """A touch of the brush."""
        s = 0.8 * radius
        short, cut = 0.1 * s, (style or uniform())["xi"][0]
        density = cut * ROOT_PI * s * math.exp((radius / s) ** 2) / math.erf(0.05)
        ends = [(x + short * (k / 3 - 0.5), y) for k in range(4)]
        self.add(name, [(ends, s, density, granulation, colour)], style or uniform(), mix)

    def fill(self, name, outlines, colour, s=8.0, row=None, angle=0.0, level=1.0, style=None, mix=COVER,
             granulation=1.0, piece=None, spread=None, rims=None):
        """A shape filled by one stroke: round its outline, then to and fro. Inside, its density is `level` (a field; 1
        ends a style that cuts at 0.5 on the outline). s sets the rows' distance, spread (a field, default s) the
        spread; colour is a field. rims: how often round, default 1, or 2 for large shapes."""
        outlines = [outlines] if isinstance(outlines[0][0], (int, float)) else outlines
        pitch = row or 1.1 * s
        varies = callable(colour) or callable(level) or callable(spread)
        piece = piece or (1.6 * s if varies else 1e9)
        spread, segments = spread or s, []

        def lay(points, share):
            x, y = (points[0][0] + points[3][0]) / 2, (points[0][1] + points[3][1]) / 2
            density = share * value(level, x, y)
            segments.append((points, value(spread, x, y), density, granulation, value(colour, x, y)))

        def straight(a, b, share, pieces=1):
            cut = [tuple(lerp(a[i], b[i], k / (3 * pieces)) for i in (0, 1)) for k in range(3 * pieces + 1)]
            for k in range(pieces):
                lay(cut[3 * k:3 * k + 4], share)

        if rims is None:
            thin = min(max(q[i] for q in outlines[0]) - min(q[i] for q in outlines[0]) for i in (0, 1)) < 12 * s
            rims = 1 if thin or s < 5 else 2
        for _ in range(rims):
            for outline in outlines:
                for run in runs(inset(outline, pitch / 2)):
                    if segments:
                        straight(segments[-1][0][3], run[0], 0.0)
                    for points in smoothed(resampled(run, 1.4 * s), math.dist(run[0], run[-1]) < 1e-9):
                        lay(points, pitch)
            outlines = [inset(outline, pitch) for outline in outlines]
        self.scribble(outlines, pitch, angle, piece, straight, lay, segments)
        self.add(name, segments, style or uniform(), mix)

    @staticmethod
    def scribble(outlines, spacing, angle, piece, straight, lay, segments):
        """Lays the rows to and fro. A row ends a quarter pitch early; its turn lays what that leaves out."""
        c, sn = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        back = lambda x, y: (c * x - sn * y, sn * x + c * y)
        turned = [[(c * x + sn * y, -sn * x + c * y) for x, y in points] for points in outlines]
        chains, pitch = rows_of(turned, spacing)
        last = None
        for chain in chains:
            right = True
            for k, (y, x0, x1) in enumerate(chain):
                gap = min(pitch / 4, (x1 - x0) / 4)
                ends = ((x0 + gap, y), (x1 - gap, y)) if right else ((x1 - gap, y), (x0 + gap, y))
                a, b = back(*ends[0]), back(*ends[1])
                if k:
                    bow = (-0.4 if right else 0.4) * pitch
                    lay([last, (last[0] + c * bow, last[1] + sn * bow), (a[0] + c * bow, a[1] + sn * bow), a],
                        0.5 * pitch * pitch / max(pitch, 1.15 * math.dist(a, last)))
                elif segments:
                    straight(segments[-1][0][3], a, 0.0)
                straight(a, b, pitch, max(1, math.ceil((x1 - x0) / piece)))
                last, right = b, not right

    def write(self, path):
        """Writes the text form; a line a segment."""
        line = lambda value: json.dumps(value, separators=(",", ":"), ensure_ascii=False)
        rows = []
        for stroke in self.strokes:
            head = {k: v for k, v in stroke.items() if k != "segments"}
            rows.append(line(head)[:-1] + ',"segments":[\n' + ",\n".join(map(line, stroke["segments"])) + "]}")
        with open(path, "w", encoding="utf-8") as out:
            new = any("fill" in s for s in self.strokes) or any("text" in g for g in self.groups)
            layers = any(key in g for g in self.groups for key in ("opacity", "blend", "isolated", "clips", "mask", "wash"))
            version = 3 if layers else 2 if new else 1
            out.write(f'{{"format":"suffuse-text","version":{version},\n"canvas":' + line(self.canvas) + ',\n"groups":'
                      + line(self.groups) + ',\n"strokes":[\n' + ",\n".join(rows) + "]}\n")
