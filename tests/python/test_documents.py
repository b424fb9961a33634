"""Edits and their undo steps."""

import concurrent.futures
import os
import random
import subprocess
import sys
import tempfile
import unittest

from support import SAMPLES, places, text_along_a_wave, three_strokes

import numpy as np
import suffuse


class Documents(unittest.TestCase):
    def setUp(self):
        self.painting = three_strokes()
        self.document = suffuse.Document(self.painting)

    def check(self, changed):
        """The edit changed something, and is undone and done again exactly."""
        self.assertTrue(changed)
        after = self.document.painting
        self.assertNotEqual(after, self.painting)
        self.assertTrue(self.document.undo())
        self.assertEqual(self.document.painting.hash, self.painting.hash)
        self.assertTrue(self.document.redo())
        self.assertEqual(self.document.painting.hash, after.hash)
        return after

    def test_values_of_segments(self):
        self.document.select([2])
        after = self.check(self.document.change_segments(diffusion=30, colour=(0.5, 0.25, 0, 1), style_kind=1, has_style=True,
                                                         style_xi=(1, 2, 0)))
        self.assertEqual(list(after.segments["diffusion"]), [12.5, 12.5, 30, 30, 12.5, 12.5])
        self.assertEqual(self.document.steps, ("Change Segments",))
        self.document.select(segments=[(1, 1)])
        self.assertEqual(self.document.selected_strokes, [1])
        self.assertTrue(self.document.change_segments(density=3))
        self.assertEqual(list(self.document.painting.segments["density"]), [9, 3, 9, 9, 9, 9])
        self.assertFalse(self.document.change_segments(density=3))
        self.assertEqual(self.document.done, 2)

    def test_values_that_cannot_be(self):
        self.document.select_all()
        with self.assertRaisesRegex(suffuse.DataError, r"diffusion: -1 is not in \(0, 1e12\]"):
            self.document.change_segments(diffusion=-1)
        with self.assertRaisesRegex(suffuse.DataError, "no such column"):
            self.document.change_segments(wetness=1)
        with self.assertRaises(ValueError):
            self.document.change_segments(colour=(1, 2))
        with self.assertRaisesRegex(suffuse.DataError, "use group"):
            self.document.change_strokes(group=3)
        with self.assertRaisesRegex(suffuse.DataError, "give one of raise, lower"):
            self.document.arrange("sideways")
        self.assertEqual(self.document.steps, ())
        self.assertEqual(self.document.painting, self.painting)

    def test_strokes_and_canvas(self):
        self.document.select([1, 3])
        after = self.check(self.document.change_strokes(name="sky", mix_mode="beta", mix_beta=0.5))
        self.assertEqual(list(after.strokes["name"]), ["sky", "", "sky"])
        self.assertTrue(self.document.change_canvas(width=200, background=(0, 0.1, 0, 1)))
        self.assertEqual(self.document.painting.size, (200, 120))
        with self.assertRaises(suffuse.DataError):
            self.document.change_canvas(height=-1)

    def test_fills(self):
        self.document.select([1])
        self.check(self.document.fill())
        self.assertEqual(list(self.document.painting.fills["stroke"]), [0])
        self.assertTrue(self.document.change_fills(density=2))
        self.assertEqual(self.document.painting.fills["density"][0], 2)
        with self.assertRaises(suffuse.DataError):
            self.document.change_fills(density=-1)
        self.assertTrue(self.document.unfill())
        with self.assertRaisesRegex(suffuse.DataError, "too few areas"):
            self.document.combine_areas("union")

    def test_groups(self):
        self.document.select([1, 2])
        self.check(self.document.group("layer"))
        group = int(self.document.painting.groups["id"][0])
        self.assertTrue(self.document.change_groups([group], opacity=0.5, blend=1))
        self.assertTrue(self.document.set_group(group, name="water", visible=False))
        row = self.document.painting.groups[0]
        self.assertEqual((row["name"], row["opacity"], row["blend"], row["visible"]), ("water", 0.5, 1, False))
        self.assertEqual(self.document.steps, ("Group", "Change Groups", "Change Group"))
        with self.assertRaises(suffuse.DataError):
            self.document.change_groups([group], opacity=2)
        self.assertTrue(self.document.show_all())
        self.document.select([1, 2])
        self.assertTrue(self.document.ungroup())
        self.assertEqual(len(self.document.painting.groups), 0)

    def test_order_and_copies(self):
        self.document.select([1])
        after = self.check(self.document.arrange("top"))
        self.assertEqual(list(after.strokes["id"]), [2, 3, 1])
        self.assertTrue(self.document.reorder(before=3, strokes=[1]))
        self.assertEqual(list(self.document.painting.strokes["id"]), [2, 1, 3])
        self.assertTrue(self.document.duplicate(5, 6))
        self.assertEqual(len(self.document.painting), 4)
        self.assertTrue(self.document.delete())
        self.assertTrue(self.document.add(self.painting))
        self.assertEqual(self.document.selected_strokes, [5, 6, 7])

    def test_curves(self):
        self.document.select([1])
        after = self.check(self.document.transform((2, 0, 0, 2, 10, 20)))
        self.assertEqual(after.segments["diffusion"][0], 50)
        self.assertEqual(after.strokes["origin"][0].tolist(), [10, 80])
        self.assertTrue(self.document.reverse())
        self.assertTrue(self.document.smooth(20))
        self.assertTrue(self.document.erase([(60, 0), (60, 120)], 6))
        self.assertTrue(self.document.break_apart())
        self.document.select([2, 3])
        self.assertTrue(self.document.align("left", "canvas"))
        self.assertTrue(self.document.join())

    def test_colours(self):
        asked = []

        def greyed(colour):
            asked.append(colour)
            mean = sum(colour[:3]) / 3
            return mean, mean, mean, colour[3]

        after = self.check(self.document.recolour(greyed))
        self.assertEqual(len(asked), 3)
        np.testing.assert_allclose(after.segments["colour"][:, :3], 1 / 3)
        with self.assertRaises(ZeroDivisionError):
            self.document.recolour(lambda colour: 1 / 0)
        with self.assertRaises(suffuse.DataError):
            self.document.recolour(lambda colour: (2, 0, 0, 1))
        self.document.select_all()
        self.assertTrue(self.document.apply_brush(suffuse.brushes()[0]))
        with self.assertRaisesRegex(suffuse.DataError, "no such brush"):
            self.document.apply_brush("broom")

    def test_times(self):
        self.document.select([2])
        after = self.check(self.document.retime(2.5))
        self.assertEqual(after.segments["born"][2], 3)
        self.assertTrue(self.document.stretch(0, 4))
        self.assertEqual(self.document.painting.segments["born"][2:4].tolist(), [0, 4])
        self.assertTrue(self.document.rewet(4.5, 2))
        self.assertEqual(len(self.document.painting.rewets), 2)
        self.assertTrue(self.document.remove_rewetting())
        self.assertTrue(self.document.freeze(4.25))

    def test_any_painting_is_a_step(self):
        other = suffuse.open(SAMPLES / "still-life.suffuse")
        self.check(self.document.apply(other, "Everything New"))
        self.assertEqual(self.document.painting, other)
        self.assertEqual(self.document.steps, ("Everything New",))
        self.assertFalse(self.document.apply(other))

    def test_several_edits_are_one_step(self):
        self.document.select_all()
        with self.document.step("Restyle") as document:
            document.change_segments(diffusion=20)
            with document.step("inner"):
                document.change_segments(density=5)
            document.duplicate()
            document.delete()
            self.assertFalse(document.undo())
        self.assertEqual(self.document.steps, ("Restyle",))
        self.check(True)
        self.document.undo()
        with self.assertRaises(KeyError):
            with self.document.step("fails"):
                self.document.change_segments(diffusion=20)
                raise KeyError
        self.assertEqual(self.document.painting, self.painting)
        with self.document.step("nothing"):
            pass
        self.assertEqual(self.document.done, 0)

    def test_random_walk(self):
        """Undoing all leads to the start, redoing all to the end."""
        generator = random.Random(7)
        document = self.document
        edits = [
            lambda: document.change_segments(density=generator.uniform(1, 20)),
            lambda: document.transform((1, 0.1, 0, 1, generator.uniform(-9, 9), 3)),
            lambda: document.duplicate(3, 1), lambda: document.delete(), lambda: document.arrange("lower"),
            lambda: document.group(), lambda: document.ungroup(), lambda: document.fill(), lambda: document.retime(0.1),
            lambda: document.simplify(5, 1), lambda: document.undo(), lambda: document.redo(),
            lambda: document.add(self.painting, False),
        ]
        for _ in range(120):
            ids = self.document.painting.strokes["id"]
            document.select([int(i) for i in ids if generator.random() < 0.5])
            generator.choice(edits)()
        end = document.painting.hash
        while document.undo():
            pass
        self.assertEqual(document.painting.hash, self.painting.hash)
        steps = 0
        while document.redo():
            steps += 1
        self.assertEqual(steps, len(document.steps))
        while document.done > 0:
            document.undo()
        self.assertNotEqual(end, "")

    def test_threads_share_a_document(self):
        self.document.select_all()

        def work(k):
            return self.document.change_segments(density=1 + k)

        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertTrue(all(pool.map(work, range(20))))
        self.assertEqual(len(self.document.steps), 20)
        while self.document.undo():
            pass
        self.assertEqual(self.document.painting, self.painting)

    def test_a_step_belongs_to_its_thread(self):
        self.document.select_all()

        def elsewhere(act):
            with concurrent.futures.ThreadPoolExecutor(1) as pool:
                return pool.submit(act).result()

        acts = [lambda: self.document.change_segments(density=9), self.document.undo, self.document.redo,
                lambda: self.document.begin_step("Other"), self.document.end_step, self.document.select_all]
        with self.document.step("Mine"):
            self.assertTrue(self.document.change_segments(density=2))
            for act in acts:
                with self.assertRaisesRegex(RuntimeError, "another thread"):
                    elsewhere(act)
            self.assertEqual(elsewhere(lambda: self.document.steps), ("Mine",))  # Looking is no harm.
            self.assertTrue(self.document.change_segments(density=3))
        self.assertEqual(self.document.steps, ("Mine",))
        self.assertTrue(elsewhere(acts[0]))
        self.assertEqual(len(self.document.steps), 2)
        self.assertTrue(self.document.undo() and self.document.undo())
        self.assertEqual(self.document.painting, self.painting)


