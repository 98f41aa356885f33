// SPDX-License-Identifier: LGPL-2.1-or-later
// Converts a CONTACT input file to case files: consecutive cases that
// differ only in their load points share one.
#pragma once

#include "convert/contact_reader.hpp"
#include <map>
#include <string>
#include <vector>

namespace rollfem::convert {

/// A case file to write.
struct CaseFile {
  std::string name;        ///< with .toml, without a folder
  std::vector<int> cases;  ///< CONTACT cases, from 1, in the order of the load points
  std::string text;
  std::map<std::string, std::string> attached_files;  ///< further files: name, text
  std::vector<std::string> notes;                     ///< also written as comments
};

/// A case without an equivalent.
struct Refusal {
  int number = 0;
  std::size_t line = 0;
  std::vector<std::string> reasons;
};

struct Conversion {
  std::vector<CaseFile> files;
  std::vector<Refusal> refused;
};

/// `stem`: start of the file names; `source`: name of the input file in their comments;
/// `profile_folder`: see equivalent_of; `chosen`: numbers of the cases to convert, ascending;
/// empty: all.
Conversion convert_cases(const std::vector<ContactCase>& cases, const std::string& stem,
                         const std::string& source, const std::string& profile_folder,
                         const std::vector<int>& chosen = {});

/// The numbers in "1-5,8", ascending. Throws contact::InputError for anything else, and for a
/// number beyond 1 to `count`; `file` is named in the message.
std::vector<int> numbers_of(const std::string& text, int count, const std::string& file);

/// "1, 3 to 30": for comments and messages.
std::string numbers_text(const std::vector<int>& numbers);

}  // namespace rollfem::convert
