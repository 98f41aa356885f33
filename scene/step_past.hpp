// SPDX-License-Identifier: LGPL-2.1-or-later
// What a step of a wheel on its rail inherits from the steps before, in which the wheel stood
// elsewhere. The elements of all steps lie on one lattice in the material: tractions are taken over
// as they are, and the displacements that they cause are those of the same half-space.
#pragma once

#include "base/grid.hpp"
#include "case/case.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace rollfem::contact {

/// Elements on which a contact has left tractions.
struct PastPatch {
  ContactGrid grid;
  SurfaceField traction;        ///< MPa
  Field coefficient, plastic;   ///< mu and u*; empty where friction remembers nothing
  Field heat_wheel, heat_rail;  ///< flows into the bodies, N/(mm s); empty without heat
};
using PastPatches = std::vector<PastPatch>;

/// The heat of an earlier step. Along x its elements lie as they did in the frame of that step.
struct PastHeat {
  double length = 0.0;  ///< mm rolled; infinite: steady rolling
  PastPatches patches;
};

/// Keeps of steps, the last one first, those that reach `way` back, mm.
template <class Step>
void keep_within(double way, std::vector<Step>& steps) {
  double behind = 0.0;
  std::size_t kept = 0;
  while (kept < steps.size() && behind < way) behind += steps[kept++].length;
  steps.resize(kept);
}

/// Elements of one size, and what lies on them: in the frame of the contact now, where the material
/// has come to.
struct PastLevel {
  std::array<double, 2> cell{};    ///< mm, along x and y
  std::array<double, 2> middle{};  ///< mm, a corner of the lattice
  PastPatches last, before_last;
  /// mm rolled in the last step and in the one before; 0: there was none, or it cannot be used.
  std::array<double, 2> lengths{};
  std::vector<PastHeat> heat;  ///< the last step first
};

/// A step and the one before as one step, which says how far forces depend on the length of steps.
struct DoubledStep {
  PastLevel level;  ///< the past before both, on the elements of the next to finest level
  double step_length = 0.0;
  Creepage creepage;  ///< the mean
};

struct StepPast {
  std::vector<PastLevel> levels;       ///< the coarsest first
  std::optional<DoubledStep> doubled;  ///< none: error bars leave out the length of the step
  int steps = 0;                       ///< before this one
  double distance = 0.0;               ///< mm rolled in them
  std::array<double, 3> shift{};       ///< mm, mm, rad: sum of their shifts
  /// What the step leaves in its turn, in its own frame: one for each level, and one for the
  /// doubled step, set by the model; empty grids where it has no solution.
  std::shared_ptr<PastPatches> left = std::make_shared<PastPatches>();
};

}  // namespace rollfem::contact