class FollowedTexts(unittest.TestCase):
    """What changes a stroke sets the text along it anew, in the same step."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.painting = text_along_a_wave(self.folder.name)
        if self.painting is None:
            self.skipTest("there are no fonts")
        self.document = suffuse.Document(self.painting)

    def check(self, expected):
        """The painting is as a drawing of it has it; undo leads back, and redo here."""
        now = self.document.painting
        self.assertEqual(len(self.document.steps), 1)
        np.testing.assert_allclose(places(now), places(expected), atol=2e-3)
        np.testing.assert_allclose(now.text_curves["bezier"], expected.text_curves["bezier"], atol=2e-3)
        self.assertEqual(list(now.texts["follows"]), [1])
        self.assertTrue(self.document.undo())
        self.assertEqual(self.document.painting, self.painting)
        self.assertTrue(self.document.redo())
        self.assertEqual(self.document.painting, now)

    def test_moved(self):
        self.document.select([1])
        self.assertTrue(self.document.transform((1, 0, 0, 1, 35, 0)))
        self.check(text_along_a_wave(self.folder.name, move=35))

    def test_reshaped(self):
        bent = text_along_a_wave(self.folder.name, bend=40)
        segments = self.painting.segments.copy()
        segments["bezier"][0] = bent.segments["bezier"][0]
        self.assertTrue(self.document.apply(self.painting.replaced(segments=segments)))
        self.check(bent)

    def test_within_a_step_and_by_threads(self):
        bent = text_along_a_wave(self.folder.name, bend=40)
        with self.document.step("both"):
            self.document.select([1])
            self.document.transform((1, 0, 0, 1, 35, 0))
            self.document.transform((1, 0, 0, 1, -35, 0))
            segments = self.document.painting.segments.copy()
            segments["bezier"][0] = bent.segments["bezier"][0]
            with concurrent.futures.ThreadPoolExecutor(4) as pool:  # Others set texts of their own meanwhile.
                others = [pool.submit(self.moved) for _ in range(8)]
                self.document.apply(self.document.painting.replaced(segments=segments))
                for other in others:
                    np.testing.assert_array_equal(other.result(), others[0].result())
        self.check(bent)

    def moved(self):
        document = suffuse.Document(self.painting)
        document.select([1])
        document.transform((1, 0, 0, 1, 0, 12))
        return places(document.painting)

    def test_deleted(self):
        self.document.select([1])
        self.assertTrue(self.document.delete())
        now = self.document.painting
        self.assertEqual(list(now.texts["follows"]), [0])
        np.testing.assert_array_equal(places(now), places(self.painting)[self.painting.segments["stroke"] > 0])

    def test_the_process_stays_what_it_was(self):
        """Neither the language of numbers nor the environment of programs that it starts becomes another one."""
        program = (
            "import locale, os, sys, suffuse\n"
            "locale.setlocale(locale.LC_ALL, 'C')\n"
            "before = locale.setlocale(locale.LC_ALL), dict(os.environ)\n"
            "document = suffuse.Document(suffuse.open(sys.argv[1]))\n"
            "document.select([1])\n"
            "before_it = document.painting.strokes['origin'][1] + document.painting.segments['bezier'][1, 0]\n"
            "document.transform((1, 0, 0, 1, 0, 12))\n"
            "now = document.painting.strokes['origin'][1] + document.painting.segments['bezier'][1, 0]\n"
            "assert abs(now - before_it - (0, 12)).max() < 1e-3\n"
            "assert before == (locale.setlocale(locale.LC_ALL), dict(os.environ))\n"
            "import ctypes; get = ctypes.CDLL(None).getenv; get.restype = ctypes.c_char_p\n"
            "assert get(b'QT_QPA_PLATFORM') is None\n"
        )
        source = os.path.join(self.folder.name, "wave.suffuse")
        environment = {name: value for name, value in os.environ.items() if name != "QT_QPA_PLATFORM"}
        done = subprocess.run([sys.executable, "-c", program, source], capture_output=True, text=True, env=environment)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
