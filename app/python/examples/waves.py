#!/usr/bin/env python3
"""Paints waves: a painting that is made of arrays alone.

    waves.py OUT.suffuse [ROWS]
"""

import sys

import numpy as np
import suffuse


def wave(x, row, rows):
    """The height of a row of waves, units."""
    return 8 * np.sin(x / 40 + 1.7 * row) + 5 * np.sin(x / 23 - row) * row / rows


def paint(rows=24, width=640, height=400, segments_per_row=16):
    """A stroke for each row, of cubics that follow the wave; later rows are wetter, bluer and darker."""
    count = rows * segments_per_row
    row = np.repeat(np.arange(rows), segments_per_row)
    step = width / segments_per_row
    start = np.tile(np.arange(segments_per_row), rows) * step
    # A cubic through four points of the curve: its control points by the inverse of Bernstein's matrix.
    through = np.array([[1, 0, 0, 0], [8, 12, 6, 1], [1, 6, 12, 8], [0, 0, 0, 1]]) / np.array([[1], [27], [27], [1]])
    x = start[:, None] + step * np.arange(4) / 3
    y = wave(x, row[:, None], rows)
    segments = suffuse.new_table("segments", count)
    segments["stroke"] = row
    segments["bezier"] = np.linalg.solve(through[None], np.stack([x, y], axis=-1))
    # Segments of a stroke meet in equal numbers.
    same = row[1:] == row[:-1]
    segments["bezier"][1:][same, 0] = segments["bezier"][:-1][same, 3]
    depth = row / rows
    segments["diffusion"] = 3 + 20 * depth
    segments["density"] = 6 + 6 * depth
    segments["born"] = 0.05 * np.arange(count)
    segments["max_age"] = 2
    segments["colour"] = np.stack([0.1 * depth, 0.25 * (1 - depth), 0.3 + 0.6 * depth, np.full(count, 0.8)], axis=-1)
    strokes = suffuse.new_table("strokes", rows)
    strokes["id"] = np.arange(rows) + 1
    strokes["origin"][:, 1] = (np.arange(rows) + 1) * height / (rows + 1)
    canvas = suffuse.new_table("canvas", 1)
    canvas["width"], canvas["height"] = width, height
    return suffuse.Painting.from_tables(canvas=canvas, strokes=strokes, segments=segments)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    painting = paint(*map(int, sys.argv[2:3]))
    painting.save(sys.argv[1])
    print(painting)
