// SPDX-License-Identifier: LGPL-2.1-or-later
// Balances wheels with true profiles: the share of the vertical load of every patch including
// friction, and the creepages of the wheelset's motion, which are unknowns in free rolling. The
// results are scenes for any model; the balance itself is found with half-space solutions on a
// coarse grid.
#pragma once

#include "base/checkpoint.hpp"
#include "base/progress.hpp"
#include "case/case.hpp"
#include "contact/solve/run_part.hpp"
#include "result/result.hpp"
#include "scene/scene.hpp"
#include "track/balance/springs.hpp"
#include "track/motion/placed_scenes.hpp"

#include <string>
#include <vector>

namespace rollfem::track {

/// The wheels of a case on their rails, at all positions, before any balance. Create it once: it
/// takes as long as solving a small patch.
struct PlacedWheels {
  SearchScene search;  ///< the profiles, and the positioned rail
  /// Scenes of both wheels for a free wheelset, including contacts that the load may reach.
  std::vector<PlacedScene> scenes;
};

struct BalancedCase {
  /// One for each patch that carries load, in the order of positions, left before right, the most
  /// loaded patch first.
  std::vector<contact::Scene> scenes;
  std::vector<PlacedScene> placed;   ///< as placed, for drawings
  std::vector<contact::Note> notes;  ///< notes for the reader
  RailVector rail_moved{};           ///< by its springs, at the last position
};

/// Throws as make_scenes.
PlacedWheels place_for_balance(const contact::Case& input);

/// Whether the case requests results of this scene, which is in contact.
bool asked_for(const contact::Case& input, const PlacedScene& scene);

/// Patches and near misses of the wheels at all positions; nothing is solved. Throws
/// contact::InputError and contact::SolveError as find_contacts does.
std::vector<WheelRailContact> place_wheels(const contact::Case& input, const SearchScene& scene);

/// Balance of wheels placed by place_for_balance. Positions outside `own` are skipped. Balanced
/// positions are restored from `kept` and stored in it; it may be null. Throws contact::SolveError
/// when there is no balance (friction that would lift the wheel, no rotation without torque).
BalancedCase balance(const contact::Case& input, const PlacedWheels& placed,
                     const contact::Progress& progress = {}, contact::Checkpoint* kept = nullptr,
                     contact::RunPart own = {});

/// The same, including the placement of the wheels.
BalancedCase balance(const contact::Case& input);

/// One sentence for each wheel that a given height leaves above its rail: it carries no load. Empty
/// where the load is given.
std::vector<std::string> untouched_wheels(const contact::Case& input, const PlacedWheels& placed);

// Checks of the results of one wheel: patches must not overlap, each on a grid that holds its
// reference point, with positive approaches and shares that add up to the load.

/// `results`: of one model, all contacts of all wheels at all positions; results without a position
/// are skipped. Throws contact::SolveError naming the defect, contact::ConformalContact where
/// contacts of a wheel overlap.
void check_results(const contact::Case& input, const std::vector<contact::ModelResult>& results);

}  // namespace rollfem::track
