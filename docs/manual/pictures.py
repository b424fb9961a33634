#!/usr/bin/env python3
"""Draws the pictures of the manual into docs/manual/pictures: pictures.py SUFFUSE_CLI [SUFFUSE]

Each one is a small painting in the text form, drawn by suffuse-cli with one and a half pixels a unit; the manual shows
units as pixels.
With SUFFUSE, the editor, the pictures of its window are taken as well; they need Xvfb, xdotool and ImageMagick.
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE / "pictures"
SAMPLES = HERE.parent.parent / "packaging" / "samples"
sys.path.insert(0, str(SAMPLES))
from paintbox import ryb  # noqa: E402

ROOT_PI = math.sqrt(math.pi)
INDIGO, MADDER, OCHRE = ryb("#2f3f8f", 0.95), ryb("#b5303f", 0.95), ryb("#d9972e", 0.95)
TEAL, PLUM, LEAF = ryb("#1f6d76", 0.95), ryb("#6b3a78", 0.95), ryb("#4f7a2e", 0.95)
BLUE, YELLOW = ryb("#1f4fae", 0.95), ryb("#f2c516", 0.95)
SHEET = ryb("#fffdf7", 1)
UNIFORM = {"kind": "uniform", "xi": [0.5, 0.05]}


def feather(power=1.2):
    return {"kind": "feathering", "xi": [1, power]}


def edge(inside=0.75):
    return {"kind": "edge", "xi": [0.5, 0.5 * inside * 1.25, inside]}


def cubics(points):
    """The cubics of a smooth curve through the points."""
    out = []
    for i in range(len(points) - 1):
        before, a, b, after = points[max(i - 1, 0)], points[i], points[i + 1], points[min(i + 2, len(points) - 1)]
        out.append([a, [a[k] + (b[k] - before[k]) / 6 for k in (0, 1)], [b[k] - (after[k] - a[k]) / 6 for k in (0, 1)],
                    b])
    return out


def wave(x, y, width=110, height=14, steps=8):
    """Points of a gentle S around (x, y)."""
    return [[x + width * (i / steps - 0.5), y + height * math.sin(2 * math.pi * i / steps)] for i in range(steps + 1)]


def circle(x, y, r, squash=1.0):
    k = 0.5523 * r
    p = [(r, 0), (r, k), (k, r), (0, r), (-k, r), (-r, k), (-r, 0), (-r, -k), (-k, -r), (0, -r), (k, -r), (r, -k), (r, 0)]
    p = [[x + a, y + b * squash] for a, b in p]
    return [p[i:i + 4] for i in (0, 3, 6, 9)]


def stroke(curves, colour, spread=9.0, peak=1.6, style=UNIFORM, age=1.0, born=0.0, **more):
    """A stroke whose spread is so many units once it is dry, and whose peak is that of a long line."""
    own = {k: more.pop(k) for k in ("granulation", "anisotropy") if k in more}
    values = lambda i: dict({"diffusion": spread ** 2 / (4 * age), "density": peak * ROOT_PI * spread, "maxAge": age,
                             "born": born, "colour": list(colour(i / max(len(curves) - 1, 1)) if callable(colour)
                                                          else colour)}, **own)
    return dict({"style": style, "segments": [dict(values(i), bezier=c) for i, c in enumerate(curves)]}, **more)


def filled(curves, colour, spread=3.0, density=1.0, style=UNIFORM, **more):
    fill = {"diffusion": spread ** 2 / 4, "density": density, "colour": list(colour)}
    fill.update(more.pop("fill", {}))
    lines = [{"bezier": c, "diffusion": 1, "density": 0, "colour": list(colour)} for c in curves]
    return dict({"style": style, "fill": fill, "segments": lines}, **more)


def painting(width, height, strokes, groups=(), paper=None):
    for i, s in enumerate(strokes):
        s["id"] = i + 1
    return {"format": "suffuse-text", "version": 4, "groups": list(groups), "strokes": strokes,
            "canvas": {"width": width, "height": height, "background": list(SHEET), "paper": paper or {"kind": "none"}}}


def grain(strength=0.9):
    return {"kind": "procedural", "seed": 5, "scale": 7, "strength": strength, "grain": "tooth"}


def at(n, of, width=620):
    """The middle of the nth of so many columns."""
    return (n + 0.5) * width / of


# ---------------------------------------------------------------- the numbers

def diffusion():
    return painting(620, 96, [stroke(cubics(wave(at(i, 4), 48)), INDIGO, s) for i, s in enumerate((3, 6, 10, 15))])


def drying():
    """One stroke at four ages: the document's time is 1 s."""
    return painting(620, 96, [stroke(cubics(wave(at(i, 4), 48)), TEAL, 14, born=1 - age)
                              for i, age in enumerate((0.06, 0.25, 0.55, 1.0))])


