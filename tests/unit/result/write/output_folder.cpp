// SPDX-License-Identifier: LGPL-2.1-or-later
// A result appears completely or not at all, and foreign files are never lost.
#include "base/errors.hpp"
#include "result/files/result_folder.hpp"
#include "result/write/output.hpp"

#include "support/output_in_folder.hpp"
#include "support/output_synthetic_run.hpp"
#include <csignal>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

class ResultFolderTest : public InFolder {
 protected:
  std::string target() const { return (base_ / "result").string(); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(base_), fs::directory_iterator()));
  }
  /// The message with which writing is refused, empty when it is not.
  std::string refusal(const std::string& directory) const {
    return rollfem::testing::refusal<InputError>(
        [&] { write_results(directory, synthetic_run()); });
  }
};

TEST_F(ResultFolderTest, HoldsAllFilesAndNothingIsLeftBeside) {
  write_results(target(), synthetic_run());
  for (const char* name :
       {"case.toml", "summary.json", "results.h5", "creep_curve.csv", "path_x.csv", "path_y.csv",
        "fields/fem_wheel.vtu", "fields/fem_rail.vtu", "fields/fem_contact.vtu",
        "fields/halfspace_contact.vtu", "fields/hertz_contact.vtu", "fields/fem_contact.pvd",
        "fields/fem_contact_0000.vtu", "fields/halfspace_contact_0006.vtu"})
    EXPECT_GT(fs::file_size(fs::path(target()) / name), 0U) << name;
  EXPECT_EQ(entries(), 1U);
  EXPECT_EQ(contents(fs::path(target()) / "case.toml"), synthetic_run().input.text);
}

TEST_F(ResultFolderTest, ThreadsWriteAndReadOneResultAndTheirOwn) {
  const RunRecord run = synthetic_run();
  const std::string alone = results_hdf5(run);
  std::vector<std::string> faults(8);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < faults.size(); ++t)
    threads.emplace_back([&, t] {
      for (const std::string& folder : {target(), target() + std::to_string(t), target()}) try {
          write_results(folder, run);
          if (contents(fs::path(folder) / "results.h5") != alone) faults[t] = "another result";
        } catch (const std::exception& error) {
          faults[t] = error.what();
        }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& fault : faults) EXPECT_EQ(fault, "");
  EXPECT_EQ(entries(), 1 + faults.size());
}

TEST_F(ResultFolderTest, HoldsOnlyWhatTheCaseAsksFor) {
  RunRecord run = synthetic_run();
  run.input.output.paths = {"y"};
  run.input.output.fields = false;
  write_results(target(), run);
  EXPECT_FALSE(fs::exists(fs::path(target()) / "path_x.csv"));
  EXPECT_TRUE(fs::exists(fs::path(target()) / "path_y.csv"));
  EXPECT_FALSE(fs::exists(fs::path(target()) / "fields"));
}

TEST_F(ResultFolderTest, MakesMissingParentsAndTakesEmptyFolders) {
  write_results((base_ / "one/two/result/").string(), synthetic_run());
  EXPECT_TRUE(fs::exists(base_ / "one/two/result/summary.json"));
  fs::create_directory(target());
  write_results(target(), synthetic_run());
  EXPECT_TRUE(fs::exists(fs::path(target()) / "summary.json"));
}

TEST_F(ResultFolderTest, ReplacesAnEarlierResultButKeepsFilesOfOthers) {
  write_results(target(), synthetic_run());
  fs::create_directory(fs::path(target()) / "figures");
  for (const char* name : {"notes.txt", "figures/old.svg", "figures/mine.png", "fields/my.txt",
                           "pass_work.csv", "wheelset_rigid.csv"})
    std::ofstream(fs::path(target()) / name) << name;
  RunRecord second = synthetic_run();
  second.input.title = "second";
  second.input.output.paths = {"x"};
  write_results(target(), second);
  EXPECT_TRUE(says(contents(fs::path(target()) / "summary.json"), "second"));
  EXPECT_FALSE(fs::exists(fs::path(target()) / "path_y.csv"));
  EXPECT_FALSE(fs::exists(fs::path(target()) / "figures/old.svg"));
  for (const char* name : {"pass_work.csv", "wheelset_rigid.csv"})
    EXPECT_NE(contents(fs::path(target()) / name), name);
  for (const char* name : {"notes.txt", "figures/mine.png", "fields/my.txt"})
    EXPECT_EQ(contents(fs::path(target()) / name), name);
  EXPECT_EQ(entries(), 1U);
}

