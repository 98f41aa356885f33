// SPDX-License-Identifier: LGPL-2.1-or-later
// The Python that draws is Debian's or that of a virtual environment, and never one of the user's
// folder. What it draws: tests/cli/test_figures.py.
#include "result/write/report.hpp"

#include "support/places.hpp"
#include "support/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

const std::string scripts = std::string(ROLLFEM_SOURCE_DIR) + "/postprocess";

/// `base_` is empty at first and removed at the end.
class FiguresTest : public ::testing::Test {
  const TemporaryFolder folder_;

 protected:
  const fs::path base_ = folder_.path();
};

TEST_F(FiguresTest, ADefectOfThePlottingIsOneLineAndATextInAFile) {
  const fs::path folder = base_ / "result with spaces";
  fs::create_directory(folder);
  const fs::path scripts_here = base_ / "rollfem";
  fs::create_directory(scripts_here);
  std::ofstream(scripts_here / "__init__.py") << "";
  std::ofstream(scripts_here / "__main__.py") << "def f():\n    raise ValueError('odd')\nf()\n";
  const std::string message = make_report(folder.string(), base_.string());
  EXPECT_FALSE(says(message, "\n"));
  EXPECT_EQ(message.rfind("ValueError: odd (full text in ", 0), 0U) << message;
  EXPECT_TRUE(says(contents(folder / "report.log"), "Traceback"));
}

/// Modules and settings that lie in the user's folder are not the program's.
TEST_F(FiguresTest, TakeNothingFromTheCurrentFolder) {
  const fs::path before = fs::current_path();
  const fs::path hostile = base_ / "hostile";
  fs::create_directories(hostile / "h5py");
  const std::string trap = "open('" + (hostile / "ran").string() + "', 'a').write('x')\n";
  for (const char* name :
       {"numpy.py", "argparse.py", "h5py/__init__.py", "sitecustomize.py", "rollfem.py"})
    std::ofstream(hostile / name) << trap;
  // All modules are imported before a folder is looked at that is not there.
  const std::string message = make_report("/nowhere", scripts);
  EXPECT_TRUE(says(message, "/nowhere"));
  fs::current_path(hostile);
  // An empty entry of PYTHONPATH stands for the current folder, and comes by accident.
  for (const char* path : {"", ":/elsewhere", "."}) {
    ::setenv("PYTHONPATH", path, 1);
    EXPECT_EQ(make_report("/nowhere", scripts), message);
  }
  ::unsetenv("PYTHONPATH");
  // A Python that is named by a relative path is found from here all the same.
  fs::create_symlink("/usr/bin/python3", "python-here");
  ::setenv("ROLLFEM_PYTHON", "./python-here", 1);
  EXPECT_EQ(make_report("/nowhere", scripts), message);
  ::unsetenv("ROLLFEM_PYTHON");
  fs::current_path(before);
  EXPECT_FALSE(fs::exists(hostile / "ran"));
}

TEST_F(FiguresTest, AVirtualEnvironmentDrawsWithItsOwnPython) {
  const fs::path environment = base_ / "venv", package = "share/rollfem/rollfem";
  fs::create_directories(environment / package);
  fs::create_directory(environment / "bin");
  std::ofstream(environment / package / "__main__.py") << "raise SystemExit('another Python')\n";
  std::ofstream(environment / "bin" / "python3") << "#!/bin/sh\necho its own >&2\nexit 1\n";
  fs::permissions(environment / "bin" / "python3", fs::perms::owner_all);
  EXPECT_TRUE(says(make_report("/nowhere", environment / package), "another Python"));
  std::ofstream(environment / "pyvenv.cfg") << "";
  EXPECT_TRUE(says(make_report("/nowhere", environment / package), "its own"));
}

TEST(MakeReport, ReportsMissingProgramsAndScripts) {
  EXPECT_TRUE(says(make_report("/nowhere", "/nowhere"), "no Python package"));
  ::setenv("ROLLFEM_PYTHON", "/nowhere/python3", 1);
  EXPECT_TRUE(says(make_report("/nowhere", scripts), "cannot run /nowhere/python3"));
  ::unsetenv("ROLLFEM_PYTHON");
  EXPECT_NE(make_report("/nowhere", scripts + "/rollfem"), "");
}

}  // namespace
}  // namespace rollfem::result
