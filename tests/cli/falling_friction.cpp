// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls through the commands run with auto, study and stress: at 10 % creepage the
// whole patch slides, so that forces and surface stresses are those of the law itself.
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

/// mu at V xi = 1000 mm/s in cases/falling_friction.toml.
const double sliding = 0.14 + (0.33 - 0.14) * std::exp2(-1000.0 / 1250.0);

std::vector<std::string> with_case(const std::string& command,
                                   const std::vector<std::string>& more) {
  return joined(
      {command, ROLLFEM_SOURCE_DIR "/cases/falling_friction.toml", "-o", "out", "--set",
       "rolling.longitudinal_creepage=[0.002, 0.1]", "--set", "contact_grid.elements_across=20"},
      more);
}

using FallingFriction = ProgramTest;

TEST_F(FallingFriction, AutoTakesAModelWithIt) {
  done(with_case("run", {"-m", "auto", "--no-report"}));
  const nlohmann::json model = folder.json("out/summary.json")["models"][0];
  EXPECT_EQ(model["chosen_by"], "auto");
  EXPECT_NEAR(model["points"][1]["traction_coefficient"].get<double>(), sliding, 0.003 * sliding);
}

TEST_F(FallingFriction, AStudyConvergesToTheLaw) {
  done(with_case("study", {"--levels", "4"}));
  EXPECT_TRUE(folder.holds("out/study.html"));
  std::vector<double> coefficients;
  for (const auto& row : csv_records(folder.text("out/study.csv")))
    if (row.at("quantity") == "traction_coefficient:2")
      coefficients.push_back(std::stod(row.at("value")));
  ASSERT_EQ(coefficients.size(), 4U);
  EXPECT_NEAR(coefficients.back(), sliding, 0.001 * sliding);
}

TEST_F(FallingFriction, StressesOfTheSurfaceAreThoseOfItsTractions) {
  done(with_case("run", {"--no-report"}));
  done({"stress", "out", "-o", "stress", "--no-figures"});
  const double pressure =
      folder.json("out/summary.json")["models"][0]["points"][1]["max_pressure"].get<double>();
  double shear = 0.0;
  for (const auto& row : csv_records(folder.text("stress/stress.csv")))
    if (row.at("set") == "depth_centre" && row.at("body") == "wheel" &&
        std::stod(row.at("z")) == 0.0)
      shear = std::abs(std::stod(row.at("xz")));
  EXPECT_NEAR(shear, sliding * pressure, 0.01 * sliding * pressure);
}

/// So steep that the second load point has no stable state; the third slides as a whole.
std::vector<std::string> steep_run(const std::string& directory, const std::string& memory,
                                   const std::string& creepages = "[0.008, 0.014, 0.2]") {
  std::vector<std::string> call{"run", ROLLFEM_SOURCE_DIR "/cases/falling_friction.toml", "-o",
                                directory, "--no-report"};
  for (const std::string& setting :
       {"rolling.longitudinal_creepage=" + creepages, "friction.memory_distance=" + memory,
        std::string("friction.coefficient=3"), std::string("friction.kinetic_coefficient=0.3"),
        std::string("friction.half_velocity=100"), std::string("layer.shear_modulus=1e6"),
        std::string("contact_grid.elements_across=10")})
    call = joined(call, {"--set", setting});
  return call;
}

TEST_F(FallingFriction, ALoadPointWithoutAStateIsLeftEmptyBesideTheOthers) {
  const Outcome outcome = call(steep_run("out", "0"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(says(outcome.err, "the results were written, but",
                   "1 of 3 load points are left empty", "load point 2 of 3",
                   "no stable steady state"))
      << outcome.err;
  const nlohmann::json points = folder.json("out/summary.json")["models"][0]["points"];
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1]["longitudinal_creepage"], 0.014);
  EXPECT_EQ(points[1]["converged"], false);
  for (const char* name : {"normal_force", "max_pressure", "traction_coefficient", "approach"})
    EXPECT_FALSE(points[1].contains(name)) << name;
  const auto notes = folder.json("out/summary.json")["models"][0]["notes"];
  EXPECT_EQ(notes.back().get<std::string>().rfind("warning: 1 of 3 load points are left", 0), 0U);
  const auto rows = csv_records(folder.text("out/creep_curve.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].at("traction_coefficient"), "");
  const double slides = 0.3 + 2.7 * std::exp2(-2000.0 / 100.0);
  EXPECT_NEAR(points[2]["traction_coefficient"].get<double>(), slides, 0.001 * slides);
  done(steep_run("alone", "0", "[0.008]"));
  const double alone = point_of(folder, "alone")["traction_coefficient"];
  EXPECT_NEAR(points[0]["traction_coefficient"].get<double>(), alone, 1e-6 * alone);
}

TEST_F(FallingFriction, TheMemoryThatIsNamedGivesOneStateEverywhere) {
  const Outcome steep = call(steep_run("out", "0"));
  EXPECT_TRUE(says(steep.out, "warning: friction falls so steeply")) << steep.out;
  const std::string words = "one state from about ";
  const std::size_t at = steep.err.rfind(words);
  ASSERT_NE(at, std::string::npos) << steep.err;
  const std::string memory = std::to_string(std::stod(steep.err.substr(at + words.size())));
  const Outcome calm = done(steep_run("calm", memory));
  EXPECT_FALSE(says(calm.out, "several states"));
  for (const auto& point : folder.json("calm/summary.json")["models"][0]["points"])
    EXPECT_EQ(point["converged"], true);
}

}  // namespace
