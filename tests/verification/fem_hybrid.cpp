// The hybrid: nothing where bodies are half-spaces, the strain of a loaded wheel where it is one,
// and the finite elements' pressure and forces where the surfaces are steep.
#include "contact/case/case_reader.hpp"
#include "contact/scene/scene.hpp"
#include "halfspace/model/model.hpp"
#include "hybrid/compliance.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/model.hpp"

#include <gtest/gtest.h>

#include "support/mpi_environment.hpp"
#include "support/places.hpp"
#include "support/recorded.hpp"
#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace rollfem;

contact::Case study_on_40(const std::string& name, std::vector<double> creepages) {
  contact::Case input =
      contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_" + name + ".toml");
  input.contact_grid.elements_across = 40;
  input.rolling.creepages.clear();
  for (const double xi : creepages) input.rolling.creepages.push_back({xi, 0.0, 0.0});
  return input;
}

contact::ModelResult hybrid_of(const contact::Case& input) {
  return hybrid::run_hybrid(input, {}, nullptr, fem::find_smooth_parts);
}

/// Displacement by one body of a scene whose other one is rigid, under Hertz's pressure and half of
/// it as friction, less its mean (which is the far boundary's), in mm.
contact::SurfaceField beyond(const halfspace::SmoothMap& map) {
  const double a = map.loads.half_length, b = map.loads.half_width;
  const auto grid = contact::ContactGrid::centred(16, 16, 0.1 * a, 0.1 * b);
  const contact::Field hertz = grid.sample([&](double x, double y) {
    return 1e3 * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a) - y * y / (b * b)));
  });
  // Half a body carries friction along rolling, and to both sides.
  const contact::Field sides =
      hertz.cwiseProduct(grid.sample([&](double, double y) { return y / b; }));
  contact::SurfaceField u =
      halfspace::SmoothMapOnGrid(map, grid).apply({0.5 * hertz, sides, hertz});
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

TEST(Hybrid, AFlatRailIsNotMeshed) {
  // On a curved common surface it still adds something; with stresses below the surface it is
  // meshed. The bars hold a tenth of what is
  // added.
  contact::Case input = study_on_40("b", {0.0});
  input.wheel.transverse_radius = 100.0;
  input.wheel.material.young_modulus = contact::infinity;
  input.rail.transverse_radius = contact::infinity;
  input.fem.extent = 25.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const halfspace::SmoothParts plain = fem::find_smooth_parts(scene, {});
  EXPECT_EQ(plain.unknowns, 0);
  scene.output.stress_maxima = true;
  const halfspace::SmoothParts meshed = fem::find_smooth_parts(scene, {});
  EXPECT_GT(meshed.unknowns, 1000);
  const double difference = farthest(beyond(plain.rail), beyond(meshed.rail));
  rollfem::testing::record("difference", difference);
  EXPECT_LT(difference, 0.05);
}

TEST(Hybrid, LinearCellsFindWhatQuadraticOnesDo) {
  // With as many cells as quadratic ones, linear ones once had a fit that was not determined.
  contact::Case input = study_on_40("b", {0.0});
  input.rail.material.young_modulus = contact::infinity;
  input.fem.extent = 25.0;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const auto quadratic = fem::find_smooth_parts(scene, {});
  scene.fem.degree = 1;
  const auto linear = fem::find_smooth_parts(scene, {});
  const double difference = farthest(beyond(linear.wheel), beyond(quadratic.wheel));
  rollfem::testing::record("difference", difference);
  EXPECT_LT(difference, 0.1);
}

TEST(Hybrid, AddsNothingToBodiesThatAreHalfSpaces) {
  // Radii of 4 m under 0.05 N: patch over radius is 1e-5, and with it what curvature adds.
  contact::Case input = study_on_40("a", {0.001});
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
  const contact::Case input = study_on_40("a", {0.0, 0.001});
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
  const auto result = hybrid_of(study_on_40("f", {0.0, 0.001, 0.003}));
  const double on_this_grid = 582.997 / 583.319;
  EXPECT_NEAR(result.points[0].max_pressure / (581.17 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[2].max_pressure / (580.20 * on_this_grid), 1.0, 5e-4);
  EXPECT_NEAR(result.points[0].traction_coefficient, -0.12889, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[1].traction_coefficient, 0.07417, 1e-3 * 0.55);
  EXPECT_NEAR(result.points[2].traction_coefficient, 0.41276, 1e-3 * 0.55);
}

TEST(Hybrid, HasTheSlipOfAnElasticSphere) {
  // Under Hertz's pressure of 50 kN on a flat rail, in units of p0 a/(G R), positive as creepage:
  // a polynomial through Lur'e's series (benchmarks/book/elastic_sphere.py, fem_sphere.cpp).
  const auto exact = [](double x, double y) { return 0.24021 - 0.0464 * x * x - 0.1993 * y * y; };
  constexpr double radius = 405.0, semi_axis = 5.0868168, max_pressure = 922.6121;
  contact::Case input = study_on_40("a", {0.0});
  input.wheel.transverse_radius = radius;
  input.rail.transverse_radius = contact::infinity;
  contact::Scene scene(input);
  scene.follows_surface = 1.0;
  const auto grid = contact::ContactGrid::centred(20, 20, 0.1 * semi_axis, 0.1 * semi_axis);
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::arc);
  const hybrid::HybridCompliance compliance(scene, geometry, grid,
                                            fem::find_smooth_parts(scene, {}));
  const contact::Field hertz = grid.sample([](double x, double y) {
    return max_pressure * std::sqrt(std::max(0.0, 1.0 - (x * x + y * y) / semi_axis / semi_axis));
  });
  const contact::Field none = contact::Field::Zero(grid.size());
  const contact::Response response = compliance.respond({none, none, hertz});
  const double shear_modulus = 210e3 / 2.6;
  const double unit = max_pressure * semi_axis / radius / shear_modulus;
  double sum = 0.0, exact_sum = 0.0, weight = 0.0, squares = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 1; i + 1 < grid.nx; ++i) {
      const auto& u = response.displacement.x;
      const int e = grid.index(i, j);
      const double stretch = (u[grid.index(i + 1, j)] - u[grid.index(i - 1, j)]) / (2.0 * grid.dx);
      const double slip = (response.curvature_slip.x[e] - stretch) / unit;
      const double at = exact(grid.x(i) / semi_axis, grid.y(j) / semi_axis);
      weight += hertz[e];
      sum += hertz[e] * slip;
      exact_sum += hertz[e] * at;
      squares += hertz[e] * (slip - at) * (slip - at);
    }
  rollfem::testing::record("mean", sum / exact_sum);
  rollfem::testing::record("shape", std::sqrt(squares * weight) / exact_sum);
  EXPECT_NEAR(sum / exact_sum, 1.0, 0.02);
  EXPECT_LT(std::sqrt(squares * weight) / exact_sum,
            0.03);  // over the patch; 0.09 by a plain fit of degree 6
}
