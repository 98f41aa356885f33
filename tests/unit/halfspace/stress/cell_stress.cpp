// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of a uniformly loaded rectangle: against quadrature of the textbook point loads, boundary
// values and limits.
#include "halfspace/stress/cell_stress.hpp"

#include "base/errors.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "support/cell_state.hpp"

using namespace rollfem::halfspace;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double G = 80000.0;

/// Boussinesq and Cerruti as printed in Johnson (1985), eqs. (3.18)-(3.20) and (3.75)-(3.76): an
/// independent form of what cell_stress.cpp derives from potentials.
LocalState textbook_normal(double x, double y, double z, double nu) {
  const double r = std::sqrt(x * x + y * y + z * z);
  const double h2 = x * x + y * y;
  const double a = 1.0 - 2.0 * nu;
  LocalState s{};
  s[u_x] = x * z / std::pow(r, 3) - a * x / (r * (r + z));
  s[u_y] = y * z / std::pow(r, 3) - a * y / (r * (r + z));
  s[u_z] = z * z / std::pow(r, 3) + 2.0 * (1.0 - nu) / r;
  const double d = 1.0 - z / r;
  s[s_xx] = a / h2 * (d * (x * x - y * y) / h2 + z * y * y / std::pow(r, 3)) -
            3.0 * z * x * x / std::pow(r, 5);
  s[s_yy] = a / h2 * (d * (y * y - x * x) / h2 + z * x * x / std::pow(r, 3)) -
            3.0 * z * y * y / std::pow(r, 5);
  s[s_zz] = -3.0 * std::pow(z, 3) / std::pow(r, 5);
  s[s_xy] = 2.0 * a / h2 * (d * x * y / h2 - 0.5 * x * y * z / std::pow(r, 3)) -
            3.0 * x * y * z / std::pow(r, 5);
  s[s_yz] = -3.0 * y * z * z / std::pow(r, 5);
  s[s_xz] = -3.0 * x * z * z / std::pow(r, 5);
  return s;
}

LocalState textbook_tangential(double x, double y, double z, double nu) {
  const double r = std::sqrt(x * x + y * y + z * z);
  const double a = 1.0 - 2.0 * nu;
  const double q = r + z;
  const double r3 = std::pow(r, 3), r5 = std::pow(r, 5), q2 = q * q, q3 = q * q * q;
  LocalState s{};
  s[u_x] = 1.0 / r + x * x / r3 + a * (1.0 / q - x * x / (r * q2));
  s[u_y] = x * y / r3 - a * x * y / (r * q2);
  s[u_z] = x * z / r3 + a * x / (r * q);
  s[s_xx] = -3.0 * x * x * x / r5 + a * (x / r3 - 3.0 * x / (r * q2) + x * x * x / (r3 * q2) +
                                         2.0 * x * x * x / (r * r * q3));
  s[s_yy] = -3.0 * x * y * y / r5 +
            a * (x / r3 - x / (r * q2) + x * y * y / (r3 * q2) + 2.0 * x * y * y / (r * r * q3));
  s[s_zz] = -3.0 * x * z * z / r5;
  s[s_xy] = -3.0 * x * x * y / r5 +
            a * (-y / (r * q2) + x * x * y / (r3 * q2) + 2.0 * x * x * y / (r * r * q3));
  s[s_yz] = -3.0 * x * y * z / r5;
  s[s_xz] = -3.0 * x * x * z / r5;
  return s;
}

/// Force along x, y, z on the axes of the local frame.
LocalState textbook(double x, double y, double z, const LocalLoad& load, double nu) {
  const LocalState n = textbook_normal(x, y, z, nu);
  const LocalState t = textbook_tangential(x, y, z, nu);
  const LocalState v = textbook_tangential(y, -x, z, nu);  // frame turned by 90 degrees
  LocalState s{};
  for (std::size_t i = 0; i < component_count; ++i) s[i] = load.z * n[i] + load.x * t[i];
  s[u_x] -= load.y * v[u_y];
  s[u_y] += load.y * v[u_x];
  s[u_z] += load.y * v[u_z];
  s[s_xx] += load.y * v[s_yy];
  s[s_yy] += load.y * v[s_xx];
  s[s_zz] += load.y * v[s_zz];
  s[s_xy] -= load.y * v[s_xy];
  s[s_yz] += load.y * v[s_xz];
  s[s_xz] -= load.y * v[s_yz];
  for (std::size_t i = 0; i < component_count; ++i) s[i] /= i < s_xx ? 4.0 * pi * G : 2.0 * pi;
  return s;
}

