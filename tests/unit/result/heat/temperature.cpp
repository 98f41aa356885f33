// SPDX-License-Identifier: LGPL-2.1-or-later
// Flash temperatures against closed forms: Jaeger 1942; Carslaw and Jaeger 1959, 2.9 and 2.15.
#include "result/heat/temperature.hpp"

#include "base/pi.hpp"

#include "support/test.hpp"

namespace {

using contact::Field;
using contact::PointResult;
using contact::SurfaceHeat;

constexpr double speed = 30e3, steel = 13.29;

/// Contact for |x| < a with this work of friction in one row; `behind` of the grid is free of
/// contact.
PointResult heated(const SurfaceHeat& heat, int across, const std::function<double(double)>& work,
                   ContactGrid& grid, double a = 5.0, double behind = 10.0) {
  const double dx = 2.0 * a / across;
  grid = ContactGrid::centred(across + static_cast<int>(behind / dx), 1, dx, 1.0, -0.5 * behind);
  PointResult point;
  const auto within = [&](double x, double value) { return std::abs(x) < a ? value : 0.0; };
  point.fields.traction.n = grid.sample([&](double x, double) { return within(x, 1.0); });
  point.fields.work = grid.sample([&](double x, double) { return within(x, work(x)); });
  contact::set_temperatures(grid, heat, point);
  return point;
}

SurfaceHeat heat_of(double wheel, double rail, double wheel_temperature = 0.0,
                    double rail_temperature = 0.0) {
  return {{wheel, 14.0, 1.2e-5, wheel_temperature, 700.0},
          {rail, 14.0, 1.2e-5, rail_temperature, 700.0},
          speed};
}

double uniform(double) {
  return 2.0;
}

}  // namespace

TEST(FlashTemperature, OfAUniformSourceIsJaegersAtEveryElement) {
  ContactGrid grid;
  const SurfaceHeat heat = heat_of(steel, 0.5 * steel, 20.0, 20.0);
  const PointResult point = heated(heat, 20, uniform, grid);
  const double flow = speed * 2.0;
  for (int i = 0; i < grid.nx; ++i) {
    // Since the leading and the trailing edge.
    const double since = std::max(0.0, 5.0 - grid.x(i)), until = std::max(0.0, -5.0 - grid.x(i));
    const double exact =
        20.0 + 2.0 * flow / (1.5 * steel) *
                   (std::sqrt(since / (pi * speed)) - std::sqrt(until / (pi * speed)));
    EXPECT_NEAR(point.fields.temperature_wheel[i], exact, 1e-9 * exact);
    EXPECT_NEAR(point.fields.temperature_rail[i], exact, 1e-9 * exact);
  }
  EXPECT_NEAR(*point.heat_wheel, 2.0 * *point.heat_rail, 1e-9);
  EXPECT_NEAR(*point.heat_wheel + *point.heat_rail, 2.0 * 10.0, 1e-12);
  EXPECT_NEAR(*point.max_temperature_x, grid.x(0) + 10.0, 1e-9);
}

TEST(FlashTemperature, OfHertzianPressureInFullSlidingConvergesToTheClosedForm) {
  // 0.5 q0 sqrt(a/V) / (beta sqrt(pi)) times 2.1883 at x = -0.65 a, both bodies of steel.
  const double exact =
      0.5 * 100.0 * speed * std::sqrt(5.0 / speed) / (steel * std::sqrt(pi)) * 2.1883;
  const auto hertz = [](double x) { return 100.0 * std::sqrt(std::max(0.0, 1.0 - x * x / 25.0)); };
  ContactGrid grid;
  // The largest of the elements' middles; the last figure of 2.1883 is left at 640.
  for (const auto& [across, allowed] : {std::pair{20, 6e-3}, {40, 2e-3}, {80, 7e-4}, {640, 1e-4}}) {
    const PointResult point = heated(heat_of(steel, steel), across, hertz, grid);
    EXPECT_NEAR(*point.max_temperature / exact, 1.0, allowed) << across;
    if (across == 640) {
      EXPECT_NEAR(*point.max_temperature_x / 5.0, -0.65, 0.01);
    }
  }
}

TEST(FlashTemperature, BodiesOfUnlikeTemperatureMeetInBetweenAndReturnToTheirOwn) {
  ContactGrid grid;
  const SurfaceHeat heat = heat_of(steel, 0.5 * steel, 150.0, 0.0);
  const PointResult point = heated(
      heat, 400, [](double) { return 0.0; }, grid);
  EXPECT_NEAR(heat.contact_temperature(), 100.0, 1e-12);
  for (int i = 0; i < grid.nx; ++i) {
    const double since = (5.0 - grid.x(i)) / speed, touching = 10.0 / speed;
    const double left = since > touching ? 2.0 / pi * std::asin(std::sqrt(touching / since)) : 1.0;
    // Behind the trailing edge the exchange, infinite where contact begins, is a mean over
    // elements.
    const double tolerance = since > touching ? 0.3 : 1e-9;
    EXPECT_NEAR(point.fields.temperature_wheel[i], 150.0 - 50.0 * left, tolerance) << grid.x(i);
    EXPECT_NEAR(point.fields.temperature_rail[i], 100.0 * left, 2.0 * tolerance) << grid.x(i);
  }
  // beta (T - T_0) 2 sqrt(t/pi) per area until the trailing edge, V per length.
  const double taken = 0.5 * steel * 100.0 * 2.0 * std::sqrt(10.0 * speed / pi) / speed;
  EXPECT_NEAR(*point.heat_rail, speed * taken / speed, 0.01 * taken);
  EXPECT_NEAR(*point.heat_wheel + *point.heat_rail, 0.0, 1e-9);
}

