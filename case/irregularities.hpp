// SPDX-License-Identifier: LGPL-2.1-or-later
// Irregularities of wheels about their axle and of rails along the track, by which their profiles
// move in and out. Plain values; profiles/irregularity.hpp makes heights of them.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace rollfem::contact {

/// A flat of a wheel.
struct WheelFlat {
  enum class Shape {
    chord,    ///< new: plane across, with edges
    rounded,  ///< worn: one wave of a cosine
  };
  Shape shape = Shape::chord;
  std::optional<double> depth, length;  ///< mm; of a chord one of them, before its ends are rounded
  double edge_radius = 0.0;             ///< mm, of the arcs at the ends of a chord; 0: edges
  double angle = 0.0;                   ///< rad about the axle, of its middle
};

/// Cosines, amplitude cos(2 pi way/wave - phase); lists of one length.
struct Waves {
  std::vector<double> amplitude;  ///< mm, > 0 adds to the body
  std::vector<double> phase;      ///< rad; empty: 0
};

struct WheelPolygon : Waves {
  std::vector<double> order;  ///< waves around the wheel
};

struct RailCorrugation : Waves {
  std::vector<double> wavelength;               ///< mm
  std::optional<std::array<double, 2>> extent;  ///< mm along the track; unset: everywhere
};

/// A dip of the rail: both halves are cubics, level at their far ends.
struct RailDip {
  double position = 0.0;                ///< mm along the track, of its middle
  std::optional<double> depth, length;  ///< mm
  double angle = 0.0;                   ///< rad, between both rails at their joint; 0: a weld
};

}  // namespace rollfem::contact