/// Rectangle by adaptive quadrature of the textbook point loads.
LocalState by_quadrature(double x, double y, double z, double dx, double dy, const LocalLoad& load,
                         double nu) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  LocalState s{};
  for (std::size_t i = 0; i < component_count; ++i)
    s[i] = Rule::integrate(
        [&](double b) {
          return Rule::integrate([&](double a) { return textbook(x - a, y - b, z, load, nu)[i]; },
                                 -0.5 * dx, 0.5 * dx, 6, 1e-11);
        },
        -0.5 * dy, 0.5 * dy, 6, 1e-11);
  return s;
}

void expect_states_near(const LocalState& found, const LocalState& expected, double u_tolerance,
                        double s_tolerance, const char* where) {
  for (std::size_t i = 0; i < component_count; ++i)
    EXPECT_NEAR(found[i], expected[i], i < s_xx ? u_tolerance : s_tolerance)
        << where << ", component " << i;
}

const std::vector<LocalLoad> loads{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};

}  // namespace

TEST(CellStress, PointLoadsAreThoseOfTheTextbook) {
  for (const double nu : {0.0, 0.28, 0.5})
    for (const LocalLoad& load : loads) {
      expect_states_near(point_state(0.3, -0.7, 0.4, load, G, nu),
                         textbook(0.3, -0.7, 0.4, load, nu), 1e-18, 1e-14, "inside");
      expect_states_near(point_state(0.3, -0.7, 0.0, load, G, nu),
                         textbook(0.3, -0.7, 0.0, load, nu), 1e-18, 1e-14, "surface");
    }
}

TEST(CellStress, RectangleEqualsQuadratureOfPointLoads) {
  const double nu = 0.3;
  const double dx = 1.2, dy = 0.5;
  const std::vector<std::array<double, 3>> points{
      {0.11, 0.07, 0.4},   // below the middle
      {0.6, 0.13, 0.3},    // below an edge
      {0.6, 0.25, 0.25},   // below a corner
      {0.45, -0.2, 0.1},   // shallow
      {-1.3, 0.9, 0.2},    // aside
      {1.4, 0.1, 0.0},     // surface, outside, on the extension of the rectangle
      {-0.2, -1.1, 0.0}};  // surface, outside
  for (const auto& [x, y, z] : points)
    for (const LocalLoad& load : loads)
      expect_states_near(rectangle_state(x, y, z, dx, dy, load, G, nu),
                         by_quadrature(x, y, z, dx, dy, load, nu), 1e-14, 1e-8, "quadrature");
}

TEST(CellStress, SurfaceTractionsAreTheLoad) {
  const LocalLoad load{0.4, -0.7, 1.3};
  const auto expect_traction = [&](double x, double y, double share) {
    const LocalState s = rectangle_state(x, y, 0.0, 1.0, 2.0, load, G, 0.3);
    EXPECT_NEAR(s[s_zz], -share * load.z, 1e-14) << x << " " << y;
    EXPECT_NEAR(s[s_xz], -share * load.x, 1e-14) << x << " " << y;
    EXPECT_NEAR(s[s_yz], -share * load.y, 1e-14) << x << " " << y;
    for (const double value : s) EXPECT_TRUE(std::isfinite(value));
  };
  expect_traction(0.0, 0.0, 1.0);
  expect_traction(0.499, -0.999, 1.0);
  expect_traction(0.5, 0.3, 0.5);    // edge: the mean of both sides
  expect_traction(0.1, -1.0, 0.5);   // edge
  expect_traction(-0.5, 1.0, 0.25);  // corner
  expect_traction(0.501, 0.3, 0.0);
  expect_traction(0.5, 1.7, 0.0);  // on the extension of an edge
  expect_traction(30.0, 0.3, 0.0);
}

