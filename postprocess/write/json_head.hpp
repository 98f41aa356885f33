// SPDX-License-Identifier: LGPL-2.1-or-later
// What JSON files have in common: the kind of file and its provenance, headings, places.
#pragma once

#include "contact/result/quantities.hpp"
#include "postprocess/write/output.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rollfem::postprocess {

/// Keys format, kind, program, host, started, command, processes.
nlohmann::ordered_json json_head(int format, const std::string& kind, const Provenance& provenance);

/// Title, symbol and unit by name, for headings.
nlohmann::ordered_json headings_json(const std::vector<contact::Quantity>& quantities);

/// Wheel, position and patch.
nlohmann::ordered_json place_json(const contact::ContactPlace& place);

/// The file's text with its checksum; invalid UTF-8 becomes replacement characters.
std::string json_text(const nlohmann::ordered_json& json, int indent = 1);

}  // namespace rollfem::postprocess
