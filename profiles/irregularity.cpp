// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/irregularity.hpp"

#include "base/pi.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rollfem::profiles {

namespace {

using contact::CurveValue;
using contact::pi;
using WayHeight = std::function<CurveValue(double)>;

void add_height(Irregularity& sum, double shortest, WayHeight more) {
  sum.shortest = std::min(sum.shortest, shortest);
  if (!sum.height) {
    sum.height = std::move(more);
    return;
  }
  sum.height = [a = std::move(sum.height), b = std::move(more)](double way) {
    const CurveValue one = a(way), other = b(way);
    return CurveValue{one.value + other.value, one.slope + other.slope, 0.0};
  };
}

/// Adds waves of these lengths, raised by `sign`.
void add_waves(Irregularity& sum, const contact::Waves& waves, const std::vector<double>& lengths,
               double sign) {
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    const double amplitude = sign * waves.amplitude[k], number = 2.0 * pi / lengths[k];
    const double phase = waves.phase.empty() ? 0.0 : waves.phase[k];
    if (amplitude == 0.0) continue;
    add_height(sum, lengths[k], [=](double way) {
      const double angle = number * way - phase;
      return CurveValue{amplitude * std::cos(angle), -amplitude * number * std::sin(angle), 0.0};
    });
  }
}

/// From the middle of a chord, in polar coordinates about the axle: a line, at each end an arc that
/// touches it and the wheel's circle, and that circle.
WayHeight chord_flat(const contact::WheelFlat& flat, double radius) {
  const double half = 0.5 * flat.length.value_or(0.0);
  const double depth =
      flat.depth.value_or(half * half / (radius + std::sqrt(radius * radius - half * half)));
  const double line = radius - depth, arc = flat.edge_radius;
  const double up = line - arc, to_arc = radius - arc;  // of the middle of the arc, from the axle
  const double along = std::sqrt(to_arc * to_arc - up * up);
  const double line_ends = std::atan2(along, line), arc_ends = std::atan2(along, up);
  return [=](double angle) {
    const double size = std::abs(angle), sign = angle < 0.0 ? -1.0 : 1.0;
    if (size >= arc_ends) return CurveValue{};
    if (size <= line_ends) {
      const double here = line / std::cos(angle);
      return CurveValue{here - radius, here * std::tan(angle), 0.0};
    }
    const double sine = to_arc * std::sin(size - arc_ends);
    const double cosine = to_arc * std::cos(size - arc_ends);
    const double root = std::sqrt(arc * arc - sine * sine);
    return CurveValue{cosine + root - radius, -sign * sine * (1.0 + cosine / root), 0.0};
  };
}

WayHeight rounded_flat(const contact::WheelFlat& flat, double radius) {
  const double ends = 0.5 * *flat.length / radius, depth = *flat.depth;
  return [=](double angle) {
    const double phase = pi * angle / ends;
    if (std::abs(phase) >= pi) return CurveValue{};
    return CurveValue{-0.5 * depth * (1.0 + std::cos(phase)),
                      0.5 * depth * pi / ends * std::sin(phase), 0.0};
  };
}

/// Waves that begin and end over their longest wavelength.
WayHeight faded(WayHeight waves, const std::array<double, 2>& extent, double over) {
  return [=, waves = std::move(waves)](double way) {
    CurveValue height = waves(way);
    for (const double sign : {1.0, -1.0}) {
      const double inside = sign * (way - (sign > 0.0 ? extent[0] : extent[1]));
      const CurveValue factor =
          contact::hermite(over, std::clamp(inside / over, 0.0, 1.0), 0.0, 1.0, 0.0, 0.0);
      height.slope = factor.value * height.slope + sign * factor.slope * height.value;
      height.value *= factor.value;
    }
    return height;
  };
}

WayHeight dip_of(const contact::RailDip& given) {
  const double half = 0.5 * *given.length, depth = *given.depth, fall = 0.5 * given.angle;
  return [=, middle = given.position](double way) {
    const double part = std::abs(way - middle) / half;
    if (part >= 1.0) return CurveValue{};
    const CurveValue height = contact::hermite(half, part, depth, 0.0, -fall, 0.0);
    return CurveValue{height.value, way < middle ? -height.slope : height.slope, 0.0};
  };
}

}  // namespace

Irregularity irregularity_of(const contact::Wheel& wheel) {
  Irregularity sum;
  if (wheel.polygon) {
    std::vector<double> lengths;
    for (const double order : wheel.polygon->order) lengths.push_back(2.0 * pi / order);
    add_waves(sum, *wheel.polygon, lengths, 1.0);
  }
  if (wheel.flat) {
    const double radius = wheel.rolling_radius;
    const bool is_chord = wheel.flat->shape == contact::WheelFlat::Shape::chord;
    const WayHeight flat =
        is_chord ? chord_flat(*wheel.flat, radius) : rounded_flat(*wheel.flat, radius);
    const double length = wheel.flat->length.value_or(
        2.0 * std::sqrt(2.0 * radius * wheel.flat->depth.value_or(0.0)));
    add_height(sum, length / radius, [flat, middle = wheel.flat->angle](double angle) {
      return flat(std::remainder(angle - middle, 2.0 * pi));
    });
  }
  return sum;
}

Irregularity irregularity_of(const contact::Rail& rail) {
  Irregularity sum;
  if (const auto& waves = rail.corrugation) {
    add_waves(sum, *waves, waves->wavelength, -1.0);
    if (sum.height && waves->extent)
      sum.height = faded(std::move(sum.height), *waves->extent,
                         *std::max_element(waves->wavelength.begin(), waves->wavelength.end()));
  }
  if (rail.dip && *rail.dip->depth > 0.0) add_height(sum, *rail.dip->length, dip_of(*rail.dip));
  return sum;
}

}  // namespace rollfem::profiles
