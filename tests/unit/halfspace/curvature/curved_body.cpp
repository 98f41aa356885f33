// SPDX-License-Identifier: LGPL-2.1-or-later
// The first-order correction of a curved body: symmetric, linear in the height, nothing for a flat
// one, and on a sphere the strain at the pole that Lur'e's exact series has in the limit of a small
// cap.
#include "halfspace/curvature/curved_body.hpp"

#include <Eigen/LU>

#include "support/random_field.hpp"

namespace {

using halfspace::BodySurface;
using halfspace::CurvedBody;

constexpr double nu = 0.3;
constexpr double modulus = 210e3;

BodySurface paraboloid(double curvature_x, double curvature_y) {
  BodySurface surface;
  surface.material = {modulus, nu, 0.0};
  surface.height = [=](double x, double y) {
    return 0.5 * (curvature_x * x * x + curvature_y * y * y);
  };
  surface.slope_x = [=](double x) { return curvature_x * x; };
  surface.slope_y = [=](double y) { return curvature_y * y; };
  return surface;
}

const ContactGrid skewed{11, 7, 0.3, 0.5, -1.2, -1.9};

TEST(CurvedBody, IsSymmetric) {
  const CurvedBody body(skewed, paraboloid(1.0 / 40.0, -1.0 / 70.0));
  const SurfaceField p = random_field(skewed, 1), q = random_field(skewed, 2);
  const SurfaceField of_p = body.apply(p).correction, of_q = body.apply(q).correction;
  const double size = std::sqrt(dot(of_p, of_p) * dot(q, q));
  EXPECT_NEAR(dot(q, of_p), dot(p, of_q), 1e-12 * size);
  EXPECT_GT(std::abs(dot(q, of_p)), 1e-6 * size);
}

TEST(CurvedBody, TractionsOfChequeredElementsMoveItLessThanTheHalfSpace) {
  // Heights up to twice the shorter side of an element, tractions that no gradient at corners
  // feels: what is left of the correction must not outweigh what it corrects.
  const ContactGrid flat{24, 24, 0.7, 0.1, -8.05, -1.15};
  const CurvedBody body(flat, paraboloid(1.0 / 160.0, 1.0 / 13.0));
  const Field chequered = flat.sample([&](double x, double y) {
    const auto column = std::lround((x - flat.x_first) / flat.dx);
    const auto row = std::lround((y - flat.y_first) / flat.dy);
    return (column + row) % 2 == 0 ? 1.0 : -1.0;
  });
  const Field none = Field::Zero(flat.size());
  for (const SurfaceField& t : {SurfaceField{chequered, none, none}, {none, chequered, none}}) {
    const CurvedBody::Displacement moved = body.apply(t);
    EXPECT_LT(std::abs(dot(t, moved.correction)), dot(t, moved.plane));
  }
}

TEST(CurvedBody, FlatOneIsTheHalfSpace) {
  const CurvedBody body(skewed, paraboloid(0.0, 0.0));
  const SurfaceField c = body.apply(random_field(skewed, 3)).correction;
  EXPECT_EQ(dot(c, c), 0.0);
}

TEST(CurvedBody, IsLinearInTheHeight) {
  // As long as heights stay below a quarter of the elements.
  const SurfaceField t = random_field(skewed, 4);
  const SurfaceField c = CurvedBody(skewed, paraboloid(0.005, 0.01)).apply(t).correction;
  const SurfaceField along = CurvedBody(skewed, paraboloid(0.01, 0.0)).apply(t).correction;
  const SurfaceField across = CurvedBody(skewed, paraboloid(0.0, 0.02)).apply(t).correction;
  const SurfaceField half{0.5 * (along.x + across.x), 0.5 * (along.y + across.y),
                          0.5 * (along.n + across.n)};
  const SurfaceField difference{c.x - half.x, c.y - half.y, c.n - half.n};
  EXPECT_LT(dot(difference, difference), 1e-24 * dot(c, c));
}

/// Strain along a meridian at the pole of a sphere of radius 1 under two opposite Hertz caps of
/// largest pressure E, reaching to the angle alpha, less that of a half-space,
/// -(1 - 2 nu)(1 + nu)/2; by Lur'e's solution, a pair of harmonics for each Legendre polynomial
/// (A. I. Lur'e, Three-Dimensional Problems of the Theory of Elasticity, 1964, section 5.8).
double strain_of_sphere_beyond_half_space(double alpha) {
  constexpr int points = 1000;
  std::vector<double> cosine(points), weight(points), before(points, 1.0), legendre(points);
  for (int k = 0; k < points; ++k) {
    // theta = alpha sin(t) takes the root at the edge out.
    const double step = std::acos(0.0) / points, t = (k + 0.5) * step;
    const double theta = alpha * std::sin(t);
    cosine[k] = std::cos(theta);
    const double ratio = std::sin(theta) / std::sin(alpha);
    weight[k] = std::sqrt(1.0 - ratio * ratio) * std::sin(theta) * alpha * std::cos(t) * step;
  }
  legendre = cosine;
  const double of_half_space = (1.0 - 2.0 * nu) * (1.0 + nu) / 2.0;
  const double twice_shear = 1.0 / (1.0 + nu);
  const int last = static_cast<int>(100.0 / alpha);
  // Partial sums swing about their limit: the mean of the later half of them.
  double sum = 0.0, mean = 0.0;
  for (int n = 0; n <= last; ++n) {
    const std::vector<double>& p = n == 0 ? before : legendre;
    if (n % 2 == 0) {
      double load = 0.0;
      for (int k = 0; k < points; ++k) load -= (2.0 * n + 1.0) * weight[k] * p[k];
      double strain = 1.0 - 2.0 * nu;
      if (n > 0) {
        // u_r = (A (n+1)(n-2+4nu) + B n) P_n, u_theta = (A (n+5-4nu) + B) dP_n/dtheta, no shear.
        const double m = n, ratio = -(m * m + 2.0 * m - 1.0 + 2.0 * nu) / (m - 1.0);
        const double a =
            1.0 / twice_shear / ((m + 1.0) * (m * m - m - 2.0 - 2.0 * nu) + m * (m - 1.0) * ratio);
        const double b = a * ratio;
        strain = a * (m + 1.0) * (m - 2.0 + 4.0 * nu) + b * m -
                 (a * (m + 5.0 - 4.0 * nu) + b) * m * (m + 1.0) / 2.0;
      }
      sum += load * (strain - of_half_space);
      if (2 * n > last) mean += 4.0 * sum / last;
    }
    if (n == 0) continue;
    for (int k = 0; k < points; ++k) {
      const double next = ((2.0 * n + 1.0) * cosine[k] * legendre[k] - n * before[k]) / (n + 1.0);
      before[k] = legendre[k];
      legendre[k] = next;
    }
  }
  return mean;
}

/// The series goes as alpha (c + d alpha ln(1/alpha) + e alpha): c from three angles.
double limit_for_small_caps() {
  Eigen::Matrix3d terms;
  Eigen::Vector3d values;
  int row = 0;
  for (const double alpha : {0.04, 0.02, 0.01}) {
    terms.row(row) << 1.0, -alpha * std::log(alpha), alpha;
    values[row++] = strain_of_sphere_beyond_half_space(alpha) / alpha;
  }
  const Eigen::Matrix3d inverse = terms.inverse();
  return inverse.row(0).dot(values);
}

/// The same for pressure E sqrt(1 - r^2) on a paraboloid of radius 1.
double strain_of_paraboloid(int across) {
  const double d = 2.0 / across;
  const ContactGrid grid = ContactGrid::centred(across + 7, across + 7, d, d);
  const CurvedBody body(grid, paraboloid(1.0, 1.0));
  const Field none = Field::Zero(grid.size());
  const Field pressure = grid.sample([&](double x, double y) {
    double sum = 0.0;
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const double px = x + d * ((i + 0.5) / 8 - 0.5), py = y + d * ((j + 0.5) / 8 - 0.5);
        sum += std::sqrt(std::max(0.0, 1.0 - px * px - py * py));
      }
    return modulus * sum / 64.0;
  });
  const auto u = body.apply({none, none, pressure});
  const int middle = grid.nx / 2;
  const auto at = [&](int i) { return u.correction.x[grid.index(i, middle)]; };
  return (at(middle + 1) - at(middle - 1)) / (2.0 * d) - u.plane.n[grid.index(middle, middle)];
}

