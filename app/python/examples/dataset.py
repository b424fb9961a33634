#!/usr/bin/env python3
"""Makes a dataset: renders of random strokes, with the numbers that they were made of.

    dataset.py OUT.npz [COUNT [SIZE]]
"""

import concurrent.futures
import sys

import numpy as np
import suffuse


def random_painting(seed, side=64):
    """One to four strokes of three segments on a square canvas."""
    random = np.random.default_rng(seed)
    strokes = int(random.integers(1, 5))
    segments = suffuse.new_table("segments", 3 * strokes)
    segments["stroke"] = np.repeat(np.arange(strokes), 3)
    for s in range(strokes):
        nodes = np.cumsum(random.normal(0, side / 10, (10, 2)), axis=0) + random.uniform(0.2, 0.8, 2) * side
        for k in range(3):
            segments["bezier"][3 * s + k] = nodes[3 * k : 3 * k + 4]
    segments["diffusion"] = np.repeat(random.uniform(1, 10, strokes), 3)
    segments["density"] = np.repeat(random.uniform(3, 10, strokes), 3)
    segments["colour"] = np.repeat(random.uniform(0, 1, (strokes, 4)), 3, axis=0)
    canvas = suffuse.new_table("canvas", 1)
    canvas["width"] = canvas["height"] = side
    return suffuse.Painting.from_tables(canvas=canvas, segments=segments)


def sample(arguments):
    """A picture and its painting's segments. Threads do not wait for each other: the work is done without Python's lock."""
    seed, size = arguments
    painting = random_painting(seed)
    return suffuse.render(painting, size=size, backend="cpu", threads=1), painting.segments


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    size = int(sys.argv[3]) if len(sys.argv) > 3 else 64
    with concurrent.futures.ThreadPoolExecutor() as pool:
        samples = list(pool.map(sample, ((seed, size) for seed in range(count))))
    pictures = np.stack([picture for picture, _ in samples])
    segments = np.concatenate([table for _, table in samples])
    first = np.cumsum([0] + [len(table) for _, table in samples])
    np.savez_compressed(sys.argv[1], pictures=pictures, segments=segments, first=first)
    print(f"{count} pictures of {size} × {size} pixels, {len(segments)} segments")
