# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wheelset that is held to its bogie frame by springs: equations of motion with the forces of rollfem_c.

m, kg, s, N, rad; x along the track, y to the right, z down. The unknowns are lateral shift y, its velocity, yaw, its
rate, and the rate at which the wheelset turns about its axle beyond V/r. The frame follows the track at the speed V."""
import dataclasses
import math

import numpy

STATE = ("shift", "velocity", "yaw", "yaw_rate", "extra_rotation")


@dataclasses.dataclass
class Vehicle:
    """A wheelset, a quarter of the car on it, and the springs of its axle boxes."""

    speed: float
    mass: float = 1500.0                 # kg, of the wheelset
    yaw_inertia: float = 900.0           # kg m^2
    spin_inertia: float = 100.0          # kg m^2, about the axle
    load: float = 100e3                  # N, on both wheels
    radius: float = 0.46                 # m
    lateral_stiffness: float = 1e6       # N/m, both axle boxes together
    yaw_stiffness: float = 1e6           # N m/rad
    lateral_damping: float = 0.0         # N s/m
    curvature: float = 0.0               # 1/m, of the track, to the right; canted for this speed
    frame_yaw: float = 0.0               # rad, of the frame against the track under it
    half_gauge: float = 0.75             # m, from the middle to the contacts


class ContactForces:
    """Forces of both rails on the wheelset by rollfem_solve, and their derivatives by rollfem_linearise."""

    def __init__(self, lib, **definition):
        self.lib = lib
        self.wheels = [lib.pair(units=lib.ROLLFEM_M_N, side=side, **definition)
                       for side in (lib.ROLLFEM_LEFT, lib.ROLLFEM_RIGHT)]
        self.calls = 0

    def states(self, vehicle, at):
        shift, velocity, yaw, yaw_rate, extra = at
        loads = wheel_loads(vehicle, at)
        roll = math.nan  # found by the first wheel, taken by the second
        for load in loads:
            yield self.lib.state(
                lateral_shift=shift, yaw=yaw, roll=roll, forward_speed=vehicle.speed, lateral_velocity=velocity,
                yaw_rate=yaw_rate + vehicle.speed * vehicle.curvature,
                rotation_speed=vehicle.speed / vehicle.radius + extra, vertical_force=load)

    def results(self, vehicle, at):
        self.calls += 2
        first, second = self.states(vehicle, at)
        left = self.wheels[0].solve(first)
        second.roll = left.roll
        return left, self.wheels[1].solve(second)

    def sums(self, vehicle, at):
        """Lateral force, moments about z and about y (which slows the rotation)."""
        results = self.results(vehicle, at)
        return numpy.array([sum(r.force[1] for r in results), sum(r.moment[2] for r in results),
                            sum(r.moment[1] for r in results)])

    def derivatives(self, vehicle, at):
        """Of sums() by the unknowns."""
        lib = self.lib
        columns = (lib.ROLLFEM_BY_LATERAL_SHIFT, lib.ROLLFEM_BY_LATERAL_VELOCITY, lib.ROLLFEM_BY_YAW,
                   lib.ROLLFEM_BY_YAW_RATE, lib.ROLLFEM_BY_ROTATION_SPEED)
        total = numpy.zeros((3, len(columns)))
        by_load = load_derivatives(vehicle)
        for side, state in enumerate(self.states(vehicle, at)):
            _, by = self.wheels[side].linearise(state)
            columns_of = numpy.array([by.force[1], by.moment[2], by.moment[1]])
            total += columns_of[:, columns] + numpy.outer(columns_of[:, lib.ROLLFEM_BY_LOAD], by_load[side])
        return total


def suspension(vehicle, at):
    """Lateral force and yaw moment of the springs on the wheelset."""
    shift, velocity, yaw, _, _ = at
    return (-vehicle.lateral_stiffness * shift - vehicle.lateral_damping * velocity,
            -vehicle.yaw_stiffness * (yaw - vehicle.frame_yaw))


def wheel_loads(vehicle, at):
    """Of the left and the right wheel: the springs push at the height of the axle, the rails hold against them."""
    tilting = suspension(vehicle, at)[0] * vehicle.radius / (2.0 * vehicle.half_gauge)
    return 0.5 * vehicle.load - tilting, 0.5 * vehicle.load + tilting


def load_derivatives(vehicle):
    """Of wheel_loads() by the unknowns, in which they are linear."""
    still = numpy.array(wheel_loads(vehicle, numpy.zeros(5)))
    return numpy.array([wheel_loads(vehicle, unit) - still for unit in numpy.eye(5)]).T


def inertia(vehicle):
    return numpy.array([vehicle.mass, vehicle.yaw_inertia, vehicle.spin_inertia])


def rates(vehicle, contact, at):
    """Time derivatives of the unknowns."""
    lateral, about_z, about_y = contact.sums(vehicle, at)
    push, turn = suspension(vehicle, at)
    accelerations = numpy.array([lateral + push, about_z + turn, -about_y]) / inertia(vehicle)
    return numpy.array([at[1], accelerations[0], at[3], accelerations[1], accelerations[2]])


def jacobian(vehicle, contact, at):
    """Of rates() by the unknowns."""
    by = contact.derivatives(vehicle, at)
    by[0, 0] -= vehicle.lateral_stiffness
    by[0, 1] -= vehicle.lateral_damping
    by[1, 2] -= vehicle.yaw_stiffness
    by[2] *= -1.0
    by /= inertia(vehicle)[:, None]
    matrix = numpy.zeros((5, 5))
    matrix[0, 1] = matrix[2, 3] = 1.0
    matrix[1], matrix[3], matrix[4] = by
    return matrix


def hunting_mode(matrix):
    """Growth (1/s) and angular frequency (1/s) of the oscillation that is damped least."""
    values = numpy.linalg.eigvals(matrix)
    swinging = values[values.imag > 1e-6]
    if len(swinging) == 0:
        return -math.inf, 0.0
    worst = swinging[numpy.argmax(swinging.real)]
    return worst.real, worst.imag
