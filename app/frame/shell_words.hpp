// SPDX-License-Identifier: LGPL-2.1-or-later
// Shell completion and the manual page, generated from the options
// themselves.
#pragma once

#include "contact/solve/model.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace rollfem::app {

/// Words that Tab completes: commands, options, models, case files. To be read by `source`.
std::string bash_completion(const CLI::App& program, const contact::ModelRegistry& models);
/// The same as a file _rollfem of a folder in $fpath.
std::string zsh_completion(const CLI::App& program, const contact::ModelRegistry& models);

/// rollfem(1) in troff.
std::string manual_page(const CLI::App& program, const std::string& version);

}  // namespace rollfem::app
