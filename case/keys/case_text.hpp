// SPDX-License-Identifier: LGPL-2.1-or-later
// Keys and values of a case file as text: for messages, `check`, `new-case` and the reference.
#pragma once

#include "case/keys/case_keys.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// The number N of a ratio "1:N", above 1; empty for other text.
std::optional<double> ratio_of(const std::string& text);

/// A value as written in a case file: 0.55, "second", [0.0, 0.001]. Empty for no value.
std::string toml_text(const KeyValue& value);

/// "a, b, c"
std::string joined(const std::vector<std::string>& texts);

/// The values that a key accepts, in words: "a number from 0 to 1000", "one of first, second".
/// `brief`: in few words, for a table: "0 to 1000", "first, second".
std::string allowed_values(const Key& key, const KnownNames& known = {}, bool brief = false);

}  // namespace rollfem::contact
