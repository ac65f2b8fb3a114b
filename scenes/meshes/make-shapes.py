#!/usr/bin/env python3
"""Writes the small meshes that scenes of single materials use: disc, silk, sunglasses and carrot.

    python3 make-shapes.py [FOLDER]
"""

import math
import os
import sys

folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))


def number(value):
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Mesh:
    def __init__(self):
        self.points, self.places, self.faces = [], [], []

    def grid(self, columns, rows, point, close=False, places=True):
        """A surface over the unit square, its outside where u x v points; closed, u = 1 is u = 0."""
        first_point, first_place = len(self.points) + 1, len(self.places) + 1
        wide = columns if close else columns + 1
        for row in range(rows + 1):
            for column in range(columns + 1):
                u, v = column / columns, row / rows
                if column < wide:
                    self.points.append(point(u, v))
                if places:
                    self.places.append((u, v))
        for row in range(rows):
            for column in range(columns):
                corners = []
                for c, r in ((column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)):
                    around = r * wide + c % wide
                    place = f"/{first_place + r * (columns + 1) + c}" if places else ""
                    corners.append(f"{first_point + around}{place}")
                self.faces.append(corners)

    def write(self, name, about):
        with open(os.path.join(folder, name), "w", encoding="ascii", newline="\n") as file:
            file.write(f"# {about}\n")
            for kind, rows in (("v", self.points), ("vt", self.places)):
                for row in rows:
                    file.write(" ".join([kind] + [number(x) for x in row]) + "\n")
            for corners in self.faces:
                file.write("f " + " ".join(corners) + "\n")


def disc():
    """A flat ring of the radii 0.125 and 1 round +y: u goes round, v outwards."""
    mesh = Mesh()

    def point(u, v):
        radius, angle = 0.125 + 0.875 * v, -math.tau * u
        return (radius * math.cos(angle), 0, radius * math.sin(angle))

    mesh.grid(96, 1, point, close=True)
    for corners in mesh.faces:
        corners.reverse()
    mesh.write("disc.obj", "A flat ring round +y, radii 0.125 and 1; u goes round, v outwards")


def silk():
    """A cloth in soft folds over a square of side 3: u goes along x, v along -z."""
    mesh = Mesh()

    def point(u, v):
        x, z = 3 * (u - 0.5), 1.5 - 3 * v
        bend = 0.35 * math.sin(1.3 * z + 0.4)
        fold = 0.26 * math.sin(3.1 * (x + bend) + 0.5 * z) + 0.11 * math.sin(5.3 * (x - 0.6 * bend) - 1.9 * z + 1.1)
        swell = 0.12 * math.sin(1.7 * z - 0.8 * x)
        return (x + 0.1 * math.sin(2.2 * z + x), fold * (0.75 + 0.25 * math.cos(z)) + swell + 0.5, z)

    mesh.grid(32, 32, point)
    mesh.write("silk.obj", "A cloth in soft folds over a square of side 3; u goes along x, v along -z")


def sunglasses():
    """The lens of sunglasses, a closed shell 0.05 thick round the origin, 2 wide and 1.6 high, bulging to +z."""
    lens = Mesh()

    def outline(angle):
        c, s = math.cos(angle), math.sin(angle)
        power = 2 / 2.6
        x, y = math.copysign(abs(c) ** power, c), math.copysign(abs(s) ** power, s)
        return x * (1 + 0.1 * y), 0.8 * y * (1 - 0.14 * x)

    def front(radius, angle, lift):
        x, y = outline(angle)
        x, y = radius * x, radius * y
        return (x, y, lift + 0.55 - 0.28 * x * x - 0.14 * y * y - 0.3)

    rows = [(0.04, 0.05), (0.3, 0.05), (0.55, 0.05), (0.78, 0.05), (0.94, 0.05), (0.99, 0.04), (1.0, 0.025), (0.99, 0.01),
            (0.94, 0), (0.78, 0), (0.55, 0), (0.3, 0), (0.04, 0)]
    around = 56

    def vertex(row, column):
        radius, lift = rows[row]
        return front(radius, math.tau * column / around, lift)

    points = [front(0, 0, 0.05)]
    for row in range(len(rows)):
        points += [vertex(row, column) for column in range(around)]
    points.append(front(0, 0, 0))
    lens.points = points
    lens.places = [((x + 1.1) / 2.2, (y + 0.85) / 1.7) for x, y, _ in points]

    def corner(index):
        return f"{index}/{index}"

    for column in range(around):
        after = (column + 1) % around
        lens.faces.append([corner(1), corner(2 + column), corner(2 + after)])
        for row in range(len(rows) - 1):
            a, b = 2 + row * around, 2 + (row + 1) * around
            lens.faces.append([corner(a + column), corner(b + column), corner(b + after), corner(a + after)])
        last = 2 + (len(rows) - 1) * around
        lens.faces.append([corner(len(points)), corner(last + after), corner(last + column)])
    lens.write("lens.obj", "A lens of sunglasses, a closed shell 0.05 thick, bulging to +z; v is the height")

    def tube(path, radius, columns, rows, close):
        """A tube along a path, whose frame is taken from the path and z."""

        def place(u, v):
            step = 1e-4
            before, after = path(u - step), path(u + step)
            along = [b - a for a, b in zip(before, after)]
            size = math.sqrt(sum(x * x for x in along))
            along = [x / size for x in along]
            up = (0, 0, 1) if abs(along[2]) < 0.9 else (0, 1, 0)
            side = [along[1] * up[2] - along[2] * up[1], along[2] * up[0] - along[0] * up[2], along[0] * up[1] - along[1] * up[0]]
            size = math.sqrt(sum(x * x for x in side))
            side = [x / size for x in side]
            top = [side[1] * along[2] - side[2] * along[1], side[2] * along[0] - side[0] * along[2], side[0] * along[1] - side[1] * along[0]]
            c, s = math.cos(math.tau * v), math.sin(math.tau * v)
            return path(u), [c * a + s * b for a, b in zip(side, top)]

        frame.grid(columns, rows,
                   lambda u, v: tuple(p + radius * n for p, n in zip(*place(u, v))), close, places=False)

    frame = Mesh()

    def rim(side):
        def path(u):
            x, y, z = front(1.015, math.tau * u, 0.025)
            return (side * (x + 1.32), y, z)
        return path

    for side in (1, -1):
        tube(rim(side), 0.055, 56, 6, True)
    bridge = lambda u: (-0.36 + 0.72 * u, 0.2 + 0.16 * math.sin(math.pi * min(max(u, 0), 1)), -0.02 + 0.1 * math.sin(math.pi * min(max(u, 0), 1)))
    tube(bridge, 0.05, 10, 6, False)
    for side in (1, -1):
        temple = lambda u, side=side: (side * (2.3 + 0.1 * min(u * 6, 1)), 0.3 - 0.35 * max(0, u - 0.75) * 2, -0.1 - 2.9 * u)
        tube(temple, 0.045, 12, 6, False)
    frame.write("frame.obj", "A frame for two lenses of lens.obj at x -1.32 and 1.32, looking to +z")


def carrot():
    """A carrot from the origin along +z, 0.5 long."""
    mesh = Mesh()

    def point(u, v):
        radius = 0.085 * max(1 - v, 0.02) ** 0.8 * (1 + 0.05 * math.sin(40 * v))
        return (radius * math.cos(math.tau * u), radius * math.sin(math.tau * u), 0.5 * v)

    mesh.grid(14, 8, point, close=True)
    mesh.write("carrot.obj", "A carrot along +z")


disc()
silk()
sunglasses()
carrot()
