# SPDX-License-Identifier: MIT
"""The report: a page of charts, from eq. (17) to the force at the finger, and the data of each.

    python3 -m limitcurve.report -o DIR

It needs matplotlib. Its numbers come from the command `limitcurve`; it imports nothing compiled.
"""
