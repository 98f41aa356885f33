// SPDX-License-Identifier: LGPL-2.1-or-later
// Implementation of rollfem.h: a wheel on its rail, prepared once and solved for one state after
// another. Units mm, N, MPa, s, rad; track frame: x along the track, y to the right, z down.
#pragma once

#include "capi/quick_wheel.hpp"
#include "capi/solved_wheel.hpp"
#include "capi/wheel_state.hpp"
#include "contact/case/case.hpp"
#include "track/motion/placed_scenes.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace rollfem::capi {

/// Derivatives of the sums over the patches of a wheel by state_variables; 0 for a roll that is
/// found and for a wheel that does not touch.
struct WheelDerivatives {
  std::array<Wrench, state_variables.size()> by;
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
  SolvedWheel solve(const WheelState& state) const;

  /// Also returns derivatives. Velocities use the linearised friction problem, the load two
  /// solutions on the same elements, the position central differences; all use differences if
  /// QuickWheel cannot solve the contacts.
  SolvedWheel linearise(const WheelState& state, WheelDerivatives& derivatives) const;

 private:
  /// Working memory of a call, kept for later calls of any thread.
  struct Workspace {
    contact::Case input;
    std::vector<std::unique_ptr<QuickWheel>> wheels;  ///< tried in this order
    std::vector<track::WheelRailContact> found;
    std::vector<QuickContact> contacts;
    QuickLoad load;
    bool linearises = false;       ///< a response follows the solution
    QuickWheel* solved = nullptr;  ///< the wheel that holds the solution
    std::vector<PatchResponse> responses;
  };
  class Borrowed;

  SolvedWheel solve(Workspace& workspace, const WheelState& state) const;
  bool solve_quickly(Workspace& workspace, const WheelState& state, SolvedWheel& wheel) const;
  QuickOutcome solve_quickly_on(Workspace& workspace, const WheelState& state,
                                SolvedWheel& wheel) const;
  static void take(const QuickWheel& quick, SolvedWheel& wheel);
  void solve_with_care(const contact::Case& input, const WheelState& state,
                       SolvedWheel& wheel) const;
  bool solve_curved(contact::Case input, const WheelState& state, SolvedWheel& wheel) const;

  bool respond(Workspace& workspace, const WheelState& state, WheelDerivatives& derivatives) const;
  Wrench difference(Workspace& workspace, const WheelState& state, const SolvedWheel& at,
                    std::size_t variable) const;
  /// Then the law depends on the forward speed.
  bool friction_falls() const { return friction_ && friction_->feels_slip(); }
  double step_of(const WheelState& state, const SolvedWheel& at, std::size_t variable) const;

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

/// The workspace of a call, given back at its end.
class WheelRailPair::Borrowed {
 public:
  explicit Borrowed(const WheelRailPair& pair);
  ~Borrowed();
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  Workspace& operator*() const { return *workspace_; }
  Workspace* operator->() const { return workspace_.get(); }

 private:
  const WheelRailPair& pair_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace rollfem::capi
