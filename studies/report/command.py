# SPDX-License-Identifier: MIT
"""The command `limitcurve`, from which the report has its numbers."""

import csv
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor


class Failed(Exception):
    """A run failed; the message is what it said."""


class Command:
    """Runs of the command that `words` call, as many at a time as there are processors."""

    def __init__(self, words):
        self.words = words
        self.pool = ThreadPoolExecutor(os.cpu_count())

    def stream(self, arguments):
        """What one run prints, row by row: a dictionary of texts each. A run ends with its reader."""
        call = [*self.words, *map(str, arguments), "--quiet"]
        pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        try:
            process = subprocess.Popen(call, **pipes, encoding="utf-8")
        except OSError as error:
            raise Failed(f"cannot run '{call[0]}': {error.strerror}") from error
        with process:
            lines = csv.reader(process.stdout)
            header = next(lines, ())
            for line in lines:
                yield dict(zip(header, line))
            said = process.stderr.read()
        if process.returncode:
            said = said.strip().split("\n")[-1].removeprefix("limitcurve: error: ")
            raise Failed(said or f"{' '.join(call)}: exit status {process.returncode}")

    def rows(self, *arguments):
        return list(self.stream(arguments))

    def each(self, calls, take=list):
        """What `take` makes of the rows of each run, given by lists of arguments, in their order."""
        return list(self.pool.map(lambda arguments: take(self.stream(arguments)), calls))


def numbers(rows, *names):
    """Columns of rows as numbers: for each row a list."""
    return [[float(row[name]) for name in names] for row in rows]


def listed(values):
    """A list for an option, every digit of it."""
    return ",".join(map(repr, values))
