#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The man page and the shell completions of the command line, from its --help; every build of the executable makes them.

python3 cli/manual.py EXECUTABLE FOLDER     writes limitcurve.1, limitcurve.bash and _limitcurve (zsh) there
"""

import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Option:
    """An option, or without dashes a positional argument: ["-o", "--output"], "FILE", whether it is required, and its text."""

    names: list[str]
    kind: str
    required: bool
    text: str

    @property
    def choices(self):
        return self.kind.split("|") if "|" in self.kind else []


@dataclass
class Page:
    """The --help of the command or of a subcommand."""

    purpose: str
    options: list[Option] = field(default_factory=list)
    positionals: list[Option] = field(default_factory=list)
    subcommands: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)  # paragraphs
    example: str = ""


def parse(help_text):
    """A page. The parser of the command line indents a name by two spaces and its text further, on the same line or on those below."""
    lines = iter(help_text.splitlines())
    page = Page(purpose=next(lines).strip())
    required, options, subcommands = [], [], []
    entries = {"Positionals": [], "Required": required, "Options": options, "Rare options": options}
    entries |= {"Answers": subcommands, "Numbers": subcommands, "Motions": subcommands}
    section, notes, example = None, [], []
    for line in lines:
        title = line.rstrip(":")
        if line == "Example:":
            section = None
            while line := next(lines, ""):
                example.append(line)
        elif title in entries and line.endswith(":"):
            section = entries[title]
        elif section is not None and (match := re.fullmatch(r" {2}(\S.*?)(?: {2,}(\S.*))?|( {3,}\S.*)", line)) and (match[1] or section):
            # A name that fills its column has one space before its text: the column is where the others begin.
            if match[1] and not match[2] and len(line) > 30 and line[29] == " ":
                section.append([line[2:29].strip(), line[30:]])
            elif match[1]:
                section.append([match[1], match[2] or ""])
            else:
                section[-1][1] = (section[-1][1] + " " + line.strip()).strip()
        elif line and not line.startswith(("Usage: ", " ")) or (line and section is None and notes):
            section = None
            notes.append(line)
        elif not line:
            section = None
            notes.append("")
    page.notes = [paragraph for paragraph in re.split(r"\n{2,}", "\n".join(notes).strip()) if paragraph]
    page.example = "\n".join(example)
    page.subcommands = dict(subcommands)
    for name, listed in (("options", required + options), ("positionals", entries["Positionals"])):
        for head, text in listed:
            names, _, kind = head.partition(" ")
            getattr(page, name).append(Option(names.split(","), kind, listed is not options and [head, text] in required, text))
    return page


class Manual:
    """All pages of an executable."""

    def __init__(self, executable):
        def said(*arguments):
            return subprocess.run([executable, *arguments], capture_output=True, text=True, check=True).stdout

        self.version = said("--version").split()[-1]
        self.whole = parse(said("--help"))
        self.pages = {name: parse(said(name, "--help-all")) for name in self.whole.subcommands}
        # What a law begins with: a shell would break a word at the colon after it.
        laws = [row.split(",")[0].strip('"') for row in said("laws").splitlines()[1:]] + ["samples:", "mix:"]
        wrong = subprocess.run([executable, "translate", "--engine", "?"], capture_output=True, text=True, check=False).stderr
        self.words = {"LAW": list(dict.fromkeys(law.partition(":")[0] + law.partition(":")[1] for law in laws)),
                      "ENGINE": wrong.partition("expected one of ")[2].split()}


def roff(text):
    """Text escaped for groff."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    text = re.sub(r"([|,/])(?=\S)", r"\1\\:", text)  # where a long word may be broken
    return re.sub(r"(?m)^([.'])", r"\\&\1", text)


def man_options(options):
    for option in options:
        names = ", ".join(rf"\fB{roff(name)}\fR" for name in option.names)
        yield f".TP\n{names}" + (rf" \fI{roff(option.kind)}\fR" if option.kind else "")
        yield roff(option.text.rstrip(".") + ("; must be given." if option.required else "."))


