#!/usr/bin/env python3
"""Plots how dense the paint of a stroke is over time, in its middle and beside it.

    density_over_time.py PAINTING STROKE_ID OUT.png|OUT.csv

The plot needs matplotlib; the table does not.
"""

import sys

import numpy as np
import suffuse


def densities(painting, stroke, count=60):
    """Times, seconds; distances from the curve, units; and φ, (times, distances)."""
    row = int(np.flatnonzero(painting.strokes["id"] == stroke)[0])
    segments = painting.segments[painting.segments["stroke"] == row]
    middle = segments[len(segments) // 2]
    curve = painting.strokes["origin"][row] + middle["bezier"].astype(float)
    place = np.array([1, 3, 3, 1]) @ curve / 8
    along = curve[3] - curve[0]
    across = np.array([-along[1], along[0]]) / max(np.hypot(*along), 1e-9)
    distances = np.array([0.0, 4.0, 8.0, 16.0])
    times = np.linspace(middle["born"], middle["born"] + middle["max_age"], count)
    return times, distances, suffuse.density(painting, stroke, place + distances[:, None] * across, time=times)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    times, distances, phi = densities(suffuse.open(sys.argv[1]), int(sys.argv[2]))
    out = sys.argv[3]
    if out.endswith(".csv"):
        header = "seconds," + ",".join(f"phi at {d:g} units" for d in distances)
        np.savetxt(out, np.column_stack([times, phi]), delimiter=",", header=header, comments="")
    else:
        try:
            import matplotlib
        except ImportError:
            sys.exit("matplotlib is not installed; give an OUT that ends with .csv")
        matplotlib.use("Agg")
        from matplotlib import pyplot

        for k, distance in enumerate(distances):
            pyplot.plot(times, phi[:, k], label=f"{distance:g} units beside the curve")
        pyplot.xlabel("document time, s")
        pyplot.ylabel("density φ")
        pyplot.legend()
        pyplot.savefig(out)
    print(f"φ is at most {phi.max():.3g}, at {times[phi.max(axis=1).argmax()]:.3g} s")
