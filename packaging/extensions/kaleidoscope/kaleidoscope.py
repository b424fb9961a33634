"""Puts mirrored or turned copies of strokes around a point."""

import math

import suffuse
from suffuse import extension

NAMES = {"de": "Kopie {}", "fr": "Copie {}", "ja": "コピー {}", "es": "Copia {}", "zh_CN": "副本 {}"}


def turned(centre, angle, mirrored):
    """The map that turns about a point and, if wanted, mirrors left and right before: (a, b, c, d, e, f)."""
    x, y = centre
    cosine, sine = math.cos(angle), math.sin(angle)
    a, b, c, d = (-cosine if mirrored else cosine), -sine, (-sine if mirrored else sine), cosine
    return a, b, c, d, x - a * x - b * y, y - c * x - d * y


def maps_of(centre, kind, copies):
    """A map for each copy, without the one that leaves all where it is."""
    across, down = turned(centre, 0, True), turned(centre, math.pi, True)
    if kind in ("across", "down", "both"):
        return {"across": [across], "down": [down], "both": [across, down, turned(centre, math.pi, False)]}[kind]
    # Every other sector of a kaleidoscope is the one before it in a mirror between them.
    return [turned(centre, 2 * math.pi * k / copies, kind == "kaleidoscope" and k % 2 == 1) for k in range(1, copies)]


def kaleidoscope(job):
    values, painting = job.values, job.painting
    width, height = painting.size
    centre = (width * values["x"] / 100, height * values["y"] / 100)
    ids = [int(id) for id in painting.strokes["id"] if not job.selection or int(id) in job.selection]
    document = suffuse.Document(painting)
    maps = maps_of(centre, values["kind"], int(values["copies"]))
    for k, matrix in enumerate(maps, 1):
        extension.progress(k / len(maps))
        document.select(ids)
        document.duplicate()
        copies = document.selected_strokes
        if not copies:
            extension.fail("Nothing that can be copied is selected.")
        document.reorder(0)
        document.transform(matrix)
        if values["delay"]:
            document.retime(k * values["delay"])
        document.group(NAMES.get(job.language, "Copy {}").format(k))
    return document.painting


if __name__ == "__main__":
    job = extension.job()
    job.write(kaleidoscope(job))
