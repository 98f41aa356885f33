// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that yield under a load that presses, up and down in steps, and does not roll: first yield
// of a ball, mean pressure, elastic unloading and loading again, equal bodies, friction, a run that
// is resumed.
#include "fem/elasticity/fem_model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"

#include "support/equal_balls.hpp"
#include "support/records_in_memory.hpp"

namespace {

using contact::Case;
using contact::PointResult;
using contact::YieldedSection;
using contact::YieldVerdict;

constexpr double ball_radius = 100.0, yield_stress = 300.0;
/// Of a rigid ball on steel.
constexpr double contact_modulus = 210e3 / (1.0 - 0.3 * 0.3);

/// N, by Hertz.
double force_of(double max_pressure) {
  return std::pow(contact::pi * max_pressure, 3) * ball_radius * ball_radius /
         (6.0 * contact_modulus * contact_modulus);
}

contact::BodyPlasticity steel(double hardening = 0.0) {
  contact::BodyPlasticity steel;
  steel.yield_stress = yield_stress;
  steel.back_stresses[0].modulus = hardening;
  return steel;
}

void press_with(Case& input, const std::vector<double>& forces) {
  input.rolling.problem = contact::Problem::shift;
  input.rolling.creepages.assign(forces.size(), {});
  input.history.assign(forces.size(), {});
  for (std::size_t k = 0; k < forces.size(); ++k) input.history[k].normal_force = forces[k];
  input.load.normal_force = *std::max_element(forces.begin(), forces.end());
}

/// A rigid ball on flat steel, without friction.
Case ball_on_flat(const std::vector<double>& forces) {
  Case input = equal_balls(ball_radius, 1000.0, 0.0);
  input.wheel.material.young_modulus = contact::infinity;
  input.rail.rolling_radius = input.rail.transverse_radius = contact::infinity;
  input.friction_coefficient = 0.0;
  input.rail.plasticity = steel();
  input.body_extent.reset();
  press_with(input, forces);
  return input;
}

std::vector<PointResult> steps_of(const Case& input, double cell) {
  return fem::run_level(input, {cell, "", false}, {}).points;
}

const YieldedSection& rail_of(const PointResult& point) {
  return point.yielded.back();
}

/// Of the patch of elastic bodies, semi-axis over 2.2.
const double cell_of_unloading =
    std::cbrt(0.75 * 15.0 * force_of(1.6 * yield_stress) * ball_radius / contact_modulus) / 2.2;

double mean_pressure(const PointResult& point) {
  return point.normal_force / point.contact_area;
}

}  // namespace

// Johnson (1985), section 6.1: 1.60 Y for nu = 0.3; the largest von Mises stress is 0.620 p0.
TEST(PlasticPressing, ABallYieldsFirstAtItsElasticLimit) {
  const double low = force_of(1.55 * yield_stress), high = force_of(1.75 * yield_stress);
  const double cell = std::cbrt(0.75 * high * ball_radius / contact_modulus) / 5.0;
  const auto points = steps_of(ball_on_flat({low, high, low}), cell);
  EXPECT_EQ(rail_of(points[0]).verdict, YieldVerdict::elastic);
  EXPECT_NEAR(points[0].max_pressure / (rail_of(points[0]).utilisation * yield_stress), 1.613,
              0.025);
  EXPECT_EQ(rail_of(points[1]).verdict, YieldVerdict::yields);
  // Half a radius of the patch below the middle.
  const auto& accumulated = rail_of(points[1]).accumulated;
  const auto deepest = std::max_element(accumulated.begin(), accumulated.end());
  EXPECT_NEAR(rail_of(points[1]).depth[deepest - accumulated.begin()] / points[1].semi_axis_x, 0.48,
              0.15);
  EXPECT_EQ(rail_of(points[2]).verdict, YieldVerdict::holds);
  EXPECT_FALSE(points[2].forward_flow || points[2].plastic_work || points[2].net_plastic_increment);
}

namespace {

/// What finite elements of others give for a perfectly plastic ball of nu = 0.3 and a rigid flat,
/// which differ from a rigid ball on a flat by the square of patch over radius: fitted by Jackson
/// and Green (2005, J. Tribol. 127, 343), where more than the core yields.
struct FittedContact {
  double force, radius;  ///< N, mm
};

FittedContact by_jackson_and_green(double approach) {
  const double c = 1.295 * std::exp(0.736 * 0.3), yield_strain = yield_stress / contact_modulus;
  const double slope = 0.5 * contact::pi * c * yield_strain;  // a/R at first yield
  const double first_force =
      4.0 / 3.0 * ball_radius * ball_radius * contact_modulus * slope * slope * slope;
  const double w = approach / (slope * slope * ball_radius);
  const double relative =
      slope * std::sqrt(w * std::pow(w / 1.9, 0.14 * std::exp(23.0 * yield_strain)));
  const double hardness = 2.84 * (1.0 - std::exp(-0.82 * std::pow(relative, -0.7)));
  return {first_force * (std::exp(-0.25 * std::pow(w, 5.0 / 12.0)) * std::pow(w, 1.5) +
                         4.0 * hardness / c * (1.0 - std::exp(-0.04 * std::pow(w, 5.0 / 9.0))) * w),
          ball_radius * relative};
}

/// Up to fifteen times the load of first yield in two steps, off and on again.
const std::vector<PointResult>& up_down_and_up() {
  static const std::vector<PointResult> points = [] {
    const double most = 15.0 * force_of(1.6 * yield_stress);
    return steps_of(ball_on_flat({0.4 * most, most, 0.95 * most, 0.0, most}), cell_of_unloading);
  }();
  return points;
}

/// Displacement, mm, that a pressure on elements causes at the origin of an elastic half-space, a
/// corner of four of them: integral p / (pi E* r).
double sinking_of(const contact::Field& pressure, double cell) {
  const int across = static_cast<int>(std::lround(std::sqrt(pressure.size())));
  double sum = 0.0;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i) {
      const double r = std::hypot(i + 0.5 - 0.5 * across, j + 0.5 - 0.5 * across);
      sum += pressure[j * across + i] * (r < 1.0 ? 2.0 * std::asinh(1.0) : 1.0 / r);
    }
  return sum * cell / (contact::pi * contact_modulus);
}

}  // namespace

