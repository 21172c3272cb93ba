#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""That the compiler refuses what would compile and be wrong, in words that help.

    refused_code.py COMPILER INCLUDE_FOLDERS...    checks refused_code.cpp beside it
Exit status: 0 every marked line is refused with its words and the rest compiles, 1 not."""
import re
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).with_name("refused_code.cpp")


def errors(compiler, folders, *options):
    """The compiler's exit status and what it says."""
    command = [compiler, "-std=c++20", "-fsyntax-only", *options, *[f"-I{folder}" for folder in folders], str(SOURCE)]
    run = subprocess.run(command,
                         capture_output=True,
                         text=True,
                         check=False,
                         env={
                             "LC_ALL": "C",
                             "PATH": "/usr/bin:/bin"
                         })
    return run.returncode, run.stderr


def main(compiler, *folders):
    for options in ([], ["-fno-exceptions"]):
        status, text = errors(compiler, folders, *options)
        if status != 0:
            print(f"what is right does not compile {' '.join(options)}:\n{text}")
            return 1
    _, text = errors(compiler, folders, "-DWRONG", "-ferror-limit=0" if "clang" in compiler else "-fmax-errors=0")
    # An error in a header belongs to the line of the source that asked for it: GCC names it before, Clang after.
    lines, said = text.splitlines(), {}
    for i, line in enumerate(lines):
        if "error:" in line:
            own = re.findall(re.escape(SOURCE.name) + r":(\d+):", line)
            around = re.findall(re.escape(SOURCE.name) + r":(\d+):", "\n".join(lines[max(i - 4, 0) : i + 5]))
            for place in own or around:
                said.setdefault(int(place), []).append(line)
    failed = 0
    for number, line in enumerate(SOURCE.read_text().splitlines(), 1):
        mark = re.search(r"// wrong: (.*)", line)
        if mark and not any(mark[1] in words for words in said.get(number, [])):
            print(f"{SOURCE.name}:{number}: expected an error that says '{mark[1]}', got {said.get(number, 'none')}")
            failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
