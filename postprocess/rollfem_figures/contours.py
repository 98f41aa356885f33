"""Lines on which a field on a grid has a value (marching squares)."""
import numpy as np

# Of the 16 ways in which the corners of a cell are above (bits: 1 at (i, j), 2 at (i+1, j), 4 at
# (i+1, j+1), 8 at (i, j+1)), the sides that a line joins, with what is above on its left; sides:
# 0 below, 1 right, 2 above, 3 left. Saddles are joined as if the middle was not above.
_JOINED = {1: [(0, 3)], 2: [(1, 0)], 3: [(1, 3)], 4: [(2, 1)], 5: [(0, 3), (2, 1)], 6: [(2, 0)],
           7: [(2, 3)], 8: [(3, 2)], 9: [(0, 2)], 10: [(1, 0), (3, 2)], 11: [(1, 2)], 12: [(3, 1)],
           13: [(0, 1)], 14: [(3, 0)]}


def _edges(side, i, j, width):
    """Numbers of the sides of cells among all sides of the grid: those along x are even."""
    at = {0: (i, j), 1: (i + 1, j), 2: (i, j + 1), 3: (i, j)}[side]
    return 2 * (at[1] * width + at[0]) + (side in (1, 3))


def _places(edges, x, y, values, level):
    """Where the level is passed on sides of cells, by their numbers."""
    width = len(x)
    place, upright = edges // 2, edges % 2
    j, i = place // width, place % width
    k, m = np.where(upright, i, i + 1), np.where(upright, j + 1, j)
    low, high = values[j, i], values[m, k]
    share = (level - low) / (high - low)
    return np.stack([x[i] + share * (x[k] - x[i]), y[j] + share * (y[m] - y[j])], axis=1)


def lines(x, y, values, level):
    """Lines of a field [ny, nx] at a level as arrays [n, 2]; closed ones end where they begin."""
    above = values >= level
    kind = (above[:-1, :-1] * 1 + above[:-1, 1:] * 2 + above[1:, 1:] * 4 + above[1:, :-1] * 8)
    follows = {}
    for number, joined in _JOINED.items():
        j, i = np.nonzero(kind == number)
        for start, end in joined if len(i) else ():
            follows.update(zip(_edges(start, i, j, len(x)).tolist(), _edges(end, i, j, len(x)).tolist()))
    found = []
    ends = set(follows.values())
    begins = [edge for edge in follows if edge not in ends]
    while follows:
        edge = begins.pop() if begins else next(iter(follows))
        chain = [edge]
        while edge in follows:
            edge = follows.pop(edge)
            chain.append(edge)
        found.append(_places(np.array(chain), np.asarray(x), np.asarray(y), values, level))
    return found


def at_points(x, y, values, points):
    """A field between the points of its even grid, bilinearly."""
    i = np.clip((points[:, 0] - x[0]) / (x[1] - x[0]), 0, len(x) - 1.000001)
    j = np.clip((points[:, 1] - y[0]) / (y[1] - y[0]), 0, len(y) - 1.000001)
    k, m = i.astype(int), j.astype(int)
    s, t = i - k, j - m
    return ((1 - t) * ((1 - s) * values[m, k] + s * values[m, k + 1])
            + t * ((1 - s) * values[m + 1, k] + s * values[m + 1, k + 1]))
