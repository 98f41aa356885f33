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

/// Output folder of the study.
std::filesystem::path directory_of(const StudyRequest& request);

/// Checks the options on their own and against the bodies of the case. Throws contact::InputError.
void check_call(const StudyRequest& request, const contact::Case& input,
                const contact::ModelRegistry& known);

/// The models named by the call, unchecked; "all" gives every model.
std::vector<std::string> named_models(const StudyRequest& request,
                                      const contact::ModelRegistry& known);

/// The subset of these models that can take every scene. Throws contact::InputError for a named
/// model that cannot, and if no model can refine what --vary requests.
std::vector<std::string> models_of(const StudyRequest& request, const modelling::Scenes& scenes,
                                   const contact::ModelRegistry& known);

/// Sets rule and given values from --reference. The places must already have their creepages and
/// exact values. Throws contact::InputError.
void read_references(const StudyRequest& request, postprocess::StudyRecord& record);

}  // namespace rollfem::app
