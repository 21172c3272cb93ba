# SPDX-License-Identifier: MIT
"""The command `limitcurve` of the wheel."""

import signal
import sys


def main() -> int:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # C++ code runs, and does not check Python's signals
    from . import _commands

    return _commands.main(sys.argv[1:])
