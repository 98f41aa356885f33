// SPDX-License-Identifier: LGPL-2.1-or-later
// compare and study on several processes: the numbers of one process, files of the first alone, and
// a failure that ends the call with nothing half-written.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;

std::string coarse_flat_case(const std::string& cell_size) {
  return with("2000.0", "500.0") +
         "[rolling]\nlongitudinal_creepage = 0.001\n[contact_grid]\nelements_across = 20\n"
         "[fem]\nextent = 30\nfine_extent = 1.0\nlinear_solver = \"multigrid\"\ncell_size = " +
         cell_size + "\n[output]\nfields = false\n";
}

/// Runs the command on one process and on two; its JSON of both.
std::array<json, 2> both(const Folder& folder, const std::string& command,
                         const std::vector<std::string>& options) {
  const std::string input = folder.file("coarse.toml", coarse_flat_case("1.4"));
  std::array<json, 2> results;
  for (const int processes : {1, 2}) {
    const std::string output = "on_" + std::to_string(processes);
    const Outcome outcome = checked(folder.execute(command_of(
        joined({command, input, "-o", output, "-q", "--no-report"}, options), processes)));
    EXPECT_EQ(outcome.out, "");
    results[static_cast<std::size_t>(processes - 1)] =
        folder.json(output + "/" + command + ".json");
  }
  for (const std::string& name : folder.made()) EXPECT_FALSE(says(name, "partial"));
  return results;
}

/// Checks that the rows of both tables have the same values; returns their number.
std::size_t same_rows(const Folder& folder, const std::string& name) {
  const auto one = csv_records(folder.text("on_1/" + name + ".csv"));
  const auto two = csv_records(folder.text("on_2/" + name + ".csv"));
  EXPECT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < std::min(one.size(), two.size()); ++k) {
    for (const char* cell : {"quantity", "model", "unknowns"})
      if (one[k].count(cell) > 0) {
        EXPECT_EQ(one[k].at(cell), two[k].at(cell));
      }
    const double value = std::stod(one[k].at("value"));
    EXPECT_NEAR(std::stod(two[k].at("value")), value, 1e-8 * std::abs(value))
        << one[k].at("quantity");
  }
  return one.size();
}

using FemCommands = ProgramTest;

TEST_F(FemCommands, StudyOnTwoProcessesGivesTheNumbersOfOne) {
  const auto [one, two] = both(folder, "study", {"--model", "fem", "halfspace", "--levels", "2"});
  EXPECT_EQ(two.at("processes"), 2);
  ASSERT_EQ(one.at("places").at(0).at("series").size(), 2U);
  for (const json& series : one.at("places").at(0).at("series"))
    EXPECT_EQ(series.at("levels").size(), 2U);
  EXPECT_GT(same_rows(folder, "study"), 8U);
}

TEST_F(FemCommands, CompareOnTwoProcessesGivesTheNumbersOfOne) {
  both(folder, "compare", {"--model", "halfspace", "fem"});
  EXPECT_GT(same_rows(folder, "compare"), 8U);
}

TEST_F(FemCommands, AFailureOnTwoProcessesEndsTheCallAndWritesNothing) {
  // More unknowns than any memory holds, which shows before a mesh is made.
  const std::string input = folder.file("fine.toml", coarse_flat_case("0.001"));
  for (const char* command : {"study", "compare"}) {
    const Outcome outcome =
        execute(command_of({command, input, "-o", "out", "--no-report", "-m", "fem"}, 2));
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(says(outcome.err, "model fem"));
    EXPECT_TRUE(folder.made().empty()) << command;
  }
}

}  // namespace
