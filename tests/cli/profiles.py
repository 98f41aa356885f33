# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles as points and as text in files, and the curves that are read from them."""

import numpy as np
import pytest
from program import package


def _between(at, knots, value, slope):
    """The cubic between rows, which lie a tenth of a millimetre apart and at every joint."""
    knots, keep = np.unique(knots, return_index=True)
    value, slope = value[keep], slope[keep]
    k = np.clip(np.searchsorted(knots, at, side="right") - 1, 0, len(knots) - 2)
    h = knots[k + 1] - knots[k]
    t = (at - knots[k]) / h
    return ((1 + 2 * t) * (1 - t)**2 * value[k] + t**2 * (3 - 2 * t) * value[k + 1]
            + h * t * (1 - t) * ((1 - t) * slope[k] - t * slope[k + 1]))


def along(profile, at):
    """Points [n, 2], y and z, at these lengths along a profile."""
    angle = np.radians(profile.angle)
    return np.stack([_between(at, profile.s, profile.y, np.cos(angle)), _between(at, profile.s, profile.z, np.sin(angle))], axis=1)


def height(profile, y):
    """z of a profile at these y, where it is not vertical."""
    return _between(np.asarray(y), profile.y, profile.z, np.tan(np.radians(profile.angle)))


def points_of(name, spacing=0.5):
    """Points [n, 2] of a built-in profile, this far apart along it."""
    profile = package().Profile(name)
    return along(profile, np.arange(0.0, profile.length, spacing))


def columns(points, separator=" ", unit=1.0):
    return "".join(f"{y / unit:.12g}{separator}{z / unit:.12g}\n" for y, z in points)


def off(profile, name):
    """Largest distance in z from a built-in profile where that is not steep and its radius does not jump."""
    truth = package().Profile(name)
    y = np.arange(-35.0, 55.0, 0.7) if truth.body == "wheel" else np.arange(-30.0, 30.0, 0.7)
    y = y[np.abs(y[:, None] - np.array([*truth.joints, 1e9])).min(axis=1) > 0.2]
    return np.abs(height(profile, y) - height(truth, y)).max()


# Of a spline through points 0.5 mm apart, beside joints from a radius of 13 to one of 80 mm.
SPLINE = 5e-4


@pytest.fixture
def read(tmp_path, monkeypatch):
    """Reads a file of this content as the profile of a body."""
    monkeypatch.chdir(tmp_path)

    def reader(text, body, name="profile.txt", **mend):
        (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return package().Profile(name, body, **mend)
    return reader


@pytest.fixture
def refusal(read):
    """The message with which such a file is refused: one line that says what to do."""
    def said(*arguments, **mend):
        with pytest.raises(package().InputError) as refused:
            read(*arguments, **mend)
        message = str(refused.value)
        assert "; do: " in message and "\n" not in message
        return message
    return said
