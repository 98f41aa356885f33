// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/point_fields.hpp"

namespace rollfem::contact {

const std::vector<PointField>& point_fields() {
  using F = ContactFields&;
  static const std::vector<PointField> fields{
      {"pressure", "MPa", "contact pressure p_n", "positive in compression, 0 outside the patch",
       [](F f) -> Field& { return f.traction.n; }},
      {"traction_x", "MPa", "tangential traction p_x along rolling",
       "acts on the wheel in +x; negative for positive longitudinal creepage",
       [](F f) -> Field& { return f.traction.x; }},
      {"traction_y", "MPa", "tangential traction p_y across rolling", "acts on the wheel in +y",
       [](F f) -> Field& { return f.traction.y; }},
      {"traction_bound", "MPa", "traction bound g of |p_t|: mu p_n, or the theory's own",
       "never negative", [](F f) -> Field& { return f.traction_bound; }},
      {"slip_x", "-", "slip w_x per unit of rolling distance",
       "wheel surface relative to rail, positive in +x", [](F f) -> Field& { return f.slip.x; }},
      {"slip_y", "-", "slip w_y per unit of rolling distance",
       "wheel surface relative to rail, positive in +y", [](F f) -> Field& { return f.slip.y; }},
      {"gap", "mm", "h + u_n - approach: distance of the deformed surfaces, as solved",
       "positive where open, in the patch 0 within the tolerance, with either sign",
       [](F f) -> Field& { return f.gap; }},
      {"displacement_x", "mm", "tangential displacement difference u_x", "wheel minus rail",
       [](F f) -> Field& { return f.displacement.x; }},
      {"displacement_y", "mm", "tangential displacement difference u_y", "wheel minus rail",
       [](F f) -> Field& { return f.displacement.y; }},
      {"displacement_n", "mm", "normal displacement difference u_n",
       "wheel minus rail, positive when it opens the gap",
       [](F f) -> Field& { return f.displacement.n; }},
      {"work", "N/mm^2", "frictional work per area and distance rolled, local T-gamma/A",
       "its rows times dx are pass_work", [](F f) -> Field& { return f.work; }},
  };
  return fields;
}

}  // namespace rollfem::contact
