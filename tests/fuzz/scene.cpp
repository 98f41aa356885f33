// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/scene.hpp"

#include "base/errors.hpp"

#include "rollfem/rollfem.hpp"
#include <cstdio>
#include <cstdlib>
#include <regex>

namespace rollfem::testing {

std::string said_of(const std::string& text) {
  if (std::getenv("ROLLFEM_FUZZ_SHOW") != nullptr) std::fprintf(stderr, "%s\n", text.c_str());
  const std::string name = (scene_folder() / "case.toml").string();
  std::string said;
  try {
    static_cast<void>(rollfem::solve(rollfem::parse_case(text, name)));
    return said;
  } catch (const contact::Failure& failure) {
    said = failure.what();
  }
  // A user can do nothing with these.
  for (const char* word : {"nan", "internal error", "std::", "change of sign", "defect of"})
    if (said.find(word) != std::string::npos)
      return "useless: " + said.substr(0, said.find("do: "));
  // Files of the scene and keys begin with these.
  static const std::regex file_or_key("case\\.toml|\\b(wheel|rail|placement|track)[a-z0-9_]*\\.");
  return std::regex_search(said, file_or_key)
             ? said
             : "names neither file nor key: " + said.substr(0, said.find("do: "));
}

}  // namespace rollfem::testing
