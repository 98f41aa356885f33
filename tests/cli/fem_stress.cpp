// The command stress on stored finite-element bodies: any load point of a creep curve, without
// solving, is what a run with that creepage alone gives.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace {

using namespace rollfem::testing;
namespace fs = std::filesystem;

/// Small bodies of case a.
std::string coarse_output_case(const std::string& creepages, const std::string& output) {
  return "title = \"coarse\"\nmodels = [\"fem\"]\n"
         "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n"
         "[wheel]\nrolling_radius = 405.0\ntransverse_radius = inf\n"
         "[rail]\ntransverse_radius = 2000.0\n"
         "[rolling]\nlongitudinal_creepage = " +
         creepages + "\n[fem]\ncell_size = 1.9\nextent = 25\nlinear_solver = \"factorisation\"\n" +
         output;
}

/// The numbers of stress.csv, row by row, from x on.
std::vector<double> numbers(const fs::path& folder) {
  std::istringstream file(contents(folder / "stress.csv"));
  std::string line;
  std::getline(file, line);
  std::vector<double> values;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int k = 0; std::getline(cells, cell, ','); ++k)
      if (k >= 4) values.push_back(std::stod(cell));
  }
  return values;
}

class FemStress : public ::testing::Test {
 protected:
  void run(const std::string& name, const std::string& creepages, const std::string& output) {
    const std::string file = folder.file(name + ".toml", coarse_output_case(creepages, output));
    const Outcome outcome = call(folder, {"run", file, "-o", name, "-q", "--no-report"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  std::vector<double> stress(const std::string& result, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"stress", result, "--no-figures", "--depth-profile", "--depth", "10",
                      "--line", "-6,1,-2:6,1,-2:25", "-o", "out"});
    const Outcome outcome = call(folder, arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return numbers(folder.work() / "out");
  }
  double max_pressure(const std::string& result) const {
    const auto summary = nlohmann::json::parse(contents(folder.work() / result / "summary.json"));
    return summary["models"][0]["points"][0]["max_pressure"];
  }
  bool has(const std::string& file) const { return fs::exists(folder.work() / file); }
  Folder folder;
};

TEST_F(FemStress, AtAnyLoadPointIsThatOfARunWithItAlone) {
  const std::string all = "[output]\nbody_fields = \"all\"\n";
  run("curve", "[0.001, 0.003, 0.006]", all);
  run("first", "[0.001]", all);
  run("second", "[0.003]", all);
  const double p0 = max_pressure("curve");

  // Both begin from the frictionless solution: the same numbers.
  const std::vector<double> first = stress("curve", {"--point", "1"});
  ASSERT_GT(first.size(), 1000U);
  EXPECT_EQ(first, stress("first", {}));

  // From the point before and from the frictionless solution: to the tolerance of the iteration.
  const std::vector<double> second = stress("curve", {"--creepage", "0.003"});
  const std::vector<double> alone = stress("second", {});
  ASSERT_EQ(second.size(), alone.size());
  double difference = 0.0;
  double change = 0.0;
  for (std::size_t k = 0; k < second.size(); ++k) {
    difference = std::max(difference, std::abs(second[k] - alone[k]));
    change = std::max(change, std::abs(second[k] - first[k]));
  }
  EXPECT_LT(difference, 1e-4 * p0);
  EXPECT_GT(change, 0.05 * p0) << "the load points are not told apart";

  for (const char* name : {"wheel_0000.vtu", "rail_0002.vtu", "wheel.vtu", "bodies.pvd"})
    EXPECT_TRUE(has(std::string("curve/fields/fem_") + name)) << name;
}

TEST_F(FemStress, BodiesAreKeptAsTheCaseSays) {
  const std::string curve = "[0.001, 0.003]";
  run("last", curve, "[output]\nbody_fields = \"last\"\n");
  EXPECT_TRUE(has("last/fields/fem_wheel_0001.vtu"));
  EXPECT_FALSE(has("last/fields/fem_wheel_0000.vtu"));
  EXPECT_FALSE(stress("last", {}).empty());
  expect_refused(call(folder, {"stress", "last", "--point", "1"}),
                 "stores its bodies only for these load points: 2; do: ");
  run("none", curve, "");
  EXPECT_TRUE(has("none/fields/fem_contact_0001.vtu"));
  EXPECT_FALSE(has("none/fields/fem_wheel.vtu"));
  expect_refused(call(folder, {"stress", "none"}),
                 "do: run the case again with [output] body_fields = \"all\"");
}

}  // namespace
