# SPDX-License-Identifier: MIT
"""`python -m limitcurve`: the command `limitcurve`."""

import sys

from ._command import main

sys.exit(main())
