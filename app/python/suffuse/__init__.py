"""Paintings made of strokes that diffuse: read, made, changed, rendered and fitted.

A painting is an immutable value. Its strokes, segments and so on are structured numpy arrays ("tables"); `columns` says what
each column is. Lengths are in canvas units (y points down), times in seconds of document time, colours are red, yellow, blue
and opacity, each in [0, 1], where (0, 0, 0) is white. docs/python.md begins with an example.
"""

import os as _os
import pathlib as _pathlib
import sys as _sys

# Where numbers are typed: `import suffuse` alone does not load numpy, which takes longer than all else together.
from . import _suffuse
from ._suffuse import (
    DataError,
    DifferentiablePicture,
    Document as _Document,
    Error,
    FileError,
    Frames,
    LeftOutWarning,
    Painting,
    Renderer,
    __version__,
    backends,
    brushes,
    columns,
    density,
    diff,
    fit,
    loads,
    new_table,
    open,
    probe,
    read_picture,
    refit,
    render,
    render_tiles,
    table_names,
    timelapse,
    write_picture,
)
from ._documented import document as _document

__all__ = [
    "DataError",
    "DifferentiablePicture",
    "Document",
    "Error",
    "FileError",
    "Frames",
    "LeftOutWarning",
    "Painting",
    "Renderer",
    "Step",
    "backends",
    "brushes",
    "columns",
    "density",
    "diff",
    "fit",
    "gradient",
    "loads",
    "new_table",
    "open",
    "probe",
    "read_picture",
    "refit",
    "render",
    "render_tiles",
    "table_names",
    "timelapse",
    "write_picture",
]


def _module_folder():
    """The folder with the parts that read and write image files: beside this file, in a build, or where Debian has it."""
    here = _pathlib.Path(_os.path.abspath(__file__)).parent
    libraries = here.parents[2]
    machine = getattr(_sys.implementation, "_multiarch", "")  # Debian's Python says so: "x86_64-linux-gnu"
    for folder in (here / "modules", here.parents[1] / "lib" / "suffuse", libraries / machine / "suffuse", libraries / "suffuse"):
        if (folder / "suffuse_image_io.so").is_file():
            return str(folder)
    return str(here / "modules")


_suffuse.set_module_folder(_module_folder())


class Step:
    """Several edits as one undo step: `with document.step("Name"): …`. An exception undoes them."""

    def __init__(self, document, name):
        """The step of a document, which begins with `with`."""
        self._document = document
        self._name = name

    def __enter__(self):
        """Begins the step."""
        self._document.begin_step(self._name)
        return self._document

    def __exit__(self, kind, value, trace):
        """Ends the step; where an exception came, all of it is undone."""
        self._document.end_step(kind is None)
        return False


class Document(_Document):
    """A painting that is edited, with its undo steps.

    Edits act on what is selected, leave locked strokes alone, and return whether they changed something. Each is one step,
    which `undo` takes back and `redo` does again. Several threads may use one document: each edit is done as a whole. What is
    selected belongs to the document. A step that is open belongs to the thread that began it: until it ends, edits, undo and
    selecting by others raise RuntimeError.
    """

    def step(self, name):
        """All edits inside `with document.step("Name"):` are one step; an exception undoes them."""
        return Step(self, str(name))


def gradient(painting, loss_by_rgb, *, size=None, scale=None, area=None, time=None, threads=0):
    """Returns the derivatives of a loss by the numbers of a painting.

    `loss_by_rgb`: ∂L/∂(R, G, B) of each pixel, (height, width, 3) float32, or a function that gets the picture (of that
    shape, sRGB-encoded, [0, 1]) and returns it. The result has the tables of `DifferentiablePicture.backward`.
    """
    picture = DifferentiablePicture(painting, size=size, scale=scale, area=area, time=time, threads=threads)
    return picture.backward(loss_by_rgb(picture.picture) if callable(loss_by_rgb) else loss_by_rgb)


_document(_suffuse)
