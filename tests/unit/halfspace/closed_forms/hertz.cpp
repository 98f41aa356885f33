// SPDX-License-Identifier: LGPL-2.1-or-later
// Hertz's closed forms against published digits, each other and limits.
#include "halfspace/closed_forms/hertz.hpp"

#include "base/errors.hpp"
#include "result/validity.hpp"
#include "scene/geometry.hpp"
#include "theories/elliptic_patch.hpp"

#include "support/test.hpp"
#include "support/thesis_cases.hpp"

namespace rollfem::halfspace {
TEST(Hertz, GivesCaseAToAllDigitsShown) {
  const HertzContact hertz = hertz_of_scene(thesis_case('a'));
  EXPECT_NEAR(hertz.semi_axis_x, 3.79236, 5e-6);
  EXPECT_NEAR(hertz.semi_axis_y, 10.87295, 5e-6);
  EXPECT_NEAR(hertz.max_pressure, 578.967, 5e-4);
  EXPECT_NEAR(hertz.approach, 0.0473108, 5e-8);
}

TEST(Hertz, GivesTheBenchmarkTable) {
  struct Row {
    double rx, ry, force, a, b, p0, approach;
  };
  for (const Row& row : {Row{300, 300, 82000, 5.45136, 5.45136, 1317.484, 0.099058},
                         Row{460, 300, 10000, 3.33864, 2.51140, 569.449, 0.022628},
                         Row{460, 300, 82000, 6.73248, 5.06432, 1148.311, 0.092013},
                         Row{460, 80, 82000, 8.03001, 2.53894, 1920.375, 0.110377},
                         Row{460, 13, 82000, 9.47315, 0.96579, 4279.343, 0.133419}}) {
    const HertzContact hertz =
        hertz_from_force(0.5 / row.rx, 0.5 / row.ry, 82000.0 / (1.0 - 0.28), row.force);
    EXPECT_NEAR(hertz.semi_axis_x, row.a, 6e-6);
    EXPECT_NEAR(hertz.semi_axis_y, row.b, 6e-6);
    EXPECT_NEAR(hertz.max_pressure, row.p0, 6e-4);
    EXPECT_NEAR(hertz.approach, row.approach, 6e-7);
  }
}

TEST(Hertz, HoldsForAnyAspectRatioBothWays) {
  // The displacement under the pressure must be approach - h everywhere in the patch: checked at
  // the middle and the ends of both axes, where the potential is evaluated independently of the
  // root that gave the shape.
  for (const double ratio : {1.0, 1.000001, 2.0, 37.0, 1e3, 1e5, 1e7})
    for (const bool swapped : {false, true}) {
      const double A = swapped ? 1e-3 * ratio : 1e-3;
      const double B = swapped ? 1e-3 : 1e-3 * ratio;
      const double modulus = 115384.6;
      const HertzContact hertz = hertz_from_force(A, B, modulus, 1e4);
      const auto mismatch = [&](double x, double y) {
        return hertz_displacement(hertz, modulus, x, y) + A * x * x + B * y * y - hertz.approach;
      };
      EXPECT_NEAR(mismatch(0.0, 0.0), 0.0, 1e-13 * hertz.approach);
      EXPECT_NEAR(mismatch(hertz.semi_axis_x, 0.0), 0.0, 1e-11 * hertz.approach) << ratio;
      EXPECT_NEAR(mismatch(0.0, hertz.semi_axis_y), 0.0, 1e-11 * hertz.approach) << ratio;
      EXPECT_NEAR(mismatch(0.3 * hertz.semi_axis_x, -0.7 * hertz.semi_axis_y), 0.0,
                  1e-11 * hertz.approach);
      const HertzContact back = hertz_from_approach(A, B, modulus, hertz.approach);
      EXPECT_NEAR(back.normal_force / 1e4, 1.0, 1e-12);
      EXPECT_NEAR(back.semi_axis_y / hertz.semi_axis_y, 1.0, 1e-12);
    }
  const HertzContact slender = hertz_from_force(1e-10, 1e-2, 1e5, 1e3);
  EXPECT_GT(slender.semi_axis_x / slender.semi_axis_y, 1e4);
}

TEST(Hertz, LongEllipseTendsToTheLine) {
  // In the middle of a very long ellipse the pressure and the width are those of a line contact
  // with the force per length found there, p0 = 2 P/(pi a).
  const double modulus = 1e5;
  const HertzContact ellipse = hertz_from_force(1e-2, 1e-9, modulus, 1e4);
  const double force_per_length = 0.5 * M_PI * ellipse.semi_axis_x * ellipse.max_pressure;
  const LineHertz line = line_hertz(0.5 / 1e-2, modulus, force_per_length, 1.0);
  EXPECT_NEAR(line.half_width / ellipse.semi_axis_x, 1.0, 1e-4);
  EXPECT_NEAR(line.max_pressure / ellipse.max_pressure, 1.0, 1e-4);
  const LineHertz benchmark = line_hertz(500.0, 82000.0 / 0.72, 178.896, 1.0);
  EXPECT_NEAR(benchmark.half_width, 1.0, 1e-5);
  EXPECT_NEAR(benchmark.max_pressure, 113.889, 1e-3);
}

TEST(Hertz, RefusesContactsThatAreNotElliptic) {
  EXPECT_THROW(hertz_from_force(1e-3, 0.0, 1e5, 1.0), contact::InputError);
  EXPECT_THROW(hertz_from_force(1e-3, -1e-3, 1e5, 1.0), contact::InputError);
  EXPECT_THROW(hertz_from_force(1e-3, 1e-3, 1e5, 0.0), contact::InputError);
  EXPECT_THROW(hertz_from_force(1e-3, 1e-3, 1e5, std::nan("")), contact::InputError);
  EXPECT_THROW(hertz_from_approach(1e-3, 1e-3, 1e5, -1e-3), contact::InputError);
}

TEST(HertzModel, HasOnePointWithTheFieldsOfTheClosedForm) {
  contact::Case input = thesis_case('a', 40, {{0.0, 0.0, 0.0}, {1e-3, 0.0, 0.0}});
  const contact::ModelResult result = theories::run_hertz(input, {});
  ASSERT_EQ(result.points.size(), 1u);
  const contact::PointResult& point = result.points.front();
  EXPECT_EQ(point.creepage.longitudinal, 0.0);
  EXPECT_EQ(point.normal_force, 50e3);
  const double sum = point.fields.traction.n.sum() * result.grid.element_area();
  EXPECT_NEAR(sum / 50e3, 1.0, 0.003);
  // The ellipsoid's displacement closes the parabolas within the patch and opens them outside.
  const contact::ContactResidual left = contact::contact_residual(point.fields);
  EXPECT_LT(left.gap, 1e-13);
  EXPECT_GT(point.fields.gap.maxCoeff(), 0.01 * point.approach);
  EXPECT_EQ(point.fields.traction.x.cwiseAbs().maxCoeff(), 0.0);
}
}  // namespace rollfem::halfspace
