#!/usr/bin/env python3
"""Says what changed between two versions of a painting, and shows where: what differs is drawn in red over grey.

    versions.py BEFORE AFTER OUT.png [WIDTH]
"""

import sys

import numpy as np
import suffuse


def marked(before, after, width):
    """The later picture in grey, red where the two differ by more than 2 of 255."""
    pictures = [suffuse.render(painting, size=width) for painting in (before, after)]
    differs = np.abs(pictures[0].astype(int) - pictures[1]).max(axis=2) > 2
    grey = np.repeat(128 + pictures[1].mean(axis=2, keepdims=True).astype(np.uint8) // 2, 3, axis=2)
    grey[differs] = (208, 32, 32)
    return grey, differs.mean()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    before, after = suffuse.open(sys.argv[1]), suffuse.open(sys.argv[2])
    found = suffuse.diff(before, after)
    print(f"{len(found['added'])} strokes added, {len(found['removed'])} removed, {len(found['changed'])} changed")
    for change in found["changed"][:5]:
        for value in change["values"][:3]:
            print(f"  stroke {change['id']}: {value['path']}: {value['before']} → {value['after']}")
    picture, share = marked(before, after, int(sys.argv[4]) if len(sys.argv) > 4 else 800)
    suffuse.write_picture(sys.argv[3], picture)
    print(f"{100 * share:.1f} % of the picture differs")
