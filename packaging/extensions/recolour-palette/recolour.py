"""Gives paint the colours of a palette."""

import numpy as np
import suffuse
from suffuse import extension

# As sRGB, from dark to light.
PALETTES = {
    "dusk": ["1b1433", "3c2a6b", "7a3b86", "c94f7c", "f2836b", "fbc687", "fdeed3"],
    "sea": ["06202f", "0c4a60", "15808c", "4fb3ac", "a3d9cb", "e8f3e6"],
    "forest": ["14210f", "2f4a24", "5b7a34", "98a84b", "d3c77a", "f4ecc9"],
    "terracotta": ["2b1511", "6b2d1e", "b04e2e", "d98a55", "ecc08c", "f8ead6"],
    "blossom": ["3a1730", "8a2f62", "d35f8f", "f29cb4", "f9cfd3", "fff3ec"],
    "ink": ["0d1016", "262f3d", "51596a", "a08546", "d9b75f", "f6efdc"],
    "sepia": ["1d120a", "4a2f1b", "80573a", "b58b66", "dcc09c", "f7ecd9"],
}

# Oklab (Ottosson, 2020): from linear sRGB to what the eye's cones see, and from that to lightness and two axes of colour.
TO_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
FROM_CONES = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


def converted(colour, turn):
    """Takes white out, turns the hue, keeps the greatest value, and puts black in, as Suffuse does in both directions."""
    white, black = min(colour), min(1 - c for c in colour)
    pure = [c - white for c in colour]
    after = turn(*pure)
    scale = max(pure) / max(after) if max(after) > 0 else 1
    return [min(max(c * scale + black, 0.0), 1.0) for c in after]


def rgb_of(colour):
    """sRGB of red, yellow and blue."""

    def turn(red, yellow, blue):
        green = min(yellow, blue)
        return red + yellow - green, yellow + green, 2 * (blue - green)

    return converted([float(c) for c in colour[:3]], turn)


def ryb_of(rgb):
    """Red, yellow and blue of sRGB."""

    def turn(red, green, blue):
        yellow = min(red, green)
        return red - yellow, (green + yellow) / 2, (blue + green - yellow) / 2

    return converted(rgb, turn)


def oklab(rgb):
    """Lightness and two axes of colour, so that distances are those that people see."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in rgb]
    return FROM_CONES @ np.cbrt(TO_CONES @ linear)


def palette_of(painting, name):
    """The palette as sRGB, from dark to light."""
    if name != "swatches":
        return [[int(hex[k : k + 2], 16) / 255 for k in (0, 2, 4)] for hex in PALETTES[name]]
    if len(painting.swatches) < 2:
        extension.fail("The painting has fewer than two swatches. Add some in the Colour dock, or choose another palette.")
    return sorted((rgb_of(colour) for colour in painting.swatches["colour"]), key=lambda rgb: oklab(rgb)[0])


class Recolouring:
    """What becomes of a colour."""

    def __init__(self, palette, by, strength, lightest, darkest):
        self._palette = np.array(palette)
        self._lab = np.array([oklab(rgb) for rgb in palette])
        self._by = by
        self._strength = strength
        self._darkest, self._range = darkest, max(lightest - darkest, 1e-6)

    def __call__(self, colour):
        rgb = rgb_of(colour)
        target = np.asarray(self._target(oklab(rgb)))
        mixed = (1 - self._strength) * np.array(rgb) + self._strength * target
        return [*ryb_of([float(c) for c in mixed]), float(colour[3])]

    def _target(self, lab):
        last = len(self._palette) - 1
        if self._by == "nearest":
            return self._palette[np.argmin(((self._lab - lab) ** 2).sum(axis=1))]
        # The painting's darkest colour becomes the palette's darkest one, and so on.
        place = last * min(max((lab[0] - self._darkest) / self._range, 0.0), 1.0)
        if self._by == "steps":
            return self._palette[round(place)]
        below = min(int(place), last - 1)
        return self._palette[below] + (place - below) * (self._palette[below + 1] - self._palette[below])


def lightness_range(painting, selection):
    """The lightness of the darkest and the lightest colour of the paint."""
    colours = []
    for table in (painting.segments, painting.fills):
        rows = table[np.isin(painting.strokes["id"][table["stroke"]], list(selection))] if selection else table
        colours += [rows["colour"][:, :3]]
    unique = np.unique(np.concatenate(colours), axis=0)
    if not len(unique):
        extension.fail("There is no paint that could be recoloured.")
    lightness = [oklab(rgb_of(colour))[0] for colour in unique]
    return min(lightness), max(lightness)


def recoloured(job):
    painting, values = job.painting, job.values
    darkest, lightest = lightness_range(painting, job.selection)
    background = painting.canvas["background"][0]
    if values["paper"]:
        lightest = max(lightest, oklab(rgb_of(background))[0])
    recolouring = Recolouring(
        palette_of(painting, values["palette"]), values["by"], values["strength"] / 100, lightest, darkest
    )
    document = suffuse.Document(painting)
    document.select(job.selection)
    document.recolour(recolouring)
    if values["paper"]:
        document.change_canvas(background=recolouring(background))
    return document.painting


if __name__ == "__main__":
    job = extension.job()
    job.write(recoloured(job))
