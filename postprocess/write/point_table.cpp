// SPDX-License-Identifier: LGPL-2.1-or-later
#include "postprocess/write/point_table.hpp"

namespace rollfem::postprocess {

using contact::ContactFields;
using contact::Field;

const std::vector<PlaceScalar>& place_scalars() {
  using P = contact::ContactPlace;
  static const std::vector<PlaceScalar> scalars{
      {"position", "-", "number of the wheelset's position, from 1", &P::position},
      {"patch", "-", "number of the patch of this wheel at this position, from 1", &P::patch},
      {"patches", "-", "number of patches of this wheel at this position", &P::patches},
      {"lateral_shift", "mm", "of the wheelset, positive to the right", &P::lateral_shift},
      {"yaw", "rad", "of the wheelset, positive from x to y of the track (to the right)", &P::yaw},
      {"roll", "rad", "of the wheelset, positive from y to z of the track (right wheel down)",
       &P::roll},
      {"height", "mm", "z of the middle of the axle (down) plus the nominal rolling radius",
       &P::height},
      {"x_track", "mm", "contact point in the track frame, ahead of the middle of the axle",
       &P::x_track},
      {"y_track", "mm", "contact point in the track frame, y to the right", &P::y_track},
      {"z_track", "mm", "contact point in the track frame, z down from the top of the rails",
       &P::z_track},
      {"y_rail", "mm", "contact point in the rail's profile coordinates", &P::y_rail},
      {"y_wheel", "mm", "contact point in the wheel's profile coordinates", &P::y_wheel},
      {"contact_angle", "rad",
       "of the contact plane, positive where it falls towards the middle of the track, as at a "
       "flange",
       &P::contact_angle},
      {"climb", "rad", "rise of the contact plane ahead, on a rail that changes along the track",
       &P::climb},
      {"rolling_radius", "mm", "distance of the contact point from the axle", &P::rolling_radius},
      {"separation", "mm", "distance along the normal at first contact of the wheel",
       &P::separation},
  };
  return scalars;
}

std::vector<WayScalar> ways_of(const contact::Case& input) {
  using W = contact::Wheelset;
  std::vector<WayScalar> ways;
  for (const WayScalar& way :
       {WayScalar{"track_position", "mm", "where along the track the wheel is", &W::track_position},
        WayScalar{"wheel_angle", "rad",
                  "of the section of the wheel that points down; grows as it rolls forward",
                  &W::wheel_angle}})
    if (!(input.wheelset.*way.list).empty()) ways.push_back(way);
  return ways;
}

const std::vector<PointField>& point_fields() {
  using F = const ContactFields&;
  static const std::vector<PointField> fields{
      {"pressure", "MPa", "contact pressure p_n", "positive in compression, 0 outside the patch",
       [](F f) -> const Field& { return f.traction.n; }},
      {"traction_x", "MPa", "tangential traction p_x along rolling",
       "acts on the wheel in +x; negative for positive longitudinal creepage",
       [](F f) -> const Field& { return f.traction.x; }},
      {"traction_y", "MPa", "tangential traction p_y across rolling", "acts on the wheel in +y",
       [](F f) -> const Field& { return f.traction.y; }},
      {"traction_bound", "MPa", "traction bound g of |p_t|: mu p_n, or the theory's own",
       "never negative", [](F f) -> const Field& { return f.traction_bound; }},
      {"slip_x", "-", "slip w_x per unit of rolling distance",
       "wheel surface relative to rail, positive in +x",
       [](F f) -> const Field& { return f.slip.x; }},
      {"slip_y", "-", "slip w_y per unit of rolling distance",
       "wheel surface relative to rail, positive in +y",
       [](F f) -> const Field& { return f.slip.y; }},
      {"gap", "mm", "h + u_n - approach: distance of the deformed surfaces, as solved",
       "positive where open, in the patch 0 within the tolerance, with either sign",
       [](F f) -> const Field& { return f.gap; }},
      {"displacement_x", "mm", "tangential displacement difference u_x", "wheel minus rail",
       [](F f) -> const Field& { return f.displacement.x; }},
      {"displacement_y", "mm", "tangential displacement difference u_y", "wheel minus rail",
       [](F f) -> const Field& { return f.displacement.y; }},
      {"displacement_n", "mm", "normal displacement difference u_n",
       "wheel minus rail, positive when it opens the gap",
       [](F f) -> const Field& { return f.displacement.n; }},
      {"work", "N/mm^2", "frictional work per area and distance rolled, local T-gamma/A",
       "its rows times dx are pass_work", [](F f) -> const Field& { return f.work; }},
  };
  return fields;
}

}  // namespace rollfem::postprocess