def man(manual):
    """The man page, section 1."""
    lines = [f'.TH LIMITCURVE 1 "" "limitcurve {manual.version}" "User Commands"', ".nh", ".ad l", ".SH NAME"]
    lines += [r"limitcurve \- " + roff(manual.whole.purpose[0].lower() + manual.whole.purpose[1:].rstrip("."))]
    lines += [".SH SYNOPSIS", r"\fBlimitcurve\fR \fISUBCOMMAND\fR [\fIoptions\fR]", ".SH DESCRIPTION"]
    lines += [f".PP\n{roff(paragraph)}" for paragraph in manual.whole.notes]
    lines += [".SH OPTIONS", *man_options(manual.whole.options), ".SH SUBCOMMANDS"]
    for name, page in manual.pages.items():
        arguments = "".join(rf" \fI{roff(each.names[0])}\fR" for each in page.positionals)
        lines += [f".SS {roff(name)}", f"{roff(page.purpose)}.", rf".PP{chr(10)}\fBlimitcurve {roff(name)}\fR [\fIoptions\fR]{arguments}"]
        lines += [*man_options(page.positionals), *man_options(page.options)]
        lines += [f".PP\n{roff(paragraph)}" for paragraph in page.notes]
        if page.example:
            lines += [".PP\nExample:\n.PP\n.nf", roff(page.example), ".fi"]
    return "\n".join(lines)


def words_after(manual, option):
    """Completions after an option: its choices, the laws or the engines; nothing if the shell should offer files."""
    return manual.words.get(option.kind.removesuffix(" ..."), option.choices)


def bash(manual):
    """The completion for bash. If it offers nothing, bash offers files."""
    after, others, first = [], set(), []
    for name, page in manual.pages.items():
        offered = [word for option in page.options for word in option.names] + [word for each in page.positionals for word in each.choices]
        first.append(f'      {name}) words="{" ".join(offered)}" ;;')
        for option in page.options:
            patterns = [f"{name}:{each}" for each in option.names]
            if words := words_after(manual, option):
                after.append(f'    {"|".join(patterns)}) words="{" ".join(words)}" ;;')
            elif option.kind:
                others.update(patterns)
    newline = "\n"
    return f"""# bash completion of limitcurve {manual.version}, made from its --help by cli/manual.py.
_limitcurve() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=
  COMPREPLY=()
  case ${{COMP_WORDS[1]}}:${{COMP_WORDS[COMP_CWORD - 1]}} in
{newline.join(after)}
    {"|".join(sorted(others))}) return ;;
    *) case ${{COMP_WORDS[1]}} in
{newline.join(first)}
    esac ;;
  esac
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="{' '.join([*manual.pages, *(each for option in manual.whole.options for each in option.names)])}"
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  case ${{COMPREPLY[0]-}} in *:) compopt -o nospace 2>/dev/null ;; esac
}}
complete -o default -F _limitcurve limitcurve
"""


def zsh_text(text):
    """Within a specification of _arguments in single quotes."""
    return re.sub(r"([\\:\[\]])", r"\\\1", text).replace("'", "'\\''")


def zsh_action(manual, option):
    words = words_after(manual, option)
    if words:
        return "(" + " ".join(zsh_text(word) for word in words) + ")"
    return {"FILE": "_files", "DIR": "_files -/", "": ""}.get(option.kind, "_default")


def zsh(manual):
    """The completion for zsh."""

    def specifications(page):
        for option in page.options:
            for name in option.names:
                argument = f":{zsh_text(option.kind)}:{zsh_action(manual, option)}" if option.kind else ""
                yield f"'*{name}[{zsh_text(option.text)}]{argument}'"
        for number, option in enumerate(page.positionals, 1):
            yield f"'{number}:{zsh_text(option.names[0])}:{zsh_action(manual, option)}'"

    lines = ["#compdef limitcurve", f"# zsh completion of limitcurve {manual.version}, made from its --help by cli/manual.py."]
    lines += ["local -a subcommands", "subcommands=("]
    lines += [f"  '{name}:{zsh_text(purpose)}'" for name, purpose in manual.whole.subcommands.items()]
    lines += [")", "if (( CURRENT == 2 )); then", "  _describe subcommand subcommands"]
    lines += [f"  _arguments {' '.join(specifications(manual.whole))}", "  return", "fi"]
    lines += ["local subcommand=$words[2]", "shift words", "(( CURRENT-- ))", "case $subcommand in"]
    for name, page in manual.pages.items():
        lines += [f"  {name})", "    _arguments \\", " \\\n".join("      " + each for each in specifications(page)), "    ;;"]
    return "\n".join([*lines, "esac"])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: manual.py EXECUTABLE FOLDER")
    manual = Manual(sys.argv[1])
    for name, text in {"limitcurve.1": man(manual), "limitcurve.bash": bash(manual), "_limitcurve": zsh(manual)}.items():
        (Path(sys.argv[2]) / name).write_text(text.rstrip("\n") + "\n", encoding="utf-8")
