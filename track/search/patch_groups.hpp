// SPDX-License-Identifier: LGPL-2.1-or-later
// Groups minima of the gap into contacts, each with its reference point and plane.
#pragma once

#include "track/search/load_estimate.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::track {

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
