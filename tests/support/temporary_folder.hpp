// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder that is removed at the end, the content of files, and searches in texts.
#pragma once

#include "support/test.hpp"

namespace rollfem::testing {

/// Empty at first, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rollfem_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string path(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file, in folders below if its name says so, and returns its path.
  std::string file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path(name);
  }

 private:
  std::filesystem::path path_;
};

/// The whole file; empty when it cannot be read.
inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Whether a text contains all of these parts; EXPECT_TRUE prints the text and the missing parts.
inline ::testing::AssertionResult says(const std::string& text,
                                       const std::vector<std::string>& parts) {
  std::string missing;
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) missing += "no '" + part + "' ";
  if (!missing.empty()) return ::testing::AssertionFailure() << missing << "in: " << text;
  return ::testing::AssertionSuccess() << text;
}

template <class... Parts>
::testing::AssertionResult says(const std::string& text, const Parts&... parts) {
  return says(text, std::vector<std::string>{std::string(parts)...});
}

/// Message of a refused call, "" if it succeeds.
template <class Error, class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace rollfem::testing
