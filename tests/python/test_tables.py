"""Paintings as tables and back, and files."""

import copy
import json
import pathlib
import pickle
import tempfile
import unittest
import warnings

from support import SAMPLES, SOURCE, documents, quietly, run_cli, three_strokes

import numpy as np
import suffuse


def tables_of(painting):
    return {name: painting.table(name) for name in suffuse.table_names()}


class Tables(unittest.TestCase):
    def test_round_trip_is_exact(self):
        self.assertGreater(len(documents()), 10)
        for path in documents():
            painting = quietly(suffuse.open, path)
            again = suffuse.Painting.from_tables(**tables_of(painting), images=painting.images)
            self.assertEqual(again.hash, painting.hash, path)
            self.assertEqual(again, painting, path)

    def test_every_value_of_the_text_form_is_a_column(self):
        """What the text form has is in the tables, whatever comes to it."""
        parts = {"strokes": set(), "segments": set(), "fills": set(), "groups": set(), "canvas": set(), "swatches": set()}
        for path in documents():
            text = json.loads(quietly(suffuse.open, path).dumps("json"))
            parts["canvas"].update(text["canvas"])
            for name in ("groups", "swatches"):
                for value in text.get(name, []):
                    parts[name].update(value)
            for stroke in text["strokes"]:
                parts["strokes"].update(stroke)
                parts["fills"].update(stroke.get("fill", {}))
                for segment in stroke["segments"]:
                    parts["segments"].update(segment)
        tables = {"segments", "fill", "picture", "rewet", "text"}
        self.assertIn("lift", parts["segments"])
        for name, members in parts.items():
            columns = [column["name"] for column in suffuse.columns(name)]
            for member in members - tables:
                snake = "".join("_" + c.lower() if c.isupper() else c for c in member)
                known = [c for c in columns if c == snake or c.startswith(snake + "_")]
                self.assertTrue(known, (name, member, columns))

    def test_types_units_and_domains(self):
        segments = {column["name"]: column for column in suffuse.columns("segments")}
        self.assertEqual(segments["diffusion"]["unit"], "unit²/s")
        self.assertEqual(segments["diffusion"]["domain"], "(0, 1e12]")
        self.assertEqual(segments["born"]["unit"], "s")
        self.assertEqual(segments["bezier"]["shape"], (4, 2))
        self.assertEqual(segments["node"]["words"], "smooth, symmetric, corner")
        for name in suffuse.table_names():
            dtype = suffuse.new_table(name, 2).dtype
            self.assertEqual(dtype.names, tuple(column["name"] for column in suffuse.columns(name)))

    def test_moments_are_exact_to_the_microsecond(self):
        base = three_strokes()
        generator = np.random.default_rng(1)
        for limit in (10, 10**9, 10**15):
            microseconds = generator.integers(-limit, limit, len(base.segments))
            segments = base.segments.copy()
            segments["born"] = microseconds / 1e6
            born = base.replaced(segments=segments).segments["born"]
            self.assertTrue((np.rint(born * 1e6).astype(np.int64) == microseconds).all())
            self.assertEqual(base.replaced(segments=segments).replaced(segments={
                name: base.replaced(segments=segments).segments[name] for name in segments.dtype.names}),
                base.replaced(segments=segments))

    def test_texts_are_exact(self):
        base = three_strokes()
        strokes = suffuse.new_table("strokes", 3)
        names = np.array(["", "ä 湖 🎨", "\ud800 alone"])
        wide = {name: strokes[name] for name in strokes.dtype.names}
        wide.update(id=[1, 2, 3], name=names, brush=["x" * 100, "", "y"])
        painting = base.replaced(strokes=wide)
        self.assertEqual(list(painting.strokes["name"]), list(names))
        self.assertEqual(painting.strokes["brush"][0], "x" * 100)

    def test_columns_of_other_types_and_orders(self):
        painting = three_strokes()
        columns = {name: painting.segments[name] for name in reversed(painting.segments.dtype.names)}
        columns["bezier"] = np.asfortranarray(columns["bezier"].astype(np.float64))
        columns["stroke"] = columns["stroke"].astype(np.int16)
        columns["colour"] = np.repeat(columns["colour"], 2, axis=0)[::2]
        self.assertEqual(painting.replaced(segments=columns), painting)
        columns["node"] = ["smooth"] * 6
        columns["style_kind"] = np.zeros(6, int)
        self.assertEqual(painting.replaced(segments=columns), painting)
        for name, wrong in (("node", ["round"] * 6), ("style_kind", [-1] * 6), ("style_kind", [256] * 6)):
            with self.assertRaisesRegex(suffuse.DataError, f"segments.{name}: give"):
                painting.replaced(segments={**columns, name: wrong})
        del columns["granulation"]  # which is the default, 1
        self.assertEqual(painting.replaced(segments=columns), painting)

    def test_only_segments_make_strokes(self):
        segments = suffuse.new_table("segments", 2)
        segments["bezier"] = [(0, 0), (1, 0), (2, 0), (3, 0)]
        segments["stroke"] = [1, 0]
        painting = suffuse.Painting.from_tables(segments=segments)
        self.assertEqual(list(painting.strokes["id"]), [1, 2])
        self.assertEqual(painting.size, (1024, 768))

    def test_tables_are_shared_and_cannot_be_written(self):
        painting = three_strokes()
        self.assertIs(painting.segments, painting.segments)
        with self.assertRaises(ValueError):
            painting.segments["density"] = 1

    def test_what_is_wrong_is_named(self):
        painting = three_strokes()
        bad = painting.segments.copy()
        bad["diffusion"][3] = -1
        with self.assertRaisesRegex(suffuse.DataError, r"strokes\[1\]\.segments\[1\]\.diffusion: -1 is not in \(0, 1e12\]"):
            painting.replaced(segments=bad)
        for column, value in (("diffusion", np.nan), ("born", np.nan), ("born", np.inf), ("node", 9), ("bezier", np.inf)):
            bad = painting.segments.copy()
            bad[column][2] = value
            with self.assertRaises(ValueError, msg=column):
                painting.replaced(segments=bad)
        for row in (-1, 3, 2**62):
            bad = painting.segments.copy()
            bad["stroke"][0] = row
            with self.assertRaisesRegex(suffuse.DataError, r"segments\[0\]\.stroke: there is no row"):
                painting.replaced(segments=bad)
        with self.assertRaisesRegex(suffuse.DataError, "segments.wetness: there is no such column"):
            painting.replaced(segments={"wetness": [1]})
        with self.assertRaisesRegex(suffuse.DataError, "shape"):
            painting.replaced(segments={"bezier": np.zeros((6, 2, 4))})
        with self.assertRaisesRegex(suffuse.DataError, "give one of canvas, strokes"):
            painting.replaced(segment=bad)
        with self.assertRaises(TypeError):
            painting.replaced(segments={"stroke": np.array([0.5] * 6)})
        with self.assertRaises(suffuse.DataError):
            painting.table("nothing")

    def test_strokes_that_stay_are_shared(self):
        painting = three_strokes()
        segments = painting.segments.copy()
        segments["diffusion"][0] = 20
        difference = suffuse.diff(painting, painting.replaced(segments=segments))
        self.assertEqual([change["id"] for change in difference["changed"]], [1])
        self.assertEqual(difference["changed"][0]["values"],
                         [{"path": "segments[0].diffusion", "before": "12.5", "after": "20"}])
        self.assertFalse(difference["same"])
        self.assertTrue(suffuse.diff(painting, painting)["same"])


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def test_documents_are_what_the_command_line_writes(self):
        linked = SOURCE / "tests" / "fixtures" / "v3" / "pictures.suffuse"  # Its link is another one from elsewhere.
        for source in (SAMPLES / "still-life.suffuse", linked):
            painting = quietly(suffuse.open, source)
            for ending in ("suffuse", "json"):
                painting.save(self.path / f"a.{ending}")
                run_cli("convert", source, self.path / f"b.{ending}")
                self.assertEqual((self.path / f"a.{ending}").read_bytes(), (self.path / f"b.{ending}").read_bytes())
                self.assertEqual(quietly(suffuse.open, self.path / f"a.{ending}"), painting)
            self.assertEqual(quietly(suffuse.loads, painting.dumps("json")), painting)

    def test_drawings_are_what_the_command_line_writes(self):
        painting = three_strokes()
        painting.save(self.path / "in.suffuse")
        for ending, options, flags in (("svg", {}, []), ("svg", {"kind": "outlines", "time": 0.8}, ["--as", "outlines", "--time", "0.8"]),
                                       ("svgz", {"bands": 3}, ["--bands", "3"]), ("pdf", {"page": "A4"}, ["--page", "A4"])):
            painting.save(self.path / f"picture.{ending}", **options)
            bytes_here = (self.path / f"picture.{ending}").read_bytes()
            run_cli("convert", self.path / "in.suffuse", self.path / f"picture.{ending}", *flags)
            self.assertEqual(bytes_here, (self.path / f"picture.{ending}").read_bytes(), ending)

    def test_errors_are_those_of_the_command_line(self):
        (self.path / "rubbish.suffuse").write_bytes(b"rubbish")
        for name, error in (("missing.suffuse", OSError), ("rubbish.suffuse", ValueError), (".", OSError)):
            with self.assertRaises(error) as raised:
                suffuse.open(self.path / name)
            self.assertIsInstance(raised.exception, suffuse.Error)
            _, said = run_cli("info", self.path / name, code=1)
            self.assertEqual(said, f"suffuse-cli: {raised.exception}\n")
        with self.assertRaisesRegex(suffuse.DataError, "unknown ending; use .suffuse, .json, .svg, .svgz or .pdf"):
            three_strokes().save(self.path / "a.png")
        with self.assertRaises(suffuse.FileError):
            three_strokes().save(self.path / "no folder" / "a.suffuse")
        with self.assertRaisesRegex(suffuse.DataError, "bands 0"):
            three_strokes().dumps("svg", bands=0)

    def test_what_is_left_out_is_told(self):
        drawing = b'<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90"><path d="M0 0L50 50" stroke="red"/>'
        drawing += b'<image width="10" height="10"/></svg>'
        (self.path / "a.svg").write_bytes(drawing)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            painting = suffuse.open(self.path / "a.svg")
        self.assertEqual(len(painting), 1)
        self.assertEqual([w.category for w in told], [suffuse.LeftOutWarning])
        _, said = run_cli("convert", self.path / "a.svg", self.path / "b.json")
        self.assertEqual(said, f"suffuse-cli: {told[0].message}\n")
        self.assertNotIn("(s)", said)

    def test_damaged_documents_are_refused_or_salvaged(self):
        whole = (SAMPLES / "still-life.suffuse").read_bytes()
        damaged = bytearray(whole)
        damaged[len(whole) // 2] ^= 0xFF
        with self.assertRaisesRegex(suffuse.DataError, "is damaged; salvage=True"):
            suffuse.loads(bytes(damaged))
        with self.assertWarns(suffuse.LeftOutWarning):
            part = suffuse.loads(bytes(damaged), salvage=True)
        self.assertLessEqual(len(part), len(suffuse.loads(whole)))

    def test_what_lies_beside_the_picture_is_kept(self):
        source = SOURCE / "tests" / "fixtures" / "v1" / "extras.suffuse"
        painting = suffuse.open(source)
        painting.save(self.path / "a.suffuse")
        run_cli("convert", source, self.path / "b.suffuse")
        self.assertEqual((self.path / "a.suffuse").read_bytes(), (self.path / "b.suffuse").read_bytes())
        self.assertLess(len(painting.without_extras().dumps()), len(painting.dumps()))
        document = suffuse.Document(painting)
        self.assertEqual(document.painting.dumps(), painting.dumps())
        document.select_all()
        self.assertTrue(document.change_strokes(name="new"))
        changed = document.painting.dumps()  # Preview and history are of another picture now.
        self.assertNotEqual(changed, document.painting.without_extras().dumps())
        self.assertLess(len(changed), len(painting.dumps()))

    def test_values(self):
        painting = three_strokes()
        self.assertEqual(len(painting), 3)
        self.assertEqual(painting.segment_count, 6)
        self.assertEqual(painting.size, (160, 120))
        self.assertEqual(painting.begin, 0)
        self.assertEqual(painting.end, 2)
        self.assertEqual(pickle.loads(pickle.dumps(painting)), painting)
        self.assertEqual(copy.deepcopy(painting), painting)
        self.assertEqual(len({painting, pickle.loads(pickle.dumps(painting))}), 1)
        self.assertEqual(suffuse.Painting(30, 20).size, (30, 20))
        with self.assertRaises(suffuse.DataError):
            suffuse.Painting(-1, 20)


if __name__ == "__main__":
    unittest.main()
