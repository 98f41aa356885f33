// SPDX-License-Identifier: LGPL-2.1-or-later
// The hybrid: nothing where bodies are half-spaces, the strain of a loaded wheel where it is one,
// and the finite elements' pressure and forces where the surfaces are steep.
#include "base/errors.hpp"
#include "fem/elasticity/fem_model.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_compliance.hpp"
#include "hybrid/hybrid_model.hpp"
#include "scene/scene.hpp"

#include "support/committed_cases.hpp"
#include "support/elastic_sphere.hpp"
#include "support/mpi_environment.hpp"

namespace {

contact::Case study_on_40(char name, const std::vector<double>& creepages) {
  contact::Case input = committed_case(name, creepages);
  input.contact_grid.elements_across = 40;
  return input;
}

contact::ModelResult hybrid_of(const contact::Case& input) {
  return hybrid::run_hybrid(input, {}, nullptr, hybrid::find_smooth_parts);
}

/// Displacement by one body of a scene whose other one is rigid, under Hertz's pressure and half of
/// it as friction, less its mean (which is the far boundary's), in mm.
contact::SurfaceField beyond(const hybrid::SmoothMap& map) {
  const double a = map.loads.half_length, b = map.loads.half_width;
  const auto grid = contact::ContactGrid::centred(16, 16, 0.1 * a, 0.1 * b);
  const contact::Field hertz = hertz_pressure(grid, a, b, 1e3);
  // Half a body carries friction along rolling, and to both sides.
  const contact::Field sides =
      hertz.cwiseProduct(grid.sample([&](double, double y) { return y / b; }));
  contact::SurfaceField u = hybrid::SmoothMapOnGrid(map, grid).apply({0.5 * hertz, sides, hertz});
  for (contact::Field* part : {&u.x, &u.y, &u.n}) part->array() -= part->mean();
  return u;
}

/// Largest difference of any component over the largest of the second.
double farthest(const contact::SurfaceField& one, const contact::SurfaceField& other) {
  double most = 0.0, scale = 0.0;
  for (auto part :
       {&contact::SurfaceField::x, &contact::SurfaceField::y, &contact::SurfaceField::n}) {
    most = std::max(most, (one.*part - other.*part).cwiseAbs().maxCoeff());
    scale = std::max(scale, (other.*part).cwiseAbs().maxCoeff());
  }
  return most / scale;
}

}  // namespace

TEST(Hybrid, OfAFreeMeshIsThatOfTheBox) {
  // Sections by gmsh have a twin with other cells than theirs: a box. What they add must be what
  // boxes add to within what a hybrid calls uncertain of it, a tenth.
  contact::Case input = study_on_40('e', {0.0});
  input.body_extent = 30.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const hybrid::SmoothParts boxes = hybrid::find_smooth_parts(scene, {});
  scene.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh;
  const hybrid::SmoothParts free = hybrid::find_smooth_parts(scene, {});
  EXPECT_NE(free.unknowns, boxes.unknowns);
  const double wheel = farthest(beyond(free.wheel), beyond(boxes.wheel));
  const double rail = farthest(beyond(free.rail), beyond(boxes.rail));
  EXPECT_LT(wheel, 0.1);
  EXPECT_LT(rail, 0.1);
  scene.output.stress_maxima = true;
  EXPECT_THROW(hybrid::find_smooth_parts(scene, {}), contact::InputError);
}

TEST(Hybrid, AFlatRailIsNotMeshed) {
  // On a curved common surface it still adds something; with stresses below the surface it is
  // meshed. The bars hold a tenth of what is
  // added.
  contact::Case input = study_on_40('b', {0.0});
  input.wheel.transverse_radius = 100.0;
  input.wheel.material.young_modulus = contact::infinity;
  input.rail.transverse_radius = contact::infinity;
  input.body_extent = 25.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const hybrid::SmoothParts plain = hybrid::find_smooth_parts(scene, {});
  EXPECT_EQ(plain.unknowns, 0);
  scene.output.stress_maxima = true;
  const hybrid::SmoothParts meshed = hybrid::find_smooth_parts(scene, {});
  EXPECT_GT(meshed.unknowns, 1000);
  const double difference = farthest(beyond(plain.rail), beyond(meshed.rail));
  EXPECT_LT(difference, 0.05);
}

TEST(Hybrid, LinearCellsFindWhatQuadraticOnesDo) {
  // With as many cells as quadratic ones, linear ones once had a fit that was not determined.
  contact::Case input = study_on_40('b', {0.0});
  input.rail.material.young_modulus = contact::infinity;
  input.body_extent = 25.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const auto quadratic = hybrid::find_smooth_parts(scene, {});
  scene.options.set<fem::FemOptions>().degree = 1;
  const auto linear = hybrid::find_smooth_parts(scene, {});
  const double difference = farthest(beyond(linear.wheel), beyond(quadratic.wheel));
  EXPECT_LT(difference, 0.1);
}

