"""The edge of the patch below the element size."""
import numpy as np


def edge_function(pressure):
    """A field on the grid whose zero line is the edge of the patch.

    Near the edge p^2 is linear in the distance (Hertz), so p^2 is continued linearly from the two
    outermost loaded elements to the unloaded ones beside them.
    """
    known = pressure > 0
    values = np.where(known, pressure, 0.0) ** 2
    scale = values.max() if values.size else 0.0
    for _ in range(2):  # the second ring gives the corners between a row and a column
        values, known = _continued(values, known, -1e-6 * scale)
    return np.where(known, values, -0.05 * scale)


def _continued(values, known, largest):
    """`values` with one more ring of elements around the known ones, at most `largest` there."""
    sums, counts = np.zeros_like(values), np.zeros_like(values)
    for axis in (0, 1):
        for step in (1, -1):
            near, far = np.roll(values, step, axis), np.roll(values, 2 * step, axis)
            reaches = np.roll(known, step, axis) & ~known
            border = [slice(None)] * 2
            border[axis] = slice(0, 1) if step == 1 else slice(-1, None)
            reaches[tuple(border)] = False  # what np.roll took from the other side
            sums += np.where(reaches, np.minimum(2 * near - far, largest), 0.0)
            counts += reaches
    return np.where(known, values, sums / np.maximum(counts, 1)), known | (counts > 0)


def loaded_runs(at, pressure):
    """Yields (edge below, edge above, first, last + 1) of every run of loaded elements on a line, the
    edges from p^2 continued linearly, at most one element beyond."""
    inside = np.concatenate([[False], pressure > 0, [False]])
    starts, ends = np.flatnonzero(~inside[:-1] & inside[1:]), np.flatnonzero(inside[:-1] & ~inside[1:])
    step = at[1] - at[0] if len(at) > 1 else 1.0

    def beyond(outer, inner):
        fall = inner ** 2 - outer ** 2
        return step * min(1.0, outer ** 2 / fall) if fall > 0 else 0.5 * step

    for first, last in zip(starts, ends):
        second = min(first + 1, last - 1)
        yield (at[first] - beyond(pressure[first], pressure[second]),
               at[last - 1] + beyond(pressure[last - 1], pressure[max(last - 2, first)]), first, last)


def padded(model, values, outside):
    """x, y and values with a ring of elements around, so that outlines close at the border."""
    x = np.concatenate([[model.x[0] - model.dx], model.x, [model.x[-1] + model.dx]])
    y = np.concatenate([[model.y[0] - model.dy], model.y, [model.y[-1] + model.dy]])
    return x, y, np.pad(values, 1, constant_values=outside)


def extent(models):
    """Half-widths (x, y) in mm of a frame around the patches of all models."""
    half_x = half_y = 0.0
    for model in models:
        for point in model.points:
            pressure = point.fields.get("pressure")
            if pressure is None or not (pressure > 0).any():
                continue
            half_x = max(half_x, np.abs(model.x[(pressure > 0).any(axis=0)]).max() + model.dx)
            half_y = max(half_y, np.abs(model.y[(pressure > 0).any(axis=1)]).max() + model.dy)
    return 1.06 * half_x, 1.06 * half_y
