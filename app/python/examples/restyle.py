#!/usr/bin/env python3
"""Restyles paintings: wetter, softer and in the colours of dusk. The originals stay.

    restyle.py OUT_FOLDER PAINTING…
"""

import pathlib
import sys

import suffuse


def dusk(colour):
    """Takes yellow out of a colour (red, yellow, blue, opacity), and puts blue in."""
    red, yellow, blue, opacity = colour
    return red, 0.6 * yellow, blue + 0.3 * (1 - blue), opacity


def restyled(painting):
    """The painting after three edits, which are one step of its document."""
    document = suffuse.Document(painting)
    with document.step("Dusk"):
        document.recolour(dusk)
        document.select_all()
        document.change_segments(granulation=0.6)
        document.change_canvas(paper_kind="procedural", paper_strength=0.4, background=(0.02, 0.05, 0.08, 1))
    return document.painting


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[2:]:
        before = suffuse.open(name)
        after = restyled(before)
        after.save(folder / (pathlib.Path(name).stem + ".suffuse"))
        print(f"{name}: {len(suffuse.diff(before, after)['changed'])} strokes changed")
