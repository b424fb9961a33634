"""The examples of app/python/examples do what they say; small here."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from support import SAMPLES, SOURCE, three_strokes

import numpy as np
import suffuse

EXAMPLES = SOURCE / "app" / "python" / "examples"
TRIED = set()


def run(name, *arguments):
    """Runs an example; returns what it printed. It is skipped, with its reason, where something is not installed."""
    TRIED.add(name)
    done = subprocess.run([sys.executable, "-B", EXAMPLES / name, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode == 77:
        raise unittest.SkipTest(done.stdout.strip())
    if done.returncode != 0:
        raise AssertionError(f"{name}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.small = self.path / "small.suffuse"
        three_strokes().save(self.small)

    def test_waves(self):
        self.assertIn("6 strokes, 96 segments", run("waves.py", self.path / "a.suffuse", 6))
        painting = suffuse.open(self.path / "a.suffuse")
        self.assertLess(suffuse.render(painting, size=64).min(), 200)

    def test_restyle(self):
        self.assertIn("3 strokes changed", run("restyle.py", self.path / "out", self.small))
        after = suffuse.open(self.path / "out" / "small.suffuse")
        self.assertTrue((after.segments["colour"][:, 2] >= three_strokes().segments["colour"][:, 2]).all())
        self.assertEqual(after.canvas["paper_kind"][0], 1)

    def test_camera(self):
        run("camera.py", self.small, self.path / "film", 5, 64)
        frames = [suffuse.read_picture(path) for path in sorted((self.path / "film").glob("*.png"))]
        self.assertEqual([frame.shape for frame in frames], [(48, 64, 4)] * 5)
        self.assertFalse((frames[1] == frames[4]).all())

    def test_film_strip(self):
        self.assertIn("frame 4: ", run("film_strip.py", self.small, self.path / "a.png", 4, 40))
        picture = suffuse.read_picture(self.path / "a.png")
        self.assertEqual(picture.shape, (30, 160, 4))
        self.assertFalse((picture[:, :40] == picture[:, 120:]).all())

    def test_density_over_time(self):
        run("density_over_time.py", self.small, 2, self.path / "phi.csv")
        table = np.loadtxt(self.path / "phi.csv", delimiter=",", skiprows=1)
        self.assertEqual(table.shape, (60, 5))
        self.assertTrue((np.diff(table[-1, 1:]) < 0).all())
        try:
            import matplotlib  # pylint: disable=unused-import
        except ImportError:
            return
        run("density_over_time.py", self.small, 2, self.path / "phi.png")
        self.assertGreater(suffuse.read_picture(self.path / "phi.png").shape[0], 100)

    def test_dataset(self):
        run("dataset.py", self.path / "data.npz", 12, 24)
        data = np.load(self.path / "data.npz")
        self.assertEqual(data["pictures"].shape, (12, 24, 24, 3))
        self.assertEqual(data["first"][-1], len(data["segments"]))
        again = suffuse.Painting.from_tables(segments=data["segments"][: data["first"][1]],
                                             canvas={"width": [64], "height": [64]})
        np.testing.assert_array_equal(suffuse.render(again, size=24), data["pictures"][0])

    def test_optimise(self):
        self.assertIn("mean square error", run("optimise.py", 15))

    def test_torch_function(self):
        self.assertIn("loss", run("torch_function.py"))

    def test_strokes_of_picture(self):
        suffuse.write_picture(self.path / "a.png", suffuse.render(three_strokes(), size=48))
        run("strokes_of_picture.py", self.path / "a.png", self.path / "a.suffuse", 8, 10)
        self.assertEqual(suffuse.open(self.path / "a.suffuse").size, (48, 36))

    def test_kaleidoscope(self):
        self.assertIn("12 strokes", run("kaleidoscope.py", self.small, self.path / "a.suffuse", 4))
        painting = suffuse.open(self.path / "a.suffuse")
        self.assertEqual(list(painting.groups["name"]), ["copy 1", "copy 2", "copy 3"])

    def test_contact_sheet(self):
        run("contact_sheet.py", self.path / "a.png", self.small, self.small, "--width", 40)
        self.assertEqual(suffuse.read_picture(self.path / "a.png").shape, (46, 104, 4))

    def test_versions(self):
        document = suffuse.Document(three_strokes())
        document.select([2])
        document.change_segments(density=4)
        document.painting.save(self.path / "b.suffuse")
        said = run("versions.py", self.small, self.path / "b.suffuse", self.path / "a.png", 80)
        self.assertIn("0 strokes added, 0 removed, 1 changed", said)
        self.assertIn("stroke 2: segments[0].density: 9 → 4", said)

    @classmethod
    def tearDownClass(cls):
        untried = {path.name for path in EXAMPLES.glob("*.py")} - TRIED
        assert not untried, f"not tried: {untried}"


if __name__ == "__main__":
    unittest.main()
