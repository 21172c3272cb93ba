# SPDX-License-Identifier: MIT
"""The command `limitcurve` of the wheel."""

import os
import pathlib
import signal
import sys


def main() -> int:
    os.environ.setdefault("LIMITCURVE_SHARE", str(pathlib.Path(__file__).parent / "share"))
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # C++ code runs, and does not check Python's signals
    from . import _commands

    return _commands.main(sys.argv[1:])
