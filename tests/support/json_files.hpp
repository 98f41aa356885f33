// JSON files that the program wrote.
#pragma once

#include <nlohmann/json.hpp>

#include "support/temporary_folder.hpp"
#include <filesystem>

namespace rollfem::testing {

inline nlohmann::json read(const std::filesystem::path& file) {
  return nlohmann::json::parse(contents(file));
}

}  // namespace rollfem::testing
