// Speed of the half-space: the products, the normal problem (case a) and one steady-rolling
// solution with combined creepage and spin (benchmark 9) from coarse to fine.
#include "contact/normal.hpp"
#include "contact/tangential.hpp"
#include "halfspace/compliance.hpp"
#include "halfspace/hertz.hpp"
#include "halfspace/interpolation.hpp"

#include <benchmark/benchmark.h>

#include "tests/support/thesis_cases.hpp"

namespace {

using namespace rollfem;
using contact::ContactGrid;
using contact::Field;
using contact::TangentialField;
using contact::UpwindOrder;
using halfspace::HalfspaceCompliance;

ContactGrid grid_of(int across) {
  return tests::Benchmark9().grid(across);
}

void setup(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const HalfspaceCompliance compliance(grid, tests::steel());
    benchmark::DoNotOptimize(&compliance.rolling(UpwindOrder::second));
  }
}

void rolling_product(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  const HalfspaceCompliance compliance(grid, tests::steel());
  const contact::TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const TangentialField p{Field::Ones(grid.size()), Field::Ones(grid.size())};
  for (auto _ : state) benchmark::DoNotOptimize(rolling.apply(p));
}

void rolling_preconditioner(benchmark::State& state) {
  const ContactGrid grid = grid_of(static_cast<int>(state.range(0)));
  const HalfspaceCompliance compliance(grid, tests::steel());
  const contact::TangentialOperator& rolling = compliance.rolling(UpwindOrder::second);
  const TangentialField p{Field::Ones(grid.size()), Field::Ones(grid.size())};
  for (auto _ : state) benchmark::DoNotOptimize(rolling.precondition(p, 1e5, 0.1));
}

void normal_problem(benchmark::State& state) {
  const int across = static_cast<int>(state.range(0));
  const contact::Case input = tests::thesis_case('a');
  const halfspace::HertzContact hertz = halfspace::hertz_of_case(input);
  const contact::Curvatures curvatures = contact::relative_curvatures(input);
  const ContactGrid grid = ContactGrid::centred(
      across + 6, across + 6, 2 * hertz.semi_axis_x / across, 2 * hertz.semi_axis_y / across);
  contact::NormalProblem problem;
  problem.undeformed_distance = grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  problem.normal_force = input.load.normal_force;
  for (auto _ : state) {
    const HalfspaceCompliance compliance(grid, tests::steel());
    const contact::NormalSolution s = contact::solve_normal(compliance.normal(), problem);
    state.counters["elements"] = s.contact_elements;
    state.counters["iterations"] = s.iterations;
    state.counters["p0_error"] = s.pressure.maxCoeff() / hertz.max_pressure - 1.0;
  }
}

/// Grids of 10, 20, ... across up to the wanted one, each starting from the one before.
void steady_rolling(benchmark::State& state) {
  const int across = static_cast<int>(state.range(0));
  const tests::Benchmark9 benchmark9;
  for (auto _ : state) {
    int first = across;
    while (first >= 20) first /= 2;
    TangentialField relative;
    ContactGrid coarse;
    Field inside;
    int krylov = 0;
    for (int n = first; n <= across; n *= 2) {
      const ContactGrid grid = benchmark9.grid(n);
      const HalfspaceCompliance compliance(grid, tests::Benchmark9::material());
      const contact::TangentialProblem problem = benchmark9.problem(grid);
      const Field& g = problem.traction_bound;
      TangentialField start;
      if (n > first)
        start = {halfspace::interpolated(coarse, relative.x, grid, inside).cwiseProduct(g),
                 halfspace::interpolated(coarse, relative.y, grid, inside).cwiseProduct(g)};
      const contact::TangentialSolution s =
          contact::solve_tangential(compliance.rolling(UpwindOrder::second), problem, {}, start);
      inside = (g.array() > 0.0).cast<double>();
      const Field inverse = g.unaryExpr([](double v) { return v > 0.0 ? 1.0 / v : 0.0; });
      relative = {s.traction.x.cwiseProduct(inverse), s.traction.y.cwiseProduct(inverse)};
      coarse = grid;
      krylov += s.krylov_iterations;
      const tests::Forces forces = tests::forces(grid, s.traction);
      state.counters["elements"] = inside.sum();
      state.counters["newton"] = s.newton_steps;
      state.counters["Fx"] = forces.x;
      state.counters["Mz"] = forces.moment;
    }
    state.counters["krylov_all"] = krylov;
  }
}

constexpr auto unit = benchmark::kMillisecond;
BENCHMARK(setup)->Arg(40)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(rolling_product)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(rolling_preconditioner)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(normal_problem)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);
BENCHMARK(steady_rolling)->Arg(20)->Arg(40)->Arg(80)->Arg(160)->Arg(320)->Unit(unit);

}  // namespace

BENCHMARK_MAIN();
