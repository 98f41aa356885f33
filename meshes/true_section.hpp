// SPDX-License-Identifier: LGPL-2.1-or-later
// The true section of a rail or a wheel rim in the frame of a patch, for finite-element bodies: the
// profile and the outline below it. Rails get the underside of the head, web and foot of 60E1 (EN
// 13674-1: height 172, web 16.5, foot 150 mm) as straight lines, wheels a rim with an inner side.
#pragma once

#include "meshes/segment_mesh.hpp"
#include "scene/patch_geometry.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::meshes {

/// An axle in the plane x = 0 (the trace of a yawed axle): direction, and position above y = 0.
struct AxleTrace {
  double cosine, sine;  ///< direction
  double height;        ///< z at y = 0, mm
  double axial;         ///< axial coordinate there
};
AxleTrace axle_trace(const contact::Axle& axle);

struct TrueSection {
  std::vector<SectionPoint> profile;  ///< dense, y and z from the left end to the right one
  /// Outline from the right end of the profile around to the left end: straight lines, both ends
  /// included.
  std::vector<SectionPoint> around;
  std::size_t held = 0;  ///< the line around[held] - around[held + 1] is fixed
  double inwards = 1.0;  ///< sign of z into the material: +1 wheel, -1 rail
};

/// Orientation of the rail: "up" is the normal of the axle, leaned by the inclination.
struct RailStand {
  double inclination = 0.0;    ///< tangent, towards the middle of the track
  bool field_at_left = false;  ///< the field side is at smaller y of the patch frame (right wheel)
  double cut_depth = 172.0;    ///< mm below the top of the rail: the section is clamped there
};

/// Throws contact::InputError when the cut is above the underside of the head.
TrueSection rail_section(const contact::PatchGeometry& geometry, const RailStand& stand);

/// The rim of the wheel or of a roller over the known extent of the profile, with its inner side
/// `rim_thickness` (mm) from the origin; a ring around the wheel has it outside.
TrueSection rim_section(const contact::PatchGeometry& geometry, bool is_wheel,
                        double rim_thickness);

}  // namespace rollfem::meshes
