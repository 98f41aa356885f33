#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws frames.svg, leading_edge.svg and profile_points.svg beside this file; with --png also as PNG.

Call: /usr/bin/python3 docs/figures/draw.py PROGRAM [--png]; PROGRAM is rollfem, for the points of the profiles.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("agg")
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.patches import Arc, Circle, Ellipse, Polygon, Rectangle

HERE = pathlib.Path(__file__).resolve().parent
INK, BLUE, RED, GREEN, GREY = "#1a1a1a", "#0072B2", "#D55E00", "#009E73", "#8c8c8c"
plt.rcParams.update({"font.size": 9, "svg.fonttype": "none", "svg.hashsalt": "rollfem", "font.family": "sans-serif",
                     "axes.spines.top": False, "axes.spines.right": False})


def arrow(ax, start, end, label="", color=INK, at=(0, 0), width=1.4):
    ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": color, "lw": width, "shrinkA": 0, "shrinkB": 0})
    ax.text(end[0] + at[0], end[1] + at[1], label, color=color, ha="center", va="center")


def turn(ax, middle, radius, first, last, label, color, at):
    """An arc with its arrow head at the angle `last`, degrees."""
    ax.add_patch(Arc(middle, 2 * radius, 2 * radius, theta1=min(first, last), theta2=max(first, last), color=color, lw=1.4))
    angles = np.radians([last - np.sign(last - first) * 8, last])
    p, q = [(middle[0] + radius * np.cos(a), middle[1] + radius * np.sin(a)) for a in angles]
    arrow(ax, p, q, color=color)
    ax.text(middle[0] + at[0], middle[1] + at[1], label, color=color, ha="center", va="center")


def empty(ax, title, x, y):
    ax.set(xlim=x, ylim=y, aspect="equal", title=title)
    ax.axis("off")


def across(ax, x, y, into, label):
    """An axis that points out of the page (into = False) or into it."""
    ax.add_patch(Circle((x, y), 0.16, fill=False, color=INK, lw=1.2))
    if into:
        ax.plot([x - 0.11, x + 0.11], [y - 0.11, y + 0.11], color=INK, lw=1)
        ax.plot([x - 0.11, x + 0.11], [y + 0.11, y - 0.11], color=INK, lw=1)
    else:
        ax.plot([x], [y], ".", color=INK, ms=4)
    ax.text(x - 0.3, y - 0.33, label, ha="center", va="center")


def patch_from_the_wheel(ax):
    empty(ax, "Patch, seen from the wheel", (-5.2, 5.6), (-4, 4.2))
    ax.add_patch(Ellipse((0, 0), 5.6, 4, color=GREY, alpha=0.25, lw=0))
    arrow(ax, (0, 0), (4.2, 0), "x, rolling", at=(0.65, 0.3))
    arrow(ax, (0, 0), (0, 3.3), "y", at=(0.28, 0))
    across(ax, 0, 0, False, "z")
    arrow(ax, (0.5, -1.1), (2.1, -1.1), "ξ, $F_x$", BLUE, (-0.8, -0.35))
    arrow(ax, (-1.1, 0.45), (-1.1, 1.65), "η, $F_y$", BLUE, (-0.8, -0.6))
    turn(ax, (0, 0), 0.95, 20, 150, "φ, $M_z$", BLUE, (0.95, 1.0))
    for y in (-1.0, 0.0, 1.0):
        edge = 2.8 * np.sqrt(1 - (y / 2) ** 2)
        if y:
            arrow(ax, (edge + 1.5, y), (edge + 0.15, y), color=RED, width=1)
    ax.text(4.2, -1.75, "leading edge:\nmaterial enters", color=RED, ha="center", va="center")
    ax.text(-4.1, 0, "trailing\nedge", color=RED, ha="center", va="center")
    ax.text(0.1, -3.2, "positive directions of creepages and of forces on the wheel;\nfriction makes the force along x negative for ξ > 0",
            ha="center", va="center", color=INK)


