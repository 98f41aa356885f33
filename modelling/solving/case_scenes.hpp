// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of a case: the case itself or, with profiles, one scene for each patch in balance; and
// tables and texts about them.
#pragma once

#include "base/checkpoint.hpp"
#include "base/progress.hpp"
#include "case/case.hpp"
#include "contact/solve/run_part.hpp"
#include "result/write/output.hpp"
#include "track/balance/balance.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::modelling {

struct Scenes {
  std::vector<contact::Scene> list;
  std::vector<result::PlacedPair> pairs;
  std::vector<contact::Note> notes;
};

/// The wheels of a case in position on their rails, placed once and passed on; null for bodies with
/// radii. Throws contact::InputError and contact::SolveError.
using Placed = std::shared_ptr<const track::PlacedWheels>;
Placed placed_wheels(const contact::Case& input);

/// The same case with contacts of a wheel joined on their common surface, not in planes of their
/// own (halfspace.surface = "curved").
contact::Case on_common_surface(contact::Case input);

/// The scenes of a case; with profiles only those at positions in `own`. Balances are stored in
/// and resumed from `kept`, which may be null. Throws contact::InputError and contact::SolveError.
Scenes scenes_of(const contact::Case& input, const Placed& placed,
                 const contact::Progress& progress = {}, contact::Checkpoint* kept = nullptr,
                 contact::RunPart own = {});

/// The same without the balance, which takes time.
std::vector<contact::Scene> unbalanced_scenes(const contact::Case& input, const Placed& placed);

/// Wheel and rail of the first position as a table for drawing (figures/profiles.py): the name
/// of the table without ending, and its text. One for each requested wheel.
std::vector<std::pair<std::string, std::string>> pair_tables(const contact::Case& input,
                                                             const track::SearchScene& search);

/// Table of the contacts of a case with profiles; nothing is solved.
std::string contacts_text(const contact::Case& input, const track::SearchScene& search);

}  // namespace rollfem::modelling
