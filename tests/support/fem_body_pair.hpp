// SPDX-License-Identifier: LGPL-2.1-or-later
// A concave wheel on a rail, unlike materials, whole and as halves, with their factorisations: made
// once for all tests of a program.
#pragma once

#include "fem/fem_options.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/trace/fem_compliance.hpp"

#include "support/fem_test_support.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline constexpr contact::Material steel{210e3, 0.3};
inline constexpr contact::Material soft{70e3, 0.4};

struct Pair {
  Pair(double rolling_radius, bool half)
      : wheel(wheel_shape(rolling_radius, -30), steel, options(half), MPI_COMM_SELF),
        rail(rail_shape(20), soft, options(half), MPI_COMM_SELF),
        wheel_solver(fem::make_factorisation(wheel.problem())),
        rail_solver(fem::make_factorisation(rail.problem())) {}
  static fem::BodyOptions options(bool half) {
    auto result = small_options();
    result.half = half;
    return result;
  }
  fem::FemCompliance compliance(const contact::ContactGrid& grid,
                                fem::FarBoundary far = fem::FarBoundary::clamped) const {
    return {{&wheel, wheel_solver.get()}, {&rail, rail_solver.get()}, surface(), grid, far};
  }
  contact::ContactSurface surface() const { return common_surface(wheel.shape(), rail.shape()); }
  fem::Body wheel, rail;
  std::unique_ptr<fem::LinearSolver> wheel_solver, rail_solver;
};

/// Register it with AddGlobalTestEnvironment: the bodies are released before MPI ends.
class PairEnvironment : public ::testing::Environment {
 public:
  explicit PairEnvironment(double rolling_radius) : rolling_radius_(rolling_radius) {}
  void TearDown() override {
    full_.reset();
    half_.reset();
  }
  const Pair& full() { return made(full_, false); }
  const Pair& half() { return made(half_, true); }

 private:
  const Pair& made(std::unique_ptr<Pair>& pair, bool half) const {
    if (!pair) pair = std::make_unique<Pair>(rolling_radius_, half);
    return *pair;
  }

  double rolling_radius_;
  std::unique_ptr<Pair> full_, half_;
};

}  // namespace rollfem::testing