TEST(Hybrid, AddsNothingToBodiesThatAreHalfSpaces) {
  // Radii of 4 m under 0.05 N: patch over radius is 1e-5, and with it what curvature adds.
  contact::Case input = study_on_40('a', {0.001});
  input.wheel.rolling_radius = 4000.0;
  input.rail.transverse_radius = 4000.0;
  input.load.normal_force = 0.05;
  input.rolling.creepages[0].longitudinal = 1e-7;
  const auto one = hybrid_of(input).points.front();
  const auto other = halfspace::run_halfspace(input, {}).points.front();
  EXPECT_NEAR(one.max_pressure / other.max_pressure, 1.0, 1e-4);
  EXPECT_NEAR(one.approach / other.approach, 1.0, 1e-3);
  EXPECT_NEAR(one.traction_coefficient, other.traction_coefficient, 1e-4 * 0.55);
}

TEST(Hybrid, HasTheStrainOfALoadedWheel) {
  // Case a: by a perturbation of the half-space 0.0030 at rest and 0.0023 above it at 0.1 %, where
  // finite elements on the same cells are 0.0035 above.
  const contact::Case input = study_on_40('a', {0.0, 0.001});
  const auto result = hybrid_of(input);
  const auto half = halfspace::run_halfspace(input, {});
  EXPECT_NEAR(result.points[0].traction_coefficient, 0.0030, 0.0002);
  EXPECT_NEAR(result.points[1].traction_coefficient - half.points[1].traction_coefficient, 0.0023,
              0.0003);
  EXPECT_NEAR(result.points[0].max_pressure / half.points[0].max_pressure, 1.0, 1e-3);
  // Truth and sum: what the correction changes is in the bars by a tenth.
  EXPECT_GT(result.points[0].error_estimate.at("traction_coefficient"), 0.0003);
}

TEST(Hybrid, MeetsTheLimitOfFiniteElements) {
  // Case f: limits by benchmarks/hybrid_limits.py, good to 0.07 MPa and 0.0005 (0.0007 at 0.3 %).
  // Asked are 0.05 % of p0 and 0.1 % of mu. On forty elements across p0 is 0.055 % below its limit,
  // as the half-space's on the common surface is: 582.997 of 583.319 MPa.
  const auto result = hybrid_of(study_on_40('f', {0.0, 0.001, 0.003}));
  const double on_this_grid = 582.997 / 583.319;
  EXPECT_NEAR(result.points[0].max_pressure / (581.17 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[2].max_pressure / (580.20 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[0].traction_coefficient, -0.12889, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[1].traction_coefficient, 0.07417, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[2].traction_coefficient, 0.41276, 1e-3 * 0.55);
}

TEST(Hybrid, MeetsFiniteElementsOnASmallWheelInAGroove) {
  // A round wheel of 102 mm in a groove: eight half sizes of the patch do not fit into it. Finite
  // elements on 16 cells across are within their own bars of 0.4 % of p0 and 0.6 % of b.
  contact::Case input = study_on_40('b', {0.00032});
  input.wheel.rolling_radius = 101.74;
  input.wheel.transverse_radius = 55.6142;
  input.rail.transverse_radius = -76.1164;
  input.load.normal_force = 100e3;
  input.friction_coefficient = 0.17;
  input.contact_grid.elements_across = 24;
  const contact::PointResult hybrid = hybrid_of(input).points.front();
  const contact::PointResult whole =
      fem::run_fem(contact::Scene(input), {}, nullptr).points.front();
  EXPECT_NEAR(hybrid.max_pressure / whole.max_pressure, 1.0, 0.004);
  EXPECT_NEAR(hybrid.semi_axis_x / whole.semi_axis_x, 1.0, 0.004);
  EXPECT_NEAR(hybrid.semi_axis_y / whole.semi_axis_y, 1.0, 0.006);
  EXPECT_NEAR(hybrid.traction_coefficient, whole.traction_coefficient, 0.01 * 0.17);
}

TEST(Hybrid, HasTheSlipOfAnElasticSphere) {
  using rollfem::testing::ElasticSphere;
  contact::Case input = study_on_40('a', {0.0});
  input.wheel.transverse_radius = ElasticSphere::radius;
  input.rail.transverse_radius = contact::infinity;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const auto grid = contact::ContactGrid::centred(20, 20, 0.1 * ElasticSphere::semi_axis,
                                                  0.1 * ElasticSphere::semi_axis);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::arc);
  const hybrid::HybridCompliance compliance(scene, geometry, grid,
                                            hybrid::find_smooth_parts(scene, {}));
  const ElasticSphere slip(compliance, grid);
  EXPECT_NEAR(slip.mean, 1.0, 0.02);
  EXPECT_LT(slip.shape, 0.03);  // over the patch; 0.09 by a plain fit of degree 6
}
