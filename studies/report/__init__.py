# SPDX-License-Identifier: MIT
"""The report: a page of charts, from eq. (17) to the force at the finger, and the data of each.

    PYTHONPATH=studies python3 -m report -o DIR

`scripts/demo` builds the command and calls it. It needs matplotlib. Its numbers come from the command `limitcurve`; it
imports nothing compiled.
"""
