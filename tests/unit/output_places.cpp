// Results of several patches: each has its own group, rows and figures, and all say where it is.
#include "postprocess/output.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "unit/output_python.hpp"
#include "unit/output_synthetic_run.hpp"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

const std::string scripts = std::string(ROLLFEM_SOURCE_DIR) + "/postprocess";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Left wheel at `positions` positions, of which the last has two patches.
RunRecord placed_run(int positions) {
  const RunRecord plain = tests::synthetic_run();
  RunRecord run = plain;
  run.models.clear();
  run.input.wheel.profile.name = "S1002";
  run.input.rail.profile.name = "60E1";
  run.input.load.normal_force.reset();
  run.input.load.vertical_force = 50e3;
  for (int position = 1; position <= positions; ++position)
    for (int patch = 1; patch <= (position == positions ? 2 : 1); ++patch)
      for (std::size_t k = 1; k < plain.models.size(); ++k) {
        contact::ModelResult model = plain.models[k];
        contact::ContactPlace place;
        place.position = position;
        place.patch = patch;
        place.patches = position == positions ? 2 : 1;
        place.lateral_shift = position - 1.0;
        place.y_track = -755.0 - position + 30.0 * (patch - 1);
        place.z_track = patch == 1 ? 0.1 : 12.5;
        place.contact_angle = patch == 1 ? 0.016 : 1.1;
        place.rolling_radius = 450.177;
        model.place = place;
        model.bodies.clear();
        for (contact::PointResult& point : model.points) point.bodies.clear();
        run.models.push_back(model);
      }
  for (int position = 1; position <= positions; ++position) {
    PlacedPair pair;
    pair.position = position;
    for (int k = -30; k <= 30; ++k) {
      pair.rail.push_back({-760.5 + k, k * k / 300.0});
      pair.wheel.push_back({-760.0 + k, -0.1 + k / 40.0});
    }
    run.pairs.push_back(pair);
  }
  return run;
}

class PlacesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::path(::testing::TempDir()) / "rollfem_places_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    base_ = name;
  }
  void TearDown() override { fs::remove_all(base_); }

  fs::path base_;
};

TEST_F(PlacesTest, SummaryAndTablesSayWhereEveryPatchIs) {
  const fs::path folder = base_ / "result";
  write_results(folder.string(), placed_run(3));
  const auto summary = nlohmann::json::parse(read(folder / "summary.json"));
  ASSERT_EQ(summary["models"].size(), 8U);
  const auto& last = summary["models"][7];
  EXPECT_EQ(last["name"], "fem");
  EXPECT_EQ(last["place"]["wheel"], "left");
  EXPECT_EQ(last["place"]["position"], 3);
  EXPECT_EQ(last["place"]["patch"], 2);
  EXPECT_DOUBLE_EQ(last["place"]["contact_angle"], 1.1);
  EXPECT_TRUE(fs::exists(folder / "fields/fem_left_3_2_contact.vtu"));

  std::istringstream contacts(read(folder / "contacts.csv"));
  std::string head, line;
  std::getline(contacts, head);
  EXPECT_EQ(head.rfind("wheel,position [-],patch [-],patches [-],lateral_shift [mm],", 0), 0U);
  int rows = 0;
  while (std::getline(contacts, line)) {
    ++rows;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(head.begin(), head.end(), ','));
  }
  EXPECT_EQ(rows, 8 * 7);
  EXPECT_EQ(read(folder / "creep_curve.csv").rfind("wheel,position,patch,model,point,", 0), 0U);
  EXPECT_EQ(read(folder / "path_x.csv").rfind("wheel,position,patch,model,point,", 0), 0U);
}

TEST_F(PlacesTest, TwoResultsOfOnePatchAndModelAreRefused) {
  RunRecord run = placed_run(2);
  run.models.push_back(run.models.front());
  EXPECT_THROW(write_results((base_ / "result").string(), run), std::logic_error);
}

TEST_F(PlacesTest, ReportHasAFigureOfEveryPatchAndOneOfTheRow) {
  if (!tests::python_can_import("matplotlib, h5py, numpy"))
    GTEST_SKIP() << "no figures without apt install python3-matplotlib python3-h5py";
  const fs::path folder = base_ / "result";
  write_results(folder.string(), placed_run(3));
  ASSERT_EQ(make_report(folder.string(), scripts), "");
  for (const char* name : {"pair_left_1", "pair_left_3", "positions", "s1_creep_curve",
                           "s4_contact_area", "s4_oblique_px_fem"})
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(name) + ".svg"))) << name;
  EXPECT_FALSE(fs::exists(folder / "figures/pair_left_2.svg"));
  const std::string report = read(folder / "report.html");
  for (const char* text : {"Wheel profile S1002", "50000 N vertically on each wheel",
                           "Left wheel, position 3, patch 2 of 2"})
    EXPECT_NE(report.find(text), std::string::npos) << text;
}

TEST_F(PlacesTest, OnePatchIsReportedAsACaseWithRadii) {
  if (!tests::python_can_import("matplotlib, h5py, numpy"))
    GTEST_SKIP() << "no figures without apt install python3-matplotlib python3-h5py";
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
}  // namespace rollfem::postprocess
