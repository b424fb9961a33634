"""The extensions that come along, run as people run them."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from support import SAMPLES, SOURCE, places, run_cli, text_along_a_wave

import numpy as np
import suffuse

CLI = os.environ["SUFFUSE_CLI"]


def area_painting():
    """A filled square with a hole, an open line above it, and a closed ring that is not filled, in a group."""

    def ring(corners, start):
        rows = suffuse.new_table("segments", len(corners))
        for k, corner in enumerate(corners):
            a, b = np.array(corner, float), np.array(corners[(k + 1) % len(corners)], float)
            rows["bezier"][k] = [a, a + (b - a) / 3, b - (b - a) / 3, b]
        rows["start"][0] = start
        return rows

    square = ring([(20, 20), (180, 20), (180, 180), (20, 180)], False)
    hole = ring([(80, 80), (120, 80), (120, 120), (80, 120)], True)
    line = suffuse.new_table("segments", 1)
    line["bezier"][0] = [(10, 10), (60, 10), (120, 10), (190, 10)]
    line["stroke"] = 1
    other = ring([(220, 60), (280, 60), (250, 120)], False)
    other["stroke"] = 2
    segments = np.concatenate([square, hole, line, other])
    segments["colour"] = (0.9, 0.4, 0.1, 0.9)
    segments["colour"][-3:] = (0.1, 0.2, 0.8, 1)
    strokes = suffuse.new_table("strokes", 3)
    strokes["id"] = [1, 2, 3]
    strokes["group"] = [0, 0, 5]
    groups = suffuse.new_table("groups", 1)
    groups["id"] = 5
    fills = suffuse.new_table("fills", 1)
    fills["stroke"] = 0
    fills["diffusion"], fills["density"], fills["colour"] = 20, 1, (0.9, 0.4, 0.1, 0.9)
    fills["rule"] = 1  # even-odd, so that the hole is one whatever its direction
    return suffuse.Painting.from_tables(
        canvas={"width": [300.0], "height": [200.0]}, strokes=strokes, segments=segments, fills=fills, groups=groups
    )


class Extensions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.painting = area_painting()
        cls.painting.save(cls.path("in.suffuse"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return str(pathlib.Path(cls.folder.name) / name)

    def run_it(self, id, *options, out=True, source=None):
        """Runs an extension; returns the painting, or what it printed."""
        arguments = [CLI, "extension", "run", id, source or self.path("in.suffuse"), *options]
        ran = subprocess.run(arguments + (["-o", self.path("out.suffuse")] if out else []), capture_output=True, text=True)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        return suffuse.open(self.path("out.suffuse")) if out else ran.stdout

    def refused(self, id, *options):
        ran = subprocess.run(
            [CLI, "extension", "run", id, self.path("in.suffuse"), "-o", self.path("no.suffuse"), *options],
            capture_output=True,
            text=True,
        )
        self.assertEqual(ran.returncode, 1)
        self.assertFalse(os.path.exists(self.path("no.suffuse")))
        return ran.stderr

    def test_jitter(self):
        values = ["--set", "bend=2"]
        once, again = self.run_it("jitter", *values), self.run_it("jitter", *values)
        self.assertEqual(once, again)
        self.assertNotEqual(once, self.run_it("jitter", *values, "--set", "seed=2"))
        self.assertEqual(list(once.strokes["id"]), [1, 2, 3])
        self.assertFalse(np.array_equal(once.segments["density"], self.painting.segments["density"]))
        moved = np.abs(once.segments["bezier"] + once.strokes["origin"][once.segments["stroke"]][:, None]
                       - self.painting.segments["bezier"])
        self.assertGreater(moved.max(), 1)
        self.assertLess(moved.max(), 100)
        # What was closed is closed, and each chain is whole: otherwise it could not have been read.
        curves = once.segments["bezier"]
        for begin, end in ((0, 3), (4, 7), (9, 11)):
            np.testing.assert_array_equal(curves[begin, 0], curves[end, 3])

    def test_jitter_of_nothing_changes_nothing(self):
        nothing = [f"{name}=0" for name in ("move", "bend", "turn", "size", "density", "diffusion")]
        still = self.run_it("jitter", *sum((["--set", each] for each in nothing), []))
        np.testing.assert_allclose(still.segments["bezier"], self.painting.segments["bezier"], atol=1e-4)
        np.testing.assert_array_equal(still.segments["density"], self.painting.segments["density"])

    def test_jitter_keeps_to_the_selection(self):
        one = self.run_it("jitter", "--select", "2")
        rows = self.painting.segments["stroke"] != 1
        np.testing.assert_array_equal(one.segments[rows], self.painting.segments[rows])
        self.assertNotEqual(one, self.painting)

    def test_hatch(self):
        hatched = self.run_it("hatch", "--select", "1,2", "--set", "gap=10", "--set", "angle=0", "--set", "ragged=0",
                              "--set", "wobble=0")
        new = [row for row, id in enumerate(hatched.strokes["id"]) if id > 3]
        # Sixteen lines, of which four are in two parts for the hole; the line is open and stays as it is.
        self.assertEqual(len(new), 20)
        self.assertEqual(len({int(hatched.strokes["group"][row]) for row in new}), 1)
        self.assertEqual(new, list(range(1, 21)))  # just above the area
        segments = hatched.segments[np.isin(hatched.segments["stroke"], new)]
        points = segments["bezier"] + hatched.strokes["origin"][segments["stroke"]][:, None]
        self.assertTrue(((points > 19.9) & (points < 180.1)).all())
        inside_hole = ((points > 80.5) & (points < 119.5)).all(axis=2)
        self.assertFalse(inside_hole.any())
        self.assertGreater(segments["born"].min(), 0)
        crossed = self.run_it("hatch", "--select", "1", "--set", "cross=true")
        self.assertGreater(len(crossed), len(self.run_it("hatch", "--select", "1")))
        replaced = self.run_it("hatch", "--select", "1", "--set", "replace=true")
        self.assertNotIn(1, replaced.strokes["id"])

    def test_hatch_keeps_groups_together(self):
        hatched = self.run_it("hatch", "--select", "3", "--set", "paint=chosen")
        groups = {int(group["id"]): int(group["parent"]) for group in hatched.groups}
        new = [int(group) for id, group in zip(hatched.strokes["id"], hatched.strokes["group"]) if id > 3]
        self.assertTrue(new)
        self.assertTrue(all(groups[group] == 5 for group in new))

    def test_hatch_says_what_it_needs(self):
        self.assertIn("None of the selected strokes is filled or closed", self.refused("hatch", "--select", "2"))

    def test_kaleidoscope(self):
        for kind, copies in (("both", 4), ("kaleidoscope", 5)):
            made = self.run_it("kaleidoscope", "--set", f"kind={kind}", "--set", "copies=5")
            self.assertEqual(len(made), copies * 3, kind)
        mirrored = self.run_it("kaleidoscope", "--set", "kind=across")
        picture, before = suffuse.render(mirrored), suffuse.render(self.painting)

        def lopsided(pixels):
            return np.abs(pixels.astype(int) - pixels[:, ::-1]).mean()

        self.assertLess(lopsided(picture), 0.5 * lopsided(before))  # what lies above differs still
        one = self.run_it("kaleidoscope", "--select", "2", "--set", "kind=down", "--set", "delay=2")
        self.assertEqual(len(one), 4)
        self.assertEqual(one.segments["born"].max(), self.painting.segments["born"].max() + 2)

    def test_recolour(self):
        for by in ("lightness", "nearest"):
            sea = self.run_it("recolour-palette", "--set", "palette=sea", "--set", f"by={by}")
            np.testing.assert_array_equal(sea.segments["colour"][:, 3], self.painting.segments["colour"][:, 3])
            np.testing.assert_array_equal(sea.segments["bezier"], self.painting.segments["bezier"])
            self.assertLess(sea.segments["colour"][0, 0], sea.segments["colour"][0, 2])  # no orange is left
        same = self.run_it("recolour-palette", "--set", "strength=0")
        np.testing.assert_allclose(same.segments["colour"], self.painting.segments["colour"], atol=1e-3)
        self.assertIn("fewer than two swatches", self.refused("recolour-palette", "--set", "palette=swatches"))

    def test_contact_sheet(self):
        for shows, pictures in (("moments", 6), ("growing", 2)):
            said = self.run_it("contact-sheet", "--set", f"file={self.path('sheet.png')}", "--set", f"shows={shows}",
                               "--set", "count=6", "--set", "columns=3", "--set", "width=60", "--set", "gap=10", out=False)
            self.assertTrue(said.startswith(f"{pictures} pictures"), said)
            page = suffuse.read_picture(self.path("sheet.png"))
            columns = min(3, pictures)
            self.assertEqual(page.shape[:2], (10 + 50 * -(-pictures // columns), 10 + 70 * columns))
            self.assertTrue((page[:10] == page[0, 0]).all())
            self.assertFalse((page[10:50] == page[0, 0]).all())
        # The last moment is the painting as it is now.
        alone = suffuse.render(self.painting, size=60, backend="cpu")
        self.run_it("contact-sheet", "--set", f"file={self.path('sheet.png')}", "--set", "count=2", "--set", "columns=2",
                    "--set", "width=60", "--set", "gap=10", out=False)
        page = suffuse.read_picture(self.path("sheet.png"))
        np.testing.assert_array_equal(page[10:50, 80:140, :3], alone)

    def test_command_line(self):
        listed = json.loads(run_cli("extension", "list", "--json")[0])
        by_id = {each["id"]: each for each in listed["extensions"]}
        self.assertEqual(set(by_id), {"jitter", "hatch", "kaleidoscope", "recolour-palette", "contact-sheet"})
        self.assertEqual(by_id["hatch"]["fields"][0]["choices"][0], "pencil")
        self.assertIn("gap=7", run_cli("extension", "list")[0])
        source, out = self.path("in.suffuse"), self.path("no.json")
        for arguments, code, says in (
            ((), 2, "Usage"),
            (("paint",), 2, "there is no such command"),
            (("run", "no-such", source, "-o", out), 1, "there is no such extension"),
            (("run", "jitter", source), 2, "-o OUT is missing"),
            (("run", "jitter", source, "-o", self.path("no.png")), 2, "end the name with .suffuse or .json"),
            (("run", "jitter", source, "-o", source), 1, "would be lost"),
            (("run", "jitter", source, "-o", out, "--set", "move=far"), 2, "“far” is no number"),
            (("run", "jitter", source, "-o", out, "--set", "speed=1"), 2, "one of the fields move, bend"),
            (("run", "jitter", source, "-o", out, "--set", "move=-1"), 2, "-1 is not in [0, 1000]"),
            (("run", "jitter", source, "-o", out, "--select", "99"), 2, "there is no stroke 99"),
            (("run", "contact-sheet", source, "-o", out), 2, "makes no painting"),
            (("run", "contact-sheet", source), 2, "choose a file; give it by --set"),
        ):
            self.assertIn(says, run_cli("extension", *arguments, code=code)[1])
            self.assertFalse(os.path.exists(out))

    def test_examples_of_the_docs(self):
        """The manifest and the programs of docs/extensions.md, in the shell and in Python."""
        text = (SOURCE / "docs/extensions.md").read_text("utf-8")
        manifest = json.loads(re.search(r"```json\n(.*?)```", text, re.S).group(1))
        programs = {kind: re.search(rf"```{kind}\n(.*?)```", text, re.S).group(1) for kind in ("sh", "python")}
        changed = json.loads("{" + re.search(r"In the manifest, `(.*?)`", text, re.S).group(1) + "}")
        for name, kind, members in (("denser.sh", "sh", {}), ("denser.py", "python", changed)):
            folder = pathlib.Path(self.path(kind))
            folder.mkdir()
            (folder / "manifest.json").write_text(json.dumps(manifest | members), "utf-8")
            (folder / name).write_text(programs[kind], "utf-8")
            denser = self.run_it(str(folder), "--set", "density=12")
            self.assertTrue((denser.segments["density"] == 12).all())

    def test_texts_follow_what_extensions_change(self):
        before = text_along_a_wave(self.folder.name)
        if before is None:
            self.skipTest("there are no fonts")
        before.save(self.path("along.suffuse"))
        bent = text_along_a_wave(self.folder.name, bend=40)
        folder = pathlib.Path(self.path("bend"))
        folder.mkdir()
        manifest = {"format": "suffuse-extension", "version": 1, "id": "bend", "name": "Bend", "form": "suffuse",
                    "run": ["{python3}", "-B", "{folder}/bend.py"]}
        (folder / "manifest.json").write_text(json.dumps(manifest), "utf-8")
        (folder / "bend.py").write_text(
            "from suffuse import extension\n"
            "job = extension.job()\n"
            "segments = job.painting.segments.copy()\n"
            f"segments['bezier'][0] = {bent.segments['bezier'][0].tolist()}\n"
            "job.write(job.painting.replaced(segments=segments))\n",
            "utf-8",
        )
        after = self.run_it(str(folder), source=self.path("along.suffuse"))
        self.assertGreater(np.abs(places(after) - places(before)).max(), 10)
        np.testing.assert_allclose(places(after), places(bent), atol=2e-3)

    def test_a_real_painting(self):
        source = str(SAMPLES / "still-life.suffuse")
        self.assertNotEqual(self.run_it("jitter", source=source), suffuse.open(source).without_extras())


if __name__ == "__main__":
    unittest.main()
