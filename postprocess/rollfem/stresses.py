# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scalars of stresses."""
import numpy as np
from numpy.typing import ArrayLike

from .errors import InputError


def von_mises(stress: np.ndarray) -> np.ndarray:
    """sqrt(3 J2) of stresses [..., 6], the uniaxial stress of the same distortion energy."""
    xx, yy, zz, xy, yz, xz = np.moveaxis(stress, -1, 0)
    distortion = 0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy ** 2 + yz ** 2 + xz ** 2)
    return np.asarray(np.sqrt(distortion))


def _principal(stress: np.ndarray) -> np.ndarray:
    """Principal stresses [..., 3], the largest first, by Jacobi's rotations (Golub and Van Loan 2013, section 8.5): LAPACK's
    last digit depends on the thread."""
    xx, yy, zz, xy, yz, xz = np.moveaxis(stress, -1, 0)
    on, off = [xx, yy, zz], [yz, xz, xy]  # off[r]: that between the two axes other than r
    for p, q, r in 6 * ((0, 1, 2), (0, 2, 1), (1, 2, 0)):
        apart = on[q] - on[p]
        below = apart + np.copysign(np.sqrt(apart**2 + 4.0 * off[r] ** 2), apart)
        tangent = np.divide(2.0 * off[r], below, out=np.zeros_like(below), where=below != 0.0)
        cosine = 1.0 / np.sqrt(tangent**2 + 1.0)
        on[p], on[q] = on[p] - tangent * off[r], on[q] + tangent * off[r]
        off[p], off[q] = cosine * (off[p] + tangent * off[q]), cosine * (off[q] - tangent * off[p])
        off[r] = np.zeros_like(below)
    return np.sort(np.stack(on, axis=-1), axis=-1)[..., ::-1]


def stress_measures(stress: ArrayLike) -> dict[str, np.ndarray]:
    """Scalars of stresses.

    Args:
        stress: [..., 6], MPa: xx, yy, zz, xy, yz, xz, as point.subsurface and point.bodies have them.
    Returns:
        Arrays by name, MPa, tension positive. hydrostatic: (xx + yy + zz) / 3; von_mises, tresca: equivalent uniaxial
        stresses, the latter the difference of the outer principal stresses; orthogonal_shear: sqrt(xz^2 + yz^2), on the
        plane parallel to the surface; principal [..., 3]: principal stresses, the largest first.
    Raises:
        InputError: These are not numbers, or the last axis does not have length six.

    >>> rollfem.stress_measures(point.subsurface[0]["stress"])["von_mises"].max()
    """
    try:
        components = np.asarray(stress, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"stress_measures({stress!r:.60}): allowed: numbers, six along the last axis") from None
    if components.shape[-1:] != (6,):
        raise InputError("stress_measures: the last axis of a stress has its six components xx, yy, zz, xy, yz, xz")
    xx, yy, zz, xy, yz, xz = np.moveaxis(components, -1, 0)
    principal = _principal(components)
    return {
        "hydrostatic": (xx + yy + zz) / 3,
        "von_mises": von_mises(components),
        "tresca": principal[..., 0] - principal[..., 2],
        "orthogonal_shear": np.hypot(xz, yz),
        "principal": principal,
    }
