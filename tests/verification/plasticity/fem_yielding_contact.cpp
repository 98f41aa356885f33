// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of bodies that yield, by the whole model: an elastic limit, equal discs, the pressure
// that flattens, number of threads, streamlines that may yield.
#include "base/threads.hpp"
#include "fem/elasticity/fem_model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "fem/mesh/run_layout.hpp"

#include "support/equal_balls.hpp"

namespace {

using contact::Case;
using contact::ModelResult;
using contact::PointResult;

/// A wheel on a roller like it, pressed without friction to about p0 = `pressure` (MPa).
Case equal_discs(double pressure, int passes) {
  Case input = equal_balls(200.0, pressure, 0.0);
  input.rolling.problem = contact::Problem::frictionless;
  input.rolling.creepages.resize(passes);
  input.options.set<fem::FemOptions>().passes = passes;
  input.body_extent = 8.0;
  return input;
}

contact::BodyPlasticity steel(double yield_stress, double hardening) {
  contact::BodyPlasticity steel;
  steel.yield_stress = yield_stress;
  steel.back_stresses[0].modulus = hardening;
  return steel;
}

ModelResult solved(const Case& input, double cell) {
  return fem::run_level(input, {cell, "", false}, {});
}

// p0 = 1500 MPa is 5 k of a steel of 520 MPa; a is about 1.3 mm.
constexpr double pressure = 1500.0, cell = 0.5;

/// A roller of steel that hardens, over two passes; solved once for all tests of this suite, on two
/// threads.
Case yielding_roller() {
  Case input = equal_discs(pressure, 2);
  input.rail.plasticity = steel(520.0, 20e3);
  return input;
}

const std::vector<PointResult>& two_passes() {
  static const std::vector<PointResult> points = [] {
    const contact::Threads two(2);
    return solved(yielding_roller(), cell).points;
  }();
  return points;
}

TEST(FemYieldingContact, OfStrongSteelIsElasticToTheLastDigit) {
  Case input = equal_discs(pressure, 1);
  input.rail.plasticity = steel(1e6, 0.0);
  const PointResult yielding = solved(input, cell).points.front();
  input.options.set<fem::FemOptions>().pass_pressure = fem::PassPressure::elastic;
  const PointResult elastic = solved(input, cell).points.front();
  EXPECT_EQ(yielding.max_pressure, elastic.max_pressure);
  EXPECT_EQ(yielding.approach, elastic.approach);
  EXPECT_EQ(yielding.yielded.front().verdict, contact::YieldVerdict::elastic);
  EXPECT_EQ(yielding.plastic_strain.value(), 0.0);
  EXPECT_EQ(yielding.groove_depth.value(), 0.0);
  EXPECT_LT(yielding.yielded.front().utilisation, 1e-3);
  // The mesh is finer than that of an elastic body: alike within the errors of such cells.
  input.rail.plasticity.reset();
  EXPECT_NEAR(solved(input, cell).points.front().max_pressure / elastic.max_pressure, 1.0, 3e-3);
}

TEST(FemYieldingContact, GrowsWhereSteelYieldsAtTheBorderOfTheStreamlines) {
  Case input = equal_discs(pressure, 1);
  input.rail.plasticity = steel(520.0, 20e3);
  input.options.set<fem::FemOptions>().cell_size = cell;
  input.options.set<fem::FemOptions>().plastic_extent = 0.5;
  std::array<double, 3> growth{1.0, 1.0, 1.0};
  const ModelResult grown = fem::run_fem(
      input,
      [&](const contact::ProgressEvent& event) {
        for (const auto& [border, direction] :
             {std::pair("lead", 0), {"trail", 0}, {"lateral", 1}, {"lower", 2}})
          if (event.note.find(fmt::format("yielded at the {}", border)) != std::string::npos)
            growth[direction] *= 1.3;
      },
      nullptr);
  EXPECT_GT(growth[0] * growth[1] * growth[2], 1.0);
  EXPECT_NE(grown.note_about("plastic_extent"), nullptr);
  input.options.set<fem::FemOptions>().plastic_growth = growth;
  const PointResult at_once = fem::run_fem(input, {}, nullptr).points.front();
  EXPECT_EQ(grown.points.front().max_pressure, at_once.max_pressure);
  EXPECT_EQ(grown.points.front().plastic_strain.value(), at_once.plastic_strain.value());
}

TEST(FemYieldingContact, DefaultCellsGrowWithTheRegionThatYields) {
  Case input = equal_discs(pressure, 1);
  input.rail.plasticity = steel(520.0, 20e3);
  input.options.set<fem::FemOptions>().cell_size.reset();
  const double usual = fem::default_cell_size(input);
  input.options.set<fem::FemOptions>().plastic_extent = 1.5;
  EXPECT_DOUBLE_EQ(fem::default_cell_size(input), 1.5 * usual);
}

TEST(FemYieldingContact, CellsThatGiveTooFewElementsAreRefusedBeforeTheBodiesAreMeshed) {
  Case input = equal_discs(pressure, 1);
  input.options.set<fem::FemOptions>().cell_size = 2.2;
  int events = 0;
  const auto count = [&](const contact::ProgressEvent&) { ++events; };
  EXPECT_THROW(fem::run_fem(input, count, nullptr), contact::UnfitGrid);
  EXPECT_EQ(events, 0);
}

TEST(FemYieldingContact, OfEqualDiscsYieldsEquallyInBoth) {
  Case input = equal_discs(pressure, 2);
  input.wheel.plasticity = input.rail.plasticity = steel(520.0, 20e3);
  for (const PointResult& point : solved(input, cell).points) {
    ASSERT_EQ(point.yielded.size(), 2U);
    const contact::YieldedSection &wheel = point.yielded[0], &rail = point.yielded[1];
    EXPECT_EQ(wheel.body, "wheel");
    EXPECT_GT(wheel.plastic_strain, 1e-3);
    // To the tolerance of the contact iteration.
    EXPECT_NEAR(wheel.plastic_strain / rail.plastic_strain, 1.0, 1e-4);
    EXPECT_NEAR(wheel.groove.front() / rail.groove.front(), 1.0, 1e-3);
    EXPECT_EQ(wheel.verdict, rail.verdict);
  }
}

TEST(FemYieldingContact, FlattensThePressureAndIsTheSameOnAnyNumberOfThreads) {
  const std::vector<PointResult>& points = two_passes();
  for (const PointResult& point : points) {
    EXPECT_TRUE(point.converged);
    EXPECT_LT(point.max_pressure, 0.97 * pressure);
    EXPECT_GT(point.groove_depth.value(), 0.0);
    EXPECT_NEAR(point.yielded.front().utilisation, 1.0, 1e-10);
  }
  // Steel that has yielded yields less.
  EXPECT_LT(points[1].plastic_increment.value(), 0.5 * points[0].plastic_increment.value());
  const contact::Threads one(1);
  const std::vector<PointResult> alone = solved(yielding_roller(), cell).points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(points[k].max_pressure, alone[k].max_pressure);
    EXPECT_EQ(points[k].plastic_strain.value(), alone[k].plastic_strain.value());
  }
}

