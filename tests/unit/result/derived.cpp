// SPDX-License-Identifier: LGPL-2.1-or-later
// Energy and power against values known in closed form.
#include "result/derived.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "scene/geometry.hpp"

#include "support/test.hpp"

namespace {

contact::PowerBalance balance_of(const ContactGrid& grid, const contact::PointResult& point,
                                 double speed, const contact::TangentialField& extra = {}) {
  return contact::power_balance(grid, point.fields.traction, point.fields.slip, point.creepage,
                                speed, extra);
}

}  // namespace

TEST(Derived, ElasticEnergyOfHertzianPressure) {
  // Like bodies, sphere: work of the load P over the approach, delta ~ P^(2/3), is 2/5 P delta.
  const double a = 1.0, p0 = 1000.0;
  const contact::Material steel{210e3, 0.3};
  const contact::CombinedMaterial combined = contact::combine(steel, steel);
  const auto energy = [&](int elements) {
    const double h = 2.0 * a / elements;
    const ContactGrid grid = ContactGrid::centred(elements + 2, elements + 2, h, h);
    SurfaceField p;
    p.x = p.y = contact::Field::Zero(grid.size());
    p.n = grid.sample([&](double x, double y) {
      return p0 * std::sqrt(std::max(0.0, 1.0 - (x * x + y * y) / (a * a)));
    });
    const halfspace::HalfspaceCompliance compliance(grid, combined);
    return contact::elastic_energy(grid, p, compliance.apply(p));
  };
  const double force = 2.0 / 3.0 * pi * a * a * p0;
  const double approach = pi * p0 * a / (2.0 * combined.contact_modulus);
  // Elastic energy of the pressure field: integral of p u/2 with u = delta - r^2/(2R), R =
  // a^2/delta.
  const double exact = 0.4 * force * approach;
  EXPECT_NEAR(energy(40), exact, 2e-3 * exact);
  EXPECT_NEAR(energy(80), exact, 7e-4 * exact);
}

TEST(Derived, FrictionAndCreepagePowerAgreeInCarterRolling) {
  // Carter's tractions and slip in closed form: wheel braked (xi > 0), F_x < 0, adhesion at the
  // leading edge. The slip follows from the integral of an ellipse of traction:
  // -du/dx = -(2 q0/(a E*)) (X - sign(X) sqrt(X^2 - a^2)) with the root only outside the ellipse.
  const double a = 1.0, stick = 0.6, mu_p0 = 300.0, modulus = 115e3, speed = 20e3;
  const int n = 20000;
  const ContactGrid grid = ContactGrid::centred(n, 1, 2.0 * a / n, 3.0);
  const double xi = 2.0 * mu_p0 * (a - stick) / (a * modulus);
  const auto ellipse = [](double X, double b) { return std::sqrt(std::max(0.0, b * b - X * X)); };
  const auto slope = [](double X, double b) {
    return std::abs(X) <= b ? X : X - std::copysign(std::sqrt(X * X - b * b), X);
  };
  const double centre = a - stick;
  contact::PointResult point;
  point.creepage.longitudinal = xi;
  point.fields.traction.x = grid.sample(
      [&](double x, double) { return -mu_p0 / a * (ellipse(x, a) - ellipse(x - centre, stick)); });
  point.fields.traction.y = contact::Field::Zero(n);
  point.fields.slip.x = grid.sample([&](double x, double) {
    return xi - 2.0 * mu_p0 / (a * modulus) * (slope(x, a) - slope(x - centre, stick));
  });
  point.fields.slip.y = contact::Field::Zero(n);
  // No slip in the adhesion area, slip against the traction behind it.
  EXPECT_NEAR(point.fields.slip.x[n - 10], 0.0, 1e-15);
  EXPECT_GT(point.fields.slip.x[n / 20], 0.0);
  const double force = -(1.0 - stick * stick) * pi / 2.0 * mu_p0 * a * 3.0;
  const auto balance = balance_of(grid, point, speed);
  EXPECT_NEAR(balance.creepage, -speed * xi * force, 1e-5 * balance.creepage);
  EXPECT_NEAR(balance.friction, -speed * xi * force, 1e-4 * balance.friction);
  EXPECT_LT(balance.difference, 1e-4);
}

TEST(Derived, FullSlipDissipatesForceTimesCreepage) {
  // Rigid slip only: both powers are the same sum whatever the tractions, with spin and extra slip.
  const ContactGrid grid = ContactGrid::centred(7, 5, 0.3, 0.4, 0.2, -0.1);
  const contact::Creepage creepage{2e-3, -1e-3, 4e-4};
  contact::PointResult point;
  point.creepage = creepage;
  point.fields.traction.x = grid.sample([](double x, double y) { return -30.0 + x * y; });
  point.fields.traction.y = grid.sample([](double x, double y) { return 10.0 * x - y; });
  const contact::TangentialField extra{grid.sample([](double, double y) { return 1e-4 * y * y; }),
                                       contact::Field::Zero(grid.size())};
  point.fields.slip.x = grid.sample([&](double, double y) {
    return creepage.longitudinal - creepage.spin * y;
  }) + extra.x;
  point.fields.slip.y =
      grid.sample([&](double x, double) { return creepage.lateral + creepage.spin * x; });
  const auto balance = balance_of(grid, point, 1000.0, extra);
  EXPECT_GT(balance.friction, 0.0);
  EXPECT_LT(balance.difference, 1e-13);
  // Without the extra slip the two must not agree.
  EXPECT_GT(balance_of(grid, point, 1000.0).difference, 1e-3);
}

TEST(Derived, FieldsMustFitTheGrid) {
  const ContactGrid grid = ContactGrid::centred(3, 3, 1.0, 1.0);
  const contact::Field good = contact::Field::Zero(9);
  EXPECT_THROW(contact::elastic_energy(grid, {good, good, good}, {}), contact::InputError);
  EXPECT_THROW(contact::power_balance(grid, {good, good, good}, {good, {}}, {}, 1.0),
               contact::InputError);
}