def side_view(ax):
    empty(ax, "Side view: ξ > 0 brakes the wheel", (-5, 5), (-2.2, 6.2))
    ax.add_patch(Circle((0, 3), 3, fill=False, color=INK, lw=1.4))
    ax.plot([-4.6, 4.6], [0, 0], color=INK, lw=1.4)
    ax.text(-3.9, -0.4, "rail", ha="center")
    turn(ax, (0, 3), 1.2, 150, 40, "rolls", INK, (0, 1.6))
    arrow(ax, (0, 3), (2.4, 3), "V", at=(0.3, 0))
    arrow(ax, (0, 0), (0, 1.7), "z", at=(0.28, 0))
    arrow(ax, (0, 0), (1.9, 0), "x", at=(0.28, 0.3))
    across(ax, 0, 0, True, "y")
    arrow(ax, (-0.3, 0.3), (-2.3, 0.3), "$F_x$ on\nthe wheel", RED, (-1.1, 0.55))
    arrow(ax, (-0.2, -0.85), (1.8, -0.85), "slip of the wheel over the rail", BLUE, (-0.9, -0.45))


def outline(ax, points, side, **look):
    """A closed shape given for the right side."""
    ax.add_patch(Polygon([(side * y, z) for y, z in points], closed=True, edgecolor=INK, lw=1.2, **look))


WHEEL = ((3.75, -0.6), (3.75, -1.5), (3.9, -1.8), (4.1, -1.75), (4.25, -1.3), (4.45, -1.1), (6.2, -1.0), (6.2, -0.5),
         (5.3, -0.3), (5.2, 2.0), (5.6, 2.15), (5.6, 3.05), (4.5, 3.05), (4.5, 2.15), (4.9, 2.0), (4.8, -0.3))
RAIL = ((4.45, -1.5), (4.6, -1.1), (5.4, -1.1), (5.55, -1.5), (5.55, -1.9), (5.15, -2.1), (5.15, -3.3), (5.9, -3.5),
        (5.9, -3.75), (4.1, -3.75), (4.1, -3.5), (4.85, -3.3), (4.85, -2.1), (4.45, -1.9))


def track_from_behind(ax):
    empty(ax, "Track, seen from behind (x into the page)", (-9.6, 9.6), (-5.7, 4.4))
    for side in (-1, 1):
        outline(ax, RAIL, side, facecolor="#d8d8d8")
        outline(ax, WHEEL, side, facecolor="white")
        arrow(ax, (side * 5, -1.1), (side * 5, 1.2), "z", BLUE, (0.4, -0.1))
        arrow(ax, (side * 5, -1.1), (side * 5 - 2.3, -1.1), "y", BLUE, (-0.35, 0))
        arrow(ax, (side * 5, -4.3), (side * 7.4, -4.3), "y", GREEN, (0.4 * side, 0))
        arrow(ax, (side * 5, -4.3), (side * 5, -5.5), "z", GREEN, (0.4, 0))
        ax.text(side * 5, 3.6, "left wheel" if side < 0 else "right wheel", ha="center")
    ax.add_patch(Rectangle((-4.5, 2.4), 9.0, 0.4, facecolor="white", edgecolor=INK, lw=1.2))
    ax.text(-3.2, 2.95, "axle", ha="center")
    arrow(ax, (-1, -1.1), (0.8, -1.1), "y", at=(0.4, 0))
    arrow(ax, (-1, -1.1), (-1, -2.9), "z", at=(0.4, 0))
    across(ax, -1, -1.1, True, "x")
    turn(ax, (0, 2.6), 1.0, 140, 40, "roll", RED, (0, 1.4))
    arrow(ax, (-1.0, 1.2), (1.4, 1.2), "lateral shift", RED, (-1.2, -0.45))
    ax.text(0, -4.6, "black: track; blue: patches;\ngreen: profile coordinates", ha="center", va="center")


def contact_angle(ax):
    """The flange root of a left wheel: the plane of contact falls to the middle of the track, which is on the right."""
    empty(ax, "Contact angle (left wheel, from behind)", (-5, 5.2), (-3.6, 4.4))
    angle = np.radians(40)
    t = np.linspace(0, 1.45, 60)  # inclination of the surface
    rail, wheel = (radius * np.array([np.sin(t) - np.sin(angle), np.cos(t) - np.cos(angle)]).T for radius in (2.2, 3.4))
    ax.fill([*rail[:, 0], rail[-1, 0], -4.4, -4.4], [*rail[:, 1], -3.0, -3.0, rail[0, 1]], color="#d8d8d8", lw=0)
    ax.plot([-4.4, *rail[:, 0], rail[-1, 0]], [rail[0, 1], *rail[:, 1], -3.0], color=INK, lw=1.4)
    ax.plot([-4.4, *wheel[:, 0]], [wheel[0, 1] + 0.1, *wheel[:, 1]], color=INK, lw=1.4)
    ax.text(-2.6, -2.2, "rail", ha="center")
    ax.text(-3.7, 1.3, "wheel", ha="center")
    along, normal = np.array([np.cos(angle), -np.sin(angle)]), np.array([np.sin(angle), np.cos(angle)])
    ax.plot(*np.array([-2.6 * along, 3.4 * along]).T, color=GREY, lw=0.9, ls=(0, (4, 3)))
    ax.plot([0, 3.4], [0, 0], color=GREY, lw=0.9)
    turn(ax, (0, 0), 2.3, 0, -np.degrees(angle), "contact angle > 0", RED, (3.5, 0.4))
    arrow(ax, (0, 0), tuple(2.6 * normal), "z", BLUE, (0.3, 0.15))
    arrow(ax, (0, 0), tuple(-2.6 * along), "y", BLUE, (-0.1, 0.4))
    across(ax, 0, 0, True, "x")
    ax.text(3.3, 2.9, "middle of\nthe track →", ha="center", va="center")


