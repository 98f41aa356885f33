// SPDX-License-Identifier: LGPL-2.1-or-later
// An input file of CONTACT: read, converted, and what is made of it read as a case.
#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include "convert/contact_reader.hpp"
#include "convert/conversion.hpp"
#include "fuzz/target.hpp"
#include "support/model_keys.hpp"

using namespace rollfem;

std::string outcome_of(const std::string& input) {
  try {
    const auto cases = convert::read_contact_file(input, "input.inp");
    const convert::Conversion made = convert::convert_cases(cases, "input", "input.inp", "");
    for (const convert::CaseFile& file : made.files)
      if (file.attached_files.empty()) static_cast<void>(contact::parse_case(file.text, file.name));
  } catch (const contact::InputError& error) {
    return error.what();
  }
  return "";
}