def density():
    rows = []
    for i, peak in enumerate((0.6, 0.9, 1.6, 4)):
        rows.append(stroke(cubics(wave(at(i, 4), 40, height=8)), MADDER, 8, peak))
        rows.append(stroke(cubics(wave(at(i, 4), 104, height=8)), MADDER, 8, peak * 0.5, feather()))
    return painting(620, 144, rows)


def granulation():
    return painting(620, 96, [stroke(cubics(wave(at(i, 4), 48)), PLUM, 13, 1.1, feather(1), granulation=w)
                              for i, w in enumerate((1, 0.7, 0.35, 0))], paper=grain())


def styles():
    rows = []
    for i, x in enumerate((0.02, 0.1, 0.25)):
        rows.append(stroke(cubics(wave(at(i, 3), 44, 150)), INDIGO, 12, 1.4, {"kind": "uniform", "xi": [0.5, x]}))
    for i, x in enumerate((0.5, 1.2, 3)):
        rows.append(stroke(cubics(wave(at(i, 3), 124, 150)), MADDER, 12, 1.3, {"kind": "feathering", "xi": [1, x]}))
    for i, x in enumerate((0.9, 0.7, 0.45)):
        rows.append(stroke(cubics(wave(at(i, 3), 204, 150)), TEAL, 12, 2.2, edge(x)))
    return painting(620, 248, rows)


def direction():
    """Anisotropy: a broad nib and its ratio."""
    loop = lambda x: circle(x, 60, 30)
    return painting(620, 120, [stroke(loop(at(i, 4)), INDIGO, 3, 1.5, anisotropy={"ratio": r, "angle": -0.7})
                               for i, r in enumerate((1, 2, 5, 12))])


def mixing():
    rows = []
    for i, mix in enumerate(({"mode": "alpha"}, {"mode": "beta", "beta": 0.4}, {"mode": "beta", "beta": 1.0})):
        x = at(i, 3)
        rows.append(stroke(cubics([[x - 80, 70], [x, 64], [x + 80, 70]]), BLUE, 16, 1.4, feather(2)))
        rows.append(stroke(cubics([[x - 10, 18], [x, 66], [x + 4, 120]]), YELLOW, 15, 1.4, feather(2), mix=mix))
    return painting(620, 138, rows)


# ---------------------------------------------------------------- washes, layers, erasing

def wash():
    def three(x, group=None):
        return [stroke(cubics(p), TEAL, 13, 1.7, edge(0.6), group=group) for p in (
            wave(x, 50, 190, 6), wave(x, 78, 190, -6), [[x - 60, 30], [x - 20, 66], [x + 40, 104]])]
    group = {"id": 1, "name": "wash", "wash": {"style": edge(0.6), "mix": {"mode": "alpha"}}}
    return painting(620, 130, three(165) + three(455, 1), [group])


def fills():
    y = 70
    return painting(620, 140, [
        filled(circle(at(0, 4), y, 46, 0.85), OCHRE, 0.4),
        filled(circle(at(1, 4), y, 46, 0.85), OCHRE, 14, 1.2, feather(1.4)),
        filled(circle(at(2, 4), y, 46, 0.85), OCHRE, 9, 1.0, edge(0.55)),
        filled(circle(at(3, 4), y, 46, 0.85), OCHRE, 3, fill={
            "gradient": {"from": [at(3, 4) - 40, y], "to": [at(3, 4) + 40, y], "colour": list(MADDER)}})])


def layers():
    """A form, shade above it, the same shade clipped, and the same multiplied."""
    rows, groups = [], []
    for i in range(3):
        x, base, above = at(i, 3), 2 * i + 1, 2 * i + 2
        groups += [{"id": base, "name": "form"},
                   {"id": above, "name": "shade", "clips": i > 0, "blend": "multiply" if i == 2 else "normal"}]
        rows.append(filled(circle(x, 78, 54), OCHRE, 3, group=base))
        rows.append(stroke(cubics([[x - 70, 104], [x - 10, 116], [x + 40, 84], [x + 66, 40]]),
                           ryb("#3f6fa5", 0.9), 17, 1.4, feather(1.5), group=above))
    return painting(620, 156, rows, groups)


