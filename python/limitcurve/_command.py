# SPDX-License-Identifier: MIT
"""The command `limitcurve`, as the wheel installs it."""

import os
import pathlib
import signal
import sys


def main() -> int:
    os.environ.setdefault("LIMITCURVE_SHARE", str(pathlib.Path(__file__).parent / "share"))
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # what runs is not Python, and would not notice
    from . import _commands

    return _commands.main(sys.argv[1:])
