// SPDX-License-Identifier: LGPL-2.1-or-later
// The command stress on contacts that the shakedown map once took for others: lines, which have no
// ellipse, and narrow patches.
#include "support/program.hpp"

namespace {

using nlohmann::json;

class ShakedownOfStored : public ProgramTest {};

TEST_F(ShakedownOfStored, BelowALineContactItIsPlaneStrain) {
  // Norton, Machine Design, example 7-2: 484.31 MPa, half width 1.3157 mm; one mm of its width.
  const std::string steel = "young_modulus = 206843.0\npoisson_ratio = 0.28\n";
  const std::string line =
      folder.file("line.toml",
                  "models = [\"halfspace\", \"hertz\"]\n[geometry]\nshape = \"line\"\n[load]\n"
                  "max_pressure = 484.31\n[friction]\ncoefficient = 0.0\n[wheel]\n"
                  "rolling_radius = 152.4\n" +
                      steel + "[rail]\n" + steel);
  done({"run", line, "-o", "r", "-q", "--no-report"});
  for (const char* model : {"halfspace", "hertz"}) {
    SCOPED_TRACE(model);
    const Outcome outcome = checked(
        call({"stress", "r", "--no-figures", "--model", model, "--yield-shear-stress", "131"}));
    EXPECT_TRUE(says(outcome.out, "limit of p0/k of the line contact"));
    const json data = folder.json("r_stress/stress.json")["models"][0];
    for (const json& maximum : data["maxima"]) {
      const double over = maximum["over_max_pressure"];
      if (maximum["measure"] == "tresca") {
        EXPECT_NEAR(over, 0.6006, 2e-3);
        EXPECT_NEAR(std::abs(maximum["place"][2].get<double>()), 0.786 * 1.3157, 0.02);
      }
    }
    const json& point = data["shakedown"][0];
    EXPECT_NEAR(point["ellipse"]["shakedown"].get<double>(), 4.0, 4e-3);
    EXPECT_TRUE(point["ellipse"]["ratio"].is_null());
    EXPECT_EQ(point["verdict"], "elastic shakedown");
  }
}

TEST_F(ShakedownOfStored, NarrowPatchesYieldAtEveryPassage) {
  // b/a = 0.2, p0 = 9 k: the elastic stress itself goes from 0 to 3 times the yield value.
  const std::string narrow = folder.file(
      "narrow.toml",
      "models = [\"halfspace\"]\n[given_pressure]\nsemi_axis_x = 5.0\nsemi_axis_y = 1.0\n"
      "max_pressure = 2520.0\n[friction]\ncoefficient = 0.0\n");
  done({"run", narrow, "-o", "r", "-q", "--no-report"});
  checked(call({"stress", "r", "--no-figures", "--yield-shear-stress", "280"}));
  const json point = folder.json("r_stress/stress.json")["models"][0]["shakedown"][0];
  EXPECT_NEAR(point["ellipse"]["shakedown"].get<double>(), 5.75, 0.05);
  EXPECT_GT(point["yield_ratio"], 2.0);
  EXPECT_EQ(point["verdict"], "beyond shakedown");
}

}  // namespace