TEST(CellStress, FieldIsContinuousDownToTheSurface) {
  const LocalLoad load{0.4, -0.7, 1.3};
  for (const auto& [x, y] : std::vector<std::array<double, 2>>{
           {0.1, 0.2}, {0.45, -0.9}, {0.5, 1.7}, {-3.0, 1.0}, {0.0, 0.0}}) {
    const LocalState surface = rectangle_state(x, y, 0.0, 1.0, 2.0, load, G, 0.3);
    const LocalState below = rectangle_state(x, y, 1e-9, 1.0, 2.0, load, G, 0.3);
    expect_states_near(below, surface, 1e-13, 1e-7, "surface");
  }
}

TEST(CellStress, HydrostaticStressIsTheSolidAngle) {
  // On the normal through the middle: trace = -(1 + nu) p/pi times the solid angle of the
  // rectangle.
  const double a = 0.7, b = 0.3, nu = 0.3, p = 2.0;
  for (const double z : {0.01, 0.3, 1.0, 5.0, 13.0, 15.0, 200.0}) {
    const LocalState s = rectangle_state(0.0, 0.0, z, 2.0 * a, 2.0 * b, {0.0, 0.0, p}, G, nu);
    const double angle = 4.0 * std::asin(a * b / std::sqrt((a * a + z * z) * (b * b + z * z)));
    const double trace = s[s_xx] + s[s_yy] + s[s_zz];
    EXPECT_NEAR(trace, -(1.0 + nu) * p / pi * angle, 1e-10 * std::abs(trace)) << z;
  }
}

TEST(CellStress, FarFieldIsThePointLoadWithoutCancellation) {
  const LocalLoad load{0.4, -0.7, 1.3};
  const double dx = 1.0, dy = 0.125;
  const LocalLoad force{load.x * dx * dy, load.y * dx * dy, load.z * dx * dy};
  for (const double distance : {1e3, 1e5, 1e8}) {
    const double x = 0.48 * distance, y = -0.6 * distance, z = 0.64 * distance;
    const LocalState s = rectangle_state(x, y, z, dx, dy, load, G, 0.3);
    const LocalState point = point_state(x, y, z, force, G, 0.3);
    const double relative = 2.0 / (distance * distance) + 1e-13;
    for (std::size_t i = 0; i < component_count; ++i)
      EXPECT_NEAR(s[i], point[i], relative * std::abs(point[i])) << distance << " " << i;
  }
}

TEST(CellStress, NearAndFarFormulasMeet) {
  // On both sides of the switch at 20 times the longer side, relative to the largest component.
  const LocalLoad load{0.4, -0.7, 1.3};
  for (const double dy : {1.0, 0.125})
    for (const double distance : {19.99, 20.01}) {
      const double x = 0.48 * distance, y = -0.6 * distance, z = 0.64 * distance;
      const LocalState s = rectangle_state(x, y, z, 1.0, dy, load, G, 0.3);
      const LocalState expected = by_quadrature(x, y, z, 1.0, dy, load, 0.3);
      expect_states_near(s, expected, 1e-10 * std::abs(expected[u_z]),
                         1e-10 * std::abs(expected[s_zz]), "switch");
    }
}

TEST(CellStress, IncompressibleAndRigidBodiesAreAllowed) {
  const LocalLoad load{0.4, -0.7, 1.3};
  const double infinity = std::numeric_limits<double>::infinity();
  const LocalState rigid = rectangle_state(0.2, 0.1, 0.5, 1.0, 0.6, load, infinity, 0.3);
  const LocalState soft = rectangle_state(0.2, 0.1, 0.5, 1.0, 0.6, load, G, 0.3);
  EXPECT_EQ(rigid[u_x], 0.0);
  EXPECT_EQ(rigid[u_z], 0.0);
  EXPECT_EQ(rigid[s_zz], soft[s_zz]);
  const LocalState rubber = rectangle_state(0.2, 0.1, 0.0, 1.0, 0.6, {0.0, 0.0, 1.0}, G, 0.5);
  EXPECT_NEAR(rubber[s_xx], -1.0, 1e-14);  // the surface is under hydrostatic pressure
  EXPECT_NEAR(rubber[u_x], 0.0, 1e-18);
}

TEST(CellStress, ImpossibleInputIsRefused) {
  EXPECT_NO_THROW(check_half_space(0.0, G, 0.3));
  EXPECT_THROW(check_half_space(-0.1, G, 0.3), InputError);
  EXPECT_THROW(check_half_space(0.1, -G, 0.3), InputError);
  EXPECT_THROW(check_half_space(0.1, G, 0.51), InputError);
}
