"""Works that take long: tiles, films, fewer strokes. What they make is the command line's; stopped, they keep what they say."""

import concurrent.futures
import pathlib
import signal
import tempfile
import threading
import unittest

from support import run_cli, three_strokes

import numpy as np
import suffuse


def files_of(folder):
    """All files below a folder, with what is in them."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


class Interrupt:
    """Presses Ctrl+C once, when the progress that it is told has come that far."""

    def __init__(self, share):
        self.share = share
        self.told = []

    def __call__(self, progress):
        self.told.append(progress)
        if progress >= self.share:
            self.share = 2
            signal.raise_signal(signal.SIGINT)


class Works(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.painting = three_strokes()
        self.source = self.path / "a.suffuse"
        self.painting.save(self.source)


class Tiles(Works):
    def test_tiles_are_the_command_line_s(self):
        flags = ["--size", "200", "--tile", "32", "--sheet", "64", "--backend", "cpu"]
        options = {"size": 200, "tile": 32, "sheet": 64, "backend": "cpu"}
        (self.path / "cli").mkdir()
        (self.path / "py").mkdir()
        for name, more, wish in (("a.dzi", ["--format", "png"], {"format": "png"}), ("b", [], {}), ("c.tif", ["--depth", "16"], {"depth": "16"})):
            run_cli("render", self.source, "--tiles", self.path / "cli" / name, "--threads", 1, *flags, *more)
            told = []
            stats = suffuse.render_tiles(self.painting, self.path / "py" / name, threads=1, progress=told.append, **options, **wish)
            self.assertEqual((stats["width"], stats["height"], stats["kept"]), (200, 150, 0))
            self.assertEqual((told[-1], told), (1, sorted(told)))
        made = [{name: data for name, data in files_of(self.path / folder).items() if not name.endswith((".journal", ".tif"))} for folder in ("cli", "py")]
        self.assertEqual(made[0], made[1])
        self.assertIn("b/index.html", made[1])
        self.assertEqual((self.path / "cli" / "c.tif").stat().st_size, (self.path / "py" / "c.tif").stat().st_size)
        whole = suffuse.read_picture(self.path / "py" / "c.tif", dtype="uint16")[:, :, :3]
        np.testing.assert_array_equal(whole, suffuse.render(self.painting, size=200, backend="cpu", dtype="uint16"))

    def test_what_is_finished_is_kept(self):
        out = self.path / "a.dzi"
        options = {"size": 400, "tile": 16, "sheet": 16, "format": "png", "backend": "cpu", "threads": 1}
        with self.assertRaises(KeyboardInterrupt):
            # Whenever it comes: what is drawn until then is there.
            suffuse.render_tiles(self.painting, out, progress=Interrupt(0), **options)
        there = (self.path / "a_files" / "tiles.journal").read_bytes().count(b"\nsheet ")
        stats = suffuse.render_tiles(self.painting, out, **options)
        self.assertEqual(stats["kept"], there)
        self.assertEqual(stats["kept"] + stats["sheets"], stats["tiles"])
        victim = self.path / "a_files" / "8" / "3_3.png"
        victim.write_bytes(victim.read_bytes()[:-1])
        again = suffuse.render_tiles(self.painting, out, **options)
        self.assertEqual((again["sheets"], again["kept"]), (1, stats["tiles"] - 1))

    def test_who_calls_is_told(self):
        def work(name):
            seen = set()
            suffuse.render_tiles(self.painting, self.path / name, size=64, progress=lambda share: seen.add(threading.get_ident()))
            return seen == {threading.get_ident()}

        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            self.assertEqual(list(pool.map(work, ("a.dzi", "b.dzi", "c.tif"))), [True] * 3)

    def test_refusals(self):
        for path, options, said in (("a.png", {}, "tiles .*a.png: give a name that ends in .dzi or .tif, or a folder"),
                                    ("", {}, "the name is missing"), ("a.tif", {"tile": 20}, "a multiple of 16"),
                                    ("a.dzi", {"tile": 8}, "tile 8: give a whole number from 16 to 4096"),
                                    ("a.dzi", {"depth": "12"}, "depth 12: tiles have 8 or 16 bits"),
                                    ("a.dzi", {"format": "gif"}, "format gif: tiles of a Deep Zoom are jpg or png")):
            with self.assertRaisesRegex(suffuse.DataError, said):
                suffuse.render_tiles(self.painting, path and self.path / path, **options)
        (self.path / "a_files").mkdir()
        (self.path / "a_files" / "mine").write_text("mine")
        with self.assertRaisesRegex(suffuse.FileError, "there is something else already"):
            suffuse.render_tiles(self.painting, self.path / "a.dzi", size=40)
        self.assertEqual(files_of(self.path / "a_files"), {"mine": b"mine"})


class Films(Works):
    OPTIONS = {"size": 64, "fps": 5, "duration": 2, "backend": "cpu"}

    def test_frames_are_the_command_line_s(self):
        for folder in ("cli", "py"):
            (self.path / folder).mkdir()
        run_cli("timelapse", self.source, "-o", self.path / "cli" / "%03d.png", "--size", 64, "--fps", 5, "--duration", 2, "--backend", "cpu")
        told = []
        stats = suffuse.timelapse(self.painting, self.path / "py" / "%03d.png", progress=told.append, **self.OPTIONS)
        self.assertEqual((stats["frames"], told[-1]), (10, 1))
        self.assertEqual(files_of(self.path / "py"), files_of(self.path / "cli"))
        film = suffuse.Frames(self.painting, **self.OPTIONS)
        self.assertEqual((len(film), film.times.shape), (10, (10,)))
        self.assertTrue((np.diff(film.times) >= 0).all())
        frames = list(film)
        for number, frame in enumerate(frames, 1):
            self.assertEqual(frame.shape, (48, 64, 3))
            np.testing.assert_array_equal(frame, suffuse.read_picture(self.path / "py" / f"{number:03d}.png")[:, :, :3])
        np.testing.assert_array_equal(film[-1], frames[9])
        np.testing.assert_array_equal(film[2], frames[2])
        with self.assertRaises(IndexError):
            film[10]

    def test_refusals(self):
        for path, options, said in (("a.gif", {}, "a.gif: "), ("%d.png", {"fps": 0}, "fps 0: give a number from 0.001"),
                                    ("%d.png", {"fps": 1000, "duration": 1e6}, "frames are too many"),
                                    ("%d.png", {"size": 0}, "size 0")):
            with self.assertRaisesRegex(suffuse.DataError, said):
                suffuse.timelapse(self.painting, self.path / path, **options)
        with self.assertRaisesRegex(suffuse.DataError, "give uint8, uint16 or float32"):
            suffuse.Frames(self.painting, dtype="int8")

    def test_stopped_it_writes_nothing(self):
        def stop(progress):
            raise LookupError("enough")

        for path in ("film.webp", "%06d.png"):
            with self.assertRaisesRegex(LookupError, "enough"):
                # So many frames that it is stopped before the last one.
                suffuse.timelapse(self.painting, self.path / path, progress=stop, fps=1000, duration=100, size=64)
        self.assertEqual([path.name for path in self.path.iterdir()], ["a.suffuse"])


class Fewer(Works):
    def test_refit_is_the_command_line_s(self):
        out = self.path / "b.json"
        run_cli("refit", self.source, "-o", out, "--select", "2-3", "--strokes", 1, "--iterations", 10, "--pixels", 2000)
        told = []
        made, report = suffuse.refit(self.painting, select=[2, 3], strokes=1, steps=10, pixels=2000, progress=told.append)
        self.assertEqual(made, suffuse.open(out))
        self.assertEqual((report["strokes_before"], report["strokes"], report["worse"]), (2, 1, False))
        self.assertGreater(report["error"]["greatest"], report["error"]["root_mean_square"])
        self.assertEqual(told, sorted(told))

    def test_goals(self):
        wish = {"strokes": 1, "steps": 5, "pixels": 1000}
        goal = suffuse.render(self.painting, size=80, time=0.6)
        suffuse.write_picture(self.path / "goal.png", goal)
        by_array, report = suffuse.refit(self.painting, to=goal, **wish)
        self.assertEqual(by_array, suffuse.refit(self.painting, to=self.path / "goal.png", **wish)[0])
        self.assertGreater(report["error_before"]["greatest"], 0)
        other, _ = suffuse.refit(self.painting, to=self.painting, **wish)
        self.assertEqual(len(other), 1)

    def test_refusals(self):
        for options, said in (({"select": [9]}, "select 9: there is no stroke 9"), ({"layer": "sky"}, "layer sky: there is no group"),
                              ({"select": [1], "layer": "a"}, "give one of them"), ({"strokes": 0}, "strokes 0: give a whole number from 1"),
                              ({"steps": 0}, "steps 0: give a whole number"), ({"style": "wet"}, "style wet: give feathering"),
                              ({"to": np.zeros((3, 3))}, "to: give it the shape"), ({"select": []}, ".")):
            with self.assertRaisesRegex(suffuse.DataError, said, msg=options):
                suffuse.refit(self.painting, **options)
        with self.assertRaises(suffuse.FileError):
            suffuse.refit(self.painting, to=self.path / "missing.png")


class Stopped(Works):
    def test_a_fit_keeps_the_strokes_so_far(self):
        picture = suffuse.render(self.painting, size=48)
        with self.assertRaises(KeyboardInterrupt) as stopped:
            suffuse.fit(picture, strokes=4, steps=1_000_000, progress=Interrupt(1e-4))
        kept = stopped.exception.painting
        self.assertGreater(len(kept), 0)
        self.assertEqual(kept.size, (48, 36))
        with self.assertRaises(KeyboardInterrupt) as again:
            suffuse.fit(picture, start=kept, strokes=4, steps=1_000_000, progress=Interrupt(0))
        self.assertGreater(len(again.exception.painting), 0)

    def test_a_long_step_ends_soon(self):
        """The strokes of a large picture: it ends only since it is stopped."""
        timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
        noise = np.random.default_rng(1).integers(0, 256, (600, 800, 3), np.uint8)
        with self.assertRaises(KeyboardInterrupt) as stopped:
            timer.start()
            suffuse.fit(noise, strokes=20_000, steps=1_000_000)
        timer.join()
        kept = getattr(stopped.exception, "painting", None)  # nothing where the machine is so busy that it had not begun
        self.assertTrue(kept is None or len(kept) > 0)

    def test_a_refit_makes_nothing(self):
        with self.assertRaises(KeyboardInterrupt):
            suffuse.refit(self.painting, strokes=2, steps=1_000_000, progress=Interrupt(0))


if __name__ == "__main__":
    unittest.main()
