# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hunting.py computes: waves, critical speed, time series and a curve."""
import math
import time

import numpy

import wheelset

REST = numpy.zeros(5)
CONICITY = 0.05


def cone_profile(folder):
    """A wheel with the taper 1:20 and no flange, y to the field, z out of the wheel, mm."""
    path = folder / "cone.txt"
    path.write_text("# y z, mm\n" + "".join(f"{y / 4} {-CONICITY * y / 4}\n" for y in range(-160, 161)))
    return {"wheel_profile": str(path).encode(), "rail_profile": b"60E1", "inclination": CONICITY}


def free(speed):
    """Without springs."""
    return wheelset.Vehicle(speed=speed, lateral_stiffness=0.0, yaw_stiffness=0.0)


def klingel(radius, half_distance, conicity):
    """Wave length of the free wheelset that rolls without slip, m."""
    return 2.0 * math.pi * math.sqrt(radius * half_distance / conicity)


def half_distance(vehicle, contact):
    """Half of what the contacts are apart, m."""
    left, right = contact.results(vehicle, REST)
    return 0.5 * (right.patch[0].position[1] - left.patch[0].position[1])


def harmonic_conicity(vehicle, contact, amplitude, places=24):
    """Half the slope of the line that does the work of the difference of radii over a sine (UIC 519)."""
    total = 0.0
    for k in range(places):
        phase = 2.0 * math.pi * (k + 0.5) / places
        at = REST.copy()
        at[0] = amplitude * math.sin(phase)
        left, right = contact.results(vehicle, at)
        total += (right.patch[0].rolling_radius - left.patch[0].rolling_radius) * math.sin(phase)
    return total / (places * amplitude)


def integrate(vehicle, contact, start, seconds, step, curve=None, jacobian_every=None):
    """Times, unknowns at them, and seconds simulated per second of CPU.

    Linearly implicit (ROS2 of Verwer et al. 1999, order 2 with any Jacobian): friction at low creepage is stiff, and
    an element that enters a contact makes forces jump by up to 1 % of mu N, at which methods that choose their step
    by an error estimate stop. `curve`: curvature (1/m) and yaw of the frame over time."""
    gamma = 1.0 - math.sqrt(0.5)
    count = round(seconds / step)
    times, values = step * numpy.arange(count + 1), numpy.zeros((5, count + 1))
    values[:, 0] = start
    begin = time.process_time()
    for k in range(count):
        at = values[:, k]
        if curve is not None:
            vehicle.curvature, vehicle.frame_yaw = curve(times[k])
        if k == 0 or (jacobian_every and k % jacobian_every == 0):
            matrix = numpy.linalg.inv(numpy.eye(5) - gamma * step * wheelset.jacobian(vehicle, contact, at))
        first = matrix @ wheelset.rates(vehicle, contact, at)
        second = matrix @ (wheelset.rates(vehicle, contact, at + step * first) - 2.0 * first)
        values[:, k + 1] = at + step * (1.5 * first + 0.5 * second)
    return times, values, seconds / (time.process_time() - begin)


def wave_length(vehicle, contact, amplitude, conicity):
    """Of the time series of the free wheelset at this speed, m: twice the mean way between crossings of 0."""
    start = rolling(vehicle, contact, amplitude)
    period = klingel(vehicle.radius, vehicle.half_gauge, conicity) / vehicle.speed
    t, y, _ = integrate(vehicle, contact, start, 1.4 * period, period / 80.0)
    crossings = [t[k] + (t[k + 1] - t[k]) * y[0, k] / (y[0, k] - y[0, k + 1])
                 for k in range(len(t) - 1) if y[0, k] * y[0, k + 1] < 0.0]
    return 2.0 * vehicle.speed * (crossings[-1] - crossings[0]) / (len(crossings) - 1)


def rolling(vehicle, contact, shift=0.0):
    """The unknowns of a wheelset beside the middle that turns freely: its radii there are not the nominal one."""
    at = REST.copy()
    at[0] = shift
    for _ in range(3):
        at[4] -= contact.sums(vehicle, at)[2] / contact.derivatives(vehicle, at)[2, 4]
    return at


def mode_of(vehicle, contact):
    """Growth and angular frequency (1/s) of the hunting of small amplitude."""
    return wheelset.hunting_mode(wheelset.jacobian(vehicle, contact, rolling(vehicle, contact)))


def mode_at(speed, contact, **springs):
    return mode_of(wheelset.Vehicle(speed=speed, **springs), contact)


def critical_speed(contact, low, high, **springs):
    """m/s, at which the oscillation neither grows nor dies."""
    while high - low > 1e-3 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if mode_at(middle, contact, **springs)[0] < 0.0 else (low, middle)
    return 0.5 * (low + high)


def growth(t, shift):
    """Of an oscillation, 1/s: from the logarithms of its extremes after the first two."""
    peaks = [k for k in range(1, len(t) - 1) if (shift[k] - shift[k - 1]) * (shift[k + 1] - shift[k]) < 0.0]
    peaks = peaks[2:]
    return numpy.polyfit(t[peaks], numpy.log(numpy.abs(shift[peaks])), 1)[0]
