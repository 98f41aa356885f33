// A folder of its own for a test of output, where the figures' Python package is, and a file's
// text.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rollfem::tests {

/// The folder that holds the Python package rollfem_figures.
inline const std::string scripts = std::string(ROLLFEM_SOURCE_DIR) + "/postprocess";

/// The whole file; empty when it cannot be read.
inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// `base_` is empty at first and removed at the end.
class InFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name =
        (std::filesystem::path(::testing::TempDir()) / "rollfem_output_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    base_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(base_); }

  std::filesystem::path base_;
};

}  // namespace rollfem::tests