TEST(FemYieldingContact, OfResidualCompressionYieldsLater) {
  // Compression along and across as shakedown leaves it lowers the plastic strain of the first
  // pass.
  Case input = equal_discs(pressure, 1);
  input.rail.plasticity = steel(520.0, 20e3);
  const double without = two_passes().front().plastic_increment.value();
  input.rail.plasticity->residual = {{0.0, 1.0, 3.0}, {-200.0, -200.0, 0.0}, {-200.0, -200.0, 0.0}};
  EXPECT_LT(solved(input, cell).points.front().plastic_increment.value(), 0.8 * without);
}

/// A roller of this steel on an elastic one that slide, or the wheel of it; pressure of elastic
/// bodies. Heat goes down by 0.24 mm, 0.12 a.
Case heated_roller(const contact::BodyPlasticity& of, double expansion, bool is_wheel = false,
                   double lateral = 0.0) {
  Case input = equal_balls(200.0, pressure, 0.25);
  input.rolling.creepages.front().lateral = lateral;
  input.friction_coefficient = 0.3;
  input.rolling.speed = 1000.0;
  input.body_extent = 8.0;
  contact::Body& body = is_wheel ? static_cast<contact::Body&>(input.wheel) : input.rail;
  body.plasticity = of;
  body.heat.emplace();
  body.heat->expansion = expansion;
  input.options.set<fem::FemOptions>().pass_pressure = fem::PassPressure::elastic;
  return input;
}

