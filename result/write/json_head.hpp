// SPDX-License-Identifier: LGPL-2.1-or-later
// What JSON files have in common: places, trees, the checksum.
#pragma once

#include "result/write/contents.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rollfem::result {

/// Wheel, position and patch.
nlohmann::ordered_json place_json(const contact::ContactPlace& place);

/// What summary.json has of a tree: attributes, lines, lists of parts and rows of tables; `arrays`:
/// arrays, too. No nan; inf, which JSON has no number for, is a text as in a case file.
nlohmann::ordered_json json_of(const Tree& tree, bool arrays = false);

/// The file's text with its checksum; invalid UTF-8 becomes replacement characters.
std::string json_text(const nlohmann::ordered_json& json, int indent = 1);

}  // namespace rollfem::result
