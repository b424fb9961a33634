#!/usr/bin/python3
"""Prints a .suffuse file as its text form: docs/file-format.md, read by another program.

read_suffuse.py FILE. Needs Debian's python3-cbor2 and python3-zstandard.
"""
import base64
import hashlib
import json
import math
import struct
import sys

import cbor2
import zstandard

ATTRIBUTES = ["diffusion", "density", "granulation", "maxAge"]
STYLES = [("uniform", 2), ("feathering", 2), ("edge", 3)]


def crc32c(data, table=[]):
    if not table:
        for value in range(256):
            for _ in range(8):
                value = (value >> 1) ^ (0x82F63B78 if value & 1 else 0)
            table.append(value)
    crc = 0xFFFFFFFF
    for byte in data:
        crc = (crc >> 8) ^ table[(crc ^ byte) & 255]
    return crc ^ 0xFFFFFFFF


def chunks(data):
    assert data[:12] == b"\x89SUFFUSE\r\n\x1a\n", "not a .suffuse file"
    at, kind = 12, b""
    while kind != b"ENDS":
        kind, size = struct.unpack_from("<4sI", data, at)
        assert crc32c(data[at:at + 8 + size]) == struct.unpack_from("<I", data, at + 8 + size)[0], "checksum"
        yield kind.decode(), data[at + 8:at + 8 + size]
        if kind == b"ENDS":
            assert hashlib.sha256(data[:at]).digest() == data[at + 8:at + 8 + size], "hash"
        at += 12 + size
    assert at == len(data)


class Cursor:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        self.at += size
        assert self.at <= len(self.data)
        return self.data[self.at - size:self.at]

    def u32(self):
        return struct.unpack("<I", self.take(4))[0]

    def varint(self):
        value = shift = 0
        while True:
            byte = self.take(1)[0]
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def coded(self, size):
        coding = self.take(1)[0]
        if coding == 0:
            return self.take(size)
        if coding == 1:
            return zstandard.ZstdDecompressor().decompress(self.take(self.varint()), max_output_size=max(size, 1))
        return self.take(1) * size if coding == 2 else bytes(size)

    def column(self, width, count):
        planes = [self.coded(count) for _ in range(width)]
        return [int.from_bytes(number, "little") for number in zip(*planes)] if count else []


def single(value):
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def of_bits(bits, width=4):
    return struct.unpack("<f" if width == 4 else "<d", bits.to_bytes(width, "little"))[0]


def wrap(value, bits):
    value &= (1 << bits) - 1
    return value - (1 << bits) if value >> (bits - 1) else value


def unzigzag(code):
    return code >> 1 ^ -(code & 1)


def quantised(value, digits):
    if digits < 0:
        bits = struct.unpack("<i", struct.pack("<f", single(value)))[0]
        return bits ^ 0x7FFFFFFF if bits < 0 else bits
    scaled = value * 10.0**digits
    return math.floor(scaled + 0.5) if abs(scaled) < 2e9 else 0


def decoded(code, prediction, digits):
    step = wrap(quantised(prediction, digits) + unzigzag(code), 32)
    if digits >= 0:
        return single(step / 10.0**digits)
    return of_bits((step ^ 0x7FFFFFFF if step < 0 else step) & 0xFFFFFFFF)


def series(codes, mode, carry):
    digits, order, out = mode // 4 - 1, mode % 4, []
    for k, code in enumerate(codes):
        a = out[-1] if k else carry
        p = 0.0 if order == 0 else a if order == 1 or k < 2 else 2 * a - out[-2]
        if order == 3 and k >= 3:
            p = 3 * a - 3 * out[-2] + out[-3]
        out.append(decoded(code, p, digits))
    return out


def time_ratio(born, j):
    if j + 1 >= len(born) or born[j] <= born[j - 1] or born[j + 1] <= born[j]:
        return 1.0
    ratio = float(born[j + 1] - born[j]) / float(born[j] - born[j - 1])
    powers = [2.0**k for k in range(-6, 7) if abs(ratio - 2.0**k) < 0.01 * 2.0**k]
    return powers[0] if powers else ratio


def handles(first, second, mode, node, born):
    digits, kind, out = mode // 4 - 1, mode % 4, []
    for j, (code1, code2) in enumerate(zip(first, second)):
        a, b = node[j], node[j + 1]
        if kind >= 2 and j > 0:
            p1, p2 = out[-1]
            r = time_ratio(born, j) if kind == 3 else 1.0
            h = decoded(code1, a + r * (a - p2), digits)
            out.append((h, decoded(code2, 2 * h - a + r * r * (a - 2 * p2 + p1), digits)))
        else:
            before, after = node[max(j - 1, 0)], node[min(j + 2, len(node) - 1)]
            d1, d2 = ((b - before) / 6, (after - a) / 6) if kind == 1 else ((b - a) / 3, (b - a) / 3)
            out.append((decoded(code1, a + d1, digits), decoded(code2, b - d2, digits)))
    return out


