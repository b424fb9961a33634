"""The four tasks of the keyboard, done in the program as it is, with a screen reader's eyes: a stroke is painted, selected,
recoloured and moved by keys alone, and what became of it is read over AT-SPI, where screen readers read it.

check.py PROGRAM: starts PROGRAM on a display and a session bus of its own. Without the tools for it the exit status is 77.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

SKIPPED = 77
PATIENCE = 120  # seconds; a machine that is busy takes long, and nothing is measured here


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


for tool in ("Xvfb", "xdotool", "dbus-run-session"):
    if not shutil.which(tool):
        skip(f"{tool} is not installed")
try:
    import gi

    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError):
    skip("python3-gi and gir1.2-atspi-2.0 are not both installed")
if not pathlib.Path("/usr/libexec/at-spi-bus-launcher").exists():
    skip("at-spi2-core is not installed")

if "SUFFUSE_READER_SESSION" not in os.environ:  # once more, with a session bus of its own
    os.environ["SUFFUSE_READER_SESSION"] = "1"
    os.execvp("dbus-run-session", ["dbus-run-session", "--", sys.executable, "-B", *sys.argv])

PROGRAM = sys.argv[1]
PAINTING = """{"format": "suffuse-text", "version": 1,
 "canvas": {"width": 800, "height": 600, "background": [0, 0, 0, 1], "paper": {"kind": "none"}}, "strokes": []}"""
SETTINGS = "[General]\nlanguage=en\n"


def until(found, what):
    """What `found` returns, as soon as it is true. Whatever it asks may not be there yet, or not any more."""
    deadline = time.monotonic() + PATIENCE
    last = None
    while time.monotonic() < deadline:
        while GLib.MainContext.default().iteration(False):
            pass
        try:
            if result := found():
                return result
        except Exception as error:  # libatspi has one kind of error for all that went wrong on the bus
            last = error
        time.sleep(0.03)
    raise AssertionError(f"{what}: not within {PATIENCE} s{f' ({last})' if last else ''}")


class Focus:
    """The widget that has told last that it has the keyboard, and how many have told so."""

    # Rows and tabs are no widgets. They tell so, too, as soon as they are the current ones.
    ROWS = (Atspi.Role.LIST_ITEM, Atspi.Role.TABLE_CELL, Atspi.Role.TREE_ITEM, Atspi.Role.PAGE_TAB)

    def __init__(self):
        self.name, self.inside, self.told = "", [], 0
        self.listener = Atspi.EventListener.new(self.note)
        self.listener.register("object:state-changed:focused")

    def note(self, event):
        try:
            if event.detail1 != 1 or event.source.get_role() in self.ROWS:
                return
            name, inside, around = event.source.get_name(), [], event.source.get_parent()
            while around and around.get_role() != Atspi.Role.APPLICATION:
                inside.append(around.get_name())
                around = around.get_parent()
        except GLib.GError:
            return  # it has gone already, and something else has the keyboard
        self.name, self.inside, self.told = name, inside, self.told + 1


def key(*keys):
    subprocess.run(["xdotool", "key", "--delay", "8", *keys], check=True, timeout=PATIENCE)


def typed(text):
    subprocess.run(["xdotool", "type", "--delay", "8", text], check=True, timeout=PATIENCE)


def children(of):
    return [child for i in range(of.get_child_count()) if (child := of.get_child_at_index(i))]


def has(accessible, state):
    return accessible.get_state_set().contains(state)


def find(root, wanted, depth=14):
    """The first one below `root`, itself included, for which `wanted` is true; null where there is none. What cannot be
    seen is passed by."""
    if wanted(root):
        return root
    if depth == 0 or root.get_role() == Atspi.Role.CANVAS:
        return None
    for child in children(root):
        if has(child, Atspi.StateType.SHOWING) or child.get_role() == Atspi.Role.FRAME:
            if found := find(child, wanted, depth - 1):
                return found
    return None


class FourTasks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        (folder / "painting.json").write_text(PAINTING)
        (folder / "settings.ini").write_text(SETTINGS)
        read, write = os.pipe()
        cls.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        with os.fdopen(read) as pipe:
            os.environ["DISPLAY"] = ":" + pipe.readline().strip()
        environment = os.environ | {
            "QT_QPA_PLATFORM": "xcb",
            "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1",
            "SUFFUSE_SETTINGS": str(folder / "settings.ini"),
            "SUFFUSE_BACKEND": "cpu",
            "SUFFUSE_PRESENTER": "raster",
            "XDG_DATA_HOME": str(folder / "data"),
            "HOME": str(folder),
            "LC_ALL": "C.UTF-8",
        }
        cls.program = subprocess.Popen([PROGRAM, str(folder / "painting.json")], env=environment)
        Atspi.init()
        desktop = Atspi.get_desktop(0)
        desktop.set_cache_mask(Atspi.Cache.NONE)  # what is read is what is so now

        def own():
            return next((a for a in children(desktop) if a.get_process_id() == cls.program.pid), None)

        cls.app = until(own, "the program is on the accessibility bus")
        cls.app.set_cache_mask(Atspi.Cache.NONE)
        cls.focus = Focus()
        cls.canvas = until(lambda: find(cls.app, lambda a: a.get_role() == Atspi.Role.CANVAS), "the canvas is found")
        window = ["xdotool", "search", "--onlyvisible", "--pid", str(cls.program.pid), "--name", "Suffuse"]

        def focuses():  # there is no window manager that would give the keyboard to the window
            found = subprocess.run(window, capture_output=True, text=True).stdout.split()
            return found and subprocess.run(["xdotool", "windowfocus", found[-1]]).returncode == 0 and cls.has_keyboard()

        until(focuses, "the canvas has the keyboard")

    @classmethod
    def tearDownClass(cls):
        for process in (cls.program, cls.server):
            process.terminate()
            process.wait()
        cls.folder.cleanup()

    @classmethod
    def has_keyboard(cls):
        return has(cls.canvas, Atspi.StateType.FOCUSED)

    def strokes(self):
        return children(self.canvas)

    def names(self):
        return [stroke.get_name() for stroke in self.strokes()]

    def selected(self):
        return [i for i, s in enumerate(self.strokes()) if has(s, Atspi.StateType.SELECTED)]

    def place(self, stroke):
        area = self.strokes()[stroke].get_extents(Atspi.CoordType.SCREEN)
        return area.x, area.y

    def described(self, words):
        until(lambda: words in self.canvas.get_description(), f"the canvas says “{words}”")

    def test_1_a_stroke_is_painted(self):
        self.assertEqual(self.names(), [])
        key("ctrl+alt+p")
        self.described("Space presses it down")
        for count in (1, 2):
            key("space")
            self.described("Pen down at")
            key(*["Right"] * 6, *["Down"] * 4, "Left")
            key("space")
            until(lambda: len(self.names()) == count, f"{count} strokes are there")
            self.described("Pen up at")
            key("shift+Left")
        for i, name in enumerate(self.names(), 1):
            self.assertRegex(name, rf"^stroke {i}, [a-z ]+, [a-z -]+, \d+ segments?$")
        key("Escape")
        self.described("put away")

    def test_2_a_stroke_is_selected(self):
        key("v")
        until(
            lambda: has(find(self.app, lambda a: a.get_name() == "Select"), Atspi.StateType.CHECKED),
            "the tool Select is in use",
        )
        key("Tab")
        until(lambda: len(self.selected()) == 1, "one stroke is selected")
        first = self.selected()
        key("Tab")
        until(lambda: len(self.selected()) == 1 and self.selected() != first, "the next stroke is selected")
        self.described("of 2")
        key("shift+Tab")
        until(lambda: self.selected() == first, "the first stroke is selected again")
        until(lambda: has(self.strokes()[first[0]], Atspi.StateType.FOCUSED), "it has the keyboard")

    def test_3_a_stroke_is_recoloured(self):
        [chosen] = self.selected()
        other = self.names()[1 - chosen]
        until(self.reaches_hex, "the field for the colour has the keyboard")
        key("ctrl+a")
        typed("#20b040")
        key("Return")
        until(lambda: ", green, " in self.names()[chosen], "the stroke is green")
        self.assertEqual(self.names()[1 - chosen], other)

    def reaches_hex(self):
        """Goes on to the Colour dock, and there from field to field."""
        if self.focus.name == "Hex":
            return True
        told = self.focus.told
        key("Tab" if "Colour" in self.focus.inside else "F6")
        until(lambda: self.focus.told > told, "the keyboard has gone on")
        return False

    def test_4_a_stroke_is_moved(self):
        until(self.has_keyboard, "the canvas has the keyboard again, since Return gives it back")
        [chosen] = self.selected()
        before = self.place(chosen)
        for count in range(1, 4):
            key("shift+Right")
            until(lambda: self.place(chosen)[0] >= before[0] + 5 * count, "the stroke has gone to the right")
        self.described("moved by 10, 0")
        key("ctrl+z")
        until(lambda: self.place(chosen)[0] < before[0] + 30, "undo takes the last move back")


if __name__ == "__main__":
    del sys.argv[1:]
    unittest.main(verbosity=2)
