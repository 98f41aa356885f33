// SPDX-License-Identifier: LGPL-2.1-or-later
// Groups minima of the gap into contacts, each with its reference point and plane, by the sinking
// of the wheel under its load and the load of each patch, estimated without solving the contact
// problem: the patch is the overlap of the bodies at 0.57 of the approach, the pressure
// over it semi-elliptic along rolling. W. Kik and J. Piotrowski, A fast, approximate method to
// calculate normal load at contact between wheel and rail and creep forces during rolling, 1996.
// Accurate to about 5 % of the force; used for choosing grids, merging patches and first guesses.
#pragma once

#include "track/placement/vertical_gap.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::track {

/// A stretch of the gap that is one potential contact.
struct Stretch {
  GapMinimum deepest;              ///< its lowest minimum, the reference point
  std::array<double, 2> limits{};  ///< mm, side frame: limits of the stretch
  double rolling_radius = 0.0;     ///< mm, at the reference point
  std::vector<GapMinimum> minima;  ///< all of them
  /// Gap at the second-lowest minimum separated by a valley, mm; infinite where there is none.
  double next_gap = contact::infinity;
};

/// The first with the lowest minimum; at least one.
const Stretch& deepest_of(const std::vector<Stretch>& stretches);

/// Approach along the normal of a stretch when the wheel sinks by `sinking` from gap 0, mm: sinking
/// times cosine less the separation along the normal.
double approach_of(const Stretch& stretch, double sinking);

/// Approach and deflection are averaged over some rows of elements: accurate to 1e-3 of the force.
constexpr std::size_t every_third_row = 3;

/// Normal force at an approach, N; 0 when it is not positive. `modulus` is E* of both bodies, MPa.
double estimate_force(const VerticalGap& gap, const Stretch& stretch, double approach,
                      double modulus, std::size_t every = every_third_row);

/// Sinking, measured from gap 0, at which the stretches together carry `vertical` (N) without
/// friction.
double estimate_sinking(const VerticalGap& gap, const std::vector<Stretch>& stretches,
                        double vertical, double modulus);

/// Sinking under the load carried by these stretches, measured from gap 0, mm.
using SinkingOf = std::function<double(const std::vector<Stretch>&)>;

/// The minima that a load may reach, as contacts: minima whose angles all lie within `merge_angle`
/// (rad) are one, however far apart, because one half-space describes their elasticity; the ridges
/// between the others separate them. `sinking`: sinking under the load as estimated for these
/// contacts, from gap 0, mm.
struct Contacts {
  std::vector<Stretch> groups;
  double sinking = 0.0;
  std::vector<Stretch> humps;  ///< every minimum between ridges, whether or not the load reaches it
};
Contacts group_minima(const VerticalGap& gap, double merge_angle, const SinkingOf& sinking_of);

/// Overlap of the bodies at a sinking: first and last y of the side frame.
std::array<double, 2> reach_of(const VerticalGap& gap, const Stretch& stretch, double sinking);

/// The reference of a contact: side frame, mm, and dz/dy of its plane.
struct Reference {
  double y = 0.0;
  double slope = 0.0;
  double spread = 0.0;  ///< rad, standard deviation of the normals from the plane's normal
};

/// Mean position of the overlap at a sinking and mean slope of the common surface there, midway
/// between wheel and rail, weighted by the square of the depth over the area; the lowest point
/// without overlap. The weights are close to those of the pressure: for a parabola they have 1.25
/// times the variance.
Reference reference_of(const VerticalGap& gap, const Stretch& stretch, double sinking);

}  // namespace rollfem::track
