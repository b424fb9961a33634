#!/usr/bin/python3
"""read_suffuse.py FILE: prints a .suffuse file as its text form, read after docs/file-format.md by another program.
Needs Debian's python3-cbor2 and python3-zstandard."""
import base64
import functools
import hashlib
import json
import math
import struct
import sys
from itertools import islice

import cbor2
import zstandard

BLEND_MODES = ["normal", "multiply", "screen", "overlay", "darken", "lighten", "color-dodge", "color-burn", "hard-light",
               "soft-light", "difference", "exclusion", "hue", "saturation", "color", "luminosity", "plus",
               "destination-in", "destination-out", "source-atop"]
GROUP_TAGS = ["none", "red", "orange", "yellow", "green", "blue", "violet", "brown", "grey"]
STYLE_KINDS = [("uniform", 2), ("feathering", 2), ("edge", 3)]
MIX_MODES = ["alpha", "beta"]
CRC = [functools.reduce(lambda crc, _: crc >> 1 ^ (0x82F63B78 if crc & 1 else 0), range(8), k) for k in range(256)]


def crc32c(data):
    return functools.reduce(lambda crc, byte: crc >> 8 ^ CRC[(crc ^ byte) & 255], data, 0xFFFFFFFF) ^ 0xFFFFFFFF


def chunks(data):
    assert data[:12] == b"\x89SUFFUSE\r\n\x1a\n", "not a .suffuse file"
    at, kind = 12, b""
    while kind != b"ENDS":
        kind, size = struct.unpack_from("<4sI", data, at)
        end = at + 8 + size
        assert crc32c(data[at:end]) == struct.unpack_from("<I", data, end)[0], "checksum"
        yield kind.decode(), data[at + 8:end]
        start, at = at, end + 4
    assert hashlib.sha256(data[:start]).digest() == data[start + 8:end] and at == len(data), "hash"


class Cursor:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        self.at += size
        assert self.at <= len(self.data), "a length is wrong"
        return self.data[self.at - size:self.at]

    def u32(self):
        return struct.unpack("<I", self.take(4))[0]

    def varint(self):
        byte = self.take(1)[0]
        return byte if byte < 128 else byte & 127 | self.varint() << 7

    def coded(self, size):
        coding = self.take(1)[0]
        if coding == 1:
            return zstandard.ZstdDecompressor().decompress(self.take(self.varint()), max_output_size=max(size, 1))
        return self.take(size) if coding == 0 else self.take(1) * size if coding == 2 else bytes(size)

    def column(self, width, count):
        planes = [self.coded(count) for _ in range(width)]
        return [int.from_bytes(number, "little") for number in zip(*planes)]


def of_bits(bits):
    return struct.unpack("<f", struct.pack("<I", bits & 0xFFFFFFFF))[0]


def single(value):
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def signed(value, bits):
    return (value + (1 << bits - 1)) % (1 << bits) - (1 << bits - 1)


def unzigzag(code):
    return code >> 1 ^ -(code & 1)


def decoded(code, prediction, digits):
    if digits >= 0:
        scaled = prediction * 10.0**digits
        steps = math.floor(scaled + 0.5) if abs(scaled) < 2e9 else 0
        return single(signed(steps + unzigzag(code), 32) / 10.0**digits)
    bits = struct.unpack("<i", struct.pack("<f", single(prediction)))[0]
    step = signed((bits ^ 0x7FFFFFFF if bits < 0 else bits) + unzigzag(code), 32)
    return of_bits(step ^ 0x7FFFFFFF if step < 0 else step)


def series(codes, mode, before):
    digits, order, out = mode // 4 - 1, mode % 4, []
    for k, code in enumerate(codes):
        c, b, a = ([0.0, 0.0, before] + out)[-3:]
        predicted = (0.0, a, 2 * a - b, 3 * a - 3 * b + c)[min(order, max(k, 1))]
        out.append(decoded(code, predicted, digits))
    return out


def time_ratio(born, j):
    if j + 1 == len(born) or born[j] <= born[j - 1] or born[j + 1] <= born[j]:
        return 1.0
    ratio = float(born[j + 1] - born[j]) / float(born[j] - born[j - 1])
    return next((2.0**k for k in range(-6, 7) if abs(ratio - 2.0**k) < 0.01 * 2.0**k), ratio)


def handles(codes, mode, node, born, starts):
    digits, kind, out = mode // 4 - 1, mode % 4, []
    begin = [starts.get(j, node[j]) for j in range(len(born))]
    for j, (code1, code2) in enumerate(codes):
        a, b = begin[j], node[j + 1]
        if kind >= 2 and j > 0 and j not in starts:
            (p1, p2), r = out[-1], time_ratio(born, j) if kind == 3 else 1.0
            first = decoded(code1, a + r * (a - p2), digits)
            second = decoded(code2, 2 * first - a + r * r * (a - 2 * p2 + p1), digits)
        else:
            before = a if j == 0 or j in starts else begin[j - 1]
            after = b if j + 1 == len(born) or j + 1 in starts else node[j + 2]
            d1, d2 = ((b - before) / 6, (after - a) / 6) if kind == 1 else ((b - a) / 3, (b - a) / 3)
            first, second = decoded(code1, a + d1, digits), decoded(code2, b - d2, digits)
        out.append((first, second))
    return out


