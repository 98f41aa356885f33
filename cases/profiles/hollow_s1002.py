#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes hollow_s1002.csv: the profile S1002 with a hollow tread, from a formula.

The new profile is that of profiles.md's zones A to D and the flange (docs/profiles.md names the
source); wear takes w(y) = depth / 2 (1 + cos(pi (y - middle) / half_width)) off the radius within
half_width of the middle of the running band. Call: hollow_s1002.py > hollow_s1002.csv
"""
import math

DEPTH, MIDDLE, HALF_WIDTH = 0.6, -2.0, 32.0  # mm
TREAD = [0.0, -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8,
         5.309217349e-15, -5.957839843e-12, 2.646656573e-13]
FILLET = [-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1,
          -4.169739389e-3, -4.687195829e-5, -2.252755540e-7]


def new(y):
    if y > 32.15796:
        return 1.364323640 - 0.066666667 * y
    if y >= -26:
        return sum(c * y ** k for k, c in enumerate(TREAD))
    if y >= -35:
        return sum(c * y ** k for k, c in enumerate(FILLET))
    if y >= -38.426669071:
        return 16.446 - math.sqrt(13 ** 2 - (y + 26.210665) ** 2)
    if y >= -39.764473993:
        return -93.576667419 - 2.747477419 * y
    if y >= -49.662510381:
        return 8.834924130 + math.sqrt(20 ** 2 - (y + 58.558326413) ** 2)
    return 16 + math.sqrt(12 ** 2 - (y + 55) ** 2)


def worn(y):
    way = (y - MIDDLE) / HALF_WIDTH
    wear = 0.5 * DEPTH * (1 + math.cos(math.pi * way)) if abs(way) < 1 else 0.0
    return new(y) - wear


if __name__ == "__main__":
    print("# S1002 with a hollow tread of 0.6 mm, made by hollow_s1002.py; y to the field side and")
    print("# z outward from the axle, mm")
    print("y, z")
    for number in range(-240, 221):
        y = 0.25 * number
        print(f"{y:.2f}, {worn(y):.6f}")
