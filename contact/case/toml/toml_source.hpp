// SPDX-License-Identifier: LGPL-2.1-or-later
// The text of a case file, for messages that quote it; private to contact/case.
#pragma once

#include "contact/case/toml/toml_library.hpp"

#include <string>
#include <vector>

namespace rollfem::contact {

class TomlSource {
 public:
  TomlSource(const std::string& text, std::string file);

  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }
  const std::vector<std::string>& lines() const { return lines_; }

  /// A line, from 1, shortened.
  std::string line(unsigned number) const;
  /// A value as typed, shortened: to the end of its region, or of the line if it continues.
  std::string value(const toml::source_region& region) const;

 private:
  const std::string& text_;
  std::string file_;
  std::vector<std::string> lines_;
};

}  // namespace rollfem::contact
