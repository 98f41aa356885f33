// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of keys from TOML, checked against the declarations of the keys; private to
// contact/case.
#pragma once

#include "contact/case/checks/case_checks.hpp"
#include "contact/case/toml/toml_source.hpp"

namespace rollfem::contact {

inline constexpr std::size_t longest_list = 1000;

/// `names`: allowed words for a key that declares none. Throws InputError when the value is not
/// allowed for the key.
GivenValue read_value(const TomlSource& source, const Key& key,
                      const std::vector<std::string>& names, const toml::node& node);

}  // namespace rollfem::contact
