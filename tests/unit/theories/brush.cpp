// SPDX-License-Identifier: LGPL-2.1-or-later
// Brushes along strips: linear theory, closed forms.
#include "theories/brush.hpp"

#include "theories/closed_forms.hpp"

#include "support/thesis_cases.hpp"

namespace rollfem::theories {

using namespace halfspace;
namespace {

const contact::ChartedGeometry& plane(const contact::Case& input) {
  static std::optional<contact::ChartedGeometry> kept;
  return kept.emplace(input, contact::Chart::plane);
}

TEST(Brush, FlexibilitiesGiveTheForcesOfTheLinearTheory) {
  const HertzContact ellipse{6.0, 2.5, 0, 0, 0};
  const BrushFlexibilities flexibilities = kalker_flexibilities(6.0, 2.5, 80769.0, 0.3);
  const contact::Case input = thesis_case('b');
  const auto strip_at = [&](double y) {
    return ellipse_strip(ellipse, y, std::numeric_limits<double>::infinity(),
                         BoundShape::parabolic);
  };
  for (const contact::Creepage& creepage :
       {contact::Creepage{1e-4, 0, 0}, {0, -1e-4, 0}, {0, 0, 1e-4}, {1e-4, 2e-4, -3e-5}}) {
    BrushTotals totals;
    add_strips({plane(input), creepage, flexibilities, 200}, strip_at, strip_places(2.5, 200),
               totals);
    const CreepForces& sum = totals.forces;
    const CreepForces linear = linear_creep_forces(6.0, 2.5, 80769.0, 0.3, creepage);
    const double size = std::hypot(linear.longitudinal, linear.lateral);
    EXPECT_NEAR(sum.longitudinal, linear.longitudinal, 1e-4 * size);
    EXPECT_NEAR(sum.lateral, linear.lateral, 1e-4 * size);
  }
}

TEST(Brush, AStripWithAParabolaSlipsFromItsTrailingEdge) {
  // p = xi (a - x)/L meets g (1 - x^2/a^2) at x = -a + xi a^2/(L g).
  const BrushStrip strip{0.0, 4.0, 300.0, BoundShape::parabolic};
  const BrushFlexibilities flexibilities{1e-4, 1e-4, 1e-4};
  const StripTractions t =
      solve_strip(strip, flexibilities, {4e-3, 0, 0}, chord_elements(strip, 400));
  const double edge = -4.0 + 4e-3 * 16.0 / (1e-4 * 300.0);
  for (int k = 0; k < 400; ++k) {
    const double x = t.elements.x_first - k * t.elements.step;
    const bool adheres = x > edge;
    if (std::abs(x - edge) < t.elements.step) continue;
    EXPECT_EQ(t.state[k] == contact::ElementState::adhesion, adheres) << x;
    EXPECT_NEAR(t.traction_x[k], adheres ? -4e-3 / 1e-4 * (4.0 - x) : -strip.bound_at(x), 1e-9);
    // Slip: xi - L dp/dx of the parabola, which a one-sided difference sees at mid-step.
    const double middle = x + 0.5 * t.elements.step;
    if (!adheres) {
      EXPECT_NEAR(t.slip_x[k], 4e-3 - 1e-4 * 600.0 * middle / 16.0, 1e-12);
    }
  }
}

TEST(Brush, SlipOpposesTheTractionAndTractionStaysWithinTheBound) {
  const BrushStrip strip{1.5, 4.0, 300.0, BoundShape::elliptic};
  const BrushFlexibilities flexibilities{1e-4, 1e-4, 1e-4};
  const StripTractions t =
      solve_strip(strip, flexibilities, {5e-3, -2e-3, 6e-4}, chord_elements(strip, 300));
  int slipping = 0;
  for (int k = 0; k < 300; ++k) {
    const double x = t.elements.x_first - k * t.elements.step;
    const double size = std::hypot(t.traction_x[k], t.traction_y[k]);
    EXPECT_LE(size, strip.bound_at(x) * (1 + 1e-12));
    if (t.state[k] != contact::ElementState::slip) continue;
    ++slipping;
    EXPECT_NEAR(size, strip.bound_at(x), 1e-9);
    const double slip = std::hypot(t.slip_x[k], t.slip_y[k]);
    EXPECT_NEAR(t.slip_x[k] * t.traction_x[k] + t.slip_y[k] * t.traction_y[k], -slip * size,
                1e-12 * size);
  }
  EXPECT_GT(slipping, 20);
  EXPECT_LT(slipping, 280);
}

}  // namespace
}  // namespace rollfem::theories
