// The names of models in a case file. Which there are is known to who reads it, not to this folder.
#pragma once

#include <string>
#include <vector>

namespace rollfem::contact {

struct ModelWords {
  std::vector<std::string> known;       ///< empty: any name is taken
  std::vector<std::string> by_default;  ///< where the case names none
};

}  // namespace rollfem::contact
