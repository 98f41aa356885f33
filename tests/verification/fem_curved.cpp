// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of curved conformal patches in finite elements: the flat limit, and the study's case f
// (rail of 50 mm under a wheel of -51.282 mm) on coarse cells against the half-space.
#include "fem/elasticity/run_level.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "scene/contact_surface.hpp"

#include "support/committed_cases.hpp"
#include "support/contact_laws.hpp"
#include "support/mpi_environment.hpp"

namespace {

contact::ModelResult solve(const contact::Case& input, double cell) {
  return fem::run_level(input, {cell, "", false}, {});
}

/// Solved once for all tests of this program.
const contact::ModelResult& case_f() {
  static const contact::ModelResult result = solve(committed_case('f', {0.0, 0.002}), 0.94);
  return result;
}

}  // namespace

TEST(FemCurvedContact, OfVeryLargeRadiiIsThatOfFlatBodies) {
  const contact::Case flat = committed_case('a', {0.002});
  contact::Case nearly = flat;
  nearly.wheel.transverse_radius = -1e6;
  nearly.rail.transverse_radius = 1.0 / (1.0 / 2000.0 + 1e-6);  // the same relative curvature
  const contact::PointResult one = solve(flat, 1.88).points.front();
  const contact::PointResult other = solve(nearly, 1.88).points.front();
  EXPECT_NEAR(other.max_pressure / one.max_pressure, 1.0, 1e-5);
  EXPECT_NEAR(other.approach / one.approach, 1.0, 1e-4);
  // The wheel's radius grows by y^2 / 2e6: 1e-7 of slip at the edge of the patch.
  EXPECT_NEAR(other.traction_coefficient, one.traction_coefficient, 3e-5);
  EXPECT_LT(other.traction_coefficient, one.traction_coefficient);
}

TEST(FemCurvedContact, CarriesTheVerticalForceByPressureAndFriction) {
  const contact::ModelResult& result = case_f();
  const contact::PatchShape shape =
      contact::patch_shape(contact::Geometry(committed_case('f', {0.0})).surface, result.grid);
  const contact::Field sine = shape.climb.cwiseQuotient(shape.stretch);
  const contact::Field cosine = shape.stretch.cwiseInverse();
  for (const contact::PointResult& point : result.points) {
    // Force of each element: true area times traction, turned from the local frame.
    const contact::SurfaceField& p = point.fields.traction;
    const contact::Field area = result.grid.element_area() * shape.stretch;
    const double lift = area.dot(p.y.cwiseProduct(sine));
    EXPECT_NEAR((area.dot(p.n.cwiseProduct(cosine)) + lift) / 50e3, 1.0, 1e-8);
    EXPECT_NEAR(point.normal_force / 50e3, 1.0, 1e-8);
    EXPECT_NEAR(point.longitudinal_force, area.dot(p.x), 1e-6);
    EXPECT_LT(std::abs(point.lateral_force), 1e-5 * point.normal_force);
    EXPECT_GT(std::abs(lift), 1.0);  // N: a test that would see a missing lift
  }
}

TEST(FemCurvedContact, KeepsCoulombAndComplementarityAtEveryElement) {
  for (const contact::PointResult& point : case_f().points) {
    expect_contact_laws(point, 0.55, 578.97);
    EXPECT_GT(point.fields.gap.maxCoeff(), 0.05 * point.approach);
  }
}

TEST(FemCurvedContact, OfCaseFShiftsTheCreepCurveAsTheCurvedHalfspaceOnTheSameCells) {
  // Both have distance, slip and local spin of the true surfaces. What is left is elasticity: the
  // strain of a loaded wheel, 0.0030 to 0.0034, and on cells of 0.94 mm, an eighth of the patch,
  // what the cells do, 0.4 % of mu either way. Finite elements without that strain would be 0.0039
  // below, with its sign turned 0.0073.
  contact::Case same_cells = committed_case('f', {0.0, 0.002});
  same_cells.contact_grid.cell_size = {{0.94, 0.94}};
  same_cells.surface = contact::SurfaceForm::curved;
  const contact::ModelResult half = halfspace::run_halfspace(same_cells, {});
  for (const int k : {0, 1}) {
    const double difference = case_f().points[k].traction_coefficient -
                              half.points[static_cast<std::size_t>(k)].traction_coefficient;
    EXPECT_GT(difference, -0.0025) << k;
    EXPECT_LT(difference, 0.0034 + 0.0025) << k;
  }
  EXPECT_NEAR(case_f().points[0].max_pressure / 578.97, 1.0, 0.02);
}
