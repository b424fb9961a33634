#!/usr/bin/env python3
"""Makes the manual's pages (docs/manual) into HTML: make_html.py OUT

Each language has a folder in OUT; OUT/index.html leads to them. Exits with 77 where python3-markdown is missing, and with 1,
naming the page, where a link or a picture leads nowhere.
"""
import html
import pathlib
import re
import shutil
import sys

try:
    import markdown
except ImportError:
    print("make_html.py needs the package python3-markdown.", file=sys.stderr)
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
LANGUAGES = {"en": ("en", "English"), "de": ("de", "Deutsch"), "zh_CN": ("zh-Hans", "简体中文")}
WIDTH = 1.5  # pixels of a picture for one that is shown

STYLE = """
:root { color-scheme: light dark; --ink: #1e1f22; --quiet: #5c5f66; --sheet: #fcfcfc; --side: #f0f0f1; --line: #cfd0d4;
  --link: #275a80; }
@media (prefers-color-scheme: dark) { :root { --ink: #e3e4e6; --quiet: #a6a9af; --sheet: #1c1d20; --side: #2a2c30;
  --line: #45484d; --link: #86b6da; } }
body { margin: 0; display: flex; min-height: 100vh; background: var(--sheet); color: var(--ink);
  font: 1rem/1.6 system-ui, "Noto Sans", "Noto Sans CJK SC", sans-serif; }
nav { flex: 0 0 15rem; padding: 1.5rem; background: var(--side); font-size: .95rem; }
nav h2 { font-size: .85rem; color: var(--quiet); margin: 1.2rem 0 .2rem; }
nav ul { list-style: none; margin: 0; padding: 0; }
nav .here { font-weight: 600; }
main { flex: 1; min-width: 0; max-width: 44rem; padding: 1.5rem 2.5rem 4rem; }
h1 { font-weight: 600; font-size: 1.8rem; line-height: 1.2; }
h2 { font-size: 1.25rem; margin-top: 2rem; }
a { color: var(--link); }
img { max-width: 100%; height: auto; border-radius: 3px; }
table { border-collapse: collapse; width: 100%; }
th, td { border: 1px solid var(--line); padding: .35rem .6rem; text-align: left; vertical-align: top; }
th { background: var(--side); }
pre { background: var(--side); padding: .8rem 1rem; overflow: auto; line-height: 1.4; }
code { font-size: .9em; }
@media (max-width: 50rem) { body { display: block; } main { padding: 1rem; } }
"""

PAGE = """<!DOCTYPE html>
<html lang="{lang}">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} – {manual}</title><link rel="stylesheet" href="../style.css"></head>
<body>
<nav>
{contents}
</nav>
<main>
{body}
</main>
</body>
</html>
"""


def title_of(text):
    return text.split("\n", 1)[0].removeprefix("# ").strip()


def contents_of(index, here):
    """The contents page as a list of links, the page that is shown marked."""
    rows = [f'<p><a href="index.html"{mark(here == "index")}>{html.escape(title_of(index))}</a></p>']
    is_open = False
    for line in index.split("\n"):
        link = re.match(r"- \[(.*)\]\((.*)\.md\)", line)
        if line.startswith("## "):
            rows.append(("</ul>" if is_open else "") + f"<h2>{html.escape(line[3:])}</h2><ul>")
            is_open = True
        elif link:
            rows.append(f'<li><a href="{link[2]}.html"{mark(here == link[2])}>{html.escape(link[1])}</a></li>')
    return "\n".join(rows) + "</ul>"


def mark(is_here):
    return ' class="here" aria-current="page"' if is_here else ""


def png_width(path):
    return int.from_bytes(path.read_bytes()[16:20], "big")


def body_of(text, folder, page):
    made = markdown.markdown(text, extensions=["tables", "fenced_code", "sane_lists"])
    for target in re.findall(r'(?:href|src)="([^"#]+)"', made):
        if "://" not in target and not (folder / target).is_file():
            sys.exit(f"{folder.name}/{page}.md: {target} is not there.")
    made = re.sub(r'href="([a-z-]+)\.md"', r'href="\1.html"', made)

    def sized(match):
        return f'{match[0]} width="{round(png_width(folder / match[1]) / WIDTH)}"'
    return re.sub(r'src="([^"]+)"', sized, made)


def main():
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    (out / "style.css").write_text(STYLE.lstrip(), encoding="utf-8")
    shutil.copytree(HERE / "pictures", out / "pictures", dirs_exist_ok=True)
    links = []
    for code, (lang, name) in LANGUAGES.items():
        folder = HERE / code
        (out / code).mkdir(exist_ok=True)
        index = (folder / "index.md").read_text(encoding="utf-8")
        links.append(f'<li lang="{lang}"><a href="{code}/index.html">{html.escape(title_of(index))}</a> ({name})</li>')
        for file in sorted(folder.glob("*.md")):
            text = file.read_text(encoding="utf-8")
            (out / code / f"{file.stem}.html").write_text(
                PAGE.format(lang=lang, title=html.escape(title_of(text)), manual=html.escape(title_of(index)),
                            contents=contents_of(index, file.stem), body=body_of(text, folder, file.stem)),
                encoding="utf-8")
    (out / "index.html").write_text(
        '<!DOCTYPE html>\n<html lang="en">\n<head><meta charset="utf-8"><title>Suffuse</title>'
        '<link rel="stylesheet" href="style.css"></head>\n<body><main><h1>Suffuse</h1><ul>' + "\n".join(links) +
        "</ul></main></body>\n</html>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
