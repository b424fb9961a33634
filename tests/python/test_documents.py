"""Edits and their undo steps."""

import concurrent.futures
import random
import unittest

from support import SAMPLES, three_strokes

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


if __name__ == "__main__":
    unittest.main()