def palettes(data):
    c = Cursor(data)
    texts = [c.take(c.varint()).decode() for _ in range(c.varint())]
    styles = [style_of(c.u32(), [of_bits(c.u32()) for _ in range(3)]) for _ in range(c.varint())]
    mixes = [{"mode": MIX_MODES[c.u32()], "beta": of_bits(c.u32())} for _ in range(c.varint())]
    return texts, styles, mixes


def style_of(kind, xi):
    name, count = STYLE_KINDS[kind]
    return {"kind": name, "xi": xi[:count]}


def fills(c, n):
    """The fills of so many strokes, with times after the births of the strokes' first segments, or None."""
    marks = c.column(1, n)
    count, gradients = sum(mark & 1 for mark in marks), sum(mark >> 2 for mark in marks)
    usual = [0x41480000, 0x3F800000, 0x3F800000, 0x3F800000, 0, 0, 0, 0x3F800000, 0x3F800000, 0]
    numbers = zip(*[[of_bits(bits + less) for bits in c.column(4, count)] for less in usual])
    born = iter(c.column(8, count))
    ends = zip(*[map(of_bits, c.column(4, gradients)) for _ in range(4)])
    colours = zip(*[[of_bits(bits + less) for bits in c.column(4, gradients)] for less in (0, 0, 0, 0x3F800000)])
    for mark in marks:
        if not mark:
            yield None
            continue
        diffusion, density, granulation, age, r, y, b, o, ratio, angle = next(numbers)
        gradient = None
        if mark & 4:
            x0, y0, x1, y1 = next(ends)
            gradient = {"from": [x0, y0], "to": [x1, y1], "colour": list(next(colours))}
        yield {"diffusion": diffusion, "density": density, "granulation": granulation, "maxAge": age,
               "colour": [r, y, b, o], "born": unzigzag(next(born)), "rule": "evenodd" if mark & 2 else "nonzero",
               "gradient": gradient, "anisotropy": {"ratio": ratio, "angle": angle}}


def pictures(c, n, texts):
    """The pictures of so many strokes, or None, with images that are in the painting by their SHA-256."""
    marks = c.column(1, n)
    count, linked = sum(mark > 0 for mark in marks), sum(mark > 1 for mark in marks)
    sizes = zip(c.column(4, count), c.column(4, count))
    corners = zip(*[map(of_bits, c.column(4, count)) for _ in range(6)])
    hashes = zip(*[c.column(8, count) for _ in range(4)])
    links = iter(c.column(4, linked))
    for mark in marks:
        if not mark:
            yield None
            continue
        (width, height), (x0, y0, x1, y1, x2, y2) = next(sizes), next(corners)
        picture = {"sha256": struct.pack("<4Q", *next(hashes)).hex(), "width": width, "height": height,
                   "corner": [x0, y0], "right": [x1, y1], "down": [x2, y2]}
        if mark == 2:
            picture["link"] = texts[next(links)]
        yield picture


