#!/usr/bin/env python3
"""A strip of moments of a painting being painted, side by side in one picture.

    film_strip.py PAINTING OUT.png [FRAMES [WIDTH]]
"""

import sys

import numpy as np
import suffuse


def strip(painting, count, width):
    """The frames of a film, (height, count × width, 3): a second of film for each."""
    frames = suffuse.Frames(painting, fps=1, duration=count, size=width)
    for number, seconds in enumerate(frames.times, 1):
        print(f"frame {number}: {seconds:.2f} s")
    return np.hstack(list(frames))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    count, width = (int(v) for v in (sys.argv[3:] + ["6", "240"][len(sys.argv) - 3:])[:2])
    suffuse.write_picture(sys.argv[2], strip(suffuse.open(sys.argv[1]), count, width))