// The slope at which the force falls is that of a flat punch as wide as the patch, 2 E* a (Sneddon
// 1965); what springs back is what the pressure presses down in an elastic half-space (for Hertz's
// pressure 3 F / (4 E* a): Johnson 1985, section 6.4).
TEST(PlasticPressing, UnloadingIsElasticAndSoIsTheSameLoadAgain) {
  const auto& points = up_down_and_up();
  const PointResult &most = points[1], &less = points[2], &none = points[3], &again = points[4];
  const double a = std::sqrt(most.contact_area / contact::pi);
  const double slope = (most.normal_force - less.normal_force) / (most.approach - less.approach);
  // Johnson's spherical cavity (1985, section 6.3): in the core, and up to 2/3 Y more below the
  // ball.
  const double core =
      2.0 / 3.0 * (1.0 + std::log(contact_modulus * a / (3.0 * yield_stress * ball_radius)));
  EXPECT_NEAR(mean_pressure(most) / yield_stress, core + 2.0 / 3.0, 0.25);
  for (const PointResult* point : {&points[0], &most})
    EXPECT_NEAR(point->normal_force / by_jackson_and_green(point->approach).force, 1.0, 0.08);
  EXPECT_NEAR(slope / (2.0 * contact_modulus * a), 1.0, 0.04);
  EXPECT_NEAR(
      (most.approach - none.approach) / sinking_of(most.fields.traction.n, cell_of_unloading), 1.0,
      0.03);
  for (std::size_t k = 2; k < points.size(); ++k) {
    EXPECT_EQ(rail_of(points[k]).verdict, YieldVerdict::holds) << k;
    EXPECT_NEAR(*points[k].groove_depth / *most.groove_depth, 1.0, 1e-4) << k;
  }
  EXPECT_EQ(none.max_pressure, 0.0);
  EXPECT_NEAR(none.approach / *none.groove_depth, 1.0, 0.03);
  EXPECT_NEAR(again.max_pressure / most.max_pressure, 1.0, 1e-3);
  EXPECT_NEAR(again.approach / most.approach, 1.0, 1e-4);
}

// Four elements around the middle bear the same pressure whatever the steel does.
TEST(PlasticPressing, APatchGrowsFromFourElements) {
  Case input = ball_on_flat({10e3, 28e3});
  input.options.set<fem::FemOptions>().plastic_extent = 1.3;
  const auto points = steps_of(input, 1.6);
  EXPECT_EQ((points[0].fields.traction.n.array() > 0.0).count(), 4);
  EXPECT_TRUE(points[1].converged);
  EXPECT_NEAR(std::sqrt(points[1].contact_area / contact::pi) /
                  by_jackson_and_green(points[1].approach).radius,
              1.0, 0.08);
}

// From a patch of twelve elements to steel that flows all around the contact: E* a / (Y R) = 40,
// where the mean pressure is 2.8 Y (Tabor 1951; Johnson 1985, section 6.3).
TEST(PlasticPressing, TheMeanPressureRisesToThatOfSteelThatFlowsAllAround) {
  Case input = ball_on_flat({10e3, 20e3, 38e3, 70e3});
  input.options.set<fem::FemOptions>().plastic_extent = 1.3;
  const auto points = steps_of(input, 1.3);
  for (const PointResult& point : points) {
    EXPECT_TRUE(point.converged);
    EXPECT_NEAR(point.normal_force / by_jackson_and_green(point.approach).force, 1.0, 0.08);
  }
  for (const PointResult* point : {&points[1], &points[2], &points[3]}) {
    const double a = by_jackson_and_green(point->approach).radius;
    EXPECT_NEAR(std::sqrt(point->contact_area / contact::pi) / a, 1.0, 0.04);
  }
  const double a = std::sqrt(points[3].contact_area / contact::pi);
  EXPECT_NEAR(contact_modulus * a / (yield_stress * ball_radius), 40.0, 1.0);
  EXPECT_NEAR(mean_pressure(points[3]) / yield_stress, 2.8, 0.1);
}

