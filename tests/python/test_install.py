"""What is installed works by itself: as Debian has it, with the program's modules, and as pip has it, with its own."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import support  # skips where numpy is missing

import suffuse

BUILD = pathlib.Path(suffuse.__file__).absolute().parents[2]

CODE = """
import sys, suffuse
assert suffuse.__file__.startswith(sys.argv[1]), suffuse.__file__
painting = suffuse.open(sys.argv[2])
suffuse.write_picture(sys.argv[1] + "/a.png", suffuse.render(painting, size=32))
print(suffuse.read_picture(sys.argv[1] + "/a.png").shape, len(suffuse.loads(painting.dumps("pdf"))))
"""


class Install(unittest.TestCase):
    def setUp(self):
        if not shutil.which("cmake"):
            self.skipTest("cmake is missing")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.prefix = pathlib.Path(folder.name)

    def install(self, component):
        done = subprocess.run(["cmake", "--install", BUILD, "--prefix", self.prefix, "--component", component],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def use(self, folder):
        environment = {**os.environ, "PYTHONPATH": str(folder)}
        environment.pop("SUFFUSE_MODULE_DIR", None)
        done = subprocess.run([sys.executable, "-B", "-c", CODE, self.prefix, support.SAMPLES / "flat.suffuse"], cwd="/",
                              env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.split(), ["(24,", "32,", "4)", "299"])

    def test_as_a_package_and_by_pip(self):
        self.install("python")
        folder = self.prefix / "lib" / "python3" / "dist-packages"
        installed = {path.name for path in (folder / "suffuse").iterdir()}
        self.assertLess({"__init__.py", "__init__.pyi", "py.typed"}, installed)
        self.assertTrue(all(not path.is_symlink() for path in (folder / "suffuse").iterdir()))
        shutil.copytree(BUILD / "lib" / "suffuse", self.prefix / "lib" / "suffuse")
        self.use(folder)
        shutil.rmtree(self.prefix / "lib" / "suffuse")
        self.install("python_modules")
        self.use(folder)


if __name__ == "__main__":
    unittest.main()
