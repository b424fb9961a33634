#!/usr/bin/env python3
"""Finds the densities and colours of strokes by which they look like a picture, by SciPy's L-BFGS-B and the exact gradient.

    optimise.py [STEPS]
"""

import sys

import numpy as np
import suffuse

try:
    from scipy.optimize import minimize
except ImportError:
    print("skipped: SciPy is not installed (python3-scipy)")
    sys.exit(77)

SIZE = 96


def start():
    """Five strokes side by side, all of one grey."""
    segments = suffuse.new_table("segments", 5)
    for k in range(5):
        x = 8 + 12 * k
        segments["bezier"][k] = [(x, 6), (x + 3, 18), (x - 3, 30), (x, 42)]
    segments["stroke"] = np.arange(5)
    segments["colour"] = (0.5, 0.5, 0.5, 0.9)
    segments["density"] = 8
    canvas = suffuse.new_table("canvas", 1)
    canvas["width"], canvas["height"] = 64, 48
    return suffuse.Painting.from_tables(canvas=canvas, segments=segments)


def with_numbers(painting, numbers):
    """The painting with other densities and colours."""
    segments = painting.segments.copy()
    table = numbers.reshape(-1, 4)
    segments["density"] = table[:, 0]
    segments["colour"][:, :3] = table[:, 1:]
    return painting.replaced(segments=segments)


def loss(numbers, painting, target):
    """The mean square error and its derivatives."""
    picture = suffuse.DifferentiablePicture(with_numbers(painting, numbers), size=SIZE)
    error = picture.picture - target
    slopes = picture.backward(2 * error / error.size)["segments"]
    return float((error.astype(float) ** 2).mean()), np.column_stack([slopes["density"], slopes["ryb"]]).ravel()


if __name__ == "__main__":
    painting = start()
    wanted = np.array([[9, 0.9, 0.1, 0.1], [7, 0.8, 0.7, 0.1], [8, 0.1, 0.9, 0.2], [6, 0.1, 0.6, 0.7], [9, 0.2, 0.1, 0.9]])
    target = suffuse.render(with_numbers(painting, wanted.ravel()), size=SIZE, dtype="float32")
    numbers = np.tile([8, 0.5, 0.4, 0.45], 5)
    before = loss(numbers, painting, target)[0]
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    found = minimize(loss, numbers, (painting, target), jac=True, method="L-BFGS-B",
                     bounds=[(0.5, 20), (0, 1), (0, 1), (0, 1)] * 5, options={"maxiter": steps})
    print(f"mean square error {before:.2e} → {found.fun:.2e} in {found.nit} steps")
    if not found.fun < 0.3 * before:
        sys.exit("the error did not fall as it should")
