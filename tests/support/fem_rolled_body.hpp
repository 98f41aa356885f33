// SPDX-License-Identifier: LGPL-2.1-or-later
// A rail or wheel of finite elements that yields under a given pressure and friction moving over
// it, pass by pass, and the residual stress below its surface.
#pragma once

#include "base/threads.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/plasticity/steady_pass.hpp"
#include "fem/trace/fem_compliance.hpp"

#include "support/fem_test_support.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

/// An elastic body with its material points, and the fields of a pressure and of a traction equal
/// to it along +x on a rail (-x on a wheel: what the rail receives is the same).
class RolledBody {
 public:
  /// `pressure` in MPa on the elements of `grid`.
  RolledBody(std::unique_ptr<fem::Body> the_body, const contact::ContactGrid& grid,
             const contact::Field& pressure, const fem::StreamLattice& lattice)
      : body(std::move(the_body)),
        solver(fem::make_factorisation(problem())),
        coupling(own_coupling(*body, grid)),
        lines(*body, lattice) {
    const contact::Field none = 0.0 * pressure;
    const double sign = body->shape().is_wheel ? 1.0 : -1.0;
    pressed.traction = {none, none, sign * pressure};
    sheared.traction = {-sign * pressure, none, none};
    for (Load* load : {&pressed, &sheared}) {
      auto b = fem::make_vector(body->dofs());
      load->displacement = fem::make_vector(body->dofs());
      coupling.load(load->traction, b);
      solver->solve(load->displacement, b);
      load->displacement.update_ghost_values();
      load->strain = lines.strains(load->displacement);
    }
  }

  fem::ElasticProblem problem() const {
    auto problem = body->problem();
    problem.project_dilatation = true;
    return problem;
  }
  std::vector<fem::Deviator> elastic_strain(double factor, double friction) const {
    std::vector<fem::Deviator> result;
    for (std::size_t k = 0; k < lines.points(); ++k) {
      result.push_back(fem::sum(pressed.strain[k], friction, sheared.strain[k]));
      for (double& component : result.back()) component *= factor;
    }
    return result;
  }

  struct Load {
    contact::SurfaceField traction;
    fem::Vector displacement;
    std::vector<fem::Deviator> strain;
  };
  /// Bodies of tests are so small that threads would only wait for each other.
  contact::Threads one_thread{1};
  std::unique_ptr<fem::Body> body;
  std::unique_ptr<fem::LinearSolver> solver;
  fem::SurfaceCoupling coupling;
  fem::Streamlines lines;
  Load pressed, sheared;
};

/// Steel whose yield stress in shear is `shear_yield`, with Prager's hardening.
inline contact::BodyPlasticity plain_steel(double shear_yield, double modulus = 0.0) {
  contact::BodyPlasticity steel;
  steel.yield_stress = std::sqrt(3.0) * shear_yield;
  steel.back_stresses[0].modulus = modulus;
  return steel;
}

/// Passes of one load over one body, the pressure of which is multiplied by a factor.
class Passes {
 public:
  Passes(const RolledBody& rolled, const contact::BodyPlasticity& steel, double factor,
         double with_friction = 0.0)
      : of(rolled),
        law(steel, fem::lame_mu(rolled.body->material())),
        solver(rolled.lines, *rolled.solver),
        load_factor(factor),
        friction(with_friction),
        elastic(rolled.elastic_strain(factor, with_friction)),
        state(fem::before_first_pass(rolled.lines, *rolled.body)) {}

  /// Largest increase of the accumulated plastic strain of any streamline during one more pass.
  double next() {
    const auto before = state.leaving;
    solver.steps.restart();
    report = fem::steady_pass(of.lines, law, solver, elastic, accuracy, state, hot);
    double increase = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k)
      increase = std::max(increase, state.leaving[k].accumulated - before[k].accumulated);
    return increase;
  }
  /// The same of each of so many passes.
  std::vector<double> next(int passes) {
    std::vector<double> increases;
    for (int k = 0; k < passes; ++k) increases.push_back(next());
    return increases;
  }
  /// The body as these passes have left it, of which the next pass is without load.
  Passes unloaded() const {
    Passes without = *this;
    without.elastic.assign(elastic.size(), {});
    return without;
  }
  /// Largest von Mises stress of the load alone relative to the yield stress, and where.
  std::pair<double, std::size_t> utilisation() const {
    std::pair<double, std::size_t> largest{0.0, 0};
    for (std::size_t k = 0; k < elastic.size(); ++k)
      largest = std::max(largest, {law.utilisation({}, elastic[k]), k});
    return largest;
  }
  /// Deviator of the residual stress at the points, MPa.
  std::vector<fem::Deviator> residual_stress() const {
    auto strain = of.lines.strains(state.displacement);
    for (std::size_t k = 0; k < strain.size(); ++k) {
      fem::PlasticState point;
      point.strain = state.plastic[k];
      strain[k] = law.stress(point, strain[k]);
    }
    return strain;
  }

  const RolledBody& of;
  fem::PlasticLaw law;
  fem::PassSolver solver;
  double load_factor, friction;
  std::vector<fem::Deviator> elastic;
  std::vector<double> hot;  ///< fem::steady_pass
  fem::PassAccuracy accuracy;
  fem::YieldedBody state;
  fem::PassReport report;
};

/// Increases of plastic strain that begin above `first` and fall by two fifths with every pass.
inline void expect_shakedown(const std::vector<double>& increases, double first) {
  EXPECT_GT(increases[0], first);
  for (std::size_t pass = 1; pass < increases.size(); ++pass)
    EXPECT_LT(increases[pass], 0.6 * increases[pass - 1]) << pass;
}

/// Increases that stay above `least`, and at this part of the one before.
inline void expect_ratchetting(const std::vector<double>& increases, double least = 1e-3,
                               double part = 0.85) {
  EXPECT_GT(increases.back(), least);
  EXPECT_GT(increases.back(), part * increases[increases.size() - 2]);
}

}  // namespace rollfem::testing
