// SPDX-License-Identifier: LGPL-2.1-or-later
// Combined constants, relative curvatures, undeformed distance and rigid slip.
#include "scene/geometry.hpp"

#include "case/reading/case_reader.hpp"

#include "support/case_examples.hpp"
#include "support/model_keys.hpp"
#include "support/places.hpp"

TEST(CombinedConstants, OfLikeMaterialsAreThoseOfTheMaterial) {
  const Material steel{210e3, 0.3};
  const CombinedMaterial both = combine(steel, steel);
  EXPECT_NEAR(both.shear_modulus, 210e3 / 2.6, 1e-8);
  EXPECT_NEAR(both.poisson_ratio, 0.3, 1e-15);
  EXPECT_EQ(both.difference, 0.0);
  EXPECT_NEAR(both.contact_modulus, 210e3 / (2.0 * 0.91), 1e-8);
}

TEST(CombinedConstants, OfARigidBodyAreHalfAsCompliant) {
  const CombinedMaterial both = combine({210e3, 0.3}, rigid_material());
  EXPECT_DOUBLE_EQ(both.contact_modulus, 210e3 / 0.91);
  EXPECT_DOUBLE_EQ(both.shear_modulus, 2.0 * 210e3 / 2.6);
  // K of steel on a rigid body: (1 - 2 nu)/2 (Johnson 1985, 5.1: beta = (1 - 2 nu)/(2 (1 - nu))
  // with K = (1 - nu) beta).
  EXPECT_DOUBLE_EQ(both.difference, 0.5 * (1.0 - 0.6));
}

TEST(CombinedConstants, ExchangeOfBodiesTurnsTheSignOfTheDifferenceOnly) {
  const Material steel{210e3, 0.3};
  const Material rubber{10.0, 0.45};
  const CombinedMaterial one = combine(steel, rubber);
  const CombinedMaterial other = combine(rubber, steel);
  EXPECT_DOUBLE_EQ(one.shear_modulus, other.shear_modulus);
  EXPECT_DOUBLE_EQ(one.poisson_ratio, other.poisson_ratio);
  EXPECT_DOUBLE_EQ(one.contact_modulus, other.contact_modulus);
  EXPECT_DOUBLE_EQ(one.difference, -other.difference);
  EXPECT_LT(one.difference, 0.0);
}

TEST(RelativeCurvatures, OfTheStudysCasesAgreeInPairs) {
  const std::string folder = std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_";
  const auto curvatures = [&](const char* name) {
    return relative_curvatures(read_case(folder + name + ".toml"));
  };
  EXPECT_DOUBLE_EQ(curvatures("a").A, 0.5 / 405.0);
  EXPECT_DOUBLE_EQ(curvatures("a").B, 0.5 / 2000.0);
  // The radii of d, e and f are given to three decimals.
  EXPECT_NEAR(curvatures("d").B / curvatures("c").B, 1.0, 1e-5);
  EXPECT_NEAR(curvatures("e").B / curvatures("a").B, 1.0, 1e-4);
  EXPECT_NEAR(curvatures("f").B / curvatures("a").B, 1.0, 1e-3);
}

TEST(UndeformedDistance, IsTheParabolicDropOfWheelAndRail) {
  const Curvatures curvatures = relative_curvatures(parse_case(small_case, "s"));
  EXPECT_EQ(undeformed_distance(curvatures, 0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(undeformed_distance(curvatures, 3.0, 0.0), 9.0 / 810.0);
  EXPECT_DOUBLE_EQ(undeformed_distance(curvatures, 0.0, -10.0), 100.0 / 4000.0);
}

TEST(RigidSlip, IsCreepagePlusSpinAboutTheOrigin) {
  const Case input = parse_case(small_case, "s");
  const ContactGrid grid = ContactGrid::centred(3, 3, 1.0, 2.0);
  const TangentialField slip =
      ChartedGeometry(input, Chart::plane).rigid_slip({0.001, 0.002, 0.0005}, grid);
  const int corner = grid.index(2, 0);  // x = 1, y = -2
  EXPECT_DOUBLE_EQ(slip.x[corner], 0.001 + 0.0005 * 2.0);
  EXPECT_DOUBLE_EQ(slip.y[corner], 0.002 + 0.0005 * 1.0);
  EXPECT_DOUBLE_EQ(slip.x[grid.index(1, 1)], 0.001);
}

TEST(RigidSlip, OfACurvedWheelIsThatOfItsRollingRadii) {
  // The study's case e: the wheel is 0.475 mm larger 10 mm beside the running circle (105.263 mm
  // concave), and drives there; a convex one as in case d brakes.
  for (const double radius : {-105.263, 105.263}) {
    Case input = parse_case(small_case, "s");
    input.wheel.transverse_radius = radius;
    const ContactGrid grid = ContactGrid::centred(1, 3, 1.0, 10.0);
    const TangentialField slip = ChartedGeometry(input, Chart::plane).rigid_slip({}, grid);
    const double drop = 105.263 - std::sqrt(105.263 * 105.263 - 100.0);
    EXPECT_NEAR(slip.x[0], (radius > 0.0 ? drop : -drop) / 405.0, 1e-12);
    EXPECT_EQ(slip.x[1], 0.0);
    EXPECT_DOUBLE_EQ(slip.x[0], slip.x[2]);
    EXPECT_EQ(slip.y.norm(), 0.0);
    input.rolling.extra_slip = ExtraSlip::none;
    EXPECT_EQ(ChartedGeometry(input, Chart::plane).rigid_slip({}, grid).x.norm(), 0.0);
  }
}
