// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks the call of a study before anything is computed, and turns it into models and
// references.
#pragma once

#include "app/study/study.hpp"
#include "contact/case/case.hpp"
#include "models/solving/case_scenes.hpp"
#include "postprocess/study/study.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rollfem::app {

/// Where the study is written.
std::filesystem::path directory_of(const StudyRequest& request);

/// What the case need not be known for, and what its bodies cannot vary. Throws
/// contact::InputError.
void check_call(const StudyRequest& request, const contact::Case& input,
                const contact::ModelRegistry& known);

/// The models that the call names, before any is looked at: "all" are all there are.
std::vector<std::string> named_models(const StudyRequest& request,
                                      const contact::ModelRegistry& known);

/// Of these those that can take every scene. Throws contact::InputError for one that was named and
/// cannot, and when none has something of --vary.
std::vector<std::string> models_of(const StudyRequest& request, const modelling::Scenes& scenes,
                                   const contact::ModelRegistry& known);

/// Sets rule and given values from --reference. The places are there, with their creepages and
/// exact values. Throws contact::InputError.
void read_references(const StudyRequest& request, postprocess::StudyRecord& record);

}  // namespace rollfem::app
