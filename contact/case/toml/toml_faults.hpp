// SPDX-License-Identifier: LGPL-2.1-or-later
// Faults of invalid TOML, in words; private to contact/case.
#pragma once

#include "contact/case/toml/toml_source.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace rollfem::contact {

struct TomlFault {
  unsigned line = 1;    ///< from 1
  unsigned column = 1;  ///< from 1, in characters
  std::string wrong;
};

/// Faults checked before toml++: bytes that are not UTF-8, which it does not locate exactly, and
/// keys of more than 64 parts, because it limits the nesting of values but not of keys, whose
/// tables it destroys recursively. None for most invalid TOML.
std::optional<TomlFault> find_toml_fault(const TomlSource& source);

/// The message of toml++ about a fault on that line, in words for an author of case files who does
/// not know TOML's grammar.
std::string meaning_of(std::string_view description, const std::string& line);

/// A quoted name may hold anything: characters that would disturb a terminal or end the line of a
/// message are not repeated.
std::string shown(std::string name, std::size_t longest = 80);

}  // namespace rollfem::contact
