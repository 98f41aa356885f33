// Wheels of true profiles in balance: every patch of a case with its share of the vertical load,
// friction included, and with the creepages of the wheelset's motion, free rolling solved for. What
// comes out are scenes that any model can solve; half-space solutions on a coarse grid are what the
// balance is found with.
#pragma once

#include "contact/base/progress.hpp"
#include "contact/case/case.hpp"
#include "meshes/track/scenes.hpp"

#include <string>
#include <vector>

namespace rollfem::wheelset {

struct BalancedCase {
  /// One for each patch that carries load, in the order of positions, left before right, the most
  /// loaded patch first.
  std::vector<contact::Scene> scenes;
  meshes::SearchScene search;               ///< the profiles, and the rail in its place
  std::vector<meshes::PlacedScene> placed;  ///< as they were placed, for drawings
  std::vector<std::string> notes;           ///< what a reader must know
};

/// Patches and near misses of the wheels at all positions; nothing is solved. Throws
/// contact::InputError and contact::SolveError as meshes::find_contacts does.
std::vector<meshes::WheelRailContact> place_wheels(const contact::Case& input,
                                                   const meshes::SearchScene& scene);

/// Throws contact::SolveError when there is no balance (friction that would lift the wheel, no
/// rotation without torque).
BalancedCase balance(const contact::Case& input, const contact::Progress& progress = {});

}  // namespace rollfem::wheelset
