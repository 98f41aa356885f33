# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chapters in the order of the book."""
from .bodies import elements, incompressible, inertia, persson
from .carter import carter
from .conformal import conformal_contact
from .curvature import curvature_slip
from .falling import falling_friction
from .fem import calculix, fem_hertz
from .friction import cattaneo, creep_frequency, spence
from .heat import heat
from .hybrid import hybrid
from .measured import measured
from .normal import grid_order, hertz, steuermann
from .profiles import manchester, wheel_on_rail
from .kalker import kalker
from .rolling import benchmark_9, bentall_johnson, fastsim, nowell_hills
from .stress import stress_case_a, stress_circle
from .thesis import half_space_limits, thesis_cases
from .transient import transient
from .yielding import yielding_layer

ALL = [hertz, grid_order, steuermann, cattaneo, spence, carter, bentall_johnson, nowell_hills, kalker, benchmark_9,
       fastsim, transient, creep_frequency, stress_circle, stress_case_a, elements, persson, fem_hertz, incompressible,
       inertia, thesis_cases, half_space_limits, calculix, hybrid, curvature_slip, conformal_contact, wheel_on_rail,
       manchester, measured, falling_friction, yielding_layer, heat]
