// SPDX-License-Identifier: LGPL-2.1-or-later
// Standard output of a command: text, nothing (--quiet), or one JSON object (--json).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rollfem::app {

/// Discards all text for standard output from here on.
void silence();

/// Prints the result of a command with --json, also after silence().
void print_result(const std::string& json);

/// Keys format (1), kind and program, with which every printed object begins.
nlohmann::ordered_json result_head(const std::string& kind);

/// The columns of a table with a header "name [unit],...", as lists of numbers by name, and the
/// units by name; empty cells become null. Lines that begin with # are skipped.
nlohmann::ordered_json columns_of(const std::string& csv);

}  // namespace rollfem::app