def erasing():
    """A stroke, and the same made paler by 60 %, lifted and cut."""
    rows = []
    for i in range(4):
        x = at(i, 4)
        whole = cubics(wave(x, 60, 120, 10, 12))
        s = stroke(whole, PLUM, 18, 1.5, edge(0.6))
        if i in (1, 2):
            peak = 0.92 if i == 1 else 1.6
            taken = stroke(cubics([[x - 6, 20], [x + 2, 60], [x + 10, 100]]), PLUM, 9, peak)["segments"]
            for n, part in enumerate(taken):
                part.update({"fade" if i == 1 else "lift": True, "start": n == 0})
            s["segments"] += taken
        if i == 3:
            s["segments"] = s["segments"][:4] + s["segments"][8:]
            s["segments"][4]["start"] = True
        rows.append(s)
    return painting(620, 120, rows)


def refined():
    """One leaf, and what was changed of it afterwards."""
    def leaf(x, colour, spread, style, bend=0.0, peak=1.5):
        points = [[x - 52, 96], [x - 24, 66 - bend], [x + 12, 42 - bend * 0.6], [x + 50, 34 + bend * 0.6]]
        return stroke(cubics(points), colour, spread, peak, style)
    fresh = lambda t: [LEAF[k] + (YELLOW[k] - LEAF[k]) * t for k in range(4)]
    return painting(620, 132, [leaf(at(0, 4), LEAF, 10, feather(1.6)), leaf(at(1, 4), LEAF, 10, feather(1.6), 24),
                               leaf(at(2, 4), LEAF, 17, edge(0.6), 24, 1.9), leaf(at(3, 4), fresh, 17, edge(0.6), 24, 1.9)])


# ---------------------------------------------------------------- a first painting

def first(part=3):
    """A sun, two ranges of hills and reeds, as the first page has them painted."""
    rows = [filled(circle(430, 120, 44), ryb("#e8742a", 0.95), 7, 1.1, feather(1.2))]
    if part > 1:
        rows.append(stroke(cubics([[-40, 250], [90, 190], [200, 214], [330, 168], [480, 212], [680, 182]]),
                           ryb("#7d8fb8", 0.85), 40, 1.2, feather(1.3)))
        rows.append(stroke(cubics([[-40, 330], [120, 276], [280, 300], [430, 262], [680, 310]]),
                           ryb("#3d5a74", 0.95), 46, 1.3, feather(1.5)))
    if part > 2:
        for i, (x, lean, top) in enumerate(((70, 26, 150), (96, 12, 190), (128, -14, 170), (150, 30, 215), (44, -8, 210))):
            rows.append(stroke(cubics([[x, 380], [x + lean * 0.3, 300], [x + lean, top]]), ryb("#26351f", 0.95), 3.2, 1.6))
            rows.append(stroke(cubics([[x + lean * 0.9, top + 30], [x + lean, top]]), ryb("#5b3a1e", 0.95), 6.5, 1.6))
    return painting(620, 360, rows)


# ---------------------------------------------------------------- brushes

BRUSHES = ("ink-wash", "brush-pen", "dry-brush", "broad-nib", "round-wash", "watercolour-edge", "granulating-wash",
           "wet-in-wet", "pencil", "charcoal", "gouache", "pastel")


def pen(x, y):
    """A pen's S of two seconds as CSV: it presses harder in the middle."""
    lines = ["x,y,pressure,time"]
    for i in range(81):
        u = i / 80
        lines.append(f"{x + 128 * (u - 0.5):.2f},{y - 20 * math.sin(2 * math.pi * u):.2f},"
                     f"{0.12 + 0.8 * math.sin(math.pi * u) ** 1.2:.3f},{0.9 * u:.4f}")
    return "\n".join(lines) + "\n"


