// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder drawn by Debian's Python, and queries of the package rollfem. Skipped with a
// message if numpy or h5py is not installed.
#pragma once

#include "postprocess/write/output.hpp"

#include "support/output_in_folder.hpp"
#include "support/output_python.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1))
    ++found;
  return found;
}

class DrawnPages : public InFolder {
 protected:
  void SetUp() override {
    if (!python_can_import("h5py, numpy"))
      GTEST_SKIP() << "no figures without apt install python3-numpy python3-h5py";
  }

  /// Writes the run and draws it; returns the folder.
  std::filesystem::path draw(const postprocess::RunRecord& run) {
    const std::filesystem::path folder = base_ / "result with spaces";
    postprocess::write_results(folder.string(), run);
    EXPECT_EQ(postprocess::make_report(folder.string(), scripts), "");
    return folder;
  }

  static void expect_self_contained(const std::string& page) {
    for (const char* link : {"http:", "https:", "src=\"/", "<script", "@import", "url(", "<img"})
      EXPECT_EQ(page.find(link), std::string::npos) << link;
    EXPECT_EQ(count(page, "<figure>"), count(page, "role=\"img\" aria-label="));
    EXPECT_TRUE(says(page, "name=viewport", "@media print"));
  }

  /// Output of a script with access to the package; empty if all its assertions hold.
  static std::string said(const std::string& script, const std::string& argument = "") {
    return python("import sys\nsys.dont_write_bytecode = True\nsys.path.insert(0, '" + scripts +
                      "')\nimport numpy as np\n" + script,
                  argument);
  }
};

}  // namespace rollfem::testing
