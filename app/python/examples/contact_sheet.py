#!/usr/bin/env python3
"""Puts small pictures of many paintings into one picture.

    contact_sheet.py OUT.png PAINTING… [--width PIXELS]
"""

import sys

import numpy as np
import suffuse


def sheet(paintings, width, columns=4, gap=8):
    """The pictures in rows, on grey."""
    pictures = [suffuse.render(painting, size=width) for painting in paintings]
    height = max(picture.shape[0] for picture in pictures)
    columns = min(columns, len(pictures))
    rows = -(-len(pictures) // columns)
    out = np.full((rows * (height + gap) + gap, columns * (width + gap) + gap, 3), 128, np.uint8)
    for k, picture in enumerate(pictures):
        top, left = gap + k // columns * (height + gap), gap + k % columns * (width + gap)
        out[top : top + picture.shape[0], left : left + width] = picture
    return out


if __name__ == "__main__":
    arguments = sys.argv[1:]
    width = 240
    if "--width" in arguments:
        place = arguments.index("--width")
        width = int(arguments[place + 1])
        del arguments[place : place + 2]
    if len(arguments) < 2:
        sys.exit(__doc__)
    picture = sheet([suffuse.open(name) for name in arguments[1:]], width)
    suffuse.write_picture(arguments[0], picture)
    print(f"{len(arguments) - 1} paintings in {picture.shape[1]} × {picture.shape[0]} pixels")
