# SPDX-License-Identifier: MIT
"""Shared by the tests of patches: files of twists, and the wrench of points as a sum."""

import math
import tempfile
import unittest
from pathlib import Path

from command_line import rows, run


class PatchCase(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def file(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def twists(self, *twists):
        return self.file("twists.csv", "vx,vy,omega\n" + "".join(f"{x!r},{y!r},{w!r}\n" for x, y, w in twists))

    def wrenches(self, patch, *twists, **options):
        arguments = [text for name, value in options.items() for text in (f"--{name}", value)]
        return rows("patch", "--quiet", "--patch", patch, "--twists", self.twists(*twists), *arguments)

    def refused(self, patch, *parts):
        done = run("patch", "--patch", patch, "--twists", self.twists((1.0, 0.0, 0.0)))
        self.assertEqual(done.returncode, 2, patch)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"\Alimitcurve: error: [^\n]*\n\Z")
        for part in parts:
            self.assertIn(part, done.stderr)


def by_points(points, twist, mx=1.0, my=1.0):
    """Power and wrench of weighted points about the origin."""
    vx, vy, omega = twist
    total = math.fsum(load for _, _, load in points)
    sums = [[], [], [], []]
    for x, y, load in points:
        ux, uy = mx * (vx - omega * y), my * (vy + omega * x)
        speed = math.hypot(ux, uy)
        if speed > 0:
            share = load / total
            fx, fy = share * mx * ux / speed, share * my * uy / speed
            for terms, value in zip(sums, (fx, fy, x * fy - y * fx, share * speed)):
                terms.append(value)
    return [math.fsum(terms) for terms in sums]
