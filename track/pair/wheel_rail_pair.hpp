// SPDX-License-Identifier: LGPL-2.1-or-later
// A wheel on its rail, prepared once and solved for one state after another. mm, N, MPa, s, rad;
// track frame: x along the track, y to the right, z down.
#pragma once

#include "case/case.hpp"
#include "halfspace/patch/quick_wheel.hpp"
#include "result/result.hpp"
#include "track/motion/placed_scenes.hpp"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace rollfem::track {

/// Force (N) and moment about the middle of the axle (N mm), track frame.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// Meaning of WheelState::load.
enum class GivenLoad {
  vertical_force,  ///< N, upwards on the wheel, friction included
  height,          ///< mm, z of the middle of the axle plus the rolling radius
  penetration,     ///< mm, height below the one at which the wheel just touches
};

/// Position of the wheelset, its motion relative to the ground, and the load of the wheel.
struct WheelState {
  double lateral_shift = 0.0;     ///< positive to the right
  double yaw = 0.0;               ///< positive from x to y
  double roll = 0.0;              ///< positive from y to z; NaN: both wheels touch
  double forward_speed = 0.0;     ///< above 0
  double lateral_velocity = 0.0;  ///< positive to the right
  double yaw_rate = 0.0;
  double rotation_speed = 0.0;  ///< positive when rolling forward
  GivenLoad given = GivenLoad::vertical_force;
  double load = 0.0;
};
/// Variables of a state: the columns of derivatives.
struct StateVariable {
  enum {
    lateral_shift,
    yaw,
    roll,
    forward_speed,
    lateral_velocity,
    yaw_rate,
    rotation_speed,
    load,
    count
  };
};

/// One patch of the wheel: loaded regions that share a plane. Of the fields of `point` there are
/// none; its error estimate is that of the largest pressure.
struct WheelPatch {
  contact::ContactPlace place;
  contact::Vector3 position{};
  Wrench wrench = Wrench::Zero();  ///< on the wheel
  contact::PointResult point;
};

struct WheelOnRail {
  std::vector<WheelPatch> patches;  ///< the most loaded first; empty: the wheel does not touch
  Wrench wrench = Wrench::Zero();   ///< on the wheel, of all patches
  double roll = 0.0;                ///< given or found
  double touching_height = 0.0;     ///< at which the wheel just touches
  double penetration = 0.0;         ///< height below that; negative above the rail
};

/// Derivatives of the wrench by the variables of the state; 0 for a roll that is found and for a
/// wheel that does not touch.
struct WheelDerivatives {
  using Columns = Eigen::Matrix<double, 6, StateVariable::count>;
  Columns by = Columns::Zero();
  /// N/mm, derivative of the upward force by the height, friction included.
  double stiffness = 0.0;
};

class WheelRailPair {
 public:
  /// `input`: a case with profiles, one position, one wheel and a vertical force; values given by
  /// the state are ignored. Throws contact::InputError.
  explicit WheelRailPair(contact::Case input);

  /// Throws contact::InputError for values out of bounds, contact::SolveError if there is no
  /// solution. Results do not depend on earlier calls. Thread-safe.
  WheelOnRail solve(const WheelState& state) const;

  /// Also returns derivatives. Velocities use the linearised friction problem, the load two
  /// solutions on the same elements, the position central differences; all use differences if
  /// QuickWheel cannot solve the contacts.
  WheelOnRail linearise(const WheelState& state, WheelDerivatives& derivatives) const;

 private:
  /// Working memory of a call, kept for later calls of any thread.
  struct Workspace {
    contact::Case input;
    std::vector<std::unique_ptr<halfspace::QuickWheel>> wheels;  ///< tried in this order
    std::vector<WheelRailContact> found;
    std::vector<halfspace::QuickContact> contacts;
    std::vector<Eigen::Matrix3d> by_motion;  ///< creepage_by_motion() of `found`
    halfspace::QuickLoad load;
    halfspace::QuickWheel* solved = nullptr;  ///< the wheel that holds the solution
    std::vector<halfspace::PatchResponse> responses;
  };
  /// The workspace of a call, given back at its end.
  using Lent = std::unique_ptr<Workspace, std::function<void(Workspace*)>>;
  Lent workspace() const;

  WheelOnRail solve(Workspace& workspace, const WheelState& state) const;
  halfspace::QuickOutcome solve_quickly(Workspace& workspace, const WheelState& state,
                                        WheelOnRail& wheel) const;
  WheelOnRail solve_with_care(const contact::Case& input, const WheelState& state) const;

  bool respond(Workspace& workspace, const WheelState& state, WheelDerivatives& derivatives) const;
  Wrench difference(Workspace& workspace, const WheelState& state, const WheelOnRail& at,
                    int variable) const;
  /// Then the law depends on the forward speed.
  bool friction_falls() const { return friction_ && friction_->feels_slip(); }

  contact::Case input_;
  SearchScene search_;
  contact::CombinedMaterial material_;
  contact::Friction friction_;
  /// Empty if materials are unlike, the grid is too fine, or a layer softens, so that of several
  /// states the one that grows out of small creepage is wanted.
  std::vector<std::unique_ptr<halfspace::InfluenceTables>> tables_;  ///< coarser grids first
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace rollfem::track
