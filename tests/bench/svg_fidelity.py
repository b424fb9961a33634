#!/usr/bin/env python3
"""How near imported SVG drawings come to librsvg's pictures of them.

    svg_fidelity.py SUFFUSE_CLI FOLDER [--worst N]

Each drawing of the folder is drawn 500 pixels wide by both programs, over white. A drawing counts as the same where the
mean difference of each channel is at most 1/64. Prints the share of those, and the worst ones. Needs rsvg-convert
(librsvg2-bin) and ImageMagick's convert.
"""
import argparse
import pathlib
import subprocess
import tempfile


def pixels(path):
    """Width, height and the bytes of an image over white, three a pixel."""
    size = subprocess.run(["identify", "-format", "%w %h", path], capture_output=True, text=True, check=True).stdout
    raw = subprocess.run(["convert", path, "-background", "white", "-alpha", "remove", "-depth", "8", "rgb:-"],
                         capture_output=True, check=True).stdout
    width, height = map(int, size.split()[:2])
    return width, height, raw


def difference(cli, drawing, folder):
    """The greatest of the channels' mean differences, or why there is none."""
    ours, theirs = str(folder / "ours.png"), str(folder / "theirs.png")
    subprocess.run(["rsvg-convert", "-w", "500", "-o", theirs, drawing], check=True, capture_output=True)
    made = subprocess.run([cli, "render", drawing, "-o", ours, "--size", "500", "--backend", "cpu"],
                          capture_output=True, text=True)
    width, height, wanted = pixels(theirs)
    if made.returncode != 0: # nothing to paint: an empty sheet
        return sum(255 - v for v in wanted) / max(len(wanted), 1) / 255, made.stderr.strip()[-80:]
    w, h, got = pixels(ours)
    if (w, h) != (width, height):
        return 1, f"{w}x{h} instead of {width}x{height}"
    return max(sum(abs(a - b) for a, b in zip(got[c::3], wanted[c::3])) / (w * h) / 255 for c in range(3)), ""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cli")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--worst", type=int, default=10)
    options = parser.parse_args()
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for drawing in sorted(options.folder.glob("*.svg")):
            try:
                results.append((*difference(options.cli, str(drawing), pathlib.Path(folder)), drawing.name))
            except subprocess.CalledProcessError as error:
                print(f"{drawing.name}: {error.stderr.strip()[-100:] if error.stderr else error}")
    same = sum(d <= 1 / 64 for d, _, _ in results)
    print(f"{same} of {len(results)} drawings within 1/64: {100 * same / max(len(results), 1):.0f} %")
    for d, why, name in sorted(results, reverse=True)[:options.worst]:
        print(f"{d:.4f} {name} {why}")


if __name__ == "__main__":
    main()
