#!/usr/bin/env python3
"""html_docs.py SOURCE FOLDER: README.md, the pages of docs/ and what people who build Suffuse read, as HTML in FOLDER.

cmark-gfm turns each page into HTML; links among the pages lead to each other, README.md is index.html.
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys

STYLE = """
:root { color-scheme: light dark; }
body { font: 1rem/1.55 sans-serif; max-width: 52rem; margin: 0 auto; padding: 1.5rem; }
img { max-width: 100%; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
td, th { border: 1px solid #8888; padding: 0.25rem 0.6rem; text-align: left; vertical-align: top; }
pre { overflow-x: auto; padding: 0.75rem; background: #8882; }
code { font-family: monospace; }
"""


def place_of(page, source):
    """The file of a page among the HTML files."""
    name = page.relative_to(source).stem
    return "index.html" if name == "README" else f"{name.lower()}.html"


def anchor(heading):
    """The name by which links reach a heading, as in repositories on the web."""
    plain = html.unescape(re.sub(r"<[^>]*>", "", heading)).lower()
    return re.sub(r" ", "-", re.sub(r"[^\w\- ]", "", plain))


def body_of(page, source, places):
    done = subprocess.run(["cmark-gfm", "-e", "table", "-t", "html", page], check=True, capture_output=True)
    text = done.stdout.decode()
    text = re.sub(r"<h(\d)>(.*?)</h\1>", lambda m: f'<h{m[1]} id="{anchor(m[2])}">{m[2]}</h{m[1]}>', text)

    def link(match):
        target, _, place = match[1].partition("#")
        if "://" in target:
            return match[0]
        place = "#" + place if place else ""
        file = (page.parent / target).resolve() if target else page
        if file in places:
            return f'<a href="{places[file]}{place}">{match[2]}</a>'
        return match[2]  # a file of the sources, which is not here

    def picture(match):
        return f'src="pictures/{pathlib.PurePosixPath(match[1]).name}"'

    text = re.sub(r'<a href="([^"]*)">(.*?)</a>', link, text, flags=re.DOTALL)
    return re.sub(r'src="((?:docs/)?pictures/[^"]*)"', picture, text)


def main():
    source, into = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    pages = [source / "README.md", source / "ARCHITECTURE.md", source / "CONTRIBUTING.md",
             *sorted((source / "docs").glob("*.md"))]
    places = {page: place_of(page, source) for page in pages}
    shutil.rmtree(into, ignore_errors=True)
    into.mkdir(parents=True)
    for page, place in places.items():
        body = body_of(page, source, places)
        title = re.search(r"<h1[^>]*>(.*?)</h1>", body, re.DOTALL)
        title = re.sub(r"<[^>]*>", "", title[1]) if title else page.stem
        home = "" if place == "index.html" else '<p><a href="index.html">Suffuse</a></p>\n'
        text = (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{title}</title>\n'
                f"<style>{STYLE}</style>\n</head>\n<body>\n{home}{body}</body>\n</html>\n")
        (into / place).write_text(text, encoding="utf-8")
    pictures = into / "pictures"
    pictures.mkdir()
    for picture in sorted((source / "docs/pictures").iterdir()):
        shutil.copyfile(picture, pictures / picture.name)


if __name__ == "__main__":
    main()
