"""Texts for the sample paintings, as the Text tool makes them: a group of filled strokes that knows what it says."""
import json
import subprocess

from fontTools.pens.basePen import BasePen
from fontTools.ttLib import TTFont

SERIF = "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf"


class Outlines(BasePen):
    """The contours of a glyph as lists of cubics, in font units."""

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.contours = []

    def _moveTo(self, point):
        self.contours.append([])
        self.first = self.here = point

    def _lineTo(self, point):
        if point != self.here:
            self._curveToOne(*(tuple(a + (b - a) * t / 3 for a, b in zip(self.here, point)) for t in (1, 2)), point)

    def _curveToOne(self, a, b, point):
        self.contours[-1].append([self.here, a, b, point])
        self.here = point

    def _closePath(self):
        self._lineTo(self.first)


def shaped(path, text):
    """The glyphs that HarfBuzz sets: (name, place in the text, advance, x, y), in font units."""
    out = subprocess.run(["hb-shape", "--output-format=json", "--utf8-clusters", path, text],
                         capture_output=True, check=True, text=True).stdout
    return [(g["g"], g["cl"], g["ax"], g["dx"], g["dy"]) for g in json.loads(out)]


def lettered(painting, name, text, x, y, size, spacing=0.0, **fill):
    """A line with its middle at x and its baseline at y: `size` is the em, `spacing` what lies between two letters
    besides, ems."""
    font = TTFont(SERIF)
    em, glyphs = font["head"].unitsPerEm, font.getGlyphSet()
    letters = shaped(SERIF, text)
    width = sum(a for _, _, a, _, _ in letters) / em + spacing * (len(letters) - 1)
    pen_x = x - width * size / 2
    with painting.group(name):
        painting.groups[-1]["text"] = {"string": text, "family": "DejaVu Serif", "size": size, "letterSpacing": spacing,
                                       "alignment": "centre", "place": [1, 0, 0, 1, x, y]}
        for glyph, cluster, advance, dx, dy in letters:
            pen = Outlines(glyphs)
            glyphs[glyph].draw(pen)
            at = lambda q: (pen_x + (q[0] + dx) * size / em, y - (q[1] + dy) * size / em)
            contours = [[[at(q) for q in curve] for curve in contour] for contour in pen.contours if contour]
            if contours:
                painting.area(text.encode()[cluster:].decode()[0], contours, **fill)
            pen_x += advance * size / em + spacing * size