contact::BodyPlasticity softening_steel() {
  contact::BodyPlasticity soft = steel(700.0, 20e3);
  soft.hot_temperature = 250.0;
  soft.hot_yield_stress = 400.0;
  return soft;
}

// Expanding so much that the load adds nothing, at points a fifth of a first row of a third of the
// layer deep: there the rise is 6 % below that of the surface.
TEST(FemYieldingContact, HasTheThermalStressOfItsSurface) {
  constexpr double expansion = 1e-2;
  for (const bool is_wheel : {false, true}) {
    const PointResult point =
        solved(heated_roller(steel(1e9, 0.0), expansion, is_wheel), cell).points.front();
    const double rise = point.max_temperature.value() - 20.0;
    EXPECT_GT(rise, 100.0);
    EXPECT_NEAR(point.yielded.front().utilisation * 1e9 / (210e3 * expansion * rise / 0.7), 0.94,
                0.015);
  }
}

// Where the first row is thicker, the steel is as cold as without heat, and a note says so.
TEST(FemYieldingContact, YieldsWithHeatWhereCellsResolveIt) {
  const auto increment = [](const ModelResult& result) {
    return result.points.front().plastic_increment.value();
  };
  Case cold = heated_roller(steel(700.0, 20e3), 0.0),
       warm = heated_roller(steel(700.0, 20e3), 1.2e-5),
       hot = heated_roller(softening_steel(), 0.0);
  const ModelResult warmed = solved(warm, 1.5 * cell);
  const double without = increment(solved(cold, 1.5 * cell));
  EXPECT_GT(std::abs(increment(warmed) - without), 0.05 * without);
  EXPECT_GT(increment(solved(hot, 1.5 * cell)), 1.2 * without);
  EXPECT_EQ(warmed.note_about("thermal_stress"), nullptr);
  for (Case* input : {&cold, &hot}) input->options.set<fem::FemOptions>().surface_layer = 0.1;
  hot.rail.heat->expansion = 1.2e-5;
  const ModelResult coarse = solved(hot, 1.5 * cell);
  EXPECT_EQ(increment(coarse), increment(solved(cold, 1.5 * cell)));
  const contact::Note* note = coarse.note_about("thermal_stress");
  ASSERT_NE(note, nullptr);
  const double left_out =
      210e3 * 1.2e-5 / 0.7 * (coarse.points.front().max_temperature.value() - 20.0);
  EXPECT_EQ(note->text.find(
                fmt::format("yielding leaves out thermal strain: up to {:.0f} MPa", left_out)),
            0U)
      << note->text;
}

TEST(FemYieldingContact, WithHeatIsItsMirrorImage) {
  const auto section = [](double lateral) {
    return solved(heated_roller(softening_steel(), 1.2e-5, true, lateral), 1.5 * cell)
        .points.front()
        .yielded.front();
  };
  const contact::YieldedSection left = section(0.05), right = section(-0.05);
  EXPECT_GT(left.increment, 1e-3);
  for (std::size_t k = 0; k < left.accumulated.size(); ++k) {
    const std::size_t across = k % left.across;
    const std::size_t mirrored = k - across + left.across - 1 - across;
    EXPECT_NEAR(left.accumulated[k], right.accumulated[mirrored], 1e-3 * left.increment);
  }
}

}  // namespace