def track_from_above(ax):
    empty(ax, "Track, seen from above (z into the page)", (-6.5, 6.5), (-4, 4.6))
    for x in (-4, 4):
        ax.plot([x, x], [-3.6, 3.6], color=GREY, lw=4, alpha=0.5)
    slope = np.radians(-9)
    across_ = np.array([np.cos(slope), np.sin(slope)])
    ax.plot(*np.array([-4.6 * across_, 4.6 * across_]).T, color=INK, lw=3)
    for s in (-4, 4):
        middle = s * across_
        along = 1.1 * np.array([-across_[1], across_[0]])
        ax.plot(*np.array([middle - along, middle + along]).T, color=INK, lw=5)
    arrow(ax, (0, 0), (0, 3.4), "x, rolling", at=(0.2, 0.4))
    arrow(ax, (0, 0), (2.9, 0), "y", at=(0.3, 0.25))
    across(ax, 0, 0, True, "z")
    turn(ax, (0, 0), 2.1, 85, 40, "yaw", RED, (1.3, 2.4))
    ax.text(0, -3.3, "positive yaw: steers to the right,\nthe right wheel is behind", ha="center")


def frames():
    figure = plt.figure(figsize=(8.8, 11.4))
    rows = figure.add_gridspec(3, 2, height_ratios=(1, 1.12, 1))
    patch_from_the_wheel(figure.add_subplot(rows[0, 0]))
    side_view(figure.add_subplot(rows[0, 1]))
    track_from_behind(figure.add_subplot(rows[1, :]))
    track_from_above(figure.add_subplot(rows[2, 0]))
    contact_angle(figure.add_subplot(rows[2, 1]))
    figure.tight_layout()
    return figure


def sticking_row(n, dx, kappa):
    """Tractions of n elements that stick on a half-plane under unit creepage, by (1 + kappa) d_i - kappa d_i+1."""
    edge = lambda s: s * (np.log(np.abs(s) + 1e-300) - 1.0)
    place = (np.arange(n + 2) + 0.5) * dx  # from the trailing to the leading edge, two elements ahead of it
    influence = np.array([[-(edge(s - j * dx) - edge(s - (j + 1) * dx)) for j in range(n)] for s in place])
    step = influence[1:] - influence[:-1]
    return np.linalg.solve(((1 + kappa) * step[:n] - kappa * step[1:n + 1]) / dx, np.ones(n))


