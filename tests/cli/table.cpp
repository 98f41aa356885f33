// SPDX-License-Identifier: LGPL-2.1-or-later
// The command table: its files, resuming an interrupted call, and its refusals.
#include "tables/files/table_files.hpp"

#include <fmt/format.h>

#include "support/case_examples.hpp"
#include "support/resume.hpp"

namespace {

namespace fs = std::filesystem;
using rollfem::tables::CreepTableReader;

std::string table_case(const std::string& table) {
  return small_case + "[table]\n" + table;
}

const std::string quick_table =
    "points = [4, 3, 5]\nlargest = [2.0, 2.0, 2.0]\ncheck_points = 10\n";

using Table = ProgramTest;

TEST_F(Table, IsWrittenWithItsErrorsAndAReport) {
  const Outcome outcome =
      done({"table", folder.file("case.toml", table_case(quick_table)), "-o", "out"});
  EXPECT_TRUE(
      says(outcome.out, "60 points", "4 values of xi'", "interpolation error at 10 random points"));
  const fs::path out = folder.work() / "out";
  for (const char* name :
       {"table.h5", "table.csv", "interpolation.csv", "table.html", "figures/table_surfaces.svg",
        "figures/table_curves.svg", "figures/table_errors.svg"})
    EXPECT_TRUE(fs::exists(out / name)) << name;
  const CreepTableReader reader(rollfem::tables::read_table(out.string()));
  EXPECT_EQ(reader.table().size(), 60U);
  EXPECT_EQ(reader.table().interpolation.points, 10);
  const double ratio = reader.table().axis_ratio.front();
  const double full = reader.at(ratio, {50.0, 0.0, 0.0}).forces[0];
  EXPECT_NEAR(full, -1.0, 0.005);
  const std::string rows = contents(out / "table.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 61);
  EXPECT_TRUE(says(contents(out / "table.html"), "95 of 100 points"));
}

/// The interpolation error that 95 of 100 random points of a table with these numbers of values
/// stay below, and what the command says.
std::pair<double, std::string> error_and_text(const Folder& folder, const std::string& points) {
  const Outcome outcome = folder.done(
      {"table", folder.file("case.toml", table_case("check_points = 20\npoints = " + points)), "-o",
       points, "--no-report"});
  const auto error = rollfem::tables::read_table((folder.work() / points).string()).interpolation;
  return {std::max(error.force_95, error.moment_95), outcome.out + outcome.err};
}

TEST_F(Table, NamesTheAxisWhoseRefinementHelps) {
  const auto [coarse, said] = error_and_text(folder, "[9, 8, 3]");
  EXPECT_TRUE(says(said, "by axis, in 95 of 100: xi'", "refine phi' first", "5 values instead of 3",
                   "216 points: about "));
  EXPECT_FALSE(says(said, "a/b 0")) << "a single ratio";
  // The advice against tables with more values on one axis or the other.
  const double finer_spin = error_and_text(folder, "[9, 8, 5]").first;
  const double finer_xi = error_and_text(folder, "[17, 8, 3]").first;
  EXPECT_LT(finer_spin, 0.7 * coarse);
  EXPECT_GT(finer_xi, 0.9 * coarse);
  EXPECT_TRUE(says(error_and_text(folder, "[2, 6, 9]").second, "refine xi' first"));
}

TEST_F(Table, AnEndedCallIsTakenUpAndIsTheSame) {
  const std::string file =
      folder.file("slow.toml", table_case("axis_ratio = [0.5, 2.0]\npoints = [5, 4, 5]\n"
                                          "check_points = 20\n"));
  const std::vector<std::string> table{"table", file, "--no-report", "-o"};
  const fs::path unfinished = folder.work() / "out.unfinished";
  kill_when(folder, command_of(joined(table, {"out"})), [&] { return records(unfinished) >= 3; });
  EXPECT_FALSE(folder.holds("out"));
  const int kept = records(unfinished);
  const Outcome outcome = done(joined(table, {"out", "--resume"}));
  EXPECT_TRUE(says(outcome.err, "resume: " + std::to_string(kept) + " solutions"));
  EXPECT_FALSE(fs::exists(unfinished));
  done(joined(table, {"whole"}));
  for (const std::string name : {"table.csv", "interpolation.csv"})
    EXPECT_EQ(folder.text("out/" + name), folder.text("whole/" + name)) << name;
}

/// The table at a physical creepage of the small case against the model halfspace, which solves
/// with other grids, levels and pressure.
void expect_like_halfspace(const Folder& folder, const CreepTableReader& reader,
                           const rollfem::tables::Scaled& creepage) {
  const auto key = [](const char* name, double value) {
    return std::string("rolling.") + name + "=" + fmt::format("{:.17g}", value);
  };
  folder.done({"run", folder.file("case.toml", small_case), "-m", "halfspace", "-o", "run",
               "--no-report", "--set", key("longitudinal_creepage", creepage[0]), "--set",
               key("lateral_creepage", creepage[1]), "--set", key("spin", creepage[2])});
  const auto summary = folder.json("run/summary.json");
  const auto& point = summary["models"][0]["points"][0];
  const auto number = [&](const char* name) { return point[name].get<double>(); };
  const double bound = 0.55 * 50e3, c = std::sqrt(3.79236 * 10.87295);
  // Hertz's exact semi-axes of this case.
  const auto found = reader.physical(3.79236, 10.87295, 210e3 / 2.6, bound, creepage);
  EXPECT_NEAR(found.forces[0], number("longitudinal_force"), 0.004 * bound);
  EXPECT_NEAR(found.forces[1], number("lateral_force"), 0.004 * bound);
  EXPECT_NEAR(found.forces[2], number("spin_moment"), 0.01 * bound * c);
}

TEST_F(Table, ForcesAreThoseOfTheModelHalfspace) {
  done({"table",
        folder.file("table.toml", table_case("points = [12, 2, 2]\n"
                                             "lateral_values = [0.0, 0.3, 0.6]\n"
                                             "spin_values = [0.0, 0.4, 0.8]\n"
                                             "check_points = 0\n")),
        "-o", "out", "--no-report"});
  const CreepTableReader reader(rollfem::tables::read_table((folder.work() / "out").string()));
  for (const double xi : {0.0005, 0.0015, 0.004}) expect_like_halfspace(folder, reader, {xi, 0, 0});
  // A grid point of all three.
  const double a = 3.79236, b = 10.87295, c = std::sqrt(a * b), bound = 0.55 * 50e3;
  const double stiffness = 210e3 / 2.6 * a * b / bound;
  const auto scale = reader.scale_at(a / b);
  expect_like_halfspace(folder, reader,
                        {reader.table().creepage[0][2] / (scale[0] * stiffness),
                         -0.3 / (scale[1] * stiffness), 0.4 / (scale[2] * stiffness * c)});
}

TEST_F(Table, OverLateralShiftsHasTheContactsAndItsFigures) {
  const std::string source = contents(fs::path(ROLLFEM_SOURCE_DIR) / "cases/s1002_uic60_left.toml");
  const Outcome outcome =
      done({"table", folder.file("case.toml", source), "-o", "out", "--set",
            "table.lateral_shift=[0.0,1.0,2.0]", "--set", "table.points=[2,2,3]", "--set",
            "table.check_points=10", "--set", "contact_grid.elements_across=12"});
  EXPECT_TRUE(says(outcome.out, "81 points", "3 values of lateral shift 0 to 2 mm", "radius mm",
                   "interpolation error at 10"));
  const fs::path out = folder.work() / "out";
  for (const char* name : {"table.h5", "table.csv", "shifts.csv", "interpolation.csv", "table.html",
                           "figures/table_shifts.svg", "figures/table_wheels.svg"})
    EXPECT_TRUE(fs::exists(out / name)) << name;
  const CreepTableReader reader(rollfem::tables::read_table(out.string()));
  EXPECT_EQ(reader.table().size(), 81U);
  EXPECT_EQ(reader.table().wheels.size(), 3U);
  // The radius at the case's own position (docs/track.md).
  EXPECT_NEAR(reader.wheel_at(2.0).rolling_radius, 449.82, 0.02);
}

TEST_F(Table, WrongInputIsReportedInOneLine) {
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {table_case("axis_ratio = [2.0, 1.0]\n"),
            "table.axis_ratio = [2.0, 1.0]: does not ascend"},
           {table_case("points = [1, 8, 11]\n"), "table.points"},
           {table_case("point = [8, 8, 11]\n"), "points"},
           {table_case("spin_values = [-1.0, 1.0]\n"), "table.spin_values"},
           {table_case(quick_table) + "[undeformed_distance]\nfile = \"none.csv\"\n", "none.csv"},
           {with("[rail]\n", "[rail]\npoisson_ratio = 0.4\n"), "unlike materials"},
           {with("coefficient = 0.55", "coefficient = 0.0"), "friction.coefficient = 0"}})
    refuses({"table", folder.file("case.toml", text), "-o", "out"}, said);
  EXPECT_FALSE(folder.holds("out"));
}

}  // namespace
