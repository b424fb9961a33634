"""What the programs say of themselves by --help, as values.

Man pages and completions are made of it at build time, so that neither can say anything else than the programs do.
"""

import re
import subprocess
from dataclasses import dataclass, field


@dataclass
class Option:
    names: list  # with dashes, short ones first
    value: str  # the name of its value; empty for a switch
    text: str
    joined: bool = False  # --name=VALUE rather than --name VALUE

    @property
    def words(self):
        """The values that the text lists ("8, 16, half or float"), or none."""
        return words_in(self.text) if self.value else []


@dataclass
class Page:
    """A program, or one of its commands."""

    name: str  # as it is typed: "suffuse-cli render"
    usage: str
    paragraphs: list = field(default_factory=list)
    options: list = field(default_factory=list)
    arguments: list = field(default_factory=list)  # name and text
    commands: list = field(default_factory=list)  # name and text


def words_in(text):
    """A list such as "auto, cpu, cuda or reference" that begins the text, stands behind a colon or behind "with"."""
    found = re.search(r"(?:^|: |with )((?:\w+(?: \(default\))?, )+\w+ or \w+)", text)
    if not found:
        return []
    words = re.split(r", | or ", found.group(1).replace(" (default)", ""))
    return words if all(word[0].islower() or word[0].isdigit() for word in words) else []


def said(program, *arguments):
    """What a program prints, in English."""
    run = subprocess.run([program, *arguments], check=True, capture_output=True, env={"LC_ALL": "C.UTF-8"})
    return run.stdout.decode()


# "  -o, --output <OUT>   text" of suffuse-cli, and "  --backend=NAME  text" of suffuse.
OPTION = re.compile(r"^  ((?:-\w, )*--?[\w-]+)(?:( <|=)([^ >][^>]*?)>?)?  +(\S.*)$")
ITEM = re.compile(r"^  (\S+) +(\S.*)$")


def page_of(name, text):
    lines = text.splitlines()
    page = Page(name, lines[0].split(": ", 1)[1])
    room = "text"
    paragraph = []

    def end_paragraph():
        if paragraph:
            page.paragraphs.append(" ".join(paragraph))
            paragraph.clear()

    items = None
    for line in lines[1:]:
        option, item = OPTION.match(line), ITEM.match(line)
        if line in ("Options:", "Arguments:"):
            end_paragraph()
            room = line[:-1]
        elif not line.strip():
            end_paragraph()
            items = None
        elif option and room in ("text", "Options"):
            end_paragraph()
            names, joint, value, words = option.groups()
            page.options.append(Option(names.split(", "), value or "", words, joint == "="))
            items = page.options
        elif line.startswith("   ") and items:
            if items is page.options:
                items[-1].text += " " + line.strip()
            else:
                items[-1] = (items[-1][0], items[-1][1] + " " + line.strip())
        elif item and line.startswith("  "):
            end_paragraph()
            items = page.arguments if room == "Arguments" else page.commands
            items.append(item.groups())
        else:
            paragraph.append(line.strip())
    end_paragraph()
    return page


def editor_page(program):
    return page_of("suffuse", said(program, "--help"))


def cli_pages(program):
    """The page of suffuse-cli, then one for each command."""
    top = page_of("suffuse-cli", said(program, "--help"))
    top.options += [
        Option(["-h", "--help"], "", "Shows this help."),
        Option(["-v", "--version"], "", "Prints the version."),
    ]
    return [top] + [page_of(f"suffuse-cli {name}", said(program, name, "--help")) for name, _ in top.commands]
