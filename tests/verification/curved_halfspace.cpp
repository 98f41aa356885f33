// SPDX-License-Identifier: LGPL-2.1-or-later
// Curved contact of the model halfspace ([halfspace] surface = "curved"): slip by rigid-body
// velocities of the wheel, distance of concentric circles, refusals (the plane limit, extra slip,
// conforming cylinders: the book).
#include "base/errors.hpp"
#include "scene/scene.hpp"

#include "support/committed_cases.hpp"
#include "support/half_space_models.hpp"
#include "support/patch_case.hpp"
#include "support/profile_patches.hpp"
#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"

namespace {

PointResult run(const PatchCase& input) {
  return half_space_models().run("halfspace", input, {}).points.front();
}

PatchCase curved(PatchCase input) {
  input.surface = SurfaceForm::curved;
  return input;
}

/// Tilted axle, lopsided profiles: S1002 on UIC60.
PatchCase s1002() {
  PatchCase input = thesis_case('b');
  input.wheel.rolling_radius = 450.0;
  input.patch = s1002_on_uic60(-3.95, 8.58);
  return curved(input);
}

}  // namespace

TEST(CurvedHalfspace, SlipIsThatOfTheTurningWheel) {
  const PatchCase input = s1002();
  const contact::PatchGeometry& patch = *input.patch;
  const contact::ChartedGeometry surface(contact::Scene(input).geometry, contact::Chart::arc);
  const double xi = 2e-3;
  const auto& e = patch.axle().direction;
  const double omega = (1.0 - xi) / patch.local_rolling_radius(0.0);
  // No spin and lateral creepage beyond those of the turning.
  const contact::Creepage creepage{xi, 0.0, omega * e[2]};
  const ContactGrid grid = ContactGrid::centred(3, 21, 4.0, 1.0);
  const auto slip = surface.rigid_slip(creepage, grid);
  for (int j = 0; j < grid.ny; ++j) {
    const double y = surface.lateral_place(grid.y(j));
    const double z = patch.wheel().at(y).value;
    const double cosine = 1.0 / std::hypot(1.0, surface.climb(grid.y(j)));
    const double sine = surface.climb(grid.y(j)) * cosine;
    for (int i = 0; i < grid.nx; ++i) {
      // omega x r of a point of the wheel, which moves on by 1 along x as the rail stays.
      const double r[3] = {grid.x(i) - patch.axle().point[0], y - patch.axle().point[1],
                           z - patch.axle().point[2]};
      const double along = 1.0 + omega * (e[1] * r[2] - e[2] * r[1]);
      const double v_y = omega * (e[2] * r[0] - e[0] * r[2]);
      const double v_z = omega * (e[0] * r[1] - e[1] * r[0]);
      EXPECT_NEAR(slip.x[grid.index(i, j)], along, 1e-9) << y;
      EXPECT_NEAR(slip.y[grid.index(i, j)], v_y * cosine + v_z * sine, 1e-9) << y;
    }
  }
}

TEST(CurvedHalfspace, ArcAndDistanceOfConcentricCircles) {
  // R13 in a hollow of 14 mm: the common surface is close to a circle of 13.5 mm, the distance
  // along its normal 1 - cos of the angle times the distance of the centres.
  PatchCase input = thesis_case('b');
  input.rail.transverse_radius = 13.0;
  input.wheel.transverse_radius = -14.0;
  const contact::ChartedGeometry surface(contact::Scene(curved(input)).geometry,
                                         contact::Chart::arc);
  const ContactGrid grid = ContactGrid::centred(1, 9, 1.0, 1.0);
  const auto distance = surface.undeformed_distance(grid);
  for (int j = 0; j < grid.ny; ++j) {
    const double s = grid.y(j);
    EXPECT_NEAR(surface.lateral_place(s), 13.5 * std::sin(s / 13.5), 1e-3 * std::abs(s));
    // Along any line at the angle a through about the centres: 1 mm (1 - cos a), to a^2 / 30.
    const double exact = 1.0 - std::cos(s / 13.5);
    EXPECT_NEAR(distance[j], exact, 0.01 * exact + 1e-9);
  }
}

TEST(CurvedHalfspace, RefusesCasesBeyondItsAssumptions) {
  PatchCase quadratic = curved(thesis_case('a'));
  quadratic.undeformed_distance.quadratic = {1e-3, 1e-3};
  EXPECT_THROW(run(quadratic), contact::InputError);
}

TEST(CurvedHalfspace, RefusesAGrooveThatFitsTooWell) {
  // Half the patch is 44 degrees in a groove of 10.02 mm, where circles go on as straight flanks,
  // which touch along their whole length.
  contact::Case input = committed_case("conformal_groove");
  input.rail.transverse_radius = -10.02;
  input.contact_grid.elements_across = 8;
  EXPECT_TRUE(
      says(refusal<contact::SolveError>([&] { run(input); }), "straight flanks", "round_to"));
}
