#!/usr/bin/env python3
"""Deals the strokes of a painting into layers, for benches.

    deal_layers.py IN.json OUT.json [--layers 20] [--plain]

IN.json is a painting in the text form (suffuse-cli convert). Its strokes go, in their order, into as many groups, each of
which blends in another way: every third is half transparent, and the modes of W3C Compositing come by turns. With --plain
the groups are the same, but strokes pass through them."""
import argparse
import json

MODES = ["normal", "multiply", "screen", "overlay", "darken", "lighten", "hard-light", "soft-light", "difference",
         "exclusion", "hue", "saturation", "color", "luminosity", "color-dodge", "color-burn"]

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("source")
parser.add_argument("target")
parser.add_argument("--layers", type=int, default=20)
parser.add_argument("--plain", action="store_true")
options = parser.parse_args()
with open(options.source) as file:
    painting = json.load(file)
strokes = painting["strokes"]
painting["groups"] = []
for i in range(options.layers):
    group = {"id": i + 1, "name": f"Layer {i + 1}"}
    if not options.plain:
        group |= {"isolated": True, "blend": MODES[i % len(MODES)], "opacity": 0.5 if i % 3 == 2 else 1}
    painting["groups"].append(group)
for k, stroke in enumerate(strokes):
    stroke["group"] = k * options.layers // len(strokes) + 1
painting["version"] = 3
with open(options.target, "w") as file:
    json.dump(painting, file)
