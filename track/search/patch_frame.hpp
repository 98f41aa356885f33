// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail in the frame of one contact: sections, axles and surfaces, from where the search
// has them.
#pragma once

#include "contact/case/case.hpp"
#include "contact/scene/patch_geometry.hpp"
#include "track/placement/vertical_gap.hpp"
#include "track/placement/wheelset_pose.hpp"

#include <array>

namespace rollfem::track {

/// The frame of a patch on the rail; coordinates as in a right-handed patch frame on the left side,
/// where y points to the field; on the right the lateral axis is reversed at the end.
struct PatchAxes {
  double y0, z0;        ///< side frame, mm
  double cosine, sine;  ///< of the contact angle
  double across(double y, double z) const { return cosine * (y - y0) - sine * (z - z0); }
  double along_normal(double y, double z) const { return -sine * (y - y0) - cosine * (z - z0); }
};

/// `bodies`: null of bodies that do not change along the way; `axle_of_side`: at first touch of the
/// wheel, which sinks by `sink` (mm) until this contact touches at `touch`; `overlap`: range of y
/// of the patch frame, beyond which the bodies are known for `around_overlap` (mm).
contact::PatchGeometry make_geometry(const contact::Case& input, const SearchScene& scene,
                                     const BodiesAlongWay* bodies, const PatchAxes& axes,
                                     const contact::Axle& axle_of_side, bool left,
                                     const OutlinePoint& touch, double sink,
                                     const std::array<double, 2>& overlap, double around_overlap);

}  // namespace rollfem::track
