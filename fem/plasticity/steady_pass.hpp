// SPDX-License-Identifier: LGPL-2.1-or-later
// One pass of a load over a body that yields, steady in the frame of the load (Nguyen and Rahimian
// 1981; Dang Van and Maitournam 1993, J. Mech. Phys. Solids 41, "Steady-state flow in classical
// elastoplasticity"): plastic strain along streamlines and the displacement that it causes.
#pragma once

#include "fem/linear/linear_solver.hpp"
#include "fem/plasticity/streamlines.hpp"

#include <cstddef>
#include <vector>

namespace rollfem::fem {

/// A body between two passes, and where the next one starts its iteration.
struct YieldedBody {
  std::vector<PlasticState>
      leaving;                      ///< of every streamline, what flows out and into the next pass
  std::vector<Deviator> plastic;    ///< at every point during the last pass
  std::vector<double> accumulated;  ///< the same
  Vector displacement;              ///< mm, by the plastic strain alone; with ghost values
  Vector load;                      ///< N, of the plastic strain, which causes it
};

/// Untouched steel, or with given states where it enters.
YieldedBody before_first_pass(const Streamlines& streamlines, const Body& body);

struct PassReport {
  int iterations = 0;
  double residual =
      0.0;  ///< out-of-balance forces in the energy norm, relative to the plastic ones
  /// Largest von Mises stress over the yield surface of the moment: 1 where steel yields.
  double utilisation = 0.0;
  double plastic_work = 0.0;  ///< N mm per mm of track, int s : d eps_p
};

struct PassAccuracy {
  double residual = 1e-6;
  int most_iterations = 300;
  int steps = 4;  ///< of the law between two stations
};

/// `elastic`: deviatoric strain at the points under the load alone. Replaces `yielded` by its state
/// after one more pass. Throws contact::SolveError when the iteration does not converge, and leaves
/// `yielded` as it was. Collective.
PassReport steady_pass(const Streamlines& streamlines, const PlasticLaw& law,
                       const LinearSolver& solver, const std::vector<Deviator>& elastic,
                       const PassAccuracy& accuracy, YieldedBody& yielded);

}  // namespace rollfem::fem