def palettes(data):
    c = Cursor(data)
    texts = [c.take(c.varint()).decode() for _ in range(c.varint())]
    styles = []
    for _ in range(c.varint()):
        name, count = STYLES[c.u32()]
        styles.append({"kind": name, "xi": [of_bits(c.u32()) for _ in range(3)][:count]})
    mixes = [{"mode": ["alpha", "beta"][c.u32()], "beta": of_bits(c.u32())} for _ in range(c.varint())]
    return texts, styles, mixes


def strokes(payload):
    c = Cursor(payload)
    n, m = c.u32(), c.u32()
    texts, styles, mixes = palettes(c.coded(c.varint()))
    ids, counts, flags = c.column(8, n), c.column(4, n), c.column(1, n)
    names, brushes, groups = c.column(4, n), c.column(4, n), c.column(8, n)
    own, mix, origin = c.column(4, n), c.column(4, n), [c.column(8, n), c.column(8, n)]
    modes = [c.column(1, n) for _ in range(10)]
    nodes = [c.column(4, m + n) for _ in range(2)]
    handle = [[c.column(4, m), c.column(4, m)] for _ in range(2)]
    attributes = [c.column(4, m) for _ in range(8)]
    birth, style_of, kinds = c.column(8, m), c.column(4, m), c.column(1, m)
    ratio, angle, rewets = c.column(4, m), c.column(4, m), c.column(4, m)
    times, extras = c.column(8, sum(rewets)), c.column(8, sum(rewets))
    assert c.at == len(payload) and sum(counts) == m
    identity = s = v = w = born_before = step = 0
    carry = [0.0] * 8
    for j in range(n):
        k, identity = counts[j], (identity + ids[j] + 1) % 2**64
        born = []
        for code in birth[s:s + k]:
            step = wrap(step + unzigzag(code), 64)
            born_before = wrap(born_before + step, 64)
            born.append(born_before)
        node = [series(nodes[axis][v:v + k + 1], modes[0][j], 0.0) for axis in range(2)]
        curve = [handles(handle[axis][0][s:s + k], handle[axis][1][s:s + k], modes[1][j], node[axis], born)
                 for axis in range(2)]
        values = [series(attributes[a][s:s + k], modes[2 + a][j], carry[a]) for a in range(8)]
        carry = [column[-1] for column in values]
        segments = []
        for i in range(k):
            x, y = ([node[axis][i], *curve[axis][i], node[axis][i + 1]] for axis in range(2))
            segment = {"bezier": [list(point) for point in zip(x, y)], "born": born[i] / 1e6,
                       "colour": [values[a][i] for a in range(4, 8)],
                       "node": ["smooth", "symmetric", "corner"][kinds[s + i]],
                       "anisotropy": {"ratio": of_bits((ratio[s + i] + 0x3F800000) % 2**32), "angle": of_bits(angle[s + i])}}
            segment.update((name, values[a][i]) for a, name in enumerate(ATTRIBUTES))
            if style_of[s + i]:
                segment["style"] = styles[style_of[s + i] - 1]
            segment["rewet"] = [[(born[i] + unzigzag(times[w + r])) / 1e6, extras[w + r] / 1e6]
                                for r in range(rewets[s + i])]
            w += rewets[s + i]
            segments.append(segment)
        yield {"id": identity, "name": texts[names[j]], "brush": texts[brushes[j]], "group": groups[j] or None,
               "visible": bool(flags[j] & 1), "locked": bool(flags[j] & 2), "style": styles[own[j]], "mix": mixes[mix[j]],
               "origin": [of_bits(axis[j], 8) for axis in origin], "segments": segments}
        s, v = s + k, v + k + 1


def read(data):
    images, out, head = [], {"format": "suffuse-text", "version": 1, "strokes": []}, {}
    for kind, payload in chunks(data):
        if kind == "HEAD":
            head = cbor2.loads(payload)
            assert head["reader"] <= 1, "the file is newer"
        elif kind == "IMAG":
            media = {b"\x89": "png", b"\xff": "jpeg", b"R": "webp", b"v": "x-exr"}.get(payload[:1], "tiff")
            images.append(f"data:image/{media};base64," + base64.b64encode(payload).decode())
        elif kind == "DOCU":
            out.update(cbor2.loads(payload))
        elif kind == "STRK":
            out["strokes"] += strokes(payload)
        else:
            assert kind == "ENDS" or kind[0].islower(), f"chunk {kind} is unknown"
    paper, underlay = out["canvas"]["paper"], out.get("underlay")
    paper["kind"] = ["none", "procedural", "image"][paper["kind"]]
    paper["grain"] = ["tooth", "fibres", "weave"][paper.get("grain", 0)]
    for holder in filter(lambda h: h and "image" in h, (paper, underlay)):
        holder["image"] = images[holder["image"]]
    if underlay:
        left, top, right, bottom = underlay["area"]
        underlay["area"] = [left, top, right - left, bottom - top]
    for group in out.get("groups", []):
        group["parent"] = group["parent"] or None
    assert head["strokes"] == len(out["strokes"])
    assert head["segments"] == sum(len(stroke["segments"]) for stroke in out["strokes"])
    return out


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as file:
        json.dump(read(file.read()), sys.stdout, indent=1)
