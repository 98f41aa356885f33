// SPDX-License-Identifier: LGPL-2.1-or-later
// The command stress on stored finite-element bodies: for any load point of a creep curve they
// equal a run with that creepage alone.
#include "support/case_examples.hpp"
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

/// Small bodies of case a.
std::string coarse_output_case(const std::string& creepages, const std::string& output) {
  return "models = [\"fem\"]\n" + small_case + "[rolling]\nlongitudinal_creepage = " + creepages +
         "\n[fem]\ncell_size = 1.9\nextent = 23\nlinear_solver = \"factorisation\"\n" + output;
}

class FemStress : public ProgramTest {
 protected:
  void run(const std::string& name, const std::string& creepages, const std::string& output) {
    const std::string file = folder.file(name + ".toml", coarse_output_case(creepages, output));
    done({"run", file, "-o", name, "-q", "--no-report"});
  }
  /// The numbers of stress.csv, row by row, from x on.
  std::vector<double> stress(const std::string& result,
                             const std::vector<std::string>& arguments) const {
    const std::string places = folder.file(
        "places.toml",
        "[[subsurface.line]]\nfrom = [-6, 1, -2]\nto = [6, 1, -2]\npoints = 25\nbody = \"rail\"\n");
    done(joined({"stress", result, "--no-figures", "--depth-profile", "--depth", "10", "--places",
                 places, "-o", "out"},
                arguments));
    return csv_numbers(folder.text("out/stress.csv"), 4);
  }
};

TEST_F(FemStress, OfTheHybridIsComputedAgainWhereNoCorrectionIsKept) {
  const std::string file = folder.file("h.toml", coarse_output_case("0.001", ""));
  done({"run", file, "-o", "h", "--model", "hybrid", "-q", "--no-report"});
  EXPECT_GT(stress("h", {}).size(), 1000U);
}

TEST_F(FemStress, AtAnyLoadPointIsThatOfARunWithItAlone) {
  const std::string all = "[output]\nbody_fields = \"all\"\n";
  run("curve", "[0.001, 0.003, 0.006]", all);
  run("first", "[0.001]", all);
  run("second", "[0.003]", all);
  const double p0 = point_of(folder, "curve")["max_pressure"];

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
    EXPECT_TRUE(folder.holds(std::string("curve/fields/fem_") + name)) << name;
}

TEST_F(FemStress, BodiesAreKeptAsTheCaseSays) {
  const std::string curve = "[0.001, 0.003]";
  run("last", curve, "[output]\nbody_fields = \"last\"\n");
  EXPECT_TRUE(folder.holds("last/fields/fem_wheel_0001.vtu"));
  EXPECT_FALSE(folder.holds("last/fields/fem_wheel_0000.vtu"));
  EXPECT_FALSE(stress("last", {}).empty());
  refuses({"stress", "last", "--point", "1"},
          "stores its bodies only for these load points: 2; do: ");
  run("none", curve, "");
  EXPECT_TRUE(folder.holds("none/fields/fem_contact_0001.vtu"));
  EXPECT_FALSE(folder.holds("none/fields/fem_wheel.vtu"));
  refuses({"stress", "none"}, "do: run the case again with [output] body_fields = \"all\"");
}

}  // namespace