TEST(FlashTemperature, HeatOfAFirstPatchIsCarriedToASecond) {
  // Where both touch, beta_w (T_w - T_w0) + beta_r (T_r - T_r0) is Abel's integral of all friction.
  ContactGrid grid;
  const SurfaceHeat heat = heat_of(steel, 0.3 * steel, 80.0, 10.0);
  PointResult point = heated(heat, 40, uniform, grid, 5.0, 0.0);
  for (int i = 15; i < 25; ++i) point.fields.traction.n[i] = point.fields.work[i] = 0.0;
  contact::set_temperatures(grid, heat, point);
  for (int i = 0; i < 15; ++i) {
    const int ahead = grid.nx - i;
    const double sum = heat.warming(grid.dx, ahead).dot(point.fields.work.tail(ahead));
    const double exact = heat.contact_temperature() + speed * sum / (1.3 * steel);
    EXPECT_NEAR(point.fields.temperature_wheel[i], exact, 1e-9 * exact);
    EXPECT_NEAR(point.fields.temperature_rail[i], exact, 1e-9 * exact);
  }
  EXPECT_GT(std::abs(point.fields.temperature_wheel[20] - point.fields.temperature_rail[20]), 1.0);
}

namespace {

/// A state of full sliding with the work of `heated` as traction and slip.
PointResult sliding(const PointResult& like, const ContactGrid& grid) {
  PointResult point = like;
  point.fields.traction.x = -like.fields.work;
  point.fields.traction.y = point.fields.slip.y = Field::Zero(grid.size());
  point.fields.slip.x = Field::Ones(grid.size());
  point.fields.work = {};
  return point;
}

}  // namespace

TEST(FlashTemperature, OfAStateThatStaysIsThatOfSteadyRollingWhateverTheSteps) {
  ContactGrid grid;
  const SurfaceHeat heat = heat_of(steel, 0.4 * steel, 120.0, 20.0);
  const PointResult steady = heated(
      heat, 40, [](double x) { return 2.0 + 0.3 * x; }, grid);
  for (const double length : {0.3 * grid.dx, grid.dx, 2.7 * grid.dx, 30.0}) {
    contact::HeatPast past;
    PointResult point;
    for (double way = 0.0; way < 25.0; way += length) {
      point = sliding(steady, grid);
      past.insert(past.begin(), contact::set_temperatures(grid, heat, length, past, point));
    }
    EXPECT_LT(
        (point.fields.temperature_rail - steady.fields.temperature_rail).cwiseAbs().maxCoeff(),
        1e-9)
        << length;
    EXPECT_LT(
        (point.fields.temperature_wheel - steady.fields.temperature_wheel).cwiseAbs().maxCoeff(),
        1e-9);
    EXPECT_NEAR(*point.heat_wheel, *steady.heat_wheel, 1e-9);
    // All that is left of earlier steps, with that of a last one without friction.
    const Field left = contact::left_temperature(grid, heat, length, past);
    PointResult cold = sliding(steady, grid);
    cold.fields.slip.x.setZero();
    contact::set_temperatures(grid, heat, length, past, cold);
    for (int i = 0; i < grid.nx; ++i)
      if (cold.fields.traction.n[i] > 0.0) {
        EXPECT_NEAR(cold.fields.temperature_rail[i], left[i], 1e-9) << length;
      }
  }
}

TEST(FlashTemperature, OfASourceThatStaysGrowsAsTheRootOfTime) {
  // Far from the leading edge all material has the same heat: T = 2 q sqrt(t/pi) / beta.
  ContactGrid grid;
  const SurfaceHeat heat = heat_of(steel, steel);
  const PointResult all = heated(heat, 100, uniform, grid, 5.0, 0.0);
  contact::HeatPast past;
  for (int step = 1; step <= 40; ++step) {
    PointResult point = sliding(all, grid);
    past.insert(past.begin(), contact::set_temperatures(grid, heat, grid.dx, past, point));
    const double t = (step - 0.5) * grid.dx / speed;
    const double exact = 2.0 * speed * 2.0 * std::sqrt(t / pi) / (2.0 * steel);
    EXPECT_NEAR(point.fields.temperature_wheel[10] / exact, 1.0, 1e-12) << step;
    EXPECT_NEAR(*point.heat_wheel + *point.heat_rail, 2.0 * 10.0, 1e-9);
  }
}