def leading_edge():
    """The leading end of a row that sticks: what arrives, and what the discrete schemes make of it."""
    n, shown = 400, 9
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.4, 3.9))
    d, ahead = np.linspace(0, 8, 400), np.linspace(0, 4, 200)
    beside = left.twinx()
    beside.spines["right"].set_visible(True)
    left.plot(-d, np.sqrt(d), color=INK)
    beside.plot(-d, -2.5 * d, color=BLUE)
    beside.plot(ahead, 2.5 * ahead - ahead**1.5, color=RED)
    left.axvline(0, color=GREY, lw=0.8)
    left.text(-7.8, 1.15, "sticks: a straight\nline, fixed by its\nvalue at the edge", color=BLUE)
    beside.text(0.25, 6.5, "arrives:\na line less c d^1.5", color=RED)
    left.text(-5.4, 2.55, "traction: sqrt(d)", color=INK)
    left.text(0.15, 0.05, "leading edge", color=GREY)
    left.annotate("", (0.6, 0.55), (4, 0.55), arrowprops={"arrowstyle": "-|>", "color": GREY})
    left.text(2.3, 0.62, "material", color=GREY, ha="center")
    left.set(xlim=(-8, 4.2), ylim=(0, 3.6), xlabel="place along rolling [elements]", ylabel="traction over that at d = 1",
             title="Near the leading edge, d elements behind or ahead of it")
    beside.set(ylim=(-21, 12), ylabel="displacement difference over c")
    border = np.arange(-shown, 3)
    right.vlines(border, 0, 4.0, color=GREY, lw=0.5)
    scheme = {"first order: edge 0.325 ahead": (0.0, RED, "s", 0.325), "second order: 0.184 behind": (0.5, BLUE, "o", -0.184)}
    x = -(np.arange(n)[::-1] + 0.5)
    for label, (kappa, color, mark, off) in scheme.items():
        q = -sticking_row(n, 1.0, kappa)
        q = q if q[-3] > 0 else -q
        behind = np.linspace(0, shown, 300)
        q *= np.sqrt(1.0 - (off - x) / (n + off))  # that of a semi-infinite patch
        unit = q[-40] / np.sqrt(off - x[-40])
        right.plot(off - behind, np.sqrt(behind), color=color, lw=1)
        right.plot(x[-shown:], q[-shown:] / unit, mark, color=color, ms=5, label=label)
    right.set(xlim=(-shown, 1.6), ylim=(0, 3.3), xlabel="place along rolling [elements]; border of the first element at 0",
              ylabel="traction over that at d = 1", title="Where the discrete solution puts the edge")
    right.legend(frameon=True, framealpha=1, edgecolor="none", loc="upper right")
    figure.tight_layout()
    return figure


def profile(program, name):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "profile", name, "-o", folder], check=True, capture_output=True)
        rows = [line for line in open(pathlib.Path(folder) / "profile.csv") if not line.startswith("#")]
    table = list(csv.DictReader(rows))
    return [np.array([float(row[key]) for row in table]) for key in ("y [mm]", "z [mm]")]


def mark(ax, place, text, at, color=INK):
    ax.plot(*place, "o", color=color, ms=4)
    ax.annotate(text, place, at, color=color, ha="center", va="center",
                arrowprops={"arrowstyle": "-", "color": color, "lw": 0.7})


def profile_points(program):
    figure, (wheel, rail) = plt.subplots(1, 2, figsize=(10.4, 3.3), gridspec_kw={"width_ratios": [1.5, 1]})
    y, z = profile(program, "S1002")
    wheel.plot(y, z, color=INK, lw=1.6)
    tip = z.argmax()
    mark(wheel, (0, 0), "(0, 0): tape line,\nrolling_radius", (6, 17))
    mark(wheel, (y[0], z[0]), "back of the flange,\ny = flange_back_position", (-52, -9))
    mark(wheel, (y[tip], z[tip]), "tip of the flange", (-30, 33))
    root = np.abs(y + 37).argmin()
    mark(wheel, (y[root], z[root]), "flange root", (-14, 9))
    mark(wheel, (y[-1], z[-1]), "field side", (52, -9))
    wheel.set(title="Wheel (S1002): z outward from the axle", xlim=(-82, 68))
    y, z = profile(program, "60E1")
    rail.plot(y, z, color=INK, lw=1.6)
    mark(rail, (0, 0), "(0, 0): crown", (0, -7))
    gauge = np.abs(z[:len(z) // 2] - 14).argmin()
    mark(rail, (y[gauge], z[gauge]), "gauge face at\ngauge_height 14 mm", (-12, 22))
    corner = np.abs(y + 31).argmin()
    mark(rail, (y[corner], z[corner]), "gauge corner", (-38, -8))
    mark(rail, (y[-1], z[-1]), "field side", (24, 30))
    rail.set(title="Rail (60E1), upright", xlim=(-52, 48))
    for ax in (wheel, rail):
        ax.set(xlabel="y to the field side [mm]", ylabel="z down [mm]", ylim=(42, -16), aspect="equal")
        ax.grid(color="#e6e6e6", lw=0.6)
        ax.set_axisbelow(True)
    figure.tight_layout()
    return figure


def main():
    program, png = sys.argv[1], "--png" in sys.argv
    for name, figure in (("frames", frames()), ("leading_edge", leading_edge()), ("profile_points", profile_points(program))):
        figure.savefig(HERE / f"{name}.svg", metadata={"Date": None, "Creator": None})
        if png:
            figure.savefig(HERE / f"{name}.png", dpi=90)


if __name__ == "__main__":
    main()
