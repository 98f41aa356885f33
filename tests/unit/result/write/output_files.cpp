// SPDX-License-Identifier: LGPL-2.1-or-later
// The files of a result hold the numbers of the record, all digits, and no NaN.
#include "result/quantities.hpp"
#include "result/write/csv.hpp"
#include "result/write/output.hpp"

#include <nlohmann/json.hpp>

#include "support/csv_rows.hpp"
#include "support/output_synthetic_run.hpp"
#include "support/temporary_folder.hpp"

namespace rollfem::result {
namespace {

double number(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

TEST(SummaryJson, HasTheDocumentedKeysAndNoOthers) {
  const auto json = nlohmann::ordered_json::parse(summary_json(synthetic_run()));
  const auto keys = [](const nlohmann::ordered_json& object) {
    std::string names;
    for (const auto& item : object.items()) names += item.key() + " ";
    return names;
  };
  EXPECT_EQ(keys(json), "format title case_file case_checksum program verdict models checksum ");
  EXPECT_EQ(json["format"], 3);
  EXPECT_EQ(keys(json["program"]), "version commit ");
  const auto& model = json["models"][1];
  EXPECT_EQ(keys(model), "name label unknowns contact_elements seconds notes points ");
  std::string scalars;
  for (const contact::Quantity& quantity : contact::quantities())
    if (!quantity.member.may_be_absent) scalars += std::string(quantity.name) + " ";
  EXPECT_EQ(keys(model["points"][0]), scalars + "error_estimate no_bar ");
}

TEST(SummaryJson, GivesEveryNumberBackToTheLastBit) {
  const RunRecord run = synthetic_run();
  const auto json = nlohmann::json::parse(summary_json(run));
  ASSERT_EQ(json["models"].size(), run.models.size());
  for (std::size_t m = 0; m < run.models.size(); ++m)
    for (std::size_t k = 0; k < run.models[m].points.size(); ++k) {
      const contact::PointResult& point = run.models[m].points[k];
      const auto& read = json["models"][m]["points"][k];
      EXPECT_EQ(read["longitudinal_creepage"].get<double>(), point.creepage.longitudinal);
      EXPECT_EQ(read["longitudinal_force"].get<double>(), point.longitudinal_force);
      EXPECT_EQ(read["normal_force"].get<double>(), point.normal_force);
      EXPECT_EQ(read["contact_area"].get<double>(), point.contact_area);
      EXPECT_EQ(read["converged"].get<bool>(), point.converged);
    }
  EXPECT_EQ(json["models"][2]["points"][3]["error_estimate"]["max_pressure"].get<double>(), 1.25);
}

TEST(CreepCurveCsv, HasOneRowPerModelAndCreepageWithTheSameNumbers) {
  const RunRecord run = synthetic_run();
  const auto rows = csv_records(creep_curve_csv(run));
  ASSERT_EQ(rows.size(), 1U + 7U + 7U);
  EXPECT_EQ(rows[0].at("model"), "hertz");
  EXPECT_EQ(rows[0].at("point"), "1");  // as people count
  EXPECT_EQ(rows[7].at("point"), "7");
  EXPECT_EQ(number(rows[4].at("traction_coefficient")),
            run.models[1].points[3].traction_coefficient);
  EXPECT_EQ(number(rows[14].at("max_pressure")), run.models[2].points[6].max_pressure);
}

TEST(PathCsv, SumsAlongTheMiddleLinesGiveTheForcePerLength) {
  const RunRecord run = synthetic_run();
  for (const Path path : {Path::x, Path::y}) {
    const auto rows = csv_records(path_csv(run, path));
    const SyntheticPatch patch;
    double sum = 0.0;
    for (const auto& row : rows)
      if (row.at("model") == "halfspace" && row.at("point") == "3")
        sum += number(row.at("pressure"));
    const contact::ContactGrid& grid = run.models[1].grid;
    const double axis = path == Path::x ? patch.a : patch.b;
    const double exact = M_PI / 2 * patch.p0 * axis;  // the integral of a semi-ellipse
    EXPECT_NEAR(sum * (path == Path::x ? grid.dx : grid.dy), exact, 0.005 * exact);
  }
}

TEST(PathCsv, LeavesCellsEmptyWhereAModelHasNoField) {
  const auto rows = csv_records(path_csv(synthetic_run(), Path::x));
  EXPECT_EQ(rows[0].at("model"), "hertz");
  EXPECT_NE(rows[20].at("pressure"), "");
  EXPECT_EQ(rows[20].at("slip_x"), "");
}

TEST(MiddleLines, AreTheNearestRowOrTheTwoEquallyNearOnes) {
  EXPECT_EQ(middle_lines(-2.0, 1.0, 5), (std::vector<int>{2}));
  EXPECT_EQ(middle_lines(-1.5, 1.0, 4), (std::vector<int>{1, 2}));
  EXPECT_EQ(middle_lines(-1.3, 1.0, 4), (std::vector<int>{1}));
  EXPECT_EQ(middle_lines(3.0, 1.0, 4), (std::vector<int>{0}));
  EXPECT_EQ(middle_lines(-9.0, 1.0, 4), (std::vector<int>{3}));
  EXPECT_EQ(middle_lines(0.5, 1.0, 4), (std::vector<int>{0}));
  EXPECT_TRUE(middle_lines(0.0, 1.0, 0).empty());
}

/// The text of the logic_error with which a record is refused, empty when it is not.
std::string refused(const RunRecord& run) {
  const TemporaryFolder folder;
  const std::string result = folder.path("result");
  const std::string text = refusal<std::logic_error>([&] { write_results(result, run); });
  EXPECT_EQ(std::filesystem::exists(result), text.empty());
  return text;
}

using Change = std::function<void(std::vector<contact::ModelResult>&)>;

TEST(WriteResults, RefusesAndNamesNonFiniteValuesWrongSizesAndBadFileNames) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [change, named] : std::vector<std::pair<Change, const char*>>{
           {[&](auto& m) { m[1].points[2].max_pressure = nan; },
            "halfspace/points/0002/max_pressure"},
           {[&](auto& m) { m[2].points[0].fields.slip.x[17] = contact::infinity; },
            "fem/points/0000/slip_x[0]"},
           {[&](auto& m) {
              m[2].points[5].bodies[0].stress[4][2] = std::numeric_limits<float>::quiet_NaN();
            },
            "fem/points/0005/bodies/wheel/stress[4]"},
           {[&](auto& m) { m[2].points[5].bodies[1].displacement.pop_back(); },
            "fem/points/0005/bodies/rail/displacement has 33 values, its places 36"},
           {[&](auto& m) { m[2].bodies[0].points[1][0] = nan; }, "fem/bodies/wheel/points[1]"},
           {[&](auto& m) { m[0].points[0].error_estimate["approach"] = nan; },
            "hertz/points/0000/error_estimate/approach"},
           {[&](auto& m) { m[1].points[0].fields.gap.conservativeResize(5); },
            "halfspace/points/0000/gap"},
           {[&](auto& m) { m[1].name = "../halfspace"; }, "model name"},
           {[&](auto& m) { m[1].name = "fem"; }, "twice"}}) {
    RunRecord run = synthetic_run();
    change(run.models);
    EXPECT_TRUE(says(refused(run), named));
  }
  EXPECT_EQ(refused(synthetic_run()), "");
}

}  // namespace
}  // namespace rollfem::result
