"""Probe, density, gradient and fit."""

import json
import pathlib
import tempfile
import unittest

from support import SAMPLES, run_cli, three_strokes

import numpy as np
import suffuse


class Points(unittest.TestCase):
    def test_probe_is_the_command_line_s(self):
        source = SAMPLES / "still-life.suffuse"
        painting = suffuse.open(source)
        for place, moment in (((512, 384), None), ((100.5, 200.25), 2.0)):
            flags = [] if moment is None else ["--time", moment]
            said = json.loads(run_cli("probe", source, *place, "--json", "--all", *flags)[0])
            found = suffuse.probe(painting, *place, time=moment)

            def compare(a, b, path):
                if isinstance(b, dict):
                    for name, value in b.items():
                        if name == "segmentsLeftOut":
                            continue
                        snake = "".join("_" + c.lower() if c.isupper() else c for c in name)
                        compare(a[snake], value, f"{path}.{name}")
                elif isinstance(b, list):
                    self.assertEqual(len(a), len(b), path)
                    for i, value in enumerate(b):
                        compare(a[i], value, f"{path}[{i}]")
                else:
                    self.assertEqual(a, b, path)

            compare(found, said, "")
            self.assertTrue(found["strokes"] or moment)

    def test_density_is_near_the_probe_s(self):
        painting = three_strokes()
        for stroke in (1, 2, 3):
            for moment in (0.75, 1.5, None):
                for place in ((60.0, 30.0), (100.0, 62.0), (20.0, 95.0)):
                    exact = [s["density"] for s in suffuse.probe(painting, *place, time=moment)["strokes"] if s["id"] == stroke]
                    near = suffuse.density(painting, stroke, place, time=moment)
                    self.assertLess(abs(near - (exact[0] if exact else 0)), 0.01, (stroke, moment, place))

    def test_density_has_the_shape_of_times_and_points(self):
        painting = three_strokes()
        points = np.zeros((4, 3, 2))
        self.assertEqual(suffuse.density(painting, 1, points).shape, (4, 3))
        self.assertEqual(suffuse.density(painting, 1, points, time=[0.5, 1]).shape, (2, 4, 3))
        with self.assertRaisesRegex(suffuse.DataError, "no such stroke"):
            suffuse.density(painting, 9, points)
        with self.assertRaisesRegex(suffuse.DataError, "shape"):
            suffuse.density(painting, 1, np.zeros(3))
        with self.assertRaises(suffuse.DataError):
            suffuse.density(painting, 1, points, time=np.nan)


class Gradients(unittest.TestCase):
    def loss(self, painting, weights):
        return float((suffuse.DifferentiablePicture(painting, size=80).picture.astype(float) * weights).sum())

    def test_slopes_are_those_of_differences(self):
        painting = three_strokes()
        weights = np.random.default_rng(3).random((60, 80, 3)).astype(np.float32)
        slopes = suffuse.gradient(painting, weights, size=80)
        self.assertEqual(slopes["segments"].shape, (6,))
        self.assertEqual(slopes["strokes"].shape, (3,))
        for name, row, step in (("diffusion", 0, 0.05), ("density", 3, 0.05), ("opacity", 2, 0.01), ("ryb", 1, 0.01), ("bezier", 4, 0.05)):
            values = []
            for side in (-1, 1):
                segments = painting.segments.copy()
                if name == "opacity":
                    segments["colour"][row, 3] += side * step
                elif name == "ryb":
                    segments["colour"][row, 1] += 0.5 + side * step
                elif name == "bezier":
                    segments["bezier"][row, 1, 1] += side * step
                else:
                    segments[name][row] += side * step
                values.append(self.loss(painting.replaced(segments=segments), weights))
            found = slopes["segments"][name][row]
            if name == "ryb":
                middle = painting.segments.copy()
                middle["colour"][row, 1] += 0.5
                found = suffuse.gradient(painting.replaced(segments=middle), weights, size=80)["segments"]["ryb"][row, 1]
            elif name == "bezier":
                found = found[1, 1]
            wanted = (values[1] - values[0]) / (2 * step)
            self.assertLess(abs(found - wanted), 0.02 * abs(wanted) + 0.05, name)

    def test_functions_and_refusals(self):
        painting = three_strokes()
        picture = suffuse.DifferentiablePicture(painting, size=80, time=1.4)
        self.assertEqual(picture.picture.shape, (60, 80, 3))
        self.assertFalse(picture.picture.flags.writeable)
        self.assertLess(np.abs(picture.picture - suffuse.render(painting, size=80, time=1.4, dtype="float32")).max(), 1 / 128)
        twice = [picture.backward(2 * picture.picture), suffuse.gradient(painting, lambda p: 2 * p, size=80, time=1.4)]
        for name in ("segments", "fills", "strokes"):
            np.testing.assert_array_equal(twice[0][name], twice[1][name])
        with self.assertRaisesRegex(suffuse.DataError, r"shape \(60, 80, 3\)"):
            picture.backward(np.zeros((40, 30, 3), np.float32))
        segments = painting.segments.copy()
        segments["anisotropy_ratio"][0] = 2
        with self.assertRaisesRegex(suffuse.DataError, "stroke 1: its picture has no gradient"):
            suffuse.DifferentiablePicture(painting.replaced(segments=segments), size=80)

    def test_memory_stays_while_it_is_seen(self):
        seen = suffuse.DifferentiablePicture(three_strokes(), size=80).picture
        copy = seen.copy()
        suffuse.DifferentiablePicture(three_strokes(), size=80)
        np.testing.assert_array_equal(seen, copy)