def brushes(cli, folder):
    rows = []
    for i, name in enumerate(BRUSHES):
        x, y = at(i % 4, 4), 48 + 88 * (i // 4)
        ink, out = folder / "pen.csv", folder / "brush.json"
        ink.write_text(pen(x, y))
        subprocess.run([cli, "convert", ink, out, "--brush", name], check=True, stdout=subprocess.DEVNULL)
        brushed = json.loads(out.read_text())["strokes"]
        colour = (INDIGO, MADDER, TEAL, PLUM)[i % 4]
        for s in brushed:
            s["origin"] = [0, 0] if "origin" not in s else s["origin"]
            for g in s["segments"]:
                g["colour"] = list(colour[:3]) + [g["colour"][3]]
        left = min(g["bezier"][0][0] + s["origin"][0] for s in brushed for g in s["segments"])
        top = sum(g["bezier"][0][1] + s["origin"][1] for s in brushed for g in s["segments"]) / sum(
            len(s["segments"]) for s in brushed)
        for s in brushed:
            s["origin"] = [s["origin"][0] + x - 64 - left, s["origin"][1] + y - top]
        rows += brushed
    return painting(620, 272, rows, paper=grain(0.6))


# ---------------------------------------------------------------- drawing

def draw(cli, folder, name, what, *options):
    text = folder / f"{name}.json"
    text.write_text(json.dumps(what))
    subprocess.run([cli, "render", text, "-o", OUT / f"{name}.png", "--scale", "1.5", "--backend", "cpu", *options],
                   check=True)


def fitted(cli, folder):
    """A detail of a sample painting, and 24, 120 and 600 strokes that look like it."""
    shot = folder / "shot.png"
    subprocess.run([cli, "render", SAMPLES / "still-life.suffuse", "-o", shot, "--size", "300"], check=True)
    parts = [shot]
    for n in (24, 120, 600):
        out, picture = folder / f"fit{n}.suffuse", folder / f"fit{n}.png"
        subprocess.run([cli, "fit", shot, "-o", out, "--strokes", str(n), "--iterations", "500"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([cli, "render", out, "-o", picture], check=True)
        parts.append(picture)
    subprocess.run(["convert", *parts, "-bordercolor", "white", "-border", "4x4", "+append", "-resize", "930x",
                    OUT / "fitted.png"], check=True)


def shots(editor, folder):
    """Two pictures of the window: all of it, and nodes on the canvas."""
    display, home = ":93", folder / "home"
    home.mkdir()
    server = subprocess.Popen(["Xvfb", display, "-screen", "0", "1240x780x24", "-nolisten", "tcp"])
    env = dict(os.environ, DISPLAY=display, HOME=str(home), SUFFUSE_SETTINGS=str(home / "settings.ini"), LC_ALL="C.UTF-8",
               SUFFUSE_PRESENTER="raster", QT_QPA_PLATFORM="xcb")
    do = lambda *what: subprocess.run(["xdotool", *what], env=env, check=True, capture_output=True, text=True).stdout

    def take(name, *how):
        subprocess.run(["import", "-display", display, "-window", "root", *how, "-strip", OUT / f"{name}.png"], check=True)

    time.sleep(1)
    program = subprocess.Popen([editor, "--backend=cpu", SAMPLES / "still-life.suffuse"], env=env)
    try:
        time.sleep(4)
        window = do("search", "--onlyvisible", "--name", "Suffuse").split()[-1]
        do("windowmove", window, "0", "0", "windowsize", window, "1240", "780", "windowfocus", window)
        time.sleep(1)
        do("mousemove", "400", "330", "key", "0", "key", "v")
        time.sleep(1)
        do("mousemove", "550", "388", "click", "1")
        time.sleep(2)
        take("window", "-resize", "930x", "-colors", "80", "-dither", "None")
        do("mousemove", "347", "407", "keydown", "Control", "click", "1", "keyup", "Control", "key", "n")
        time.sleep(1)
        do(*["click", "4"] * 4)
        time.sleep(3)
        take("nodes", "-crop", "560x250+80+290", "+repage", "-resize", "930x", "-colors", "128", "-dither", "None")
    finally:
        program.kill()
        server.kill()


def main():
    cli = os.path.abspath(sys.argv[1])
    OUT.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name, make in {"diffusion": diffusion, "density": density, "granulation": granulation, "styles": styles,
                           "direction": direction, "mixing": mixing, "wash": wash, "fills": fills, "layers": layers,
                           "erasing": erasing, "refined": refined, "first": first}.items():
            draw(cli, folder, name, make())
        draw(cli, folder, "drying", drying(), "--time", "1")
        draw(cli, folder, "brushes", brushes(cli, folder))
        fitted(cli, folder)
        if len(sys.argv) > 2:
            shots(os.path.abspath(sys.argv[2]), folder)


if __name__ == "__main__":
    main()
