# SPDX-License-Identifier: MIT
"""`python3 -m report -o DIR`: writes the report."""

import argparse
import signal
import sys
import time
from pathlib import Path

from .command import Command, Failed


class Progress:
    """How far the report is, as the command says it: a bar on a terminal; elsewhere a line after 5 s,
    then after 5 s or a tenth of the time."""

    def __init__(self):
        self.began = self.said = time.monotonic()
        self.bar = sys.stderr.isatty()

    def say(self, share):
        now = time.monotonic()
        status = f"{100 * share:.0f} %, {now - self.began:.0f} s"
        if self.bar:
            print(f"\rreport: [{'#' * int(20 * share):20}] {status}", end="", file=sys.stderr, flush=True)
        elif now - self.said > max(5, (now - self.began) / 10):
            print(f"report: {status}", file=sys.stderr, flush=True)
            self.said = now

    def clear(self):
        if self.bar:
            print(f"\r{60 * ' '}\r", end="", file=sys.stderr, flush=True)


def write_report(command, folder, progress):
    """All files of the report."""
    from . import csv_files, page, story  # here, for they need matplotlib
    folder.mkdir(parents=True, exist_ok=True)
    steps = len(csv_files.PARTS) + len(story.FIGURES)
    files = csv_files.CsvFiles(command, folder)
    for done, part in enumerate(csv_files.PARTS, 1):
        part(files)
        progress.say(done / steps)
    data = page.Data(folder)
    pictures = {}
    for done, (name, draw) in enumerate(story.FIGURES.items(), len(csv_files.PARTS) + 1):
        pictures[name] = page.picture(data, draw, name)
        progress.say(done / steps)
    numbers = story.numbers_to_remember(data)
    page.write(data, numbers, story.sections(data), pictures)
    progress.clear()
    print(f"{folder}/index.html  the report: {len(pictures)} figures, each beside it as SVG and PNG")
    tables = data["materials"].column("file")
    print(f"{folder}/*.csv       the data it is drawn from, and {len(tables)} look-up tables: {', '.join(tables)}")
    print("To remember:")
    for number, (_, words) in enumerate(numbers, 1):
        print(f"  {number}. {words}")


def main():
    parser = argparse.ArgumentParser("report", description="Writes index.html, a page of charts, its figures and their data.")
    parser.add_argument("-o", "--output", required=True, type=Path, metavar="DIR", help="output folder; created if it does not exist")
    parser.add_argument("--command", default="limitcurve", metavar="FILE", help="the executable to ask (%(default)s)")
    arguments = parser.parse_args()
    progress = Progress()
    try:
        write_report(Command([arguments.command]), arguments.output, progress)
        return
    except KeyboardInterrupt:
        progress.clear()
        print("report: interrupted", file=sys.stderr, flush=True)
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        signal.raise_signal(signal.SIGINT)  # a shell that called this is to know
    except ModuleNotFoundError as error:
        complaint = f"{error.name} is missing: install python3-matplotlib"
    except OSError as error:
        complaint = f"cannot write '{error.filename}': {error.strerror}"
    except Failed as error:
        complaint = str(error)
    progress.clear()
    sys.exit(f"report: error: {complaint}")


if __name__ == "__main__":
    main()
