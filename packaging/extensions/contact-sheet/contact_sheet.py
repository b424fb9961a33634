"""Puts small pictures on one page."""

import numpy as np
import suffuse
from suffuse import extension

MOST_PIXELS = 400_000_000


def flat_picture(colour, width, height):
    """A sheet of one colour, drawn as Suffuse draws a background."""
    canvas = {"width": [8.0], "height": [8.0], "background": [[*colour[:3], 1.0]]}
    pixel = suffuse.render(suffuse.Painting.from_tables(canvas=canvas), size=8, backend="cpu")[0, 0]
    return np.broadcast_to(pixel, (height, width, 3)).copy()


def moments_of(painting, count):
    """Moments that are spread evenly over what happens, so that a pause is no row of equal pictures; the last is the end."""
    born = np.sort(np.concatenate([painting.segments["born"], painting.fills["born"]]))
    if not len(born):
        return [painting.end]
    # One half by the number of curves that are there, one half by time.
    times = np.linspace(born[0], painting.end, 2001)
    shares = np.searchsorted(born, times, side="right") / len(born) + np.linspace(0, 1, len(times))
    wanted = np.linspace(shares[0], shares[-1], count + 1)[1:]
    return [*np.interp(wanted, shares, times)[:-1], painting.end]


def layers_of(painting):
    """The outermost groups and what lies beside them, from bottom to top: rows of strokes."""
    parents = {int(group["id"]): int(group["parent"]) for group in painting.groups}
    layers = []
    for row, stroke in enumerate(painting.strokes):
        group = int(stroke["group"])
        while group and parents[group]:
            group = parents[group]
        if not layers or layers[-1][0] != group:
            layers.append((group, []))
        layers[-1][1].append(row)
    visible = {int(group["id"]): bool(group["visible"]) for group in painting.groups}
    return [rows for group, rows in layers if not group or visible[group]]


def with_rows_alone(painting, rows):
    strokes = painting.strokes.copy()
    shown = np.zeros(len(strokes), bool)
    shown[rows] = True
    strokes["visible"] &= shown
    return painting.replaced(strokes=strokes)


def pictures_of(painting, values):
    """The pictures, one by one, and how many there are."""
    renderer = suffuse.Renderer(backend="cpu")
    size = int(values["width"])
    if values["shows"] == "moments":
        moments = moments_of(painting, int(values["count"]))
        return (renderer.render(painting, size=size, time=float(time)) for time in moments), len(moments)
    layers = layers_of(painting)
    if not layers:
        extension.fail("There is nothing visible in the painting.")
    if values["shows"] == "growing":
        layers = [sum(layers[: k + 1], []) for k in range(len(layers))]
    return (renderer.render(with_rows_alone(painting, rows), size=size) for rows in layers), len(layers)


def sheet(job):
    values = job.values
    pictures, count = pictures_of(job.painting, values)
    width, gap = int(values["width"]), int(values["gap"])
    columns = min(int(values["columns"]), count)
    rows = -(-count // columns)
    height = round(job.painting.size[1] / (job.painting.size[0] / width)) or 1
    page_width, page_height = columns * (width + gap) + gap, rows * (height + gap) + gap
    if page_width * page_height > MOST_PIXELS:
        extension.fail(f"The page would have {page_width} × {page_height} pixels. Choose smaller or fewer pictures.")
    page = flat_picture(values["page"], page_width, page_height)
    for k, picture in enumerate(pictures):
        extension.progress(k / count)
        top, left = gap + k // columns * (height + gap), gap + k % columns * (width + gap)
        page[top : top + picture.shape[0], left : left + picture.shape[1]] = picture
    suffuse.write_picture(values["file"], page)
    said = {
        "de": "{} Bilder auf {} × {} Pixeln",
        "ja": "画像 {} 枚、{} × {} ピクセル",
        "fr": "{} images sur {} × {} pixels",
        "es": "{} imágenes en {} × {} píxeles",
        "zh_CN": "{} 张图片，{} × {} 像素",
    }
    extension.say(said.get(job.language, "{} pictures on {} × {} pixels").format(count, page_width, page_height))


if __name__ == "__main__":
    sheet(extension.job())
