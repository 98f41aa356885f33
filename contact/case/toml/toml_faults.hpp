// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a text that is no TOML, in words; private to contact/case.
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

/// What toml++ is not left to find: bytes that are not UTF-8, which it does not place exactly, and
/// keys of more than 64 parts: it limits how deep values nest, but not the parts of a key, whose
/// tables it takes down by recursion. None for most texts that are no TOML.
std::optional<TomlFault> find_toml_fault(const TomlSource& source);

/// What toml++ says about a fault on that line, for somebody who wrote a case file and knows no
/// names of TOML's grammar.
std::string meaning_of(std::string_view description, const std::string& line);

/// A name in quotes may hold anything: what would upset a terminal, or end the line of a message,
/// is not repeated.
std::string shown(std::string name, std::size_t longest = 80);

}  // namespace rollfem::contact
