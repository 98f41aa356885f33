// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail that yield, pass after pass, or step after step where the load presses without
// rolling: what they add to the elastic displacement at the contact and to the stress, and the
// results of each pass.
// A step is a pass to all names here.
#pragma once

#include "base/errors.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/plasticity/plastic_law.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "result/record.hpp"
#include "result/result.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::fem {

/// The state that cycles of passes tend to, by Anderson's method (1965) for the residual stress and
/// the back stresses behind the load. These decide how the next cycle goes: in ratchetting they
/// repeat, while plastic strain grows by what causes no stress. It only follows them.
class LimitState {
 public:
  /// Replaces the states that have left a cycle by those with which the next one begins;
  /// `residual`: stress deviator behind the load on every streamline, MPa.
  void approach(const std::vector<Deviator>& residual, std::vector<PlasticState>& states);
  void exchange(contact::Record& record) { record.values(cycles_); }

 private:
  std::vector<std::vector<double>> cycles_;  ///< state before and behind each, in turn
};

class YieldingBody;

/// Plastic flow reaches the border of the streamlines that may yield: with a larger region in this
/// direction (FemOptions::plastic_growth) there is a solution.
class YieldsBeyondStreamlines : public contact::SolveError {
 public:
  enum Direction : std::size_t { along, across, down };
  YieldsBeyondStreamlines(const std::string& text, Direction where)
      : SolveError(text), direction(where) {}
  Direction direction;
};

class YieldingBodies {
 public:
  /// Bodies of a scene that yields; streamlines may yield in the fine region of the mesh. All
  /// arguments must outlive this object. Collective, as all members are.
  YieldingBodies(const contact::Scene& scene, const BodyPair& bodies, const Solvers& solvers,
                 const contact::ContactGrid& grid);
  ~YieldingBodies();
  /// Displacements by plastic strain of wheel and rail, mm, with ghost values, in a pass with these
  /// elastic displacements; empty for a body that stays elastic. The pass does not count until it
  /// is finished. It has the temperatures of the pass before. Throws contact::SolveError.
  std::vector<Vector> respond(const std::vector<Vector>& elastic);
  /// Of the last response: relative out-of-balance forces of a step of pressing, which each
  /// response brings closer to balance; 0 in passes.
  double imbalance() const;
  /// Ends the pass under these elastic displacements: fills the results of the point and keeps the
  /// state for the next pass. Throws YieldsBeyondStreamlines.
  void finish_pass(const std::vector<Vector>& elastic, contact::PointResult& point);

  /// The state from which the next pass starts as bytes, in a single process; recall() restores it,
  /// and does nothing without one.
  std::string memory() const;
  void recall(const std::string& memory);

  /// Fields of the last pass that ended; body 0 is the wheel. Null: the body stays elastic.
  const YieldedFields* fields(std::size_t body) const;

 private:
  const contact::ContactGrid& grid_;
  double elastic_pressure_;                             ///< p0 of elastic bodies, MPa
  std::array<std::unique_ptr<YieldingBody>, 2> parts_;  ///< wheel, rail; null: elastic
};

}  // namespace rollfem::fem
