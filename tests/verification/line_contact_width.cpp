// SPDX-License-Identifier: LGPL-2.1-or-later
// Line contact of bodies of finite width: CONTACT's row of elements, and a roller that is smaller
// than its patch.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"
#include "scene/scene.hpp"

#include "support/half_space_models.hpp"
#include "support/temporary_folder.hpp"

namespace {

contact::PointResult by_halfspace(const std::string& text) {
  return half_space_models()
      .run("halfspace", contact::Scene(contact::parse_case(text, "roller.toml")), {})
      .points.at(0);
}

TEST(LineContact, OfFiniteWidthIsAnElementOfContact) {
  // CONTACT 2707, one row of elements of 200 mm, whose layer yields: shift -1.976e-3 mm, approach
  // 6.492e-3 mm, elastic energy 0.1221 J.
  const contact::PointResult point = by_halfspace(
      "[load]\nnormal_force = 35780.0\n[friction]\ncoefficient = 0.5\n"
      "[layer]\nyield_stress = 35.0\nhardening = 123e3\n"
      "[wheel]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[rail]\nyoung_modulus = 209920.0\npoisson_ratio = 0.28\n"
      "[geometry]\nshape = \"line\"\nrelative_radius = 500.0\nwidth = 200.0\n"
      "reference_distance = inf\n[rolling]\nproblem = \"shift\"\nlongitudinal_force = 10734.0\n"
      "[contact_grid]\ncell_size = [0.08, 200.0]\nextent = [2.4, 200.0]\n");
  EXPECT_NEAR(point.longitudinal_shift, -1.976e-3, 1e-6);
  EXPECT_NEAR(point.approach, 6.492e-3, 1e-6);
  EXPECT_NEAR(*point.elastic_energy, 122.1, 0.1);
}

/// Rubber on a small roller: Hertz's half width sqrt(4 F R / (pi E* l)) is 41 mm at R = 35 mm.
TEST(LineContact, APatchLongerThanTheBodyIsReportedBeforeItsReference) {
  const std::string roller = R"(
[load]
normal_force = 380.0
[friction]
coefficient = 0.0
[wheel]
young_modulus = 0.275
poisson_ratio = 0.475
[rail]
young_modulus = inf
[geometry]
shape = "line"
width = 28.0
relative_radius = 35.0
[rolling]
problem = "frictionless"
)";
  const std::string message = refusal<contact::InputError>([&] { by_halfspace(roller); });
  EXPECT_TRUE(says(message, "the patch of 82.", "relative radius is 35 mm", "do: check"));
  EXPECT_FALSE(says(message, "reference_distance"));
}

}  // namespace
