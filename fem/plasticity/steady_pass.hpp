// SPDX-License-Identifier: LGPL-2.1-or-later
// Plastic strain of a body and the displacement that it causes, in balance. In a pass of a load
// that rolls, steady in the frame of the load (Nguyen and Rahimian 1981; Dang Van and Maitournam
// 1993, J. Mech. Phys. Solids 41, "Steady-state flow in classical elastoplasticity"), the state of
// a point is that of the point before it on its streamline; in a step of a load that presses
// without rolling, its own of the step before.
#pragma once

#include "contact/iteration/anderson.hpp"
#include "fem/linear/linear_solver.hpp"
#include "fem/plasticity/streamlines.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// A body between two passes (steps of a pressed one), and where the next one starts its iteration.
struct YieldedBody {
  /// Of every streamline, what flows out and into the next pass; of a pressed body, every point's.
  std::vector<PlasticState> leaving;
  std::vector<Deviator> strain;     ///< total, at every point of a pressed body; else empty
  std::vector<Deviator> plastic;    ///< at every point during the last pass
  std::vector<double> accumulated;  ///< the same
  Vector displacement;              ///< mm, by the plastic strain alone; with ghost values
  Vector load;                      ///< N, of the plastic strain, which causes it

  bool pressed() const { return !strain.empty(); }
};

/// Untouched steel, or with given states where it enters.
YieldedBody before_first_pass(const Streamlines& streamlines, const Body& body);
/// The same to be pressed, not rolled over. `strain`: deviatoric, at every point.
YieldedBody before_first_step(const Streamlines& streamlines, const Body& body,
                              std::vector<Deviator> strain);

struct PassReport {
  int iterations = 0;
  double residual =
      0.0;  ///< out-of-balance forces in the energy norm, relative to the plastic ones
  /// Largest von Mises stress over the yield surface of the moment: 1 where steel yields.
  double utilisation = 0.0;
  /// int s : d eps_p, N mm per mm of track; of a step of a pressed body N mm.
  double plastic_work = 0.0;
};

struct PassAccuracy {
  double residual = 1e-6;
  int most_iterations = 300;
  /// Otherwise the displacement is defined on the streamlines only.
  bool whole_body = true;
  /// One iteration towards balance, which need not be reached, going on from the last one.
  bool once = false;
  int steps = 4;  ///< of the law between two stations, or from one load to the next
};

/// The displacement of a body by plastic strain, and what its iterations have learned about it:
/// those of similar loads go on with the steps of the last one.
struct PassSolver {
  /// Both arguments must outlive it.
  PassSolver(const Streamlines& streamlines, const LinearSolver& solver);

  const LinearSolver& exact;
  std::shared_ptr<const LinearSolver> in_part;  ///< on the streamlines only; null: none
  contact::Anderson::Product energy;            ///< of displacements stacked on their loads
  contact::Anderson steps;
};

/// `elastic`: deviatoric strain at the points under the load alone; `hot`: their temperature, see
/// BodyPlasticity::yield_stress_at; empty: as before contact. Replaces `yielded` by its state
/// after one more pass, or one more step if it is pressed. Throws contact::SolveError when the
/// iteration does not converge, and leaves `yielded` as it was. Collective.
PassReport steady_pass(const Streamlines& streamlines, const PlasticLaw& law, PassSolver& solver,
                       const std::vector<Deviator>& elastic, const PassAccuracy& accuracy,
                       YieldedBody& yielded, const std::vector<double>& hot = {});

}  // namespace rollfem::fem
