// SPDX-License-Identifier: LGPL-2.1-or-later
// Line contact: CONTACT's row of elements, a roller that is smaller than its patch, models without
// line contacts (Hertz, Carter, Bentall and Johnson, Nowell and Hills, Spence, width and reference
// distance: the book).
#include "base/errors.hpp"
#include "base/material.hpp"
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

TEST(LineContact, OtherModelsSayThatTheyCannotTakeIt) {
  const contact::Scene scene(contact::parse_case(
      "[load]\nnormal_force = 180.0\n[friction]\ncoefficient = 0.3\n[geometry]\nshape = \"line\"\n"
      "[wheel]\nrolling_radius = 500.0\n[rolling]\nlongitudinal_creepage = 1e-4\n",
      "line.toml"));
  for (const char* model : {"linear", "vermeulen-johnson", "fastsim", "strip"})
    EXPECT_TRUE(
        says(refusal<std::runtime_error>([&] { half_space_models().run(model, scene, {}); }),
             "geometry.shape: it cannot handle a line contact"))
        << model;
}

TEST(BentallJohnson, MaterialOfTheBenchmark) {
  const auto m = contact::combine({2.0 * 23000.0 * 1.31, 0.31}, {2.0 * 82000.0 * 1.28, 0.28});
  EXPECT_NEAR(m.shear_modulus, 35923.8, 0.05);
  EXPECT_NEAR(m.poisson_ratio, 0.30343, 5e-6);
  EXPECT_NEAR(m.difference, 0.10019, 5e-6);
  // 16.2019 N/mm make a = 0.1 mm.
  EXPECT_NEAR(M_PI * 0.1 * 0.1 * m.contact_modulus / (4.0 * 25.0), 16.2019, 1e-3);
}

}  // namespace
