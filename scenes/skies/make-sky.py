#!/usr/bin/env python3
"""Writes sunny.hdr, a clear sky with a small bright sun: 64 by 32 pixels by longitude and latitude, the middle towards -z."""

import math
import os

WIDTH, HEIGHT = 64, 32
# Of the one pixel that is the sun: a light of somewhat more than 1 on a surface square to it.
SUN, SUN_COLUMN, SUN_ROW = (620.0, 545.0, 430.0), 54, 8


def direction(column, row):
    latitude = (row + 0.5) / HEIGHT * math.pi
    longitude = ((column + 0.5) / WIDTH - 0.5) * 2 * math.pi
    sine = math.sin(latitude)
    return (sine * math.sin(longitude), math.cos(latitude), -sine * math.cos(longitude))


def mix(a, b, weight):
    return tuple(x + (y - x) * weight for x, y in zip(a, b))


def color(column, row):
    if (column, row) == (SUN_COLUMN, SUN_ROW):
        return SUN
    here, sun = direction(column, row), direction(SUN_COLUMN, SUN_ROW)
    height = here[1]
    if height < 0:
        return mix((0.2, 0.19, 0.17), (0.1, 0.095, 0.085), -height)
    air = mix((0.32, 0.37, 0.43), (0.07, 0.15, 0.34), math.sqrt(height))
    near = max(0.0, sum(x * y for x, y in zip(here, sun)))
    return tuple(x + y * near**12 for x, y in zip(air, (0.6, 0.5, 0.35)))


def rgbe(pixel):
    mantissa, exponent = math.frexp(max(pixel))
    scale = mantissa * 256 / max(pixel)
    return bytes(min(255, round(x * scale)) for x in pixel) + bytes([exponent + 128])


def main():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sunny.hdr")
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH))
        for row in range(HEIGHT):
            # A line of run lengths: each channel in turn, here as it is.
            line = [rgbe(color(column, row)) for column in range(WIDTH)]
            file.write(bytes([2, 2, WIDTH >> 8, WIDTH & 255]))
            for channel in range(4):
                file.write(bytes([WIDTH]) + bytes(pixel[channel] for pixel in line))


main()
