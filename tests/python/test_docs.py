"""The pieces of docs/python.md run, one after another, and print what the comments beside them say."""

import contextlib
import io
import os
import re
import tempfile
import unittest

from support import SOURCE

import suffuse


class Docs(unittest.TestCase):
    def test_pieces_run(self):
        text = (SOURCE / "docs" / "python.md").read_text("utf-8")
        pieces = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreater(len(pieces), 8)
        names, said = {}, io.StringIO()
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(said):
                    for piece in pieces:
                        exec(compile(piece, "docs/python.md", "exec"), names)  # pylint: disable=exec-used
            finally:
                os.chdir(before)
        lines = [" ".join(line.split()) for line in said.getvalue().splitlines()]
        for wanted in re.findall(r"^(?:print|    print)\(.*\) +# (.*)$", text, re.M):
            if not wanted.startswith("∂"):
                self.assertIn(wanted, lines)
        self.assertIn("diffusion <f4 () unit²/s (0, 1e12]", lines)

    def test_every_public_name_is_there(self):
        text = (SOURCE / "docs" / "python.md").read_text("utf-8")
        for name in suffuse.__all__:
            if name not in ("Step", "backends", "brushes", "gradient", "read_picture"):
                self.assertIn(name, text)
        for path in (SOURCE / "app" / "python" / "examples").glob("*.py"):
            self.assertIn(f"`{path.name}`", text)


if __name__ == "__main__":
    unittest.main()
