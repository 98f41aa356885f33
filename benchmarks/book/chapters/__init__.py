"""The chapters in the order of the book."""
from .bodies import elements, incompressible, inertia, persson
from .fem import fem_hertz
from .friction import cattaneo, spence, transient
from .normal import grid_order, hertz
from .profiles import manchester, wheel_on_rail
from .rolling import benchmark_9, bentall_johnson, carter, fastsim, kalker
from .stress import stress_case_a, stress_circle
from .thesis import half_space_limits, thesis_cases

ALL = [hertz, grid_order, cattaneo, spence, carter, bentall_johnson, kalker, benchmark_9, fastsim, transient,
       stress_circle, stress_case_a, elements, persson, fem_hertz, incompressible, inertia, thesis_cases,
       half_space_limits, wheel_on_rail, manchester]
