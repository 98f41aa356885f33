"""Scalar measures of stress."""
from . import _core


def stress_measures(stress):
    """Scalars of stresses [..., 6] in MPa: xx, yy, zz, xy, yz, xz, as point.subsurface and point.bodies have them.

    A dict of arrays, MPa, tension positive:
    hydrostatic: (xx + yy + zz) / 3;
    von_mises, tresca: equivalent uniaxial stresses, the latter the difference of the outer principal stresses;
    orthogonal_shear: sqrt(xz^2 + yz^2), on the plane parallel to the surface;
    principal [..., 3]: principal stresses, the largest first.
    ValueError if the last axis does not have length six.
    """
    return _core.stress_measures(stress)
