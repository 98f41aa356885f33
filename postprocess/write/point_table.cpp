#include "postprocess/write/point_table.hpp"

namespace rollfem::postprocess {

using contact::ContactFields;
using contact::Field;
using contact::PointResult;

const std::vector<PointScalar>& point_scalars() {
  using P = const PointResult&;
  static const std::vector<PointScalar> scalars{
      {"longitudinal_creepage", "-", "xi; positive brakes the wheel",
       [](P p) { return p.creepage.longitudinal; }},
      {"lateral_creepage", "-", "eta", [](P p) { return p.creepage.lateral; }},
      {"spin", "rad/mm", "phi", [](P p) { return p.creepage.spin; }},
      {"step", "-", "number of the step in a history, from 1; 0 where there is none",
       [](P p) { return static_cast<double>(p.step); }},
      {"longitudinal_shift", "mm", "rigid shift of the wheel over the rail since the beginning",
       [](P p) { return p.longitudinal_shift; }},
      {"lateral_shift", "mm", "the same along y", [](P p) { return p.lateral_shift; }},
      {"spin_shift", "rad", "rotation about the normal since the beginning",
       [](P p) { return p.spin_shift; }},
      {"distance", "mm", "distance rolled since the beginning", [](P p) { return p.distance; }},
      {"normal_force", "N", "F_z, positive in compression", [](P p) { return p.normal_force; }},
      {"longitudinal_force", "N", "F_x on the wheel; negative for positive xi",
       [](P p) { return p.longitudinal_force; }},
      {"lateral_force", "N", "F_y on the wheel; negative for positive eta",
       [](P p) { return p.lateral_force; }},
      {"spin_moment", "N mm", "M_z on the wheel about the origin",
       [](P p) { return p.spin_moment; }},
      {"traction_coefficient", "-", "-F_x / F_z: rises with xi",
       [](P p) { return p.traction_coefficient; }},
      {"max_pressure", "MPa", "largest contact pressure", [](P p) { return p.max_pressure; }},
      {"max_traction", "MPa", "largest tangential traction |p_t|",
       [](P p) { return p.max_traction; }},
      {"max_traction_x", "MPa", "largest |p_x|", [](P p) { return p.max_traction_x; }},
      {"approach", "mm", "how far the bodies have come together since they touched",
       [](P p) { return p.approach; }},
      {"semi_axis_x", "mm", "semi-axis of the patch along rolling",
       [](P p) { return p.semi_axis_x; }},
      {"semi_axis_y", "mm", "semi-axis of the patch across", [](P p) { return p.semi_axis_y; }},
      {"contact_length", "mm", "extent of the patch in x", [](P p) { return p.contact_length; }},
      {"contact_width", "mm", "extent of the patch in y", [](P p) { return p.contact_width; }},
      {"contact_area", "mm^2", "area of the patch", [](P p) { return p.contact_area; }},
      {"adhesion_area", "mm^2", "area that does not slip", [](P p) { return p.adhesion_area; }},
  };
  return scalars;
}

const std::vector<PlaceScalar>& place_scalars() {
  using P = const contact::ContactPlace&;
  static const std::vector<PlaceScalar> scalars{
      {"position", "-", "number of the wheelset's position, from 1",
       [](P p) { return static_cast<double>(p.position); }},
      {"patch", "-", "number of the patch of this wheel at this position, from 1",
       [](P p) { return static_cast<double>(p.patch); }},
      {"patches", "-", "how many patches this wheel has at this position",
       [](P p) { return static_cast<double>(p.patches); }},
      {"lateral_shift", "mm", "of the wheelset, positive to the right",
       [](P p) { return p.lateral_shift; }},
      {"yaw", "rad", "of the wheelset, positive from x to y of the track (to the right)",
       [](P p) { return p.yaw; }},
      {"roll", "rad", "of the wheelset, positive from y to z of the track (right wheel down)",
       [](P p) { return p.roll; }},
      {"height", "mm", "z of the middle of the axle (down) plus the nominal rolling radius",
       [](P p) { return p.height; }},
      {"y_track", "mm", "contact point in the track frame, y to the right",
       [](P p) { return p.y_track; }},
      {"z_track", "mm", "contact point in the track frame, z down from the top of the rails",
       [](P p) { return p.z_track; }},
      {"y_rail", "mm", "contact point in the rail's profile coordinates",
       [](P p) { return p.y_rail; }},
      {"y_wheel", "mm", "contact point in the wheel's profile coordinates",
       [](P p) { return p.y_wheel; }},
      {"contact_angle", "rad", "of the rail's tangent, positive where it rises to the flange",
       [](P p) { return p.contact_angle; }},
      {"rolling_radius", "mm", "distance of the contact point from the axle",
       [](P p) { return p.rolling_radius; }},
      {"separation", "mm", "distance along the normal at first contact of the wheel",
       [](P p) { return p.separation; }},
  };
  return scalars;
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
      {"traction_bound", "MPa", "bound g of |p_t|: mu p_n, or that of the theory", "never negative",
       [](F f) -> const Field& { return f.traction_bound; }},
      {"slip_x", "-", "slip w_x per unit of rolling distance",
       "wheel surface relative to rail, positive in +x",
       [](F f) -> const Field& { return f.slip.x; }},
      {"slip_y", "-", "slip w_y per unit of rolling distance",
       "wheel surface relative to rail, positive in +y",
       [](F f) -> const Field& { return f.slip.y; }},
      {"gap", "mm", "distance of the deformed surfaces", "positive where open, 0 in the patch",
       [](F f) -> const Field& { return f.gap; }},
      {"displacement_x", "mm", "tangential displacement difference u_x", "wheel minus rail",
       [](F f) -> const Field& { return f.displacement.x; }},
      {"displacement_y", "mm", "tangential displacement difference u_y", "wheel minus rail",
       [](F f) -> const Field& { return f.displacement.y; }},
      {"displacement_n", "mm", "normal displacement difference u_n",
       "wheel minus rail, positive when it opens the gap",
       [](F f) -> const Field& { return f.displacement.n; }},
  };
  return fields;
}

}  // namespace rollfem::postprocess
