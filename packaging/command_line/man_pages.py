#!/usr/bin/env python3
"""man_pages.py SUFFUSE|- SUFFUSE-CLI VERSION DATE FOLDER: a man page for each program and each command, into FOLDER."""

import pathlib
import sys

from help_text import cli_pages, editor_page

WHAT = {
    "suffuse": "paint with strokes that diffuse and stay editable",
    "suffuse-cli": "draw, convert and examine paintings without a window",
}
EXIT = [
    ("0", "The work is done."),
    ("1", "The work failed; standard error names the file, the place and what to do."),
    ("2", "Wrong usage; standard error says what was expected."),
]
EXIT_OF_DIFF = [
    ("0", "Both hold the same painting."),
    ("1", "They differ."),
    ("2", "Trouble, or wrong usage; standard error says what was expected."),
]


def roff(text):
    """Text as roff has it: no escapes, no requests, hyphens that are minus signs."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


def dashed(name):
    return name.replace(" ", "-")


def option_line(option):
    names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option.names)
    if option.value:
        names += ("=" if option.joined else " ") + f"\\fI{roff(option.value)}\\fR"
    return names


def usage_line(page):
    words = page.usage[len(page.name):].strip().split(" ")
    return f".B {roff(page.name)}\n" + " ".join(roff(word) for word in words) + "\n"


def page_text(page, what, see, version, date):
    out = [f'.TH {roff(dashed(page.name)).upper()} 1 "{date}" "Suffuse {version}" "User Commands"']
    out += [".SH NAME", f"{roff(dashed(page.name))} \\- {roff(what)}", ".SH SYNOPSIS", usage_line(page).rstrip()]
    out.append(".SH DESCRIPTION")
    for paragraph in page.paragraphs:
        if not paragraph.startswith("Exit codes:"):
            out += [".PP", roff(paragraph)]
    for title, items in (("COMMANDS", page.commands), ("ARGUMENTS", page.arguments)):
        if items:
            out.append(f".SH {title}")
        for name, text in items:
            out += [".TP", f"\\fB{roff(name)}\\fR", roff(text[:1].upper() + text[1:])]
    if page.options:
        out.append(".SH OPTIONS")
    for option in page.options:
        out += [".TP", option_line(option), roff(option.text)]
    out.append(".SH EXIT STATUS")
    for code, text in EXIT_OF_DIFF if page.name.endswith(" diff") else EXIT:
        out += [".TP", f"\\fB{code}\\fR", roff(text)]
    out += [".SH SEE ALSO", ",\n".join(f".BR {roff(name)} (1)" for name in see).replace(" (1),\n", " (1),\n")]
    return "\n".join(out) + "\n"


def main():
    editor, cli, version, date, folder = sys.argv[1:]
    pages = cli_pages(cli)
    if editor != "-":
        pages.append(editor_page(editor))
    what = dict(WHAT)
    for name, text in pages[0].commands:
        what[f"suffuse-cli {name}"] = text
    names = [dashed(name) for name in what]
    into = pathlib.Path(folder)
    into.mkdir(parents=True, exist_ok=True)
    for page in pages:
        name = dashed(page.name)
        if page.name == "suffuse-cli":
            see = [other for other in names if other != name]
        else:
            see = ["suffuse"] * (name != "suffuse") + ["suffuse-cli"]
        text = page_text(page, what[page.name], see, version, date)
        (into / f"{name}.1").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
