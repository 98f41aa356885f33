// SPDX-License-Identifier: LGPL-2.1-or-later
// The page of the command stress, and several load points in one call.
#include "support/case_examples.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;

/// Of a half-space on a narrow patch at three creepages.
class StressPage : public ProgramTest {
 protected:
  void SetUp() override {
    const std::string text =
        "models = [\"halfspace\"]\n" + rolling("[0.0, 0.002, 0.006]", 16, with("2000.0", "100.0"));
    done({"run", folder.file("case.toml", text), "-o", "r", "-q", "--no-report"});
  }
  std::string point_file() const {
    return folder.file("point.toml", "[[subsurface.point]]\nat = [0, 0, -2]\nbody = \"rail\"\n");
  }
  json stored() const { return folder.json("r_stress/stress.json"); }
};

TEST_F(StressPage, HasFiguresAndOneVerdict) {
  const Outcome outcome =
      done({"stress", "r", "--yield-shear-stress", "250", "--depth-profile", "--places",
            folder.file("places.toml",
                        "[[subsurface.line]]\nfrom = [-3, 0, -1]\nto = [3, 0, -1]\n"
                        "points = 21\nbody = \"rail\"\n"
                        "[[subsurface.plane]]\nfrom = [-3, 0, 0]\nto = [3, 0, 0]\n"
                        "across = [-3, 0, -4]\npoints = [21, 11]\nbody = \"rail\"\n")});
  if (outcome.err.find("figures need") != std::string::npos)
    GTEST_SKIP() << "needs apt install python3-numpy python3-h5py";
  EXPECT_EQ(outcome.err, "");
  for (const char* name :
       {"depth_centre", "line_1_rail", "plane_1_rail_halfspace", "shakedown_map"})
    EXPECT_GT(folder.text("r_stress/figures/" + std::string(name) + ".svg").size(), 5000U) << name;
  const std::string page = folder.text("r_stress/stress.html");
  EXPECT_TRUE(says(page, "Largest stresses", "half-space, ", "Shakedown, k = 250.0 MPa", "<figure>",
                   "aria-label=\"Shakedown map"));
  // Figures that a later call does not draw are removed.
  done({"stress", "r", "--no-figures", "--places", point_file()});
  EXPECT_FALSE(folder.holds("r_stress/figures/shakedown_map.svg"));
  EXPECT_FALSE(folder.holds("r_stress/stress.html"));
}

TEST_F(StressPage, SeveralLoadPointsAreThoseOfSingleCalls) {
  const auto ask = [&](const std::vector<std::string>& more) {
    return done(joined({"stress", "r", "--no-figures", "--places", point_file()}, more)).out;
  };
  ask({"--creepage", "0.002"});
  const json alone = stored()["models"][0];
  const std::string table =
      ask({"--creepage", "0,0.002,0.002", "--yield-shear-stress", "300"});  // twice is once
  const json both = stored()["models"];
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0]["point"], 1);
  EXPECT_EQ(both[1]["point"], 2);
  EXPECT_EQ(both[1]["sets"], alone["sets"]);
  EXPECT_EQ(both[1]["maxima"], alone["maxima"]);
  EXPECT_NE(both[0]["sets"], alone["sets"]);
  // One map for both, with what is known of either.
  EXPECT_EQ(table.find("shakedown map"), table.rfind("shakedown map"));
  const json& map = both[0]["shakedown"];
  EXPECT_EQ(map, both[1]["shakedown"]);
  EXPECT_TRUE(map[0].contains("yield_ratio") && map[1].contains("yield_ratio"));
  EXPECT_FALSE(map[2].contains("yield_ratio"));
  ask({"--point", "3,1"});
  EXPECT_EQ(stored()["models"][0]["point"], 3);
}

/// Pressure on a curved patch acts across as well, here with 0.9 % of the load.
TEST_F(StressPage, TangentialForceOfACurvedPatchIsThatOfFrictionAlone) {
  const std::string text =
      "models = [\"halfspace\"]\n[load]\nvertical_force = 60e3\n[friction]\ncoefficient = 0.01\n"
      "[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n[rail]\nprofile = \"UIC60\"\n[track]\n"
      "gauge = 1435.0\ninclination = \"1:40\"\n[wheelset]\nside = \"left\"\nroll = 0.0\n"
      "flange_back_distance = 1360.0\nlateral_shift = -5.0\n[contact_grid]\nelements_across = 12\n"
      "[halfspace]\nsurface = \"curved\"\n";
  done({"run", folder.file("curved.toml", text), "-o", "curved", "-q", "--no-report"});
  done({"stress", "curved", "--no-figures", "--yield-strength", "520"});
  const json found = folder.json("curved_stress/stress.json")["models"][0]["shakedown"];
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LE(found[0]["tangential_coefficient"].get<double>(), 0.01 * 1.001);
}

}  // namespace
