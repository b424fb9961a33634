"""Pictures have the bits of the command line's; threads share what there is."""

import concurrent.futures
import pathlib
import signal
import tempfile
import threading
import time
import unittest

from support import SAMPLES, run_cli, three_strokes

import numpy as np
import suffuse


def read_pfm(path):
    """The R, G, B of a PFM file, from the top."""
    kind, size, scale, data = path.read_bytes().split(b"\n", 3)
    assert kind == b"PF" and float(scale) < 0
    width, height = map(int, size.split())
    return np.frombuffer(data, "<f4").reshape(height, width, 3)[::-1]


class Pictures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def test_floats_are_the_command_line_s(self):
        source = SAMPLES / "still-life.suffuse"
        painting = suffuse.open(source)
        for options, flags in (
            ({"size": 200}, ["--size", "200"]),
            ({"size": (160, 120), "time": 1.5, "backend": "reference"}, ["--size", "160x120", "--time", "1.5", "--backend", "reference"]),
            ({"area": (100.1, 50.7, 200, 150), "scale": 0.7, "threads": 1}, ["--area", "100.1,50.7,200,150", "--scale", "0.7"]),
        ):
            run_cli("render", source, "-o", self.path / "a.pfm", *flags)
            picture = suffuse.render(painting, dtype="float32", **options)
            self.assertEqual(picture.dtype, np.float32)
            np.testing.assert_array_equal(picture, read_pfm(self.path / "a.pfm"))

    def test_whole_numbers_are_the_command_line_s(self):
        source = SAMPLES / "lanterns.suffuse"
        painting = suffuse.open(source)
        for bits in (8, 16):
            for transparent in (False, True):
                flags = ["--transparent"] if transparent else []
                run_cli("render", source, "-o", self.path / "a.png", "--size", "150", "--depth", bits, *flags)
                dtype = f"uint{bits}"
                picture = suffuse.render(painting, size=150, transparent=transparent, dtype=dtype)
                self.assertEqual(picture.shape[2], 4 if transparent else 3)
                read = suffuse.read_picture(self.path / "a.png", dtype=dtype)
                np.testing.assert_array_equal(picture, read[:, :, : picture.shape[2]])
                suffuse.write_picture(self.path / "b.png", picture)
                if bits == 8:
                    self.assertEqual((self.path / "b.png").read_bytes(), (self.path / "a.png").read_bytes())
                np.testing.assert_array_equal(suffuse.read_picture(self.path / "b.png", dtype=dtype), read)

    def test_a_renderer_that_is_kept_gives_the_same_bits(self):
        painting = three_strokes()
        segments = painting.segments.copy()
        segments["diffusion"][1] = 30
        renderer = suffuse.Renderer(backend="cpu")
        self.assertEqual(renderer.backend, "CPU")
        for value in (painting, painting.replaced(segments=segments), painting):
            for moment in (0.7, None):
                np.testing.assert_array_equal(
                    renderer.render(value, size=80, time=moment, dtype="float32"),
                    suffuse.render(value, size=80, time=moment, dtype="float32", backend="cpu"))

    def test_floats_are_the_renderer_s_own_memory(self):
        picture = suffuse.render(three_strokes(), size=40, dtype="float32")
        self.assertFalse(picture.flags.owndata)
        self.assertEqual(picture.strides[1], 16)
        del picture

    def test_refusals_are_those_of_the_command_line(self):
        source = self.path / "in.suffuse"
        painting = three_strokes()
        painting.save(source)
        for options, flags in (({"size": (100, 10)}, ["--size", "100x10"]), ({"size": 0}, ["--size", "0"]),
                               ({"scale": -1}, ["--scale", "-1"]), ({"size": 10**6}, ["--size", "1000000"]),
                               ({"area": (0, 0, 0, 5)}, ["--area", "0,0,0,5"]), ({"time": -5}, ["--time", "-5"]),
                               ({"size": 9, "scale": 2}, ["--size", "9", "--scale", "2"]),
                               ({"backend": "gpu"}, ["--backend", "gpu"]), ({"threads": -2}, ["--threads", "-2"])):
            with self.assertRaises(ValueError) as raised:
                suffuse.render(painting, **options)
            _, said = run_cli("render", source, "-o", self.path / "a.png", *flags, code=2)
            # The command line says where help is, and names options with dashes.
            said = said.removeprefix("suffuse-cli: render: ").split(". See suffuse-cli")[0].replace("--", "")
            self.assertEqual(said, str(raised.exception).removesuffix("."))
        with self.assertRaisesRegex(suffuse.DataError, "give uint8, uint16 or float32"):
            suffuse.render(painting, dtype="float64")
        with self.assertRaises(TypeError):
            suffuse.render("painting.suffuse")

    def test_image_files(self):
        pixels = np.zeros((5, 7, 4), np.float32)
        pixels[..., 0] = np.linspace(0, 1, 7)
        pixels[..., 3] = 1
        for name in ("a.png", "a.tiff", "a.webp", "a.exr"):
            suffuse.write_picture(self.path / name, pixels, quality=100)
            read = suffuse.read_picture(self.path / name, dtype="float32")
            self.assertLess(np.abs(read - pixels).max(), 1 / 250, name)
        with self.assertRaisesRegex(suffuse.DataError, "unknown ending"):
            suffuse.write_picture(self.path / "a.bmp", pixels)
        with self.assertRaisesRegex(suffuse.DataError, "shape"):
            suffuse.write_picture(self.path / "a.png", pixels[..., 0])
        for wrong in (np.nan, np.inf):
            holed = pixels.copy()
            holed[1, 2, 0] = wrong
            with self.assertRaisesRegex(suffuse.DataError, "pixels: holds NaN or infinity"):
                suffuse.write_picture(self.path / "holed.exr", holed)
        self.assertFalse((self.path / "holed.exr").exists())
        for dtype in ("int64", "int32", "bool", "object"):
            with self.assertRaisesRegex(suffuse.DataError, f"pixels: dtype {dtype}: give uint8"):
                suffuse.write_picture(self.path / "typed.png", pixels.astype(dtype))
        suffuse.write_picture(self.path / "swapped.png", (pixels * 65535).astype(">u2"))
        suffuse.write_picture(self.path / "usual.png", (pixels * 65535).astype("u2"))
        self.assertEqual((self.path / "swapped.png").read_bytes(), (self.path / "usual.png").read_bytes())
        with self.assertRaises(OSError):
            suffuse.read_picture(self.path / "missing.png")
        with self.assertRaises(suffuse.DataError):
            suffuse.write_picture(self.path / "a.jpg", pixels)  # which has no alpha

    def test_drafts(self):
        painting = three_strokes()
        groups = suffuse.new_table("groups", 1)
        groups["id"], groups["draft"] = 1, True
        strokes = painting.strokes.copy()
        strokes["group"] = 1
        drafted = painting.replaced(groups=groups, strokes=strokes)
        self.assertEqual(suffuse.render(drafted, size=30).min(), 255)
        np.testing.assert_array_equal(suffuse.render(drafted, size=30, drafts=True), suffuse.render(painting, size=30))

    def test_backends(self):
        known = suffuse.backends()
        self.assertIn("CPU", [row["backend"] for row in known])
        self.assertEqual([row["unavailable"] for row in known if row["backend"] == "CPU"], [""])


