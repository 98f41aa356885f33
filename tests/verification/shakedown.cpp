// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundaries of the shakedown map: values of the literature, the underlying fields recomputed
// with half-space elements, and Melan's theorem for the line contact.
#include "postprocess/stress/shakedown.hpp"

#include "contact/result/stress_measures.hpp"
#include "halfspace/stress/subsurface.hpp"

#include "support/test.hpp"

namespace rollfem::postprocess {
namespace {

TEST(Shakedown, WithoutFrictionTheBoundariesAreThoseOfTheLiterature) {
  // Johnson 1985, sections 6.1 and 9.2; Ponter, Hearle & Johnson 1985.
  EXPECT_NEAR(line_contact_limits(0.0).elastic, std::sqrt(3.0) / 0.5575, 3e-3);
  EXPECT_NEAR(line_contact_limits(0.0).shakedown, 4.0, 4e-3);
  EXPECT_NEAR(point_contact_limits(0.0).elastic, std::sqrt(3.0) / 0.62004, 3e-3);
  EXPECT_NEAR(point_contact_limits(0.0).shakedown, 4.68, 0.01);
}

TEST(Shakedown, WithMuchFrictionTheSurfaceDecides) {
  for (const double friction : {0.4, 0.5, 0.6, 1.0}) {
    EXPECT_NEAR(line_contact_limits(friction).shakedown, 1.0 / friction, 1e-3 / friction);
    EXPECT_NEAR(point_contact_limits(friction).shakedown, 1.0 / friction, 1e-6);
    EXPECT_LT(point_contact_limits(friction).elastic, point_contact_limits(friction).shakedown);
  }
}

TEST(Shakedown, BoundariesFallWithFriction) {
  for (const auto limits : {line_contact_limits, point_contact_limits})
    for (int k = 0; k < 60; ++k) {
      const ShakedownLimits now = limits(0.01 * k);
      const ShakedownLimits next = limits(0.01 * (k + 1));
      EXPECT_LT(next.elastic, now.elastic) << k;
      EXPECT_LT(next.shakedown, now.shakedown) << k;
      EXPECT_GT(next.elastic, now.elastic - 0.12) << "a jump at " << k;
      EXPECT_GT(next.shakedown, now.shakedown - 0.12) << "a jump at " << k;
    }
}

/// Elements on the square around the circle of radius 1 (or the strip of half width 1) with the
/// mean of Hertz's pressure.
halfspace::LoadedBody loaded(int nx, bool circle, bool friction) {
  halfspace::LoadedBody body;
  body.body = halfspace::Body::wheel;
  body.material = {210e3, 0.3};
  const double d = 2.0 / nx;
  body.grid = circle ? contact::ContactGrid::centred(nx, nx, d, d)
                     : contact::ContactGrid::centred(nx, 1, d, 4000.0);
  const contact::Field pressure = body.grid.sample([&](double x, double y) {
    double sum = 0.0;
    for (int i = 0; i < 16; ++i)
      for (int j = 0; j < 16; ++j) {
        const double u = x + ((i + 0.5) / 16.0 - 0.5) * d;
        const double v = circle ? y + ((j + 0.5) / 16.0 - 0.5) * d : 0.0;
        sum += std::sqrt(std::max(0.0, 1.0 - u * u - v * v)) / 256.0;
      }
    return sum;
  });
  const contact::Field zero = contact::Field::Zero(pressure.size());
  body.traction.n = friction ? zero : pressure;
  body.traction.x = friction ? pressure : zero;
  return body;
}

/// Largest von Mises stress and |xz| at depths of 0.2 to 0.8 from superposed fields, in p0.
std::array<double, 2> largest_below(bool circle, double friction) {
  const int n = 80;
  const auto points = contact::ContactGrid::centred(n + 1, 1, 2.0 / n, circle ? 2.0 / n : 4000.0);
  std::vector<double> depths;
  for (int k = 0; k <= 60; ++k) depths.push_back(0.2 + 0.01 * k);
  const auto pressed = halfspace::subsurface_box(loaded(n, circle, false), points, depths);
  const auto rubbed = halfspace::subsurface_box(loaded(n, circle, true), points, depths);
  std::array<double, 2> largest{};
  for (std::size_t k = 0; k < depths.size(); ++k)
    for (int i = 0; i < points.size(); ++i) {
      auto stress = pressed[k].states[static_cast<std::size_t>(i)].stress.as_array();
      const auto more = rubbed[k].states[static_cast<std::size_t>(i)].stress.as_array();
      for (std::size_t c = 0; c < 6; ++c) stress[c] += friction * more[c];
      const auto sum = contact::Stress::from_array(stress);
      largest[0] = std::max(largest[0], contact::von_mises(sum));
      largest[1] = std::max(largest[1], std::abs(sum.xz));
    }
  return largest;
}

TEST(Shakedown, BelowTheSurfaceItIsTheFieldOfHalfSpaceElements) {
  for (const double friction : {0.0, 0.1, 0.2, 0.27}) {
    const auto circle = largest_below(true, friction);
    EXPECT_NEAR(point_contact_limits(friction).elastic * circle[0], std::sqrt(3.0), 4e-3);
    EXPECT_NEAR(point_contact_limits(friction).shakedown * circle[1], 1.0, 2e-3);
    const auto line = largest_below(false, friction);
    if (friction < 0.25) {  // the surface yields first from some 0.26 on
      EXPECT_NEAR(line_contact_limits(friction).elastic * line[0], std::sqrt(3.0), 4e-3);
    }
    EXPECT_NEAR(line_contact_limits(friction).shakedown * line[1], 1.0, 2e-3);
  }
}

TEST(Shakedown, OfTheLineItIsMelansLimit) {
  // Plane strain: residual xx and yy, functions of the depth alone. yy can make the stress across
  // the intermediate one; xx must keep the circle of every passage within k. Largest load for which
  // such an xx exists at a depth, by bisection.
  const double friction = 0.2;
  const int n = 80;
  const auto points = contact::ContactGrid::centred(3 * n + 1, 1, 2.0 / n, 4000.0);
  std::vector<double> depths;
  for (int k = 0; k <= 60; ++k) depths.push_back(0.2 + 0.01 * k);
  const auto pressed = halfspace::subsurface_box(loaded(n, false, false), points, depths);
  const auto rubbed = halfspace::subsurface_box(loaded(n, false, true), points, depths);
  double limit = 1e9;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    double low = 0.0;
    double high = 10.0;
    for (int step = 0; step < 40; ++step) {
      const double load = 0.5 * (low + high);
      double least = -1e9;
      double most = 1e9;
      for (int i = 0; i < points.size(); ++i) {
        const auto a = pressed[k].states[static_cast<std::size_t>(i)].stress;
        const auto b = rubbed[k].states[static_cast<std::size_t>(i)].stress;
        const double difference = load * (a.xx - a.zz + friction * (b.xx - b.zz));
        const double shear = load * (a.xz + friction * b.xz);
        const double room = 1.0 - shear * shear;
        if (room < 0.0) most = -1e9;  // no residual stress balances the shear
        least = std::max(least, -difference - 2.0 * std::sqrt(std::max(0.0, room)));
        most = std::min(most, -difference + 2.0 * std::sqrt(std::max(0.0, room)));
      }
      (least <= most ? low : high) = load;
    }
    limit = std::min(limit, low);
  }
  EXPECT_NEAR(limit, line_contact_limits(friction).shakedown, 0.01);
}

TEST(Shakedown, TheSurfaceOfTheCircleIsThatOfHalfSpaceElements) {
  // Middles of elements inside the circle; the steps of the traction make an error of first order.
  const double friction = 0.5;
  const int n = 161;
  const auto points = contact::ContactGrid::centred(n, 1, 2.0 / n, 2.0 / n);
  const auto pressed = halfspace::subsurface_box(loaded(n, true, false), points, {0.0}).front();
  const auto rubbed = halfspace::subsurface_box(loaded(n, true, true), points, {0.0}).front();
  for (int i = 0; i < n; ++i) {
    if (std::abs(points.x(i)) > 0.9) continue;
    const auto without = pressed.states[static_cast<std::size_t>(i)].stress.as_array();
    const auto more = rubbed.states[static_cast<std::size_t>(i)].stress.as_array();
    const auto exact = sliding_circle_surface(points.x(i), friction).as_array();
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(without[c] + friction * more[c], exact[c], 0.006) << points.x(i) << " " << c;
  }
}

TEST(Shakedown, RegionsAndIndexFollowFromTheBoundaries) {
  const ShakedownLimits limits = point_contact_limits(0.2);
  EXPECT_EQ(shakedown_region(limits, 0.99 * limits.elastic), "elastic");
  EXPECT_EQ(shakedown_region(limits, 1.01 * limits.elastic), "elastic shakedown");
  EXPECT_EQ(shakedown_region(limits, 1.01 * limits.shakedown), "beyond shakedown");
  EXPECT_NEAR(yield_shear_stress(520.0), 300.22, 0.01);
  EXPECT_NEAR(surface_fatigue_index(0.4, 2.5), 0.0, 1e-12);
  EXPECT_NEAR(surface_fatigue_index(0.4, 4.0), 0.15, 1e-12);
}

TEST(Shakedown, OfAnEllipseIsThatOfCircleAndLineAtItsEnds) {
  const EllipseShear circle(1.0), wide(50.0), between(3.0);
  // Johnson 1985: 0.2500 p0 at the line, half width 50 times less than the length; Ponter, Hearle
  // and Johnson 1985: 4.68 k at the circle.
  EXPECT_NEAR(wide.largest(0.0), 0.25, 1e-3);
  EXPECT_NEAR(circle.shakedown_limit(0.0), 4.68, 0.02);
  for (const double friction : {0.0, 0.1, 0.2, 0.3, 0.5}) {
    const double round = point_contact_limits(friction).shakedown;
    const double line = line_contact_limits(friction).shakedown;
    EXPECT_NEAR(circle.shakedown_limit(friction), round, 5e-3 * round) << friction;
    EXPECT_NEAR(wide.shakedown_limit(friction), line, 5e-3 * line) << friction;
    EXPECT_GE(between.shakedown_limit(friction), line * (1 - 5e-3)) << friction;
    EXPECT_LE(between.shakedown_limit(friction), round * (1 + 5e-3)) << friction;
  }
}

}  // namespace
}  // namespace rollfem::postprocess
