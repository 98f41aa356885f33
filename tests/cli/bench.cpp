// rollfem bench: errors and seconds of the models, and the machine's speed that check predicts by.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using rollfem::testing::call;
using rollfem::testing::expect_refused;
using rollfem::testing::Folder;
using rollfem::testing::Outcome;

namespace {

const std::string ball_on_plane = R"(
[load]
normal_force = 10e3
[friction]
coefficient = 0.3
[wheel]
rolling_radius = 400.0
transverse_radius = inf
[rail]
transverse_radius = 300.0
[rolling]
longitudinal_creepage = 0.001
)";

/// The last number but one (the error of the force) of the line that begins so.
double force_error(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find('\n' + beginning);
  EXPECT_NE(at, std::string::npos) << beginning << '\n' << text;
  if (at == std::string::npos) return 1e9;
  const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
  const std::size_t percent = line.rfind('%');
  return std::atof(line.substr(line.find_last_of("+-", percent)).c_str());
}

}  // namespace

TEST(Bench, QuicklySaysErrorsAndSecondsOfTheModels) {
  const Folder folder;
  const Outcome outcome = call(folder, {"bench", "--quick"}, {"ROLLFEM_CACHE=cache"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* text :
       {"seconds", "\nhertz ", "\nlinear ", "\nstrip ", "times the predicted seconds"})
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << '\n' << outcome.out;
  // Errors fall with the grid; theories are off by what they leave out.
  const double coarse = std::abs(force_error(outcome.out, "halfspace                 24"));
  const double fine = std::abs(force_error(outcome.out, "halfspace                 40"));
  EXPECT_LT(coarse, 0.6);
  EXPECT_LT(fine, 0.25);
  EXPECT_GT(std::abs(force_error(outcome.out, "linear ")), 5.0);
  EXPECT_FALSE(std::filesystem::exists(folder.work() / "cache")) << "nothing is kept";
}

TEST(Bench, SpeedOfTheMachineIsWhatCheckPredictsBy) {
  const Folder folder;
  const std::vector<std::string> cache{"ROLLFEM_CACHE=cache"};
  const std::string file = folder.file("case.toml", ball_on_plane);
  const Outcome before = call(folder, {"check", file}, cache);
  EXPECT_NE(before.out.find("rollfem bench calibrates them"), std::string::npos);
  const Outcome outcome = call(folder, {"bench", "--seconds", "0.1"}, cache);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("stored in cache/bench_"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nspin: "), std::string::npos) << outcome.out;
  const Outcome after = call(folder, {"check", file}, cache);
  EXPECT_NE(after.out.find("times are for this machine, "), std::string::npos) << after.out;
  expect_refused(call(folder, {"bench", "--seconds", "-1"}), "--seconds -1: allowed: above 0");
}