TEST(CurvedBody, HasTheStrainOfASphere) {
  const double exact = limit_for_small_caps();
  // -0.6433 in units of E; the grid is of second order.
  EXPECT_NEAR(strain_of_paraboloid(20) / exact, 1.0, 4e-3);
  EXPECT_NEAR(strain_of_paraboloid(40) / exact, 1.0, 1e-3);
}

/// Work on the height h = r^2 / 2R of the strain (1 - 2 nu) / (4 pi G r^2) (1, -1) that a normal
/// force has far away, through the stiffness of the surface: what the ring from r_1 to r_2 adds to
/// the approach of a unit force is (1 - 2 nu)^2 / (4 pi G R) ln(r_2 / r_1).
TEST(CurvedBody, ApproachGoesWithTheLogarithmOfTheExtent) {
  const ContactGrid grid = ContactGrid::centred(9, 9, 0.2, 0.2);
  const Field none = Field::Zero(grid.size());
  Field pressure = none;
  const Eigen::Index middle = grid.index(4, 4);
  pressure[middle] = 1.0 / grid.element_area();
  const double radius = 50.0, shear = 0.5 * modulus / (1.0 + nu);
  const auto approach = [&](double extent) {
    BodySurface surface = paraboloid(1.0 / radius, 1.0 / radius);
    surface.extent = extent;
    return CurvedBody(grid, surface).apply({none, none, pressure}).correction.n[middle];
  };
  const double expected = std::pow(1.0 - 2.0 * nu, 2) / (4.0 * 3.14159265358979 * shear * radius);
  EXPECT_NEAR(approach(6.0) - approach(3.0), expected * std::log(2.0), 2e-3 * expected);
  EXPECT_NEAR(approach(12.0) - approach(3.0), expected * std::log(4.0), 5e-3 * expected);
  EXPECT_NEAR(approach(0.5), approach(1.0), 1e-6 * expected);  // all within the near part
}

}  // namespace