namespace {

/// By CalculiX 2.20 under the pressure of these steps, benchmarks/calculix/pressed_ball.py: depth
/// below the middle, mm, plastic strain under 4 kN, residual stress along x without load, MPa.
struct BelowTheBall {
  double depth, strain, along;
};
constexpr BelowTheBall by_calculix[] = {
    {0.1972, 1.685e-3, 42.4},   {0.3028, 2.963e-3, -9.5},   {0.4472, 4.101e-3, -79.5},
    {0.5528, 4.610e-3, -124.4}, {0.6972, 4.986e-3, -170.4}, {0.8028, 5.056e-3, -191.4},
    {0.9472, 4.902e-3, -204.0}, {1.053, 4.644e-3, -203.2},  {1.197, 4.146e-3, -191.7},
    {1.303, 3.716e-3, -177.5},  {1.447, 3.096e-3, -152.7},  {1.553, 2.647e-3, -131.8},
    {1.697, 2.065e-3, -101.0},  {1.803, 1.667e-3, -77.5},   {1.947, 1.171e-3, -44.9}};
/// Of the surface, in the middle (0.053 mm beside it) relative to 2.197 mm beside it, mm.
constexpr double imprint_by_calculix = -6.310e-3;

}  // namespace

TEST(PlasticPressing, StrainStressAndImprintBelowABallAreThoseOfCalculix) {
  Case input = ball_on_flat({1e3, 2e3, 4e3, 0.0});
  input.rail.plasticity->rise = 300.0;
  input.rail.plasticity->rate = 20.0;
  const auto points = steps_of(input, 0.25);
  const YieldedSection &most = rail_of(points[2]), &left = rail_of(points[3]);
  const auto width = static_cast<std::size_t>(left.across);
  for (const BelowTheBall& one : by_calculix) {
    std::size_t k = 0;
    while (std::abs(left.depth[k] - one.depth) > 1e-3) ASSERT_LT(k += width, left.depth.size());
    EXPECT_NEAR(most.accumulated[k], one.strain, 0.06 * 5.056e-3) << one.depth;
    EXPECT_NEAR(left.stress[k][0], one.along, 0.05 * 208.0) << one.depth;
  }
  EXPECT_NEAR((left.groove.front() - left.groove.back()) / imprint_by_calculix, 1.0, 0.025);
}

TEST(PlasticPressing, EqualBodiesYieldEqually) {
  Case input = equal_balls(ball_radius, 1000.0, 0.0);
  input.wheel.plasticity = input.rail.plasticity = steel(20e3);
  press_with(input, {*input.load.normal_force, 0.0});
  for (const PointResult& point : steps_of(input, 0.6)) {
    ASSERT_EQ(point.yielded.size(), 2U);
    const YieldedSection &wheel = point.yielded[0], &rail = point.yielded[1];
    EXPECT_GT(wheel.plastic_strain, 1e-3);
    EXPECT_NEAR(wheel.plastic_strain / rail.plastic_strain, 1.0, 1e-3);
    EXPECT_NEAR(wheel.groove.front() / rail.groove.front(), 1.0, 1e-2);
    EXPECT_EQ(wheel.verdict, rail.verdict);
  }
}

// Cattaneo's shift: tangential traction makes steel yield that bears the pressure alone without.
TEST(PlasticPressing, ATangentialForceAddsPlasticStrain) {
  Case input = equal_balls(ball_radius, 1000.0, 0.0);
  input.friction_coefficient = 0.4;
  input.rail.plasticity = steel(20e3);
  const double force = *input.load.normal_force;
  press_with(input, {force, force});
  input.rolling.forces.resize(2);
  input.rolling.forces[0].longitudinal = 0.0;
  input.rolling.forces[1].longitudinal = 0.3 * force;
  const auto points = steps_of(input, 0.6);
  EXPECT_GT(*points[1].plastic_increment, 1e-4);
}

TEST(PlasticPressing, ARunThatIsResumedGivesTheSameToTheLastBit) {
  Case input = ball_on_flat({400.0, 200.0, 600.0});
  RecordsInMemory kept;
  const fem::LevelOptions options{0.25, "", false, &kept};
  const PointResult whole = fem::run_level(input, options, {}).points.back();
  kept.records.erase("fem-0.25mm-0003");
  const PointResult resumed = fem::run_level(input, options, {}).points.back();
  ASSERT_EQ(kept.records.count("fem-0.25mm-0003"), 1U);
  EXPECT_EQ(whole.max_pressure, resumed.max_pressure);
  EXPECT_EQ(whole.plastic_strain, resumed.plastic_strain);
  EXPECT_EQ(whole.groove_depth, resumed.groove_depth);
  // Stopped before the first step.
  for (const char* step : {"0001", "0002", "0003"})
    kept.records.erase(std::string("fem-0.25mm-") + step);
  const PointResult begun = fem::run_level(input, options, {}).points.back();
  EXPECT_EQ(whole.max_pressure, begun.max_pressure);
  EXPECT_EQ(whole.groove_depth, begun.groove_depth);
}
