#!/usr/bin/python3
"""compare.py SUFFUSE-CLI FILE…: reads each file with the example reader and with `suffuse-cli convert`; exit 1 and the path
of the value where they differ. Exit 77 where a module of the reader is missing."""
import json
import os
import subprocess
import sys
import tempfile

try:
    import read_suffuse
except ImportError as problem:
    print(f"skipped: {problem}; install python3-cbor2 and python3-zstandard")
    sys.exit(77)

DEFAULTS = {"brush": "", "origin": [0, 0], "node": "smooth", "anisotropy": {"ratio": 1, "angle": 0}, "rewet": [],
            "start": False, "lift": False, "fade": False, "fill": None, "gradient": None,
            "grain": "tooth", "beta": 0, "seed": 1, "scale": 24, "strength": 0.5, "style": None,
            "text": None, "italic": False, "letterSpacing": 0, "vertical": False, "curve": [], "opacity": 1, "blend": "normal",
            "isolated": False, "clips": False, "mask": False, "wash": None, "solo": False, "tag": "none",
            "draft": False, "picture": None}

EXACT = (".id", ".parent", ".group", ".canvas.width", ".canvas.height", ".origin", ".area", ".born", ".rewet", ".size", ".place",
         ".curve")


def differs(ours, theirs, path):
    """The first value that differs, or None. Numbers are compared as what they round to: 64 bits in what EXACT names, else
    32."""
    if isinstance(ours, dict) and isinstance(theirs, dict):
        for key in sorted(ours.keys() | theirs.keys()):
            a, b = (side.get(key, DEFAULTS.get(key)) for side in (ours, theirs))
            if found := differs(a, b, f"{path}.{key}"):
                return found
        return None
    if isinstance(ours, list) and isinstance(theirs, list):
        if len(ours) != len(theirs):
            return f"{path}: {len(ours)} and {len(theirs)} values"
        return next(filter(None, (differs(a, b, f"{path}[{k}]") for k, (a, b) in enumerate(zip(ours, theirs)))), None)
    is_number = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in (ours, theirs))
    # These are in ".groups", which ".group" names, too.
    is_single = ".wash." in path or path.endswith((".weight", ".letterSpacing", ".lineHeight", ".opacity"))
    is_number = is_number and (is_single or not any(name in path for name in EXACT))
    if ours == theirs or (is_number and read_suffuse.single(ours) == read_suffuse.single(theirs)):
        return None
    return f"{path}: {ours!r} and {theirs!r}"


def main():
    for file in sys.argv[2:]:
        with tempfile.TemporaryDirectory() as folder, open(file, "rb") as data:
            text = os.path.join(folder, "a.json")
            with open(text, "wb") as out: # A copy elsewhere would name linked pictures as they are seen from there.
                subprocess.run([sys.argv[1], "convert", file, "-"], stdout=out, check=True)
            with open(text, encoding="utf-8") as theirs:
                found = differs(read_suffuse.read(data.read()), json.load(theirs), os.path.basename(file))
        if found:
            sys.exit(found)
    print(f"{len(sys.argv) - 2} files are read alike")


main()
