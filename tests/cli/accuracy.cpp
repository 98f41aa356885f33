// SPDX-License-Identifier: LGPL-2.1-or-later
// The key accuracy through the program: it is reached, or the results are written with status 1.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

std::string with_accuracy(const std::string& accuracy) {
  return "models = [\"halfspace\"]\naccuracy = " + accuracy + "\n" + rolling("0.001", 10);
}

using Accuracy = ProgramTest;

TEST_F(Accuracy, IsReachedByAsManyElementsAsItTakes) {
  const std::string file = folder.file("case.toml", with_accuracy("0.005"));
  done({"run", file, "-o", "out", "--no-report"});
  const auto summary = folder.json("out/summary.json");
  const auto& point = summary["models"][0]["points"][0];
  const auto& errors = point["error_estimate"];
  for (const char* name : {"max_pressure", "semi_axis_x", "semi_axis_y"})
    EXPECT_LE(errors[name].get<double>(), 0.005 * point[name].get<double>()) << name;
  EXPECT_LE(errors["traction_coefficient"].get<double>(), 0.005 * 0.55);
  EXPECT_GT(summary["models"][0]["contact_elements"].get<int>(), 320);
}

TEST_F(Accuracy, NotReachedIsAFailureWhoseResultsAreThere) {
  const std::string file = folder.file("case.toml", with_accuracy("1e-5"));
  const Outcome outcome = call({"run", file, "-o", "out", "--no-report", "-q"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "the results were written, but model halfspace: accuracy = 1e-05"));
  EXPECT_TRUE(folder.holds("out/summary.json"));
  EXPECT_FALSE(folder.holds("out.unfinished"));
}

TEST_F(Accuracy, AnUnknownQuantityIsAnInputError) {
  const std::string file =
      folder.file("case.toml", "accuracy = 0.01\naccuracy_of = [\"beauty\"]\n" + small_case);
  refuses({"check", file}, "accuracy_of");
}

}  // namespace
