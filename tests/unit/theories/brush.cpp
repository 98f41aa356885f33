// SPDX-License-Identifier: LGPL-2.1-or-later
// Brushes along strips and FASTSIM: linear theory, closed forms, order, symmetry.
#include "theories/brush.hpp"

#include "base/errors.hpp"
#include "theories/closed_forms.hpp"
#include "theories/fastsim.hpp"

#include "support/contact_laws.hpp"
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

double observed_order(BoundShape bound, const contact::Creepage& creepage,
                      double CreepForces::*member) {
  const contact::Case input = thesis_case('b');
  const EllipticPatch patch = elliptic_patch(input);
  const auto force = [&](int n) {
    FastsimOptions options;
    options.bound = bound;
    options.strips = options.strip_elements = n;
    return fastsim(patch, creepage, options).forces.*member;
  };
  const double exact = force(1600);
  // Two doublings: the edge of the slip area moves by whole elements and makes single ones uneven.
  return std::log2(std::abs(force(50) - exact) / std::abs(force(200) - exact)) / 2.0;
}

TEST(Fastsim, ConvergesAsItsHeaderSays) {
  EXPECT_GT(observed_order(BoundShape::parabolic, {1e-3, 0, 0}, &CreepForces::longitudinal), 1.8);
  EXPECT_GT(observed_order(BoundShape::elliptic, {1e-3, 0, 0}, &CreepForces::longitudinal), 1.2);
  EXPECT_GT(observed_order(BoundShape::parabolic, {0, 0, 5e-4}, &CreepForces::lateral), 0.85);
}

TEST(Fastsim, OneFlexibilityIsTheSameForOneCreepage) {
  const contact::Case input = thesis_case('b');
  const EllipticPatch patch = elliptic_patch(input);
  FastsimOptions one;
  one.flexibilities = Flexibilities::one;
  for (const contact::Creepage& creepage :
       {contact::Creepage{1e-3, 0, 0}, {0, 1e-3, 0}, {0, 0, 2e-4}}) {
    const CreepForces a = fastsim(patch, creepage, one).forces;
    const CreepForces b = fastsim(patch, creepage).forces;
    EXPECT_NEAR(a.longitudinal, b.longitudinal, 1e-6);
    EXPECT_NEAR(a.lateral, b.lateral, 1e-6);
  }
  const contact::Creepage mixed{1e-3, 1e-3, 0};
  EXPECT_GT(
      std::abs(fastsim(patch, mixed, one).forces.lateral - fastsim(patch, mixed).forces.lateral),
      1.0);
}

TEST(Fastsim, IsMirroredWithTheScene) {
  const contact::Case input = thesis_case('b');
  const EllipticPatch patch = elliptic_patch(input);
  const CreepForces here = fastsim(patch, {1e-3, 5e-4, 1e-4}).forces;
  const CreepForces mirrored = fastsim(patch, {1e-3, -5e-4, -1e-4}).forces;
  EXPECT_NEAR(mirrored.longitudinal, here.longitudinal, 1e-8 * std::abs(here.longitudinal));
  EXPECT_NEAR(mirrored.lateral, -here.lateral, 1e-8 * std::abs(here.lateral));
  EXPECT_NEAR(mirrored.spin_moment, -here.spin_moment, 1e-7 * std::abs(here.spin_moment));
}

TEST(Fastsim, ModelForcesAreThoseOfItsFields) {
  contact::Case input = thesis_case('c', 80, {{0, 0, 0}, {1e-3, 5e-4, 1e-4}, {0.05, 0, 0}});
  for (const BoundShape bound : {BoundShape::parabolic, BoundShape::elliptic}) {
    input.fastsim.bound = bound;
    const contact::ModelResult result = run_fastsim(input, {});
    expect_forces_of_fields(result, 2e-3 * 27500);
    for (const contact::PointResult& point : result.points)
      EXPECT_LE(point.adhesion_area, point.contact_area * (1 + 1e-12));
    EXPECT_EQ(result.points[0].longitudinal_force, 0.0);
    EXPECT_NEAR(result.points[2].traction_coefficient, 0.55, 1e-3);
  }
}

TEST(Fastsim, ErrorEstimateCoversTheErrorOfResolution) {
  contact::Case input = thesis_case('b', 40, {{1e-3, 0, 0}, {1e-3, 5e-4, 1e-4}, {0, 0, 5e-4}});
  FastsimOptions fine;
  fine.strips = fine.strip_elements = 1600;
  const EllipticPatch patch = elliptic_patch(input);
  for (const contact::PointResult& point : run_fastsim(input, {}).points)
    for (const auto& [name, member] : {std::pair{"longitudinal_force", &CreepForces::longitudinal},
                                       std::pair{"lateral_force", &CreepForces::lateral}}) {
      const double exact = fastsim(patch, point.creepage, fine).forces.*member;
      const double value =
          member == &CreepForces::lateral ? point.lateral_force : point.longitudinal_force;
      if (std::abs(exact) < 1.0) continue;
      EXPECT_LT(std::abs(value - exact), 1.5 * point.error_estimate.at(name)) << name;
    }
}

TEST(Fastsim, HoldsFromNarrowToWidePatchesAndFromLittleToMuchFriction) {
  for (const double rail_radius : {0.5, 3e5})
    for (const double friction : {1e-4, 500.0})
      for (const double force : {1.0, 1e7}) {
        contact::Case input = thesis_case('b');
        input.rail.transverse_radius = rail_radius;
        input.friction_coefficient = friction;
        input.load.normal_force = force;
        const EllipticPatch patch = elliptic_patch(input);
        const HertzContact& hertz = patch.hertz;
        EXPECT_GT(std::abs(std::log(hertz.semi_axis_x / hertz.semi_axis_y)), std::log(50.0));
        const contact::Creepage small{1e-12, 2e-12, 0};
        const CreepForces linear = linear_creep_forces(hertz.semi_axis_x, hertz.semi_axis_y,
                                                       patch.material.shear_modulus, 0.3, small);
        const CreepForces sum = fastsim(patch, small).forces;
        EXPECT_NEAR(sum.longitudinal / linear.longitudinal, 1.0, 1e-3);
        EXPECT_NEAR(sum.lateral / linear.lateral, 1.0, 1e-3);
        const CreepForces large = fastsim(patch, {1e6, 0, 0}).forces;
        EXPECT_NEAR(-large.longitudinal / (friction * force), 1.0, 1e-4);
      }
}

TEST(Fastsim, WithoutFrictionHasNoForce) {
  contact::Case input = thesis_case('b');
  input.friction_coefficient = 0.0;
  input.rolling.creepages = {{1e-3, 1e-3, 1e-4}};
  const contact::PointResult point = run_fastsim(input, {}).points[0];
  EXPECT_EQ(point.longitudinal_force, 0.0);
  EXPECT_EQ(point.lateral_force, 0.0);
}

}  // namespace
}  // namespace rollfem::theories
