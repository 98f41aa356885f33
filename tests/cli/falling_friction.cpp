// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls through the commands run with auto, study and stress: at 10 % creepage the
// whole patch slides, so that forces and surface stresses are those of the law itself.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/csv_rows.hpp"
#include "support/program.hpp"
#include <algorithm>
#include <cmath>

namespace {

using namespace rollfem::testing;

/// mu at V xi = 1000 mm/s in cases/falling_friction.toml.
const double sliding = 0.14 + (0.33 - 0.14) * std::exp2(-1000.0 / 1250.0);

std::vector<std::string> with_case(const std::string& command,
                                   const std::vector<std::string>& more) {
  return joined(
      {command, ROLLFEM_SOURCE_DIR "/cases/falling_friction.toml", "-o", "out", "--set",
       "rolling.longitudinal_creepage=[0.002, 0.1]", "--set", "contact_grid.elements_across=20"},
      more);
}

TEST(FallingFriction, AutoTakesAModelWithIt) {
  const Folder folder;
  done(folder, with_case("run", {"-m", "auto", "--no-report"}));
  const nlohmann::json model = folder.json("out/summary.json")["models"][0];
  EXPECT_EQ(model["chosen_by"], "auto");
  EXPECT_NEAR(model["points"][1]["traction_coefficient"].get<double>(), sliding, 0.003 * sliding);
}

TEST(FallingFriction, AStudyConvergesToTheLaw) {
  const Folder folder;
  done(folder, with_case("study", {"--levels", "4"}));
  EXPECT_TRUE(folder.holds("out/study.html"));
  std::vector<double> coefficients;
  for (const auto& row : csv_records(folder.text("out/study.csv")))
    if (row.at("quantity") == "traction_coefficient:2")
      coefficients.push_back(std::stod(row.at("value")));
  ASSERT_EQ(coefficients.size(), 4U);
  EXPECT_NEAR(coefficients.back(), sliding, 0.001 * sliding);
}

TEST(FallingFriction, StressesOfTheSurfaceAreThoseOfItsTractions) {
  const Folder folder;
  done(folder, with_case("run", {"--no-report"}));
  done(folder, {"stress", "out", "-o", "stress", "--no-figures"});
  const double pressure =
      folder.json("out/summary.json")["models"][0]["points"][1]["max_pressure"].get<double>();
  double shear = 0.0;
  for (const auto& row : csv_records(folder.text("stress/stress.csv")))
    if (row.at("set") == "depth_centre" && row.at("body") == "wheel" &&
        std::stod(row.at("z")) == 0.0)
      shear = std::abs(std::stod(row.at("xz")));
  EXPECT_NEAR(shear, sliding * pressure, 0.01 * sliding * pressure);
}

}  // namespace