class Threads(unittest.TestCase):
    def test_threads_draw_the_same(self):
        painting = three_strokes()
        wanted = suffuse.render(painting, size=64, backend="cpu")
        shared = suffuse.Renderer()

        def work(k):
            alone = suffuse.render(painting, size=64, backend="cpu", threads=1)
            return alone, shared.render(painting, size=64), painting.segments["density"].sum(), painting.hash

        with concurrent.futures.ThreadPoolExecutor(6) as pool:
            for alone, together, total, text in pool.map(work, range(24)):
                np.testing.assert_array_equal(alone, wanted)
                np.testing.assert_array_equal(together, wanted)
                self.assertEqual((total, text), (painting.segments["density"].sum(), painting.hash))

    def test_python_goes_on_meanwhile(self):
        painting = three_strokes()
        counted = 0
        done = threading.Event()

        def draw():
            suffuse.render(painting, size=640, backend="reference", threads=1)
            done.set()

        thread = threading.Thread(target=draw)
        thread.start()
        while not done.is_set():
            counted += 1
            time.sleep(0)
        thread.join()
        self.assertGreater(counted, 10)

    def test_ctrl_c_stops_the_work(self):
        painting = suffuse.open(SAMPLES / "ink-landscape.suffuse")
        timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            # Far longer than the timer, whatever the machine: it ends only since it is stopped.
            suffuse.render(painting, size=3000, backend="reference", threads=1)
        timer.join()


if __name__ == "__main__":
    unittest.main()