def strokes(payload):
    c = Cursor(payload)
    n, m = c.u32(), c.u32()
    texts, styles, mixes = palettes(c.coded(c.varint()))
    of_stroke = zip(*[c.column(width, n) for width in (8, 4, 1, 4, 4, 8, 4, 4, 8, 8)])
    modes = zip(*[c.column(1, n) for _ in range(10)])
    nodes = [iter(c.column(4, m + n)) for _ in "xy"]
    curves = [zip(c.column(4, m), c.column(4, m)) for _ in "xy"]
    attributes = [iter(c.column(4, m)) for _ in range(8)]
    rows = list(zip(*[c.column(width, m) for width in (8, 4, 1, 4, 4, 4)]))
    rewets = zip(*[c.column(8, sum(row[5] for row in rows)) for _ in range(2)])
    is_marked = c.at < len(payload)
    marks = c.column(1, m) if is_marked else [0] * m
    begins = [iter(c.column(4, sum(mark & 1 for mark in marks)) if is_marked else []) for _ in "xy"]
    filled = iter(list(fills(c, n)) if c.at < len(payload) else [None] * n)
    painted = iter(list(pictures(c, n, texts)) if c.at < len(payload) else [None] * n)
    assert c.at == len(payload) and max(marks, default=0) < 8, "bytes are left"
    marks = iter(marks)
    rows, identity, step, moment, before = iter(rows), 0, 0, 0, [0.0] * 8
    for (added, count, flags, name, brush, group, own, mix, *origin), mode in zip(of_stroke, modes):
        identity, mine, born = (identity + added + 1) % 2**64, list(islice(rows, count)), []
        for row in mine:
            step = signed(step + unzigzag(row[0]), 64)
            moment = signed(moment + step, 64)
            born.append(moment)
        node = [series(islice(axis, count + 1), mode[0], 0.0) for axis in nodes]
        marked = list(islice(marks, count))
        starts = [{j: decoded(next(codes), line[j], mode[0] // 4 - 1) for j in range(count) if marked[j] & 1}
                  for codes, line in zip(begins, node)]
        curve = [handles(islice(axis, count), mode[1], line, born, at) for axis, line, at in zip(curves, node, starts)]
        values = [series(islice(attributes[a], count), mode[2 + a], before[a]) for a in range(8)]
        before = [column[-1] for column in values]
        segments = []
        for i, (_, style, kind, ratio, angle, wettings) in enumerate(mine):
            diffusion, density, granulation, age, *colour = (column[i] for column in values)
            points = zip(*([at.get(i, line[i]), *pairs[i], line[i + 1]] for line, pairs, at in zip(node, curve, starts)))
            segments.append({
                "bezier": [list(point) for point in points], "born": born[i] / 1e6, "colour": colour,
                "diffusion": diffusion, "density": density, "granulation": granulation, "maxAge": age,
                "node": ["smooth", "symmetric", "corner"][kind], "style": styles[style - 1] if style else None,
                "anisotropy": {"ratio": of_bits(ratio + 0x3F800000), "angle": of_bits(angle)},
                "start": bool(marked[i] & 1), "lift": bool(marked[i] & 2), "fade": bool(marked[i] & 4),
                "rewet": [[(born[i] + unzigzag(t)) / 1e6, extra / 1e6] for t, extra in islice(rewets, wettings)]})
        fill = next(filled)
        if fill:
            fill["born"] = (born[0] + fill["born"]) / 1e6
        yield {"id": identity, "fill": fill, "picture": next(painted), "name": texts[name], "brush": texts[brush], "group": group or None,
               "visible": bool(flags & 1), "locked": bool(flags & 2), "style": styles[own], "mix": mixes[mix],
               "origin": list(struct.unpack("<2d", struct.pack("<2Q", *origin))), "segments": segments}


def read(data):
    images, out, head = [], {"format": "suffuse-text", "version": 1, "strokes": []}, {}
    for kind, payload in chunks(data):
        if kind == "HEAD":
            head = cbor2.loads(payload)
            assert head["reader"] <= 4, "the file is newer"
            out["version"] = head["reader"]
        elif kind == "IMAG":
            media = {b"\x89": "png", b"\xff": "jpeg", b"R": "webp", b"v": "x-exr"}.get(payload[:1], "tiff")
            images.append(f"data:image/{media};base64," + base64.b64encode(payload).decode())
        elif kind == "DOCU":
            out.update(cbor2.loads(payload))
        elif kind == "STRK":
            out["strokes"] += strokes(payload)
        else:
            assert kind == "ENDS" or kind[0].islower(), f"chunk {kind} is unknown"
    by_hash = {hashlib.sha256(base64.b64decode(image.partition(",")[2])).hexdigest(): image for image in images}
    for picture in filter(None, (stroke["picture"] for stroke in out["strokes"])):
        if "link" not in picture and picture["sha256"] in by_hash:
            picture["image"] = by_hash[picture.pop("sha256")]
    assert head["strokes"] == len(out["strokes"])
    assert head["segments"] == sum(len(stroke["segments"]) for stroke in out["strokes"])
    paper, underlay = out["canvas"]["paper"], out.get("underlay")
    paper["kind"] = ["none", "procedural", "image"][paper["kind"]]
    paper["grain"] = ["tooth", "fibres", "weave"][paper.get("grain", 0)]
    for holder in filter(lambda h: h and "image" in h, (paper, underlay)):
        holder["image"] = images[holder["image"]]
    if underlay:
        left, top, right, bottom = underlay["area"]
        underlay["area"] = [left, top, right - left, bottom - top]
    for group in out.get("groups", []):
        if "follows" in (group.get("text") or {}): # Binary files of an earlier version hold that, too.
            out["version"] = max(out["version"], 5)
        group["parent"] = group["parent"] or None
        if "blend" in group:
            group["blend"] = BLEND_MODES[group["blend"]]
        if "tag" in group:
            group["tag"] = GROUP_TAGS[group["tag"]]
        if wash := group.get("wash"):
            wash["style"] = style_of(wash["style"]["kind"], wash["style"]["xi"])
            wash["mix"] = {"mode": MIX_MODES[wash["mix"]["mode"]], "beta": wash["mix"].get("beta", 0)}
        if text := group.get("text"):
            text["alignment"] = ["start", "centre", "end"][text["alignment"]]
            numbers = text.pop("curve", [])
            points = [numbers[k:k + 2] for k in range(0, len(numbers), 2)]
            text["curve"] = [points[k:k + 4] for k in range(0, len(points), 4)]
    return out


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as file:
        json.dump(read(file.read()), sys.stdout, indent=1)
