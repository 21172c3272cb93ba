#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the meshes beside it, in metres, each a few kB: OBJ, ascii and binary STL. `--check` writes nothing and exits with 1 if a
file differs from this script's output.

    block.obj      a block of 12 x 4 x 4 cm, as six rectangles
    plate.stl      a plate of 60 x 40 x 1 mm, ascii
    ball.obj       a sphere of radius 5 cm, as 320 triangles with their corners on it
    bracket.stl    an L of two arms of 6 cm, 2 cm thick and 4 cm wide, binary: one inner edge
    star.obj       a ball of 80 triangles with a spike on each: slivers, deep creases, sharp points
"""
import math
import struct
import sys
from pathlib import Path


def box(x, y, z):
    vertices = [(sx * x / 2, sy * y / 2, sz * z / 2) for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, faces


def triangles(faces):
    return [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]


def ball(radius, times):
    golden = (1 + math.sqrt(5)) / 2
    vertices = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden), (0, -1, -golden),
                (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]

    def on_ball(vertex):
        length = math.sqrt(sum(x * x for x in vertex))
        return tuple(radius * x / length for x in vertex)

    vertices = [on_ball(vertex) for vertex in vertices]
    for _ in range(times):
        middles = {}

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(vertices)
                vertices.append(on_ball(tuple((a + b) / 2 for a, b in zip(vertices[i], vertices[j]))))
            return middles[key]

        faces = [part for a, b, c in faces for d, e, f in [(middle(a, b), middle(b, c), middle(c, a))]
                 for part in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))]
    return vertices, faces


def star():
    vertices, faces = ball(0.03, 1)
    spiked = []
    for number, (a, b, c) in enumerate(faces):
        # Spikes of 1 to 5 cm.
        height = 0.01 * (1 + (number * 7) % 5)
        centre = [sum(vertices[i][axis] for i in (a, b, c)) / 3 for axis in range(3)]
        length = math.sqrt(sum(x * x for x in centre))
        vertices.append(tuple(x * (1 + height / length) for x in centre))
        tip = len(vertices) - 1
        spiked += [(a, b, tip), (b, c, tip), (c, a, tip)]
    return vertices, spiked


def bracket():
    outline = [(0, 0), (0.06, 0), (0.06, 0.02), (0.02, 0.02), (0.02, 0.06), (0, 0.06)]
    n = len(outline)
    vertices = [(x, y, z) for z in (-0.02, 0.02) for x, y in outline]
    faces = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    faces += [(n, n + 1, n + 2, n + 3), (n, n + 3, n + 4, n + 5), (0, 3, 2, 1), (0, 5, 4, 3)]
    return vertices, faces


def obj(title, vertices, faces):
    lines = [f"# {title} [m]; made by make_meshes.py"]
    lines += ["v " + " ".join(f"{x:.9g}" for x in vertex) for vertex in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    return ("\n".join(lines) + "\n").encode()


def normal(a, b, c):
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    length = math.sqrt(sum(x * x for x in n))
    return [x / length for x in n]


def ascii_stl(title, vertices, faces):
    lines = [f"solid {title}"]
    for face in triangles(faces):
        corners = [vertices[i] for i in face]
        lines += ["facet normal " + " ".join(f"{x:g}" for x in normal(*corners)), "  outer loop"]
        lines += ["    vertex " + " ".join(f"{x:.9g}" for x in corner) for corner in corners]
        lines += ["  endloop", "endfacet"]
    return ("\n".join(lines + [f"endsolid {title}"]) + "\n").encode()


def binary_stl(title, vertices, faces):
    data = title.encode().ljust(80, b" ") + struct.pack("<I", len(triangles(faces)))
    for face in triangles(faces):
        corners = [vertices[i] for i in face]
        data += struct.pack("<12fH", *normal(*corners), *(x for corner in corners for x in corner), 0)
    return data


FILES = {
    "block.obj": obj("block of 12 x 4 x 4 cm", *box(0.12, 0.04, 0.04)),
    "plate.stl": ascii_stl("plate", *box(0.06, 0.04, 0.001)),
    "ball.obj": obj("ball of radius 5 cm", *ball(0.05, 2)),
    "bracket.stl": binary_stl("bracket", *bracket()),
    "star.obj": obj("star of 80 spikes", *star()),
}


def main():
    folder = Path(__file__).parent
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit("usage: make_meshes.py [--check]")
    for name, content in FILES.items():
        path = folder / name
        if sys.argv[1:]:
            if not path.exists() or path.read_bytes() != content:
                sys.exit(f"{path} is not what make_meshes.py makes")
        else:
            path.write_bytes(content)


if __name__ == "__main__":
    main()
