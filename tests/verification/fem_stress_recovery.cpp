// SPDX-License-Identifier: LGPL-2.1-or-later
// Recovered stress on curved bodies with hanging nodes: its order by a manufactured solution, and
// the same numbers on any number of processes.
#include "fem/discretisation/body_points.hpp"
#include "fem/linear/multigrid.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "fem/trace/fem_compliance.hpp"

#include "support/fem_loaded_rail.hpp"
#include "support/fem_manufactured.hpp"

namespace {

/// Cells of `cell` near the origin, twice that further out: halving `cell` halves every cell.
fem::BodyOptions two_sizes(double cell) {
  fem::BodyOptions options;
  options.cell_size = cell;
  options.fine_half_length = options.fine_half_width = cell;
  options.fine_depth = 1;
  options.extent = manufactured_extent;
  options.growth = 0.4 * cell;
  return options;
}

/// Points in the body, some on its surface, on both sides of hanging faces.
std::vector<fem::Place> scattered_points(const fem::SurfaceShape& shape) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<fem::Place> places;
  for (int k = 0; k < 4000; ++k) {
    const double s = 0.75 * manufactured_extent * uniform(generator);
    const double t = 0.75 * manufactured_extent * uniform(generator);
    const double depth = k % 4 == 0 ? 0.0 : 0.375 * manufactured_extent * (1 + uniform(generator));
    const auto p = shape.place(s, t, depth);
    places.push_back({p[0], p[1], p[2]});
  }
  return places;
}

struct RecoveryErrors {
  double effectivity = 0;  ///< of the estimate in the energy norm
  double rms = 0;          ///< of all components, relative to the rms of the stress
  double surface = 0;      ///< the same at the points on the surface
  double largest = 0;      ///< of a component, relative to the same
};

RecoveryErrors errors(const fem::SurfaceShape& shape, double cell) {
  const fem::Body body(shape, manufactured_material, two_sizes(cell), MPI_COMM_WORLD);
  const Manufactured exact{shape};
  auto u = fem::make_vector(body.dofs());
  fem::make_multigrid(body.problem(), {1e-9})->solve(u, manufactured_load(body, exact));
  const auto stress = fem::StressRecovery(body).recover(u);
  const auto points = fem::BodyLocator(body).find(scattered_points(shape), 0.01);
  const auto found = fem::stress_at(points, stress);
  double all = 0, scale = 0, top = 0;
  RecoveryErrors result;
  result.effectivity =
      fem::energy_error(body, u, stress).error / std::sqrt(energies(body, exact, u)[0]);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& p = points.place(k);
    const auto expected =
        components_of(stress_of(exact.gradient(dealii::Point<3>(p[0], p[1], p[2]))));
    double sum = 0;
    for (int c = 0; c < 6; ++c) {
      const double difference = found[k][c] - expected[c];
      sum += difference * difference;
      scale += expected[c] * expected[c];
      result.largest = std::max(result.largest, std::abs(difference));
    }
    all += sum;
    if (k % 4 == 0) top += sum;
  }
  result.rms = std::sqrt(all / scale);
  result.surface = std::sqrt(4 * top / scale);
  result.largest /= std::sqrt(scale / points.size());
  return result;
}

void expect_order(const fem::SurfaceShape& shape) {
  const RecoveryErrors coarse = errors(shape, 1.0);
  const RecoveryErrors fine = errors(shape, 0.5);
  EXPECT_GT(std::log2(coarse.rms / fine.rms), 2.0) << coarse.rms << " -> " << fine.rms;
  EXPECT_GT(std::log2(coarse.surface / fine.surface), 2.0)
      << coarse.surface << " -> " << fine.surface;
  EXPECT_GT(std::log2(coarse.largest / fine.largest), 2.0)
      << coarse.largest << " -> " << fine.largest;
  EXPECT_LT(fine.rms, 1e-3);
  EXPECT_NEAR(coarse.effectivity, 1.0, 0.1);
  EXPECT_NEAR(fine.effectivity, 1.0, 0.1);
}

}  // namespace

TEST(StressRecovery, IsOfSecondOrderOrBetterOnAConvexWheel) {
  expect_order(wheel_shape(40, 30));
}

TEST(StressRecovery, IsOfSecondOrderOrBetterOnAConcaveWheel) {
  expect_order(wheel_shape(60, -40));
}

TEST(StressRecovery, IsOfSecondOrderOrBetterOnARail) {
  expect_order(rail_shape(20));
}

TEST(LoadedRail, StressIsThatOfTheHalfSpace) {
  // Elements of an eighth of the patch. What is left at depth comes with the clamped far boundary,
  // what is at the edge of the patch with tractions that are constant on elements.
  const LoadedRail rail(0.3, 1, 5.5, 32.0);
  const auto difference = [&](double depth, double y, double reach) {
    std::vector<fem::Place> places;
    // Middles of elements of the fine grid: on their edges its surface stress is infinite.
    for (int k = 0; k < 25; ++k)
      places.push_back({(std::round(reach * (k / 12.0 - 1.0) / 0.1) + 0.5) * 0.1, y, -depth});
    return LoadedRail::largest_difference(rail.recovered(rail.locator->find(places, 1e-6)),
                                          rail.of_half_space(places));
  };
  for (const double y : {0.05, -1.35}) {
    EXPECT_LT(difference(0.0, y, 3.0), 0.02) << y;
    for (const double depth : {0.25, 0.5, 1.0, 2.0, 4.0})
      EXPECT_LT(difference(depth, y, 3.0), 0.01) << y << " " << depth;
    for (const double depth : {1.0, 2.0, 4.0})
      EXPECT_LT(difference(depth, y, 6.0), 0.015) << y << " " << depth;
  }
}
