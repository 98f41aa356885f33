#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes crossing.sections and the sections it lists: wing rail and nose of a crossing.

y to the field side from the gauge line, z down, mm. The wing rail moves outwards by 1:15; the nose
widens by as much, rises by 1:120 and is level from there on. Both heads are chains of straight lines
and tangent arcs; the joints are the features. All numbers are made up. Call: make_crossing.py
"""
import math
import os

STEP, LAST = 10, 240  # mm along the track
SPREAD, RISE = 1 / 15, 1 / 120
ROUNDED = (140.0, 200.0)  # mm: from the rise to the level
NOSE_TOP = 0.6  # mm, where it is level; the wing rail's crown has its corner at z = 0
CROWN, CROWN_START = 60.0, (8.0, math.radians(-14))  # of the nose: radius; y and angle at the gauge corner
GROOVE, DEPTH = 44.0, 18.0  # mm
STEEP = math.radians(75)


def nose_height(s):
    """z of the crown's uppermost place: a parabola rounds the end of the rise."""
    start, end = ROUNDED
    below = end - s if s < start else 0.0
    low = RISE * (below - 0.5 * (end - start)) if below else RISE * max(0.0, end - s) ** 2 / (2 * (end - start))
    return NOSE_TOP + low


class Chain:
    """Points of a line that turns by arcs; angles are positive where it falls."""

    def __init__(self, y, z, angle):
        self.points, self.angle, self.length, self.joints = [(y, z)], angle, 0.0, []

    def straight(self, length):
        self._go(length, 0.0, 3.0)

    def arc(self, radius, angle):
        """To an angle; convex if that is larger."""
        self._go(radius * abs(angle - self.angle), angle - self.angle, 0.5 if radius < 50 else 1.0)

    def _go(self, length, turn, step):
        (y, z), start, count = self.points[-1], self.angle, max(2, math.ceil(length / step))
        for k in range(1, count + 1):
            along, half = length * k / count, 0.5 * turn * k / count
            chord = along * (math.sin(half) / half if half else 1.0)
            self.points.append((y + chord * math.cos(start + half), z + chord * math.sin(start + half)))
        self.angle += turn
        self.length += length
        self.joints.append(self.length)

    def down_to(self, z):
        """Straight on until that height is reached."""
        self.straight((z - self.points[-1][1]) / math.sin(self.angle))


def section(s):
    """The chain at one position: nose, groove, wing."""
    y, tilt = CROWN_START
    z = nose_height(s) + CROWN * (1 - math.cos(tilt))
    corner = 8.0
    chain = Chain(y - corner * (math.sin(tilt) + math.sin(STEEP)), z + corner * (math.cos(tilt) - math.cos(STEEP)), -STEEP)
    below = 8.0  # mm of the gauge face
    chain.points = [(chain.points[0][0] - below * math.cos(STEEP), chain.points[0][1] + below * math.sin(STEEP))]
    chain.straight(below)
    chain.arc(corner, tilt)
    width = 4.0 + s * SPREAD
    chain.arc(CROWN, math.asin(math.sin(tilt) + width / CROWN))
    edge = y + width
    chain.arc(5.0, STEEP)
    fillet = 4.0
    floor = DEPTH - fillet * (1 - math.cos(STEEP))
    chain.down_to(floor)
    chain.arc(fillet, 0.0)
    # The wing: its crown begins a groove's width beyond the nose's.
    wing, lean, round_ = edge + GROOVE, math.radians(-4.5), 12.0
    foot_y = wing - round_ * (math.sin(lean) + math.sin(STEEP))
    foot_z = round_ * (math.cos(lean) - math.cos(STEEP))
    flank = (floor - foot_z) / math.sin(STEEP)
    fillet_start = foot_y - flank * math.cos(STEEP) - fillet * math.sin(STEEP)
    chain.straight(fillet_start - chain.points[-1][0])
    chain.arc(fillet, -STEEP)
    chain.straight(flank)
    chain.arc(round_, lean)
    chain.arc(300.0, math.radians(2.0))
    return chain


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    os.makedirs(os.path.join(here, "crossing"), exist_ok=True)
    with open(os.path.join(here, "crossing.sections"), "w", encoding="utf-8") as listed:
        listed.write("# Wing rail and nose of a crossing, by make_crossing.py\n"
                     "# position (mm), file, arc lengths of the joints (mm)\n")
        for s in range(0, LAST + 1, STEP):
            chain, name = section(s), f"crossing/{s:03d}.csv"
            with open(os.path.join(here, name), "w", encoding="utf-8") as out:
                out.write("".join(f"{y:.6f}, {z:.6f}\n" for y, z in chain.points))
            listed.write(f"{s:4d}  {name}  " + "  ".join(f"{at:.4f}" for at in chain.joints[:-1]) + "\n")