TEST_F(ResultFolderTest, WritesOnlyFilesThatAnotherResultReplaces) {
  ResultFolder folder(target());
  for (const char* name :
       {"later.csv", "figures/later.png", "fields/later.csv", "other/path_x.csv"})
    EXPECT_THROW(folder.write(name, "text"), std::logic_error) << name;
  EXPECT_NO_THROW(folder.write("pass_work.csv", "text"));
}

TEST_F(ResultFolderTest, RefusesAFolderWithOtherFilesAndAFileAndTheCurrentFolder) {
  fs::create_directory(target());
  std::ofstream(fs::path(target()) / "thesis.doc") << "precious";
  EXPECT_TRUE(says(refusal(target()), "not an earlier result"));
  EXPECT_EQ(contents(fs::path(target()) / "thesis.doc"), "precious");
  std::ofstream(fs::path(target()) / "summary.json") << "{\"other\": 1}";
  EXPECT_TRUE(says(refusal(target()), "not an earlier result"));

  std::ofstream(base_ / "file") << "precious";
  EXPECT_TRUE(says(refusal((base_ / "file").string()), "is a file"));
  EXPECT_NE(refusal((base_ / "file/below").string()), "");
  EXPECT_EQ(contents(base_ / "file"), "precious");
  EXPECT_EQ(entries(), 2U);
  EXPECT_NE(refusal("."), "");
  EXPECT_NE(refusal(""), "");
}

TEST_F(ResultFolderTest, IsFollowedThroughALink) {
  fs::create_directory(base_ / "disk");
  fs::create_directory_symlink(base_ / "disk", target());
  write_results(target(), synthetic_run());
  EXPECT_TRUE(fs::is_symlink(target()));
  EXPECT_TRUE(fs::exists(base_ / "disk/summary.json"));
}

TEST_F(ResultFolderTest, CheckLeavesNothingBehind) {
  check_directory((base_ / "one/two").string());
  EXPECT_EQ(entries(), 0U);
  std::ofstream(base_ / "file") << "x";
  EXPECT_THROW(check_directory((base_ / "file").string()), InputError);
}

/// Limits the size of files this process may write.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST_F(ResultFolderTest, AFileThatCannotBeWrittenWholeLeavesTheEarlierResultIntact) {
  write_results(target(), synthetic_run());
  const std::string before = contents(fs::path(target()) / "results.h5");
  ASSERT_GT(before.size(), 100000U);
  std::string message;
  {
    const FileSizeLimit limit(20000);
    message = refusal(target());
    EXPECT_NE(refusal((base_ / "new/folder").string()), "");
  }
  EXPECT_TRUE(says(message, "File too large"));
  EXPECT_EQ(contents(fs::path(target()) / "results.h5"), before);
  EXPECT_EQ(entries(), 1U);
}

TEST_F(ResultFolderTest, MissingPermissionIsReportedAndLeavesNothing) {
  // The administrator may write everywhere but in /proc.
  const std::string directory = ::geteuid() == 0 ? "/proc/rollfem" : (base_ / "locked/r").string();
  fs::create_directory(base_ / "locked");
  fs::permissions(base_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  const std::string message = refusal(directory);
  EXPECT_TRUE(says(message, "choose another folder"));
  EXPECT_TRUE(fs::is_empty(base_ / "locked"));
}

}  // namespace
}  // namespace rollfem::result
