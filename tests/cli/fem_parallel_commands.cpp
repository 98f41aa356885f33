// compare and study on several processes: the numbers of one process, files of the first alone, and
// a failure that ends the call with nothing half-written.
#include "support/case_examples.hpp"
#include "support/program.hpp"
#include <array>
#include <cmath>

namespace {

using namespace rollfem::testing;
using Json = nlohmann::json;

std::string coarse_flat_case(const std::string& cell_size) {
  return with("2000.0", "500.0") +
         "[rolling]\nlongitudinal_creepage = 0.001\n[contact_grid]\nelements_across = 20\n"
         "[fem]\nextent = 30\nfine_extent = 1.0\nlinear_solver = \"multigrid\"\ncell_size = " +
         cell_size + "\n[output]\nfields = false\n";
}

/// Runs the command on one process and on two; its JSON of both.
std::array<Json, 2> both(const Folder& folder, const std::string& command,
                         const std::vector<std::string>& options) {
  const std::string input = folder.file("coarse.toml", coarse_flat_case("1.4"));
  std::array<Json, 2> results;
  for (const int processes : {1, 2}) {
    const std::string output = "on_" + std::to_string(processes);
    const Outcome outcome = checked(execute(
        folder, command_of(joined({command, input, "-o", output, "-q", "--no-report"}, options),
                           processes)));
    EXPECT_EQ(outcome.out, "");
    results[static_cast<std::size_t>(processes - 1)] =
        folder.json(output + "/" + command + ".json");
  }
  for (const std::string& name : folder.made()) EXPECT_FALSE(says(name, "partial"));
  return results;
}

TEST(FemCommands, StudyOnTwoProcessesGivesTheNumbersOfOne) {
  const Folder folder;
  const auto [one, two] = both(folder, "study", {"--model", "fem", "halfspace", "--levels", "2"});
  EXPECT_EQ(two.at("processes"), 2);
  ASSERT_EQ(one.at("places").at(0).at("series").size(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    const Json& levels = one.at("places").at(0).at("series").at(s).at("levels");
    const Json& other = two.at("places").at(0).at("series").at(s).at("levels");
    ASSERT_EQ(levels.size(), 2U);
    ASSERT_EQ(other.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(levels[k].at("unknowns"), other[k].at("unknowns"));
      for (const auto& [name, value] : levels[k].at("values").items())
        EXPECT_NEAR(other[k].at("values").at(name).get<double>(), value.get<double>(),
                    1e-8 * std::abs(value.get<double>()))
            << name;
    }
  }
}

TEST(FemCommands, CompareOnTwoProcessesGivesTheNumbersOfOne) {
  const Folder folder;
  const auto [one, two] = both(folder, "compare", {"--model", "halfspace", "fem"});
  const Json& numbers = one.at("cases").at(0).at("numbers");
  const Json& other = two.at("cases").at(0).at("numbers");
  ASSERT_GT(numbers.size(), 8U);
  ASSERT_EQ(numbers.size(), other.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    EXPECT_EQ(numbers[k].at("quantity"), other[k].at("quantity"));
    const double value = numbers[k].at("value");
    EXPECT_NEAR(other[k].at("value").get<double>(), value, 1e-8 * std::abs(value))
        << numbers[k].at("quantity");
  }
}

TEST(FemCommands, AFailureOnTwoProcessesEndsTheCallAndWritesNothing) {
  const Folder folder;
  // More unknowns than any memory holds, which shows before a mesh is made.
  const std::string input = folder.file("fine.toml", coarse_flat_case("0.001"));
  for (const char* command : {"study", "compare"}) {
    const Outcome outcome =
        execute(folder, command_of({command, input, "-o", "out", "--no-report", "-m", "fem"}, 2));
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(says(outcome.err, "model fem"));
    EXPECT_TRUE(folder.made().empty()) << command;
  }
}

}  // namespace
