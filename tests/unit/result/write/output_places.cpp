// SPDX-License-Identifier: LGPL-2.1-or-later
// Results of several patches: each has its own group, rows and figures, and all say where it is.
#include "result/write/output.hpp"

#include <nlohmann/json.hpp>

#include "support/output_in_folder.hpp"
#include "support/output_placed_run.hpp"
#include "support/output_python.hpp"

namespace fs = std::filesystem;

namespace rollfem::result {
namespace {

class PlacesTest : public InFolder {
 protected:
};

TEST_F(PlacesTest, SummaryAndTablesSayWhereEveryPatchIs) {
  const fs::path folder = base_ / "result";
  write_results(folder.string(), placed_run(3));
  const auto summary = nlohmann::json::parse(contents(folder / "summary.json"));
  ASSERT_EQ(summary["models"].size(), 8U);
  const auto& last = summary["models"][7];
  EXPECT_EQ(last["name"], "fem");
  EXPECT_EQ(last["place"]["wheel"], "left");
  EXPECT_EQ(last["place"]["position"], 3);
  EXPECT_EQ(last["place"]["patch"], 2);
  EXPECT_DOUBLE_EQ(last["place"]["contact_angle"], 1.1);
  EXPECT_TRUE(fs::exists(folder / "fields/fem_left_3_2_contact.vtu"));

  std::istringstream contacts(contents(folder / "contacts.csv"));
  std::string head, line;
  std::getline(contacts, head);
  EXPECT_EQ(head.rfind("wheel,position [-],patch [-],patches [-],lateral_shift [mm],", 0), 0U);
  int rows = 0;
  while (std::getline(contacts, line)) {
    ++rows;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(head.begin(), head.end(), ','));
  }
  EXPECT_EQ(rows, 8 * 7);
  EXPECT_EQ(contents(folder / "creep_curve.csv").rfind("wheel,position,patch,model,point,", 0), 0U);
  EXPECT_EQ(contents(folder / "path_x.csv").rfind("wheel,position,patch,model,point,", 0), 0U);
}

TEST_F(PlacesTest, TwoResultsOfOnePatchAndModelAreRefused) {
  RunRecord run = placed_run(2);
  run.models.push_back(run.models.front());
  EXPECT_THROW(write_results((base_ / "result").string(), run), std::logic_error);
}

TEST_F(PlacesTest, ReportHasAFigureOfEveryPatchAndOneOfTheRow) {
  if (!python_can_import("h5py, numpy"))
    GTEST_SKIP() << "no figures without apt install python3-numpy python3-h5py";
  const fs::path folder = base_ / "result";
  write_results(folder.string(), placed_run(3));
  ASSERT_EQ(make_report(folder.string(), scripts), "");
  for (const char* name : {"pair_left_1", "pair_left_3", "positions", "s1_creep_curve",
                           "s4_contact_area", "s4_oblique_px_fem"})
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(name) + ".svg"))) << name;
  EXPECT_FALSE(fs::exists(folder / "figures/pair_left_2.svg"));
  const std::string report = contents(folder / "report.html");
  EXPECT_TRUE(says(report, "Wheel profile S1002", "50000 N vertically on each wheel",
                   "Left wheel, position 3, patch 2 of 2"));
}

TEST_F(PlacesTest, OnePatchIsReportedAsACaseWithRadii) {
  if (!python_can_import("h5py, numpy"))
    GTEST_SKIP() << "no figures without apt install python3-numpy python3-h5py";
  RunRecord run = placed_run(1);
  run.models.resize(2);
  const fs::path folder = base_ / "result";
  write_results(folder.string(), run);
  ASSERT_EQ(make_report(folder.string(), scripts), "");
  EXPECT_TRUE(fs::exists(folder / "figures/contact_area.svg"));
  EXPECT_TRUE(fs::exists(folder / "figures/pair_left_1.svg"));
  EXPECT_FALSE(fs::exists(folder / "figures/positions.svg"));
}

}  // namespace
}  // namespace rollfem::result
