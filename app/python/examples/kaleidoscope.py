#!/usr/bin/env python3
"""Puts turned and mirrored copies of a painting around a point, as one undo step.

    kaleidoscope.py PAINTING OUT.suffuse [COPIES]
"""

import math
import sys

import suffuse


def turned(centre, angle, mirrored):
    """The map that turns about a point and, if wanted, mirrors left and right before: (a, b, c, d, e, f)."""
    x, y = centre
    cosine, sine = math.cos(angle), math.sin(angle)
    a, b, c, d = (-cosine if mirrored else cosine), -sine, (-sine if mirrored else sine), cosine
    return a, b, c, d, x - a * x - b * y, y - c * x - d * y


def kaleidoscope(painting, copies):
    """The painting with its copies: each a group of its own."""
    document = suffuse.Document(painting)
    centre = (painting.size[0] / 2, painting.size[1] / 2)
    with document.step("Kaleidoscope"):
        for k in range(1, copies):
            document.add(painting)
            document.transform(turned(centre, 2 * math.pi * k / copies, k % 2 == 1))
            document.group(f"copy {k}")
    assert document.steps == ("Kaleidoscope",)
    return document.painting


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    result = kaleidoscope(suffuse.open(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) > 3 else 6)
    result.save(sys.argv[2])
    print(result)
