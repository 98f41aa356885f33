// SPDX-License-Identifier: LGPL-2.1-or-later
// Which records are written, and by whom. The files themselves: tests/cli/test_results.py.
#include "result/files/result_folder.hpp"
#include "result/write/csv.hpp"
#include "result/write/output.hpp"
#include "result/write/vtu.hpp"

#include "support/small_run.hpp"
#include "support/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

TEST(ResultFiles, OfNumbersThatAreNotFiniteSizesThatDoNotFitAndBadNamesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Change = std::function<void(std::vector<contact::ModelResult>&)>;
  for (const auto& [change, named] : std::vector<std::pair<Change, std::string>>{
           {[](auto&) {}, ""},
           {[&](auto& m) { m[0].points[1].max_pressure = nan; },
            "halfspace/points/0001/max_pressure"},
           {[&](auto& m) { m[1].points[0].fields.slip.x[5] = contact::infinity; },
            "fem/points/0000/slip_x[1]"},
           {[&](auto& m) {
              m[1].points[1].bodies[0].stress[4][2] = std::numeric_limits<float>::quiet_NaN();
            },
            "fem/points/0001/bodies/wheel/stress[4]"},
           {[&](auto& m) { m[1].points[1].bodies[1].displacement.pop_back(); },
            "fem/points/0001/bodies/rail/displacement has 21 values, its places 24"},
           {[&](auto& m) { m[1].bodies[0].points[1][0] = nan; }, "fem/bodies/wheel/points[1]"},
           {[&](auto& m) { m[0].points[0].error_estimate["approach"] = nan; },
            "halfspace/points/0000/error_estimate/approach"},
           {[&](auto& m) { m[0].points[0].fields.gap.conservativeResize(5); },
            "halfspace/points/0000/gap"},
           {[&](auto& m) { m[0].name = "../halfspace"; }, "model name"},
           {[&](auto& m) { m[0].name = "fem"; }, "twice"}}) {
    RunRecord run = small_run();
    change(run.models);
    const TemporaryFolder folder;
    const std::string said =
        refusal<std::logic_error>([&] { write_results(folder.path("result"), run); });
    EXPECT_EQ(said.empty(), named.empty());
    EXPECT_TRUE(says(said, named));
    EXPECT_EQ(fs::exists(folder.path("result")), named.empty());
  }
}

TEST(ResultFiles, AreOnlyThoseThatAnotherResultReplaces) {
  const TemporaryFolder base;
  ResultFolder folder(base.path("result"));
  for (const char* name :
       {"later.csv", "figures/later.png", "fields/later.csv", "other/path_x.csv"})
    EXPECT_THROW(folder.write(name, "text"), std::logic_error) << name;
  EXPECT_NO_THROW(folder.write("pass_work.csv", "text"));
}

TEST(ResultFiles, AreThereOfARunWithoutModelsPointsOrFields) {
  RunRecord run;
  EXPECT_GT(results_hdf5(run).size(), 500U);
  run.models.resize(1);
  run.models[0].name = "empty";
  EXPECT_GT(results_hdf5(run).size(), 500U);
  run.models[0].points.resize(1);
  EXPECT_GT(results_hdf5(run).size(), 500U);
}

TEST(MiddleLines, AreTheNearestRowOrTheTwoEquallyNearOnes) {
  EXPECT_EQ(middle_lines(-2.0, 1.0, 5), (std::vector<int>{2}));
  EXPECT_EQ(middle_lines(-1.5, 1.0, 4), (std::vector<int>{1, 2}));
  EXPECT_EQ(middle_lines(-1.3, 1.0, 4), (std::vector<int>{1}));
  EXPECT_EQ(middle_lines(3.0, 1.0, 4), (std::vector<int>{0}));
  EXPECT_EQ(middle_lines(-9.0, 1.0, 4), (std::vector<int>{3}));
  EXPECT_TRUE(middle_lines(0.0, 1.0, 0).empty());
}

TEST(Series, IsOrderedByNumberWhereCreepagesRepeat) {
  std::vector<contact::PointResult> points(3);
  points[1].creepage.longitudinal = -0.001;
  points[2].creepage.longitudinal = 0.002;
  EXPECT_EQ(series_times(points), (std::vector<double>{0.0, -0.001, 0.002}));
  points[2].creepage.longitudinal = 0.0;
  points[2].creepage.lateral = 0.001;
  EXPECT_EQ(series_times(points), (std::vector<double>{0.0, 1.0, 2.0}));
}

}  // namespace
}  // namespace rollfem::result
