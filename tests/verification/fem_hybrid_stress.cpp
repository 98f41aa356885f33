// SPDX-License-Identifier: LGPL-2.1-or-later
// Stresses below the surface by the hybrid: Hertz's where bodies are half-spaces, and those of
// finite elements where they are not.
#include "halfspace/model/halfspace_model.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_model.hpp"
#include "result/stress_measures.hpp"
#include "scene/scene.hpp"

#include "support/committed_cases.hpp"
#include "support/mpi_environment.hpp"

namespace {

contact::Case frictionless_case(char name) {
  contact::Case input = committed_case(name, {0.0});
  input.contact_grid.elements_across = 40;
  input.rolling.problem = contact::Problem::frictionless;
  return input;
}

contact::PointResult hybrid_of(const contact::Scene& scene, double cells) {
  const auto find = [&](const contact::Scene& curved, const contact::Progress& progress) {
    return hybrid::find_smooth_parts_with(cells, curved, progress);
  };
  return hybrid::run_hybrid(scene, {}, nullptr, find).points.front();
}

/// From the middle of the patch down to `depth`.
contact::SubsurfaceRequest line_down(bool wheel, double depth, int points) {
  contact::SubsurfaceRequest line;
  line.kind = contact::SubsurfaceRequest::Kind::line;
  line.wheel = wheel;
  line.to = {0.0, 0.0, wheel ? depth : -depth};
  line.points = {points, 1};
  return line;
}

double von_mises(const contact::PointResult& point, std::size_t request, std::size_t k) {
  return contact::von_mises(point.subsurface[request].stress[k]);
}

double largest_von_mises(const contact::PointResult& point, const std::string& body) {
  for (const auto& maximum : point.stress_maxima)
    if (maximum.body == body && maximum.measure == "von_mises") return maximum.value;
  return 0.0;
}

}  // namespace

TEST(HybridStress, IsThatOfHertzInBodiesThatAreHalfSpaces) {
  // Radii of 4 m under 0.05 N: patch over radius is 1e-5. Johnson (1985), 3.43, on the axis.
  contact::Case input = frictionless_case('a');
  input.wheel.rolling_radius = input.wheel.transverse_radius = 4000.0;
  input.rail.transverse_radius = contact::infinity;
  input.load.normal_force = 0.05;
  const double nu = input.wheel.material.poisson_ratio;
  const double stiffness = input.wheel.material.young_modulus / (1.0 - nu * nu) / 2.0;
  const double a = std::cbrt(0.75 * 0.05 * 4000.0 / stiffness);
  const double p0 = 1.5 * 0.05 / (M_PI * a * a);
  constexpr int points = 13;
  input.subsurface = {line_down(true, 3.0 * a, points), line_down(false, 3.0 * a, points)};
  input.body_extent = 5.0 * a;
  // Fewer elements than three in the semi-axis of a circle do not tell the tractions apart.
  const auto point = hybrid_of(input, 3.0);
  double worst = 0.0;
  for (const auto& field : point.subsurface)
    for (int k = 1; k < points; ++k) {
      const double z = 3.0 * k / (points - 1);
      const double axial = -1.0 / (1.0 + z * z);
      const double radial = -(1.0 + nu) * (1.0 - z * std::atan(1.0 / z)) - 0.5 * axial;
      const double exact[] = {radial, radial, axial, 0.0, 0.0, 0.0};
      for (std::size_t c = 0; c < 6; ++c)
        worst =
            std::max(worst, std::abs(field.stress[static_cast<std::size_t>(k)][c] / p0 - exact[c]));
    }
  EXPECT_LT(worst, 1e-3);
}

TEST(HybridStress, IsThatOfFiniteElementsOnSteepSurfaces) {
  // Case f without friction: `rollfem run --model fem` with cells of 0.47 mm on the lines of this
  // test, p0 582.99 MPa. At depths of 1, 2, 3, 4, 5, 6 mm; half-spaces have 277.4, 341.3, 344.1,
  // 319.0, 285.3, 251.4 in both.
  const std::vector<std::vector<double>> elements{{308.25, 357.16, 351.61, 321.43, 284.25, 247.79},
                                                  {256.23, 332.77, 343.30, 322.80, 291.55, 258.44}};
  contact::Case input = frictionless_case('f');
  input.output.stress_maxima = true;
  input.subsurface = {line_down(true, 6.0, 7), line_down(false, 6.0, 7)};
  const auto point = hybrid_of(input, 2.0);
  const auto half = halfspace::run_halfspace(input, {}).points.front();
  for (std::size_t body = 0; body < 2; ++body) {
    double worst = 0.0, worst_half = 0.0;
    for (std::size_t k = 0; k < elements[body].size(); ++k) {
      const double exact = elements[body][k];
      worst = std::max(worst, std::abs(von_mises(point, body, k + 1) - exact));
      worst_half = std::max(worst_half, std::abs(von_mises(half, body, k + 1) - exact));
    }
    EXPECT_LT(worst, 0.006 * 583.0) << body;  // 0.4 % on the usual cells
    EXPECT_GT(worst_half, 0.03 * 583.0) << body;
  }
  EXPECT_NEAR(largest_von_mises(point, "wheel"), 360.14, 2.0);
  EXPECT_NEAR(largest_von_mises(point, "rail"), 345.20, 2.0);
  EXPECT_NEAR(largest_von_mises(half, "rail"), 348.03, 0.3);
  // A tenth of what the bodies change is in the bars.
  EXPECT_GT(point.error_estimate.at("max_von_mises_wheel"), 0.8);
  EXPECT_GT(point.error_estimate.at("subsurface_stress"), 3.0);
}
