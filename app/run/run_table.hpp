// SPDX-License-Identifier: LGPL-2.1-or-later
// The short table that `run` prints: patch and pressure of every model, and the creep curves.
#pragma once

#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

std::string run_table(const std::vector<contact::ModelResult>& models);

/// What the models say of their results, a line each. Patches share most of it: a sentence that
/// differs from patch to patch in its numbers alone is said once, with those of the first.
std::string notes_text(const std::vector<contact::ModelResult>& models);

}  // namespace rollfem::app
