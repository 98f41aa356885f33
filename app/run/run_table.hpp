// SPDX-License-Identifier: LGPL-2.1-or-later
// The short table that `run` prints: patch and pressure of every model, and the creep curves.
#pragma once

#include "result/write/output.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

std::string run_table(const result::RunRecord& record);

/// Notes of the models on their results, one line each. What a model notes about the same subject
/// at several patches appears once, with the numbers of the first patch.
std::string notes_text(const std::vector<contact::ModelResult>& models,
                       contact::Note::Severity severity);

}  // namespace rollfem::app
