"""What the tests of the Python module share."""

import os
import pathlib
import signal
import subprocess
import sys
import warnings

try:
    import numpy
except ImportError:
    print("skipped: numpy is missing (python3-numpy)")
    sys.exit(77)

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = SOURCE / "packaging" / "samples"
CLI = os.environ.get("SUFFUSE_CLI", "suffuse-cli")

# A shell that starts the tests in the background has them ignore Ctrl+C, and Python leaves it at that: what they stop by it
# would go on for ever.
signal.signal(signal.SIGINT, signal.default_int_handler)


def run_cli(*arguments, code=0):
    """Runs suffuse-cli; returns what it printed on stdout and on stderr."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, check=False)
    assert done.returncode == code, (arguments, done.returncode, done.stderr)
    return done.stdout, done.stderr


def documents():
    """The paintings of the repository: samples, and fixtures that use all that there is."""
    return sorted(SAMPLES.glob("*.suffuse")) + sorted((SOURCE / "tests" / "fixtures").glob("v*/*.suffuse"))


def quietly(function, *arguments, **options):
    """Calls a function and drops its warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return function(*arguments, **options)


def text_along_a_wave(folder, bend=-80, move=0):
    """A painting, read from a drawing: stroke 1 is a wave, and a text follows it. None where there are no fonts."""
    import suffuse

    drawing, out = pathlib.Path(folder) / "wave.svg", pathlib.Path(folder) / "wave.suffuse"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300">'
        f'<path id="p" d="M{20 + move} 100C{100 + move} {100 + bend} {200 + move} 180 {300 + move} 90" fill="none" '
        'stroke="#268" stroke-width="3" stroke-linecap="round" stroke-linejoin="round"/>'
        '<text font-size="20"><textPath href="#p">Along it</textPath></text></svg>'
    )
    run_cli("convert", drawing, out)
    painting = suffuse.open(out)
    if len(painting.texts) == 0:
        return None
    assert list(painting.texts["follows"]) == [1], painting.texts
    return painting


def places(painting):
    """Where the points of all segments are on the canvas, whatever the origins are."""
    segments = painting.segments
    return painting.strokes["origin"][segments["stroke"]][:, None, :] + segments["bezier"].astype(float)


def three_strokes():
    """A small painting with three strokes of two segments each, which are wet for a second."""
    import suffuse

    segments = suffuse.new_table("segments", 6)
    for k in range(6):
        x = 20.0 + 60 * (k % 2)
        segments["bezier"][k] = [(x, 0), (x + 20, 10), (x + 40, -10), (x + 60, 0)]
    segments["stroke"] = numpy.repeat([0, 1, 2], 2)
    segments["colour"] = numpy.repeat([(1, 0, 0, 1), (0, 1, 0, 0.8), (0, 0, 1, 0.9)], 2, axis=0)
    segments["born"] = numpy.repeat([0.0, 0.5, 1.0], 2)
    strokes = suffuse.new_table("strokes", 3)
    strokes["id"] = [1, 2, 3]
    strokes["origin"] = [(0, 30), (0, 60), (0, 90)]
    canvas = suffuse.new_table("canvas", 1)
    canvas["width"], canvas["height"] = 160, 120
    return suffuse.Painting.from_tables(canvas=canvas, strokes=strokes, segments=segments)
