"""What `cmake --install` puts into a folder: it is complete, it works there, and the desktop's own tools accept it.

check.py CMAKE BUILD: installs BUILD into a folder of its own. A test whose tool is missing is skipped, with its name.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE, BUILD = sys.argv[1:3]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
ID = "org.suffuse.Suffuse"
BASH_COMPLETION = "/usr/share/bash-completion/bash_completion"


def run(*command, env=None, check=True):
    """What a command prints, both streams. It must succeed."""
    done = subprocess.run([str(c) for c in command], capture_output=True, env=env, timeout=300)
    if check and done.returncode != 0:
        raise AssertionError(f"{command}: exit {done.returncode}\n{done.stdout.decode()}{done.stderr.decode()}")
    return (done.stdout + done.stderr).decode()


def options_in(text):
    """All names of options at the beginning of a line of a help text."""
    names = []
    for line in text.splitlines():
        begin = re.match(r"  (-[^ ].*?)(?:  |$)", line)
        if begin:
            names += re.findall(r"(?<![\w-])--?[a-z][a-z0-9-]*", re.sub(r"<.*?>|=\w+", "", begin.group(1)))
    return names


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name) / "usr"
        run(CMAKE, "--install", BUILD, "--prefix", cls.root)
        cls.share = cls.root / "share"
        cls.man = cls.share / "man/man1"
        # Nothing but what was installed, and no home.
        cls.env = {"PATH": f"{cls.root}/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8", "HOME": f"{cls.folder.name}/home"}
        cls.cli = cls.root / "bin/suffuse-cli"
        top = run(cls.cli, "--help", env=cls.env)
        cls.commands = re.findall(r"^  ([a-z]+) +\S", top, re.MULTILINE)
        cls.help = {name: run(cls.cli, name, "--help", env=cls.env) for name in cls.commands}
        cls.editor_help = run(cls.root / "bin/suffuse", "--help", env=cls.env)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def needs(self, tool):
        if not shutil.which(tool):
            self.skipTest(f"{tool} is not installed")

    def test_files(self):
        for name in (f"applications/{ID}.desktop", f"metainfo/{ID}.metainfo.xml", f"mime/packages/{ID}.xml",
                     f"thumbnailers/{ID}.thumbnailer", f"icons/hicolor/scalable/apps/{ID}.svg"):
            self.assertTrue((self.share / name).is_file(), name)
        samples = sorted(path.name for path in (self.share / "suffuse/samples").iterdir())
        self.assertEqual(samples, sorted(path.name for path in (SOURCE / "packaging/samples").glob("*.suffuse")))
        self.assertGreaterEqual(len(self.commands), 10)

    def test_extensions(self):
        """Those that came along are found, and each has what its manifest starts."""
        listed = json.loads(run(self.cli, "extension", "list", "--json", env=self.env))
        shipped = sorted(path.parent.name for path in (SOURCE / "packaging/extensions").glob("*/manifest.json"))
        self.assertEqual(sorted(each["id"] for each in listed["extensions"]), shipped)
        for each in listed["extensions"]:
            self.assertEqual((each["problem"], each["own"]), ("", False))
            folder = pathlib.Path(each["folder"])
            self.assertTrue(folder.is_relative_to(self.share), folder)
            self.assertTrue(list(folder.glob("*.py")), folder)

    def test_programs_that_desktops_start(self):
        service = (self.share / f"dbus-1/services/{ID}.service").read_text()
        self.assertIn(f"Name={ID}\nExec={self.root}/bin/suffuse --service\n", service)
        desktop = (self.share / f"applications/{ID}.desktop").read_text()
        for line in re.findall(r"^Exec=(.*)$", desktop, re.MULTILINE):
            program, *words = line.split()
            self.assertEqual(program, "suffuse")
            self.assertLessEqual(set(words) - {"%F"}, set(options_in(self.editor_help)))

    def test_icons(self):
        self.needs("rsvg-convert")
        for size in (16, 22, 24, 32, 48, 64, 128, 256, 512):
            png = (self.share / f"icons/hicolor/{size}x{size}/apps/{ID}.png").read_bytes()
            self.assertEqual([int.from_bytes(png[at:at + 4], "big") for at in (16, 20)], [size, size])

    def test_modules_are_found(self):
        picture = pathlib.Path(self.folder.name) / "a.png"
        sample = self.share / "suffuse/samples/flat.suffuse"
        self.assertEqual(run(self.cli, "render", sample, "-o", picture, "--size", "64", env=self.env), "")
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_thumbnailer(self):
        text = (self.share / f"thumbnailers/{ID}.thumbnailer").read_text()
        self.assertIn("MimeType=application/x-suffuse;", text)
        words = re.search(r"^Exec=(.*)$", text, re.MULTILINE).group(1).split()
        out = pathlib.Path(self.folder.name) / "thumbnail.png"
        values = {"%i": str(SOURCE / "tests/fixtures/v1/extras.suffuse"), "%o": str(out), "%s": "256"}
        program = self.root / "bin" / words[0]
        self.assertEqual(run(program, *(values.get(word, word) for word in words[1:]), env=self.env), "")
        self.assertTrue(out.read_bytes().startswith(b"\x89PNG"))

    def test_man_pages(self):
        pages = {f"suffuse-cli-{name}": text for name, text in self.help.items()} | {"suffuse": self.editor_help}
        self.assertEqual(sorted(path.stem for path in self.man.iterdir()), sorted([*pages, "suffuse-cli"]))
        for name, text in pages.items():
            page = (self.man / f"{name}.1").read_text().replace("\\-", "-")
            commands = re.findall(r"^  ([a-z]+) +\S", text, re.MULTILINE)  # as farm has them
            self.assertGreater(len(options_in(text)) + len(commands), 0, name)
            for command in commands:
                self.assertIn(f"\\fB{command}\\fR", page, name)
            for option in options_in(text):
                self.assertIn(f"\\fB{option}\\fR", page, name)
        overview = (self.man / "suffuse-cli.1").read_text().replace("\\-", "-")
        for name in self.commands:
            self.assertIn(f"\\fB{name}\\fR", overview)
            self.assertIn(f".BR suffuse-cli-{name} (1)", overview)

    def test_man_pages_are_well_formed(self):
        self.needs("groff")
        for page in sorted(self.man.iterdir()):
            said = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-K", "utf8", "-z", page], capture_output=True)
            self.assertEqual((said.returncode, said.stderr.decode()), (0, ""), page.name)

    def completed_by_bash(self, lines):
        """What is offered at the end of each line."""
        script = f"set -u +u; . {BASH_COMPLETION}; cd '{self.folder.name}'\n"
        for program in ("suffuse", "suffuse-cli"):
            script += f". '{self.share}/bash-completion/completions/{program}'\n"
        for line in lines:
            words = " ".join(f"'{word}'" for word in line)
            function = "_suffuse_cli" if line[0] == "suffuse-cli" else "_suffuse"
            script += f"COMP_WORDS=({words}); COMP_CWORD={len(line) - 1}; COMP_LINE='{' '.join(line)}'\n"
            script += f"COMP_POINT=${{#COMP_LINE}}; COMPREPLY=(); {function} 2>/dev/null; echo \"${{COMPREPLY[*]-}}\"\n"
        return [line.split() for line in run("bash", "--norc", "-c", script).splitlines()]

    def test_bash_completion(self):
        self.needs("bash")
        if not os.path.exists(BASH_COMPLETION):
            self.skipTest("bash-completion is not installed")
        pathlib.Path(self.folder.name, "lake.suffuse").touch()
        lines = [["suffuse-cli", ""], ["suffuse-cli", "help", ""]]
        lines += [["suffuse-cli", name, "-"] for name in self.commands]
        lines += [["suffuse", "-"], ["suffuse-cli", "render", "--depth", ""], ["suffuse-cli", "render", "la"],
                  ["suffuse", "la"], ["suffuse-cli", "render", "--backend", "cu"]]
        offered = self.completed_by_bash(lines)
        self.assertEqual(len(offered), len(lines))
        self.assertEqual(set(offered[0]), {*self.commands, "help", "-h", "--help", "-v", "--version"})
        self.assertEqual(offered[1], self.commands)
        for name, options in zip(self.commands, offered[2:]):
            self.assertEqual(options, options_in(self.help[name]), name)
        rest = offered[2 + len(self.commands):]
        self.assertEqual([option.rstrip("=") for option in rest[0]], options_in(self.editor_help))
        self.assertEqual(rest[1:], [["8", "16", "half", "float"], ["lake.suffuse"], ["lake.suffuse"], ["cuda"]])

    def test_fish_completion(self):
        self.needs("fish")
        script = ""
        for program in ("suffuse", "suffuse-cli"):
            script += f"source '{self.share}/fish/vendor_completions.d/{program}.fish'\n"
        for line in ["suffuse-cli ", "suffuse --", *(f"suffuse-cli {name} --" for name in self.commands)]:
            script += f"echo @; complete -C '{line}'\n"
        parts = run("fish", "--no-config", "-c", script, env=self.env).split("@\n")[1:]
        offered = [[line.split("\t")[0].rstrip("=") for line in part.splitlines()] for part in parts]
        self.assertLessEqual({*self.commands, "help"}, set(offered[0]))
        self.assertLessEqual(set(options_in(self.editor_help)), set(offered[1]))
        for name, options in zip(self.commands, offered[2:]):
            long = {option for option in options_in(self.help[name]) if option.startswith("--")}
            self.assertLessEqual(long, set(options), name)

    def test_zsh_completion(self):
        text = (self.share / "zsh" / "site-functions" / "_suffuse-cli").read_text()
        for name, said in self.help.items():
            branch = text.split(f"    {name})\n", 1)[1].split(";;", 1)[0]
            for option in options_in(said):
                self.assertRegex(branch, rf"'(\([^)]*\))?{option}[=\[]", name)
            self.assertIn(f"    '{name}:", text)
        self.needs("zsh")
        for path in (self.share / "zsh" / "site-functions").iterdir():
            self.assertEqual(run("zsh", "-n", path), "")

    def test_links_of_the_documentation(self):
        self.needs("cmark-gfm")
        pages = {page: page.read_text() for page in (self.share / "doc/suffuse/html").glob("*.html")}
        self.assertGreater(len(pages), 20)
        for page, text in pages.items():
            for link in re.findall(r'(?:href|src)="([^"]*)"', text):
                file, _, place = link.partition("#")
                if "://" not in link:
                    target = page.parent / file if file else page
                    self.assertTrue(target.is_file(), f"{page.name}: {link}")
                    self.assertTrue(not place or f'id="{place}"' in pages[target], f"{page.name}: {link}")

    def test_desktop_file(self):
        self.needs("desktop-file-validate")
        self.assertEqual(run("desktop-file-validate", self.share / f"applications/{ID}.desktop"), "")

    def test_metainfo(self):
        self.needs("appstreamcli")
        said = run("appstreamcli", "validate", "--no-net", self.share / f"metainfo/{ID}.metainfo.xml")
        self.assertNotIn("W:", said)
        self.assertNotIn("E:", said)

    def test_type_of_files(self):
        self.needs("update-mime-database")
        run("update-mime-database", self.share / "mime")
        mime = self.share / "mime"
        self.assertIn(":application/x-suffuse:*.suffuse\n", (mime / "globs2").read_text())
        document = (self.share / "suffuse/samples/flat.suffuse").read_bytes()
        self.assertIn(b"]\n>0=\x00\x0c" + document[:12], (mime / "magic").read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
