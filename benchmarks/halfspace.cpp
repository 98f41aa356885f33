// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the half-space: the products, the normal problem (case a) and one steady-rolling
// solution with combined creepage and spin (benchmark 9) from coarse to fine.
#include "base/threads.hpp"
#include "contact/iteration/interpolation.hpp"
#include "contact/iteration/leading_edge.hpp"
#include "contact/iteration/normal.hpp"
#include "contact/iteration/tangential.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "theories/fastsim.hpp"
#include "theories/strip.hpp"

#include <benchmark/benchmark.h>

#include "tests/support/thesis_cases.hpp"
#include <cmath>

namespace {

using namespace rollfem;
using contact::ContactGrid;
using contact::Field;
using contact::TangentialField;
using contact::UpwindOrder;
using halfspace::HalfspaceCompliance;

ContactGrid grid_of(int across) {
  return testing::Benchmark9().grid(across);
}

void setup(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const HalfspaceCompliance compliance(grid, testing::steel());
    benchmark::DoNotOptimize(&compliance.rolling(UpwindOrder::second));
  }
}

void rolling_product(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  const HalfspaceCompliance compliance(grid, testing::steel());
  const contact::TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const TangentialField p{Field::Ones(grid.size()), Field::Ones(grid.size())};
  for (auto _ : state) benchmark::DoNotOptimize(rolling.apply(p));
}

void rolling_preconditioner(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  const HalfspaceCompliance compliance(grid, testing::steel());
  const contact::TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const TangentialField p{Field::Ones(grid.size()), Field::Ones(grid.size())};
  for (auto _ : state) benchmark::DoNotOptimize(rolling.precondition(p, 1e5, 0.1));
}

void normal_problem(benchmark::State& state) {
  const int across = static_cast<int>(state.range(0));
  const contact::Case input = testing::thesis_case('a');
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(input);
  const contact::Curvatures curvatures = contact::relative_curvatures(input);
  const ContactGrid grid = ContactGrid::centred(
      across + 6, across + 6, 2 * hertz.semi_axis_x / across, 2 * hertz.semi_axis_y / across);
  contact::NormalProblem problem;
  problem.undeformed_distance = grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  problem.normal_force = input.load.normal_force;
  for (auto _ : state) {
    const HalfspaceCompliance compliance(grid, testing::steel());
    const contact::NormalSolution s = contact::solve_normal(compliance.normal(), problem);
    state.counters["elements"] = s.contact_elements;
    state.counters["iterations"] = s.iterations;
    state.counters["p0_error"] = s.pressure.maxCoeff() / hertz.max_pressure - 1.0;
  }
}

enum class Scheme { first_order, second_order, fitted_edge };

contact::TangentialSolution solve(const HalfspaceCompliance& compliance,
                                  const contact::TangentialProblem& problem, Scheme scheme,
                                  const TangentialField& start) {
  const contact::TangentialOperator& first = compliance.rolling(UpwindOrder::first);
  if (scheme == Scheme::first_order) return contact::solve_tangential(first, problem, {}, start);
  const contact::TangentialOperator& second = compliance.rolling(UpwindOrder::second);
  if (scheme == Scheme::second_order) return contact::solve_tangential(second, problem, {}, start);
  const contact::EdgeFittedRolling fitted(
      first, second, contact::upwind_weights(compliance.grid(), problem.pressure));
  return contact::solve_tangential(fitted, problem, {}, start);
}