class Fits(unittest.TestCase):
    def test_fit_is_the_command_line_s(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.png"
            picture = suffuse.render(three_strokes(), size=48)
            suffuse.write_picture(path, picture)
            run_cli("fit", path, "-o", path.with_suffix(".json"), "--strokes", 5, "--iterations", 12)
            wanted = suffuse.open(path.with_suffix(".json"))
            seen = []
            options = {"strokes": 5, "steps": 12}
            self.assertEqual(suffuse.fit(path, progress=seen.append, **options), wanted)
            self.assertEqual(suffuse.fit(picture, **options), wanted)
            self.assertTrue(seen and seen == sorted(seen))
            on = suffuse.fit(picture, start=wanted, strokes=5, steps=3)
            self.assertEqual(on.size, (48, 36))

    def test_refusals(self):
        picture = np.zeros((8, 8, 3), np.uint8)
        for options in ({"strokes": 0}, {"error": 300}, {"style": "wet"}, {"perceptual": 2}, {"weight": np.ones((2, 2))},
                        {"least_width": 5, "greatest_width": 2}):
            with self.assertRaises(suffuse.DataError, msg=options):
                suffuse.fit(picture, **options)
        for wrong in (np.nan, np.inf, -np.inf):
            holed = np.ones((8, 8, 3))
            holed[2, 3, 1] = wrong
            with self.assertRaisesRegex(suffuse.DataError, "picture: holds NaN or infinity"):
                suffuse.fit(holed)
            with self.assertRaisesRegex(suffuse.DataError, "weight: holds NaN or infinity"):
                suffuse.fit(picture, weight=holed[..., 1])
        for dtype in ("int64", "int32", "bool", "object", "uint32", "complex64"):
            with self.assertRaisesRegex(suffuse.DataError, f"picture: dtype {dtype}: give uint8"):
                suffuse.fit(picture.astype(dtype))
            with self.assertRaisesRegex(suffuse.DataError, f"weight: dtype {dtype}: give uint8"):
                suffuse.fit(picture, weight=np.ones((8, 8), dtype))
        for number in (-0.02, 1.6, 255):
            far = np.full((8, 8, 3), 0.5, np.float32)
            far[1, 2, 0] = number
            with self.assertRaisesRegex(suffuse.DataError, r"picture: .* is not in \[0, 1\]"):
                suffuse.fit(far)
            with self.assertRaisesRegex(suffuse.DataError, r"weight: .* is not in \[0, 1\]"):
                suffuse.fit(picture, weight=far[..., 0])
        for black in (np.zeros((8, 8)), np.full((8, 8), -3.0), np.zeros((8, 8, 1), np.uint8),
                      np.full((8, 8, 4), (0, 0, 0, 1.0))):
            with self.assertRaisesRegex(suffuse.DataError, "weight: is black all over"):
                suffuse.fit(picture, weight=black)
        near = np.full((8, 8, 3), (-0.005, 0.5, 1.2), np.float32)  # as resampling overshoots
        self.assertEqual(suffuse.fit(near, strokes=1, steps=1), suffuse.fit(near.clip(0, 1), strokes=1, steps=1))
        with self.assertRaises(suffuse.FileError):
            suffuse.fit("missing.png")

        def stop(progress):
            raise StopIteration

        with self.assertRaises(StopIteration):
            suffuse.fit(picture, strokes=2, steps=50, progress=stop)


if __name__ == "__main__":
    unittest.main()
