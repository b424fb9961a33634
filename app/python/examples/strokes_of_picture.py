#!/usr/bin/env python3
"""Makes strokes that look like a picture, from few to many, each time going on with those before.

    strokes_of_picture.py PICTURE OUT.suffuse [STROKES [STEPS]]
"""

import sys

import numpy as np
import suffuse


def error(painting, picture):
    """The root mean square error of a painting, 255ths."""
    drawn = suffuse.render(painting, size=picture.shape[1])
    return float(np.sqrt(((drawn.astype(float) - picture) ** 2).mean()))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    picture = suffuse.read_picture(sys.argv[1])[..., :3]
    most = int(sys.argv[3]) if len(sys.argv) > 3 else 256
    steps = int(sys.argv[4]) if len(sys.argv) > 4 else 400
    painting = None
    for strokes in (most // 4, most):
        painting = suffuse.fit(picture, strokes=max(strokes, 1), steps=steps, start=painting)
        print(f"{len(painting)} strokes: {error(painting, picture):.1f} of 255")
    painting.save(sys.argv[2])