/// Benchmark 9 on grids of 10, 20, ... across up to the requested one, each starting from the
/// previous one; the time covers all of them.
void roll(benchmark::State& state, Scheme scheme) {
  const int across = static_cast<int>(state.range(0));
  const testing::Benchmark9 benchmark9;
  for (auto _ : state) {
    int first = across;
    while (first >= 20) first /= 2;
    TangentialField relative;
    ContactGrid coarse;
    Field inside;
    int krylov = 0;
    for (int n = first; n <= across; n *= 2) {
      const ContactGrid grid = benchmark9.grid(n);
      const HalfspaceCompliance compliance(grid, testing::Benchmark9::material());
      const contact::TangentialProblem problem = benchmark9.problem(
          grid, scheme == Scheme::first_order ? UpwindOrder::first : UpwindOrder::second);
      const Field& g = problem.pressure;
      TangentialField start;
      if (n > first)
        start = {contact::interpolated(coarse, relative.x, grid, inside).cwiseProduct(g),
                 contact::interpolated(coarse, relative.y, grid, inside).cwiseProduct(g)};
      const contact::TangentialSolution s = solve(compliance, problem, scheme, start);
      inside = (g.array() > 0.0).cast<double>();
      const Field inverse = g.unaryExpr([](double v) { return v > 0.0 ? 1.0 / v : 0.0; });
      relative = {s.traction.x.cwiseProduct(inverse), s.traction.y.cwiseProduct(inverse)};
      coarse = grid;
      krylov += s.krylov_iterations;
      state.counters["krylov"] = s.krylov_iterations;
      const testing::Forces forces = testing::forces(grid, s.traction);
      state.counters["elements"] = inside.sum();
      state.counters["newton"] = s.newton_steps;
      state.counters["Fx"] = forces.x;
      state.counters["Mz"] = forces.moment;
    }
    state.counters["krylov_all"] = krylov;
  }
}

void steady_rolling(benchmark::State& state, Scheme scheme) {
  const contact::Threads alone(1);
  roll(state, scheme);
}

/// With the program's number of threads; compare its wall time.
void threaded_rolling(benchmark::State& state) {
  roll(state, Scheme::fitted_edge);
}

/// Bodies whose Hertz contact has the pressure of benchmark 9: crossed cylinders of radius 400 mm.
contact::Case benchmark_9_case() {
  const testing::Benchmark9 benchmark9;
  contact::Case input;
  input.title = "benchmark 9";
  input.file = "benchmark";
  input.load.normal_force = benchmark9.force;
  input.friction_coefficient = benchmark9.friction;
  const double poisson_ratio = 0.28;
  const double young_modulus = 2.0 * 82000.0 * (1.0 + poisson_ratio);
  input.wheel.material = input.rail.material = {young_modulus, poisson_ratio};
  input.wheel.rolling_radius = input.rail.transverse_radius =
      4.0 / 3.0 * testing::Benchmark9::material().contact_modulus * std::pow(benchmark9.radius, 3) /
      benchmark9.force;
  input.rolling.creepages = {benchmark9.creepage};
  input.contact_grid.elements_across = 10;  // for the fields only; the forces have their own strips
  return input;
}

void count(benchmark::State& state, const contact::PointResult& point) {
  state.counters["Fx"] = point.longitudinal_force;
  state.counters["Mz"] = point.spin_moment;
}

void fastsim(benchmark::State& state) {
  contact::Case input = benchmark_9_case();
  auto& options = input.options.set<theories::FastsimOptions>();
  options.strips = options.strip_elements = static_cast<int>(state.range(0));
  for (auto _ : state) count(state, theories::run_fastsim(input, {}).points[0]);
}

void strip(benchmark::State& state) {
  contact::Case input = benchmark_9_case();
  auto& options = input.options.set<theories::StripOptions>();
  options.strips = options.strip_elements = static_cast<int>(state.range(0));
  for (auto _ : state) count(state, theories::run_strip(input, {}).points[0]);
}

constexpr auto unit = benchmark::kMillisecond;
BENCHMARK(setup)->Arg(40)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(rolling_product)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(rolling_preconditioner)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(normal_problem)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK_CAPTURE(steady_rolling, first_order, Scheme::first_order)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Arg(160)
    ->Unit(unit);
BENCHMARK_CAPTURE(steady_rolling, second_order, Scheme::second_order)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Arg(160)
    ->Unit(unit);
BENCHMARK_CAPTURE(steady_rolling, fitted_edge, Scheme::fitted_edge)
    ->Arg(10)
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Arg(160)
    ->Arg(320)
    ->Unit(unit);
BENCHMARK(threaded_rolling)->Arg(160)->Arg(320)->Arg(640)->Unit(unit)->UseRealTime();
BENCHMARK(fastsim)->Arg(10)->Arg(20)->Arg(40)->Arg(80)->Arg(160)->Unit(unit);
BENCHMARK(strip)->Arg(10)->Arg(20)->Arg(40)->Arg(80)->Arg(160)->Unit(unit);

}  // namespace

BENCHMARK_MAIN();
