#!/usr/bin/env python3
"""completions.py SUFFUSE|- SUFFUSE-CLI FOLDER: completions for bash, zsh and fish, into FOLDER."""

import pathlib
import sys

from help_text import cli_pages, editor_page

# Values that are files, by the name that they have in the help.
FILES = {"FILE", "FIT", "MASK", "OUT", "PRESET"}
PAINTINGS = ["suffuse", "json", "csv", "excalidraw", "dat", "xopp", "svg", "svgz", "pdf", "ora", "psd", "xml"]


def takes_files(option):
    return option.value in FILES and not option.words


def quoted(text):
    """For single quotes of a shell."""
    return text.replace("'", "'\\''")


def first_sentence(text):
    return text.split(". ")[0].rstrip(".")


def spellings(options):
    """Every name as it is typed: "--backend=" where the value is joined."""
    return [name + ("=" if option.joined else "") for option in options for name in option.names]


# bash ---------------------------------------------------------------------------------------------------------------


def bash_values(options):
    """The branches of a case over the option before the cursor."""
    lines = []
    for option in options:
        if not option.value:
            continue
        names = "|".join(option.names)
        if option.words:
            words = " ".join(option.words)
            lines.append(f"        {names}) COMPREPLY=($(compgen -W '{words}' -- \"$current\")); return ;;")
        elif takes_files(option):
            lines.append(f"        {names}) _filedir; return ;;")
        else:
            lines.append(f"        {names}) return ;;")
    return lines


def bash_for_cli(pages):
    top, commands = pages[0], pages[1:]
    names = [page.name.split()[1] for page in commands]
    words = " ".join(names + ["help"])
    out = [
        "# bash completion for suffuse-cli, made of what suffuse-cli --help says.",
        "_suffuse_cli()",
        "{",
        "    local cur prev words cword",
        "    _init_completion || return",
        "    local current=$cur before=$prev command=${words[1]}",
        "    if [ \"$cword\" -eq 1 ]; then",
        f"        COMPREPLY=($(compgen -W '{words} {' '.join(spellings(top.options))}' -- \"$current\"))",
        "        return",
        "    fi",
        "    case $command in",
    ]
    for name, page in zip(names, commands):
        out.append(f"    {name})")
        values = bash_values(page.options)
        if values:
            out += ["        case $before in", *values, "        esac"]
        options = " ".join(spellings(page.options))
        out += [
            "        if [[ $current == -* ]]; then",
            f"            COMPREPLY=($(compgen -W '{options}' -- \"$current\"))",
            "        else",
            "            _filedir",
            "        fi",
            "        ;;",
        ]
    out += [
        f"    help) COMPREPLY=($(compgen -W '{' '.join(names)}' -- \"$current\")) ;;",
        "    esac",
        "} &&",
        "    complete -F _suffuse_cli suffuse-cli",
    ]
    return "\n".join(out) + "\n"


def bash_for_editor(page):
    out = [
        "# bash completion for suffuse, made of what suffuse --help says.",
        "_suffuse()",
        "{",
        "    local cur prev words cword split",
        "    _init_completion -s || return",
        "    local current=$cur before=$prev",
        "    case $before in",
        *bash_values([option for option in page.options if option.value]),
        "    esac",
        "    if [[ $current == -* ]]; then",
        f"        COMPREPLY=($(compgen -W '{' '.join(spellings(page.options))}' -- \"$current\"))",
        "        [[ ${COMPREPLY-} == *= ]] && compopt -o nospace",
        "    else",
        f"        _filedir '@({'|'.join(PAINTINGS)})'",
        "    fi",
        "} &&",
        "    complete -F _suffuse suffuse",
    ]
    return "\n".join(out) + "\n"


# zsh ----------------------------------------------------------------------------------------------------------------


