# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forces of wheelset.ContactForces from a creep-force table of ellipses: contact angle, rolling radius, place and
semi-axes of both wheels over the lateral shift are found once by rollfem_solve; a right-hand side is two look-ups."""
import math

import numpy

import wheelset


class TableForces:
    def __init__(self, contact, table, vehicle, friction=0.3, shear_modulus=210e9 / 2.6, largest=6e-3, places=25):
        self.table, self.friction, self.shear_modulus, self.calls = table, friction, shear_modulus, 0
        self.shifts = numpy.linspace(-largest, largest, places)
        self.load = 0.5 * vehicle.load
        rows = []
        for shift in self.shifts:
            at = numpy.array([shift, 0.0, 0.0, 0.0, 0.0])
            rows.append([[w.roll, p.contact_angle, p.rolling_radius, p.position[1], 0.5 * p.length, 0.5 * p.width]
                         for w in contact.results(vehicle, at) for p in [w.patch[0]]])
        self.geometry = numpy.array(rows)  # shift, wheel, quantity

    def sums(self, vehicle, at):
        total = numpy.zeros(3)
        for wheel, load in enumerate(wheelset.wheel_loads(vehicle, at)):
            total += self.wheel(vehicle, at, wheel, load)
        return total

    def wheel(self, vehicle, at, wheel, load):
        """Lateral force, moments about z and y of the left (0) or right (1) wheel."""
        self.calls += 1
        shift, velocity, yaw, yaw_rate, extra = at
        roll, angle, radius, place, a, b = (numpy.interp(shift, self.shifts, self.geometry[:, wheel, k])
                                            for k in range(6))
        side = 2 * wheel - 1
        speed, rotation = vehicle.speed, vehicle.speed / vehicle.radius + extra
        turning = yaw_rate + speed * vehicle.curvature
        arm = place - shift
        sine, cosine = side * math.sin(angle), math.cos(angle)
        normal = load / cosine  # without friction, for the size of the patch and the bound
        grown = (load / self.load) ** (1.0 / 3.0)
        forces = self.table.forces(
            semi_axis_x=grown * a, semi_axis_y=grown * b, shear_modulus=self.shear_modulus,
            friction_bound=self.friction * normal,
            longitudinal_creepage=(speed - rotation * radius - turning * arm) / speed,
            lateral_creepage=-(velocity - rotation * radius * yaw) / (speed * cosine),
            spin=(rotation * sine - (turning - rotation * roll) * cosine) / speed)
        normal += forces.lateral_force * sine / cosine
        along, across = forces.longitudinal_force, -forces.lateral_force * cosine - normal * sine
        return numpy.array([across, -arm * along - yaw * arm * across - forces.spin_moment * cosine, radius * along])

    def derivatives(self, vehicle, at):
        """Of sums() by central differences."""
        steps = numpy.array([1e-5, 1e-5 * vehicle.speed, 1e-5, 1e-5 * vehicle.speed, 1e-5 * vehicle.speed])
        columns = []
        for k, step in enumerate(steps):
            moved = numpy.zeros(5)
            moved[k] = step
            columns.append((self.sums(vehicle, at + moved) - self.sums(vehicle, at - moved)) / (2.0 * step))
        return numpy.array(columns).T
