# SPDX-License-Identifier: MIT
"""`python3 -m report -o DIR`: writes the report."""

import argparse
import sys
from pathlib import Path

from .command import Command, Failed


def write_report(command, folder):
    from . import csv_files, page, story  # here, for they need matplotlib
    folder.mkdir(parents=True, exist_ok=True)
    files = csv_files.CsvFiles(command, folder)
    for part in csv_files.PARTS:
        part(files)
    data = page.Data(folder)
    pictures = {name: page.picture(data, draw, name) for name, draw in story.FIGURES.items()}
    numbers = story.numbers_to_remember(data)
    page.write(data, numbers, story.sections(data), pictures)
    print(f"{folder}/index.html  the report: {len(pictures)} figures, each beside it as SVG and PNG")
    tables = data["materials"].column("file")
    print(f"{folder}/*.csv       the data it is drawn from, and {len(tables)} look-up tables: {', '.join(tables)}")
    print("To remember:")
    for number, (_, words) in enumerate(numbers, 1):
        print(f"  {number}. {words}")


def main():
    parser = argparse.ArgumentParser("report",
                                     description="Writes index.html, a page of charts, its figures and their data.")
    parser.add_argument("-o",
                        "--output",
                        required=True,
                        type=Path,
                        metavar="DIR",
                        help="output folder; created if it does not exist")
    parser.add_argument("--command", default="limitcurve", metavar="FILE", help="the executable to ask (%(default)s)")
    arguments = parser.parse_args()
    try:
        write_report(Command([arguments.command]), arguments.output)
    except ModuleNotFoundError as error:
        sys.exit(f"report: error: {error.name} is missing: install python3-matplotlib")
    except OSError as error:
        sys.exit(f"report: error: cannot write '{error.filename}': {error.strerror}")
    except Failed as error:
        sys.exit(f"report: error: {error}")


if __name__ == "__main__":
    main()
