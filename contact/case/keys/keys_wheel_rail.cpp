// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail: their radii, materials, profiles and meshes.
#include "contact/case/keys/key_builder.hpp"

namespace rollfem::contact {

namespace {

template <class Body>
void add_radius(Keys<Body>& keys, const char* symbol, const char* example, const char* sentence) {
  keys.real("transverse_radius")
      .symbol(symbol)
      .unit("mm")
      .sized(smallest_radius, largest)
      .or_inf()
      .required(example)
      .says(sentence)
      .into(&Body::transverse_radius);
  keys.real("round_to")
      .between(0.1, 0.9)
      .says(
          "Fraction of the transverse radius up to which the profile is a circle; beyond, it is "
          "straight (docs/meshes.md).")
      .into(&Body::round_to);
}

template <class Body>
void add_material(Keys<Body>& keys) {
  keys.real("young_modulus")
      .symbol("E")
      .unit("MPa")
      .positive()
      .or_inf()
      .says("Young's modulus, of steel by default; inf: a rigid body (not both).")
      .into(&Body::material, &Material::young_modulus);
  keys.real("poisson_ratio")
      .symbol("nu")
      .between(0.0, 0.5)
      .upper_open()
      .says("Poisson's ratio; 0.5 (incompressible) is not covered.")
      .into(&Body::material, &Material::poisson_ratio);
  keys.real("density")
      .symbol("rho")
      .unit("t/mm^3")
      .zero_or(1e-15, 1e-7)
      .says(
          "Mass density, of steel by default (1 t/mm^3 = 1e12 kg/m^3); matters only with "
          "fem.inertia.")
      .into(&Body::material, &Material::density);
}

/// `names`: built-in profiles, `files`: formats besides two columns.
template <class Body>
void add_shape_from_files(Keys<Body>& keys, const std::string& names, const std::string& files) {
  keys.text("profile")
      .otherwise("transverse_radius applies")
      .says("The profile, instead of transverse_radius: " + names +
            ", `arcs`, `polynomial`, or a file: columns y, z, " + files + ". Details: [" +
            keys.section().name + "_profile], docs/profiles.md.")
      .into(&Body::profile, &ProfileSource::name);
  keys.text("mesh")
      .otherwise("meshed by the program")
      .says(
          "Hexahedral gmsh mesh (.msh 4.1 or 2.2, mm, contact point at the origin) with the "
          "physical surfaces `contact`, `fixed`, and `symmetry` for a half y >= 0 (model fem).")
      .into(&Body::mesh);
}

}  // namespace

SectionWithKeys wheel_section() {
  Keys<Wheel> keys("wheel", "Upper body (1): a surface of revolution about the axle", &Case::wheel);
  keys.real("rolling_radius")
      .symbol("R")
      .unit("mm")
      .between(smallest_radius, largest)
      .required("405.0")
      .says("Radius of the wheel at the running circle.")
      .into(&Wheel::rolling_radius);
  add_radius(keys, "R_wy", "inf",
             "Radius of the wheel's profile: positive convex, negative concave (a hollow tread; "
             "larger than the rail's), inf flat; not with `profile`.");
  add_material(keys);
  add_shape_from_files(keys, "`S1002` or `S1002-smooth`", "SIMPACK .prw, MiniProf .whl");
  return keys;
}

SectionWithKeys rail_section() {
  Keys<Rail> keys("rail", "Lower body (2): a straight extruded rail", &Case::rail);
  add_radius(keys, "R_ry", "2000.0",
             "Radius of the rail's head: positive convex, negative concave, inf flat; not with "
             "`profile`.");
  add_material(keys);
  add_shape_from_files(keys, "`60E1` (the same as `UIC60`) or `UIC60-manchester`",
                       "SIMPACK .prr, MiniProf .ban");
  return keys;
}

}  // namespace rollfem::contact
