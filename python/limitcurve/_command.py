# SPDX-License-Identifier: MIT
"""The command `limitcurve` of the wheel."""

import signal
import sys

from . import _core


def main() -> int:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # C++ code runs, and does not check Python's signals
    return _core.main(sys.argv[1:])
