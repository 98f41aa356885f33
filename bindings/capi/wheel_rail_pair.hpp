// SPDX-License-Identifier: LGPL-2.1-or-later
// Implementation of rollfem.h: a wheel on its rail, prepared once and solved for one state after
// another. States and results are those of rollfem.h, in mm, N, MPa, s, rad; track frame: x along
// the track, y to the right, z down.
#pragma once

#include "bindings/capi/quick_wheel.hpp"
#include "contact/case/case.hpp"
#include "track/motion/placed_scenes.hpp"

#include <Eigen/Core>

#include "rollfem/rollfem.h"
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace rollfem::capi {

/// Force (N) and moment about the middle of the axle (N mm), track frame.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// The wrenches of unit resultants of a patch: this matrix times PatchSums is their wrench.
Eigen::Matrix<double, 6, PatchSum::count> wrenches_of(const track::WheelRailContact& contact);

/// Derivatives of the sums over the patches of a wheel by the variables of its state, in the order
/// of rollfem.h; 0 for a roll that is found and for a wheel that does not touch.
struct WheelDerivatives {
  Eigen::Matrix<double, 6, ROLLFEM_STATE_VARIABLES> by =
      Eigen::Matrix<double, 6, ROLLFEM_STATE_VARIABLES>::Zero();
  double stiffness =
      0.0;  ///< N/mm, derivative of the upward force by the height, friction included
};

class WheelRailPair {
 public:
  /// `input`: a case with profiles, one position, one wheel and a vertical force; values given by
  /// the state are ignored. Throws contact::InputError.
  explicit WheelRailPair(contact::Case input);

  /// Throws contact::InputError for values out of bounds, contact::SolveError if there is no
  /// solution. Results do not depend on earlier calls. Thread-safe.
  rollfem_result solve(const rollfem_state& state) const;

  /// Also returns derivatives. Velocities use the linearised friction problem, the load two
  /// solutions on the same elements, the position central differences; all use differences if
  /// QuickWheel cannot solve the contacts.
  rollfem_result linearise(const rollfem_state& state, WheelDerivatives& derivatives) const;

 private:
  /// Working memory of a call, kept for later calls of any thread.
  struct Workspace {
    contact::Case input;
    std::vector<std::unique_ptr<QuickWheel>> wheels;  ///< tried in this order
    std::vector<track::WheelRailContact> found;
    std::vector<QuickContact> contacts;
    QuickLoad load;
    QuickWheel* solved = nullptr;  ///< the wheel that holds the solution
    std::vector<PatchResponse> responses;
  };
  /// The workspace of a call, given back at its end.
  using Lent = std::unique_ptr<Workspace, std::function<void(Workspace*)>>;
  Lent workspace() const;

  rollfem_result solve(Workspace& workspace, const rollfem_state& state) const;
  QuickOutcome solve_quickly(Workspace& workspace, const rollfem_state& state,
                             rollfem_result& wheel) const;
  rollfem_result solve_with_care(const contact::Case& input, const rollfem_state& state) const;

  bool respond(Workspace& workspace, const rollfem_state& state,
               WheelDerivatives& derivatives) const;
  Wrench difference(Workspace& workspace, const rollfem_state& state, const rollfem_result& at,
                    int variable) const;
  /// Then the law depends on the forward speed.
  bool friction_falls() const { return friction_ && friction_->feels_slip(); }

  contact::Case input_;
  track::SearchScene search_;
  contact::CombinedMaterial material_;
  contact::Friction friction_;
  /// Empty if materials are unlike, the grid is too fine, or a layer softens, so that of several
  /// states the one that grows out of small creepage is wanted.
  std::vector<std::unique_ptr<halfspace::InfluenceTables>> tables_;  ///< coarser grids first
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;
};

/// Checks every number of a state against the bounds of case files. Throws contact::InputError.
void check(const rollfem_state& state, double rolling_radius);

}  // namespace rollfem::capi
