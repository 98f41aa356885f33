// SPDX-License-Identifier: LGPL-2.1-or-later
// Circular contact in finite elements: the largest shear stress of Hertz's theory and its place,
// and how far the recovered stress at the surface is from the tractions.
#include "case/reading/case_reader.hpp"
#include "fem/elasticity/run_level.hpp"
#include "result/stress_measures.hpp"

#include "support/mpi_environment.hpp"
#include "support/recorded.hpp"

namespace {

constexpr double radius = 405.0;  // mm, of the wheel along x and of the rail across: a circle
constexpr double force = 50e3;

/// Hertz: a^3 = 3 F R / (4 E*), p0 = 3 F / (2 pi a^2); E* of two bodies of E = 210 GPa, nu = 0.3.
const double contact_modulus = 210e3 / (2.0 * (1.0 - 0.09));
const double a = std::cbrt(0.75 * force * radius / contact_modulus);
const double p0 = 1.5 * force / (M_PI * a * a);

/// Solved once for all tests of this program.
const contact::ModelResult& solution() {
  static const contact::ModelResult result = [] {
    contact::Case input = contact::parse_case(
        "title = \"circle\"\nmodels = [\"fem\"]\n[load]\nnormal_force = 50e3\n[friction]\n"
        "coefficient = 0.001\n[wheel]\nrolling_radius = 405.0\ntransverse_radius = "
        "inf\n[rail]\ntransverse_radius = 405.0\n"
        "[output]\nstress_maxima = true\n"
        "[[subsurface.surface]]\nbody = \"rail\"\nfrom = [0, 0]\nto = [0, 4.5]\npoints = 19\n"
        "[[subsurface.surface]]\nfrom = [0, -4.5]\nto = [0, 0]\npoints = 19\n",
        "circle.toml");
    return fem::run_level(input, {a / 8.0, "", false}, {});
  }();
  return result;
}

}  // namespace

TEST(FemCircle, LargestShearStressIsThatOfHertzAndItsPlace) {
  // Johnson (1985) section 3.4, nu = 0.3: 0.310 p0 at 0.481 a below the middle.
  int found = 0;
  for (const contact::StressMaximum& maximum : solution().points.front().stress_maxima) {
    const double depth = std::abs(maximum.place[2]) / a;
    if (maximum.measure == "tresca") {
      ++found;
      EXPECT_NEAR(0.5 * maximum.value / p0, 0.31002, 0.01 * 0.31002) << maximum.body;
      EXPECT_NEAR(depth, 0.4809, 0.02) << maximum.body;
      EXPECT_LT(std::hypot(maximum.place[0], maximum.place[1]), 0.1 * a) << maximum.body;
      record(maximum.body + "_shear_over_p0", 0.5 * maximum.value / p0);
      record(maximum.body + "_depth_over_a", depth);
    }
    // On the axis xx = yy: both equivalent stresses are the same.
    if (maximum.measure == "von_mises") {
      EXPECT_NEAR(maximum.value / p0, 0.62004, 0.01 * 0.62004) << maximum.body;
    }
  }
  EXPECT_EQ(found, 2);
}

TEST(FemCircle, LargestTensionIsBesideTheEdgeAndHasNoBar) {
  // Johnson (1985) eq. 3.43: (1 - 2 nu)/3 p0 at the edge, where cells of a/8 smooth the kink.
  const contact::PointResult& point = solution().points.front();
  for (const contact::StressMaximum& maximum : point.stress_maxima) {
    if (maximum.measure != "principal_1") continue;
    const double expected = (1.0 - 2.0 * 0.3) / 3.0 * p0;
    EXPECT_NEAR(maximum.value / expected, 0.85, 0.07) << maximum.body;
    EXPECT_NEAR(std::hypot(maximum.place[0], maximum.place[1]) / a, 1.0, 0.125) << maximum.body;
    EXPECT_EQ(point.no_bar.at("max_principal_1_" + maximum.body), contact::NoBar::near_surface);
    EXPECT_EQ(point.no_bar.count("max_tresca_" + maximum.body), 0u);
  }
}

TEST(FemCircle, StressAtTheSurfaceIsThatOfTheTractionsAndOfHertz) {
  // Johnson (1985) eq. 3.42: radial and hoop stress at the surface within the circle.
  const double nu = 0.3;
  // Largest differences up to 0.75 a and up to 0.9 a, near the edge of the patch.
  double normal[2] = {0.0, 0.0}, in_plane[2] = {0.0, 0.0};
  for (const contact::SubsurfaceField& line : solution().points.front().subsurface) {
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const double r = std::hypot(line.points[k][0], line.points[k][1]) / a;
      if (r > 0.9) continue;
      const double root = std::sqrt(1.0 - r * r);
      // (1 - root^3) / r^2 without dividing by 0 in the middle.
      const double ratio = (1.0 + root + root * root) / (1.0 + root);
      const double share = (1.0 - 2.0 * nu) / 3.0 * ratio;
      const auto& s = line.stress[k];
      const double of_normal = std::abs(s[2] / p0 + root);
      const double of_plane = std::max(std::abs(s[1] / p0 - (share - root)),
                                       std::abs(s[0] / p0 - (-share - 2.0 * nu * root)));
      for (int ring = r > 0.75 ? 1 : 0; ring < 2; ++ring) {
        normal[ring] = std::max(normal[ring], of_normal);
        in_plane[ring] = std::max(in_plane[ring], of_plane);
      }
    }
  }
  EXPECT_GT(normal[0], 0.0);  // points were there
  EXPECT_LT(std::max(normal[0], in_plane[0]), 0.02);
  EXPECT_LT(std::max(normal[1], in_plane[1]), 0.05);
}