def zsh_option(option):
    """What _arguments takes: each name once, with what it means and what its value is."""
    text = quoted(first_sentence(option.text)).replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")
    value = option.value.replace(":", "\\:").replace("[", "\\[").replace("]", "\\]")
    action = ""
    if option.words:
        action = f":{value}:({' '.join(option.words)})"
    elif option.value:
        action = f":{value}:" + ("_files" if takes_files(option) else " ")
    lines = []
    for name in option.names:
        others = "(" + " ".join(option.names) + ")" if len(option.names) > 1 else ""
        lines.append(f"'{others}{name}{'=' if option.joined else ''}[{text}]{action}'")
    return lines


def zsh_arguments(options, indent):
    lines = [line for option in options for line in zsh_option(option)]
    return f"{indent}_arguments " + f" \\\n{indent}    ".join(lines + ["'*:file:_files'"])


def zsh_for_cli(pages):
    top, commands = pages[0], pages[1:]
    out = ["#compdef suffuse-cli", "# zsh completion for suffuse-cli, made of what suffuse-cli --help says."]
    out += ["_suffuse_cli_command()", "{", "    case $1 in"]
    for page in commands:
        out += [f"    {page.name.split()[1]})", zsh_arguments(page.options, "        "), "        ;;"]
    names = " \\\n".join(f"        '{name}[{quoted(text)}]'" for name, text in top.commands)
    out += ["    help)", "        _values command \\", names, "        ;;", "    esac", "}", ""]
    out += ["local -a commands", "commands=("]
    out += [f"    '{name}:{quoted(text)}'" for name, text in top.commands]
    out += ["    'help:the options of a command'", ")", "if (( CURRENT == 2 )); then", "    _describe command commands"]
    out += [f"    compadd -- {name}" for option in top.options for name in option.names]
    out += ["else", "    local command=$words[2]", "    shift words", "    (( CURRENT-- ))"]
    out += ["    _suffuse_cli_command $command", "fi"]
    return "\n".join(out) + "\n"


def zsh_for_editor(page):
    return "\n".join(["#compdef suffuse", "# zsh completion for suffuse, made of what suffuse --help says.",
                      zsh_arguments(page.options, "")]) + "\n"


# fish ---------------------------------------------------------------------------------------------------------------


def fish_option(program, option, condition):
    line = f"complete -c {program}{condition}"
    for name in option.names:
        line += f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}"
    if option.words:
        line += f" -x -a '{' '.join(option.words)}'"
    elif option.value:
        line += " -r -F" if takes_files(option) else " -x"
    text = quoted(first_sentence(option.text))
    return line + f" -d '{text}'"


def fish_for_cli(pages):
    top, commands = pages[0], pages[1:]
    first = " -n __fish_use_subcommand"
    out = ["# fish completion for suffuse-cli, made of what suffuse-cli --help says."]
    out += [f"complete -c suffuse-cli{first} -f -a {name} -d '{quoted(text)}'" for name, text in top.commands]
    out.append(f"complete -c suffuse-cli{first} -f -a help -d 'the options of a command'")
    out += [fish_option("suffuse-cli", option, first) for option in top.options]
    names = " ".join(name for name, _ in top.commands)
    out.append(f"complete -c suffuse-cli -n '__fish_seen_subcommand_from help' -f -a '{names}'")
    for page in commands:
        condition = f" -n '__fish_seen_subcommand_from {page.name.split()[1]}'"
        out += [fish_option("suffuse-cli", option, condition) for option in page.options]
    return "\n".join(out) + "\n"


def fish_for_editor(page):
    out = ["# fish completion for suffuse, made of what suffuse --help says."]
    out += [fish_option("suffuse", option, "") for option in page.options]
    return "\n".join(out) + "\n"


def main():
    editor_program, cli, folder = sys.argv[1:]
    pages = cli_pages(cli)
    editor = None if editor_program == "-" else editor_page(editor_program)
    into = pathlib.Path(folder)
    files = {"bash/suffuse-cli": bash_for_cli(pages), "zsh/_suffuse-cli": zsh_for_cli(pages),
             "fish/suffuse-cli.fish": fish_for_cli(pages)}
    if editor:
        files |= {"bash/suffuse": bash_for_editor(editor), "zsh/_suffuse": zsh_for_editor(editor),
                  "fish/suffuse.fish": fish_for_editor(editor)}
    for name, text in files.items():
        path = into / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
