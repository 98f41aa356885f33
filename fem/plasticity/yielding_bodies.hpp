// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail that yield, pass after pass: what they add to the elastic displacement at the
// contact and to the stress, and the results of each pass.
#pragma once

#include "base/errors.hpp"
#include "fem/discretisation/body.hpp"
#include "fem/linear/solver_choice.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "result/result.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::fem {

class YieldingBody;

/// Plastic flow reaches the border of the streamlines that may yield: a larger fem.plastic_extent
/// has a solution.
class YieldsBeyondStreamlines : public contact::SolveError {
 public:
  using SolveError::SolveError;
};

class YieldingBodies {
 public:
  /// Bodies of a scene that yields; streamlines may yield in the fine region of the mesh. All
  /// arguments must outlive this object. Collective, as all members are.
  YieldingBodies(const contact::Scene& scene, const BodyPair& bodies, const Solvers& solvers);
  ~YieldingBodies();
  /// Displacements by plastic strain of wheel and rail, mm, with ghost values, in a pass with these
  /// elastic displacements; empty for a body that stays elastic. The pass does not count until it
  /// is finished. Throws contact::SolveError.
  std::vector<Vector> respond(const std::vector<Vector>& elastic);
  /// The pass under the load of these elastic displacements has passed: fills the results of the
  /// point, and is the state that the next one meets. Throws YieldsBeyondStreamlines.
  void finish_pass(const std::vector<Vector>& elastic, contact::PointResult& point);

  /// What the next pass starts from, in a single process, as bytes; and going on from it, if there
  /// is one.
  std::string memory() const;
  void recall(const std::string& memory);

  /// Of the pass that was finished last; body 0 is the wheel. Null: the body stays elastic.
  const YieldedFields* fields(std::size_t body) const;

 private:
  std::array<std::unique_ptr<YieldingBody>, 2> parts_;  ///< wheel, rail; null: elastic
};

}  // namespace rollfem::fem
