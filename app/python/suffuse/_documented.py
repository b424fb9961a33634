"""The docstrings of the compiled part: shapes, units and errors. They stand here so that they can be read as one text."""

_VIEW = """
    size: W or (W, H), pixels; the height follows from the area. scale: pixels a unit, in place of size (default 1).
    area: (x, y, width, height), units (default: the canvas). time: the moment, seconds (default: all has dried)."""

TEXTS = {
    "Painting": """An immutable painting: `Painting(width, height)` is an empty one, in units.

    Paintings are equal if their values are, and may be pickled, hashed, and shared by threads. `len` is the number of
    strokes.""",
    "Painting.__init__": "An empty painting with a white canvas of width × height units.",
    "Painting.save": """Saves the painting; the ending chooses the format: .suffuse, .json, .svg, .svgz or .pdf.

    The old file stays until the new one is whole. For drawings: kind is "bands", "outlines" or "hybrid", bands the number of
    steps of full opacity (1 to 256), time the moment in seconds, page the size of a PDF's paper ("A4", "200x150mm").
    Raises FileError where the file cannot be written.""",
    "Painting.dumps": """Returns the bytes of a file: format is "suffuse", "json", "svg", "svgz" or "pdf". The rest is as in `save`.""",
    "Painting.replaced": """Returns a painting with some of its tables replaced: `painting.replaced(segments=…, strokes=…)`.

    A table is a structured array, or a mapping from names to arrays; columns that are missing have their defaults. Strokes
    that stay equal are shared. Raises DataError where a value is not in its domain, and names it as the text form does
    ("strokes[3].segments[0].diffusion: …").""",
    "Painting.from_tables": """Returns a painting of tables: `Painting.from_tables(segments=…, strokes=…, canvas=…)`.

    Without `strokes`, each number in the column `stroke` of the segments is a usual stroke. `images` is a list of encoded
    images (bytes), to which columns refer by place. The rest is as in `replaced`.""",
    "Painting.table": """Returns one of the tables by its name (`table_names`), or "images". It cannot be written to: copy it.""",
    "Painting.without_extras": "Returns the painting without what lay beside it in its file: preview, view, undo history, profile.",
    "Painting.hash": "SHA-256 of everything that a file stores of the painting, 64 hexadecimal digits.",
    "Painting.size": "Width and height of the canvas, units.",
    "Painting.begin": "When the first stroke begins, seconds; 0 where it is later.",
    "Painting.end": "When all has dried, seconds; 0 without strokes.",
    "Painting.segment_count": "The number of segments of all strokes.",
    "Painting.canvas": "The canvas, one row: width, height, background and paper.",
    "Painting.strokes": "The strokes from bottom to top: id, name, group, visible, locked, style, mix, origin, brush.",
    "Painting.segments": """The segments of all strokes. `stroke` is the row of the stroke that a segment belongs to, `bezier` has its
    control points as offsets from the stroke's origin, (4, 2), units.""",
    "Painting.rewets": "When segments are wetted again: `segment` is a row of the segments, `wetting` (time, for how long), seconds.",
    "Painting.fills": "The fills of strokes; `stroke` is the row of the stroke.",
    "Painting.pictures": "The pictures with which strokes are painted; `image` is a place in `images`, −1: none.",
    "Painting.groups": "The groups, in any order: name, parent, opacity, blend mode and so on.",
    "Painting.texts": "The texts that groups were made from; `group` is the row of the group.",
    "Painting.text_curves": "The baselines of texts, cubic by cubic: `text` is the row of the text, `bezier` (4, 2), units.",
    "Painting.swatches": "The palette: names, colours, and whether paint follows them.",
    "Painting.underlay": "The picture to paint over, no row or one. It is never part of the rendered picture.",
    "Painting.images": "The encoded images (bytes) that tables refer to by place.",
    "Renderer": """Draws paintings again and again, and evaluates only what differs from the last call: for films and for what is
    being changed. The bits are those of `render`. Threads may share it; they wait for each other.""",
    "Renderer.__init__": 'backend: "cpu", "cuda", "reference" or "auto"; threads: 0 is one a core; devices: GPUs that share a picture, or "all".',
    "Renderer.render": """Draws a painting; returns an array (height, width, 3), or 4 channels where it is transparent.
""" + _VIEW + """
    transparent: no background, alpha is the coverage. drafts: groups that are drafts, too. dtype: "uint8", "uint16" or
    "float32" (sRGB-encoded, [0, 1]).""",
    "Renderer.backend": 'What draws: "CPU", "CUDA" or "reference".',
    "Renderer.device": 'The device: "2 threads · AVX2", "H100".',
    "DifferentiablePicture": """A picture that was drawn so that its derivatives can be taken. The same bits for any number of threads.

    Raises DataError, and names the stroke, where the picture has no gradient: groups that blend, washes, pictures, tensors,
    styles that vary along a stroke, spreads below a pixel (docs/solver.md).""",
    "DifferentiablePicture.__init__": "Draws a painting, without Python's lock." + _VIEW + """
    threads: 0 is one a core.""",
    "DifferentiablePicture.picture": "sRGB-encoded R, G, B, (height, width, 3) float32. It is the picture's own memory, and cannot be written to.",
    "DifferentiablePicture.backward": """Returns the derivatives of a loss, from ∂L/∂(R, G, B) of each pixel, (height, width, 3) float32.

    The result has arrays of float64: "segments" (a row for each of the painting's segments: bezier (4, 2), density,
    diffusion, ryb (3), opacity, granulation), "fills" (the same without bezier; `stroke` is the row of the stroke) and
    "strokes" (style_xi (3)).""",
    "Document": "What `suffuse.Document` is made of.",
    "Document.__init__": "Begins with a painting and no steps.",
    "Document.painting": "The painting as it is now.",
    "Document.steps": "The names of the undo steps, the oldest first.",
    "Document.done": "How many of the steps are done; those behind them can be redone.",
    "Document.undo": "Undoes the last step. Returns False where there is none, or where a step is open.",
    "Document.redo": "Does again what was undone last. Returns False where there is nothing, or where a step is open.",
    "Document.begin_step": "Begins a step of several edits; `with document.step(name)` ends it, too.",
    "Document.end_step": "Ends a step that was begun; with keep=False it is undone and forgotten.",
    "Document.apply": "Makes another painting this document's, as one step. Strokes that are equal stay what they are.",
    "Document.select": "Selects strokes by their ids, and segments as (id, index). It is no step.",
    "Document.select_all": "Selects all strokes. It is no step.",
    "Document.selected_strokes": "The ids of the selected strokes, ascending.",
    "Document.selected_segments": "The selected segments as (id, index), ascending.",
    "Document.change_segments": """Sets values of the selected segments, or of all that lay paint in the selected strokes: `change_segments(diffusion=20)`.
    Names and units are those of the columns of "segments". Raises DataError where a value is not in its domain.""",
    "Document.change_strokes": 'Sets values of the selected strokes; names are those of the columns of "strokes".',
    "Document.change_fills": 'Sets values of the fills of the selected strokes; names are those of the columns of "fills".',
    "Document.change_groups": 'Sets how groups (ids) blend, and their tags; names are those of the columns of "groups".',
    "Document.change_canvas": 'Sets values of the canvas; names are those of the columns of "canvas".',
    "Document.add": "Adds the strokes of another painting on top, with new ids, and selects them if `select`.",
    "Document.delete": "Deletes the selected segments, or the selected strokes.",
    "Document.duplicate": "Puts copies of the selected strokes above them, moved by (dx, dy) units, and selects the copies.",
    "Document.arrange": 'Moves the selected strokes in the order: "raise", "lower", "top" or "bottom".',
    "Document.reorder": "Moves strokes (ids; default: the selected ones) just below another one, or on top of all where that is 0.",
    "Document.transform": """Maps the selected strokes: x′ = a x + b y + e, y′ = c x + d y + f, matrix = (a, b, c, d, e, f), units.
    scale_spread: whether spread and density follow, so that the picture is mapped.""",
    "Document.align": 'Moves the selected strokes so that their boxes are aligned: "left", "centre", "right", "top", "middle", "bottom"; to "selection", "anchor", "biggest" or "canvas".',
    "Document.distribute": 'Moves three or more selected strokes to even "gaps" or "centres", "horizontal" or "vertical".',
    "Document.recolour": """Gives the selected paint (all, where nothing is selected) the colours that a function makes of its colours: it gets and
    returns (red, yellow, blue, opacity), and is asked once for each colour.""",
    "Document.apply_brush": 'Puts a brush on the selection as if it had been painted with it; part is "whole", "form", "colour" or "texture".',
    "Document.simplify": "Makes the selection of fewer segments: curves differ by `distance` units, values by the share `values`.",
    "Document.smooth": "Takes wiggles shorter than `length` units out of the selected strokes.",
    "Document.reverse": "Reverses the direction of the selected strokes.",
    "Document.join": "Joins the selected strokes to the topmost one, end to end.",
    "Document.combine": "Makes one stroke of the selected ones; their densities add up.",
    "Document.break_apart": "Makes strokes of the chains of the selected strokes.",
    "Document.erase": "Takes away what of the selected strokes lies nearer than `radius` units to a path, (points, 2).",
    "Document.fill": "Fills those of the selected strokes that are not filled.",
    "Document.unfill": "Takes the fills of the selected strokes away.",
    "Document.combine_areas": 'Makes one area of the selected filled strokes: "union", "difference", "intersection", "exclusion" or "division".',
    "Document.offset_areas": "Moves the outlines of the selected areas outwards by so many units, inwards where it is negative.",
    "Document.group": "Makes a group of the selected strokes, in the place of the topmost.",
    "Document.ungroup": "Dissolves the groups that are selected as a whole, or those that the selected strokes are in.",
    "Document.set_group": "Names, shows or hides, locks or unlocks a group by its id.",
    "Document.merge_down": "Puts a group into the one just below it; the picture stays. Nothing happens where it would change.",
    "Document.show_all": "Shows all strokes and groups.",
    "Document.unlock_all": "Unlocks all strokes and groups.",
    "Document.retime": "Moves the births of the selection by so many seconds.",
    "Document.stretch": "Makes the selection be drawn from `begin` to `end`, seconds.",
    "Document.set_pace": 'Sets the births along each selected stroke: "even", "ease_in", "ease_out" or "ease_in_out".',
    "Document.freeze": "Stops the spreading of all that is wet at a time, seconds.",
    "Document.rewet": "Wets the selected segments again at a time, for `extra` seconds.",
    "Document.remove_rewetting": "Removes all wetting again from the selection.",
    "open": """Reads a painting from a file of any format that Suffuse knows, which is found from its content: documents, the text form,
    pen recordings, SVG, OpenRaster, Photoshop, PDF with a painting in it, diffusion curves.

    brush: the brush that recordings and drawings are painted with, a name (`brushes`) or a brush file. salvage: of a damaged
    document take what is whole. What is left out is told by LeftOutWarning. Raises FileError where the file cannot be read,
    DataError where its content cannot be.""",
    "loads": "Reads a painting from the bytes of a file, as `open` does. name: for messages, and to find linked images beside it.",
    "diff": """Returns what differs between two paintings, by the identities of their strokes: "same", ids that were "added", "removed" and
    "moved", "changed" (id, segments_added, segments_removed, segments_changed, values) and "values" of all else. A value has
    a path and its texts "before" and "after", as in the text form.""",
    "new_table": "Returns an array with so many rows of defaults, of one of the tables (`table_names`).",
    "columns": """Returns what the columns of a table are: for each "name", "type" (numpy's), "shape" of a row's part, "unit" ("unit" is the
    canvas unit), "domain" and, where numbers stand for words, "words" from 0 on.""",
    "table_names": "Returns the names of the tables of a painting.",
    "brushes": "Returns the names of the brushes that come along.",
    "render": """Draws a painting with the bits of `suffuse-cli render`; returns an array (height, width, 3), or 4 channels where it is
    transparent. It works without Python's lock, and Ctrl+C stops it.
""" + _VIEW + """
    transparent: no background, alpha is the coverage. drafts: groups that are drafts, too. backend: "auto", "cpu", "cuda" or
    "reference". threads: 0 is one a core. devices: GPUs that share the picture, or "all". dtype: "uint8", "uint16" or
    "float32" (sRGB-encoded, [0, 1]; the renderer's own memory). Raises DataError for what cannot be drawn.""",
    "write_picture": """Writes an array (height, width, 3 or 4) as an image file: .png, .tiff, .exr, .jpg, .webp or .pfm.

    Values are sRGB-encoded: 0 to 255, 0 to 65535, or floats in [0, 1]. depth: "8", "16", "half" or "float"; quality: 1 to
    100 of JPEG and WebP; dpi: pixels an inch, 0: not said.""",
    "read_picture": "Reads an image file; returns sRGB-encoded straight RGBA, (height, width, 4), in a dtype of `render`.",
    "backends": 'Returns what can draw here: for each "backend" its "device", and why it is "unavailable" (empty: it is not).',
    "probe": """Returns what lies at a point (units) at a time (seconds), stroke by stroke from bottom to top, as
    `suffuse-cli probe --json --all` has it: densities, coverage, opacity, colours before and after.""",
    "density": """Returns the density φ of a stroke (by its id) at points (…, 2), units, and times, seconds (default: all has dried).

    The result has the shape of the times, then that of the points. It is right to about a thousandth; `probe` is exact.""",
    "fit": """Makes strokes that look like a picture: an array (height, width, 3 or 4), sRGB-encoded, or the path of an image file.

    strokes: at most so many. error: as many strokes as this root mean square error needs, 255ths; 0: all. steps: how many.
    palette: so many paints, 0: as many as strokes. perceptual: the share of the error as people see it. style: "feathering",
    "uniform" or "edge". least_width, greatest_width: pixels of the picture, 0: any. weight: how much pixels count, (height,
    width), [0, 1]. start: a painting that was fitted before. pixels: the picture is averaged down to so many. progress: is
    called with [0, 1] after each step; an exception that it raises ends the fit.

    Ctrl+C ends it, too. The exception, KeyboardInterrupt or another, then has the strokes so far as its attribute `painting`,
    with which `start` goes on: None where there are none yet, and the start itself where they are no nearer than that.""",
    "refit": """Makes fewer strokes that look like those of a painting, as `suffuse-cli refit` does; returns the painting and a report.

    select: ids of the strokes to make anew, or layer: the name of a group (default: all strokes). to: what the whole is to look
    like, a Painting, an array (height, width, 3 or 4), sRGB-encoded, or the path of either (default: as it does). strokes: at
    most so many (default: a quarter of those before). error: as many as this root mean square error needs, 255ths. style:
    "feathering", "uniform" or "edge". steps: how many. pixels: what the strokes reach is fitted at so many. seed: other numbers
    give other strokes. progress: is called now and then with [0, 1], again from 0 for each number of strokes that is tried;
    what it raises ends the refit, as Ctrl+C does, and nothing is made.

    The report has "strokes_before", "strokes", "between" (other strokes that lay between them and lie below now), "area" (x, y,
    width, height, units, over which errors are measured), "error_before" and "error", each a "root_mean_square" and the
    "greatest" difference in 255ths, "steps", "worse" (farther from `to` than before) and "reached" (whether `error` was).
    Raises DataError where such strokes cannot be replaced, FileError where `to` cannot be read.""",
    "render_tiles": """Draws a picture of any size in tiles, as `suffuse-cli render --tiles` does: path ends in .dzi (Deep Zoom) or .tif
    (BigTIFF), or is a folder for a web server.
""" + _VIEW + """
    transparent: no background. drafts: groups that are drafts, too. tile: pixels a side (254; 512 in a TIFF). overlap: pixels
    that tiles show of their neighbours (1; 0). sheet: pixels a side of what is drawn at once. format: "jpg" or "png" of Deep
    Zoom. quality: 1 to 100. depth: "8" or "16" bits. backend, threads, devices: as in `render`. progress: is called now and
    then with [0, 1].

    Ctrl+C, or what `progress` raises, ends it soon; what is finished stays on the disk, and the same call goes on with it: tiles
    that are whole are kept, others drawn. Returns the "path" that was written, "backend", "device", "devices", "width" and
    "height" (pixels), "levels", "tiles", "sheets" (drawn now), "kept" (sheets that were there), "pixels" (drawn now), "bytes"
    (written) and "ms" (milliseconds). Raises DataError for what cannot be drawn, FileError where it cannot be written or
    something else is there.""",
    "timelapse": """Writes a painting being painted, as `suffuse-cli timelapse` does: path is film/%05d.png, or film.webp, .webm or .mp4.

    fps: frames a second. duration, idle: seconds, of the film and of what is kept of a pause. size, scale, area: as in `render`.
    transparent: no background. once: a WebP plays once. backend, threads, devices: as in `render`. progress: is called now and
    then with [0, 1]; what it raises ends the film, as Ctrl+C does, and nothing is written. Returns "backend", "device",
    "devices", "frames", "tiles" and "tiles_evaluated". Raises DataError for a film that cannot be, FileError where it cannot be
    written.""",
    "Frames": """The frames of `timelapse` as arrays, each drawn when it is asked for: a sequence, with `len`, indices and `for`.

    Frames that follow each other are quick, since only what differs is drawn. Threads may share it; they wait for each other.""",
    "Frames.__init__": """fps: frames a second. duration, idle: seconds, of the film and of what is kept of a pause. size, scale, area,
    transparent, backend, threads, devices, dtype: as in `render`.""",
    "Frames.__len__": "The number of frames.",
    "Frames.__getitem__": "Draws a frame; returns an array (height, width, 3), or 4 channels where it is transparent.",
    "Frames.__iter__": "The frames one after another.",
    "Frames.times": "The moment of each frame, (frames,), seconds of document time, ascending.",
}


def document(module):
    """Gives the functions, classes and properties of the compiled part their docstrings."""
    for path, text in TEXTS.items():
        owner = module
        *names, last = path.split(".")
        for name in names:
            owner = getattr(owner, name)
        text = "\n".join(line[4:] if line.startswith("    ") else line for line in text.split("\n"))
        value = owner.__dict__[last]
        if isinstance(value, property):
            setattr(owner, last, property(value.fget, value.fset, value.fdel, text))
        elif isinstance(value, type):
            value.__doc__ = text
            value.__module__ = "suffuse"
        else:
            module.set_doc(getattr(owner, last), text)
