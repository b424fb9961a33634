#!/usr/bin/env python3
"""Films a painting while it is painted, by a camera that comes nearer: numbered frames.

    camera.py PAINTING OUT_FOLDER [FRAMES [WIDTH]]

ffmpeg makes a film of them:  ffmpeg -framerate 25 -i OUT_FOLDER/%05d.png film.webm
"""

import pathlib
import sys

import numpy as np
import suffuse


def eased(share):
    """From 0 to 1, slow at both ends."""
    return share * share * (3 - 2 * share)


def frames(painting, count, width):
    """The pictures, one after another. The renderer is kept, so that what does not differ is not drawn again."""
    renderer = suffuse.Renderer()
    canvas_width, canvas_height = painting.size
    height = round(width * canvas_height / canvas_width)
    for share in np.linspace(0, 1, count):
        zoom = 1 + 1.5 * eased(share)
        area_width = canvas_width / zoom
        area_height = area_width * height / width
        centre = np.array(painting.size) * (0.5 + 0.12 * eased(share))
        area = (centre[0] - area_width / 2, centre[1] - area_height / 2, area_width, area_height)
        moment = painting.begin + share * (painting.end - painting.begin)
        yield renderer.render(painting, size=width, area=area, time=moment)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    count, width = (int(v) for v in (sys.argv[3:] + ["100", "640"][len(sys.argv) - 3:])[:2])
    for number, picture in enumerate(frames(suffuse.open(sys.argv[1]), count, width)):
        suffuse.write_picture(folder / f"{number:05d}.png", picture)
    print(f"{count} frames in {folder}")
