// SPDX-License-Identifier: LGPL-2.1-or-later
// Shell completion and the manual page, generated from the options
// themselves.
#pragma once

#include "contact/solve/model.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace rollfem::app {

/// Script for `source` that completes commands, options, models and case files.
std::string bash_completion(const CLI::App& program, const contact::ModelRegistry& models);
/// The same for zsh: the file _rollfem in a folder of $fpath.
std::string zsh_completion(const CLI::App& program, const contact::ModelRegistry& models);

/// The manual page rollfem(1) in troff.
std::string manual_page(const CLI::App& program, const std::string& version);

}  // namespace rollfem::app
