// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts on the built-in rails: a cylinder on their crowns against Hertz, and S1002.
#include "support/csv_rows.hpp"
#include "support/program.hpp"

namespace {

using Record = std::map<std::string, std::string>;

double number(const Record& record, const std::string& heading) {
  return std::stod(record.at(heading));
}

class StandardRailContacts : public ProgramTest {
 protected:
  std::vector<Record> records(const std::string& text, const std::string& table) {
    done({"run", folder.file("case.toml", text), "-o", "out", "--no-report"});
    return csv_records(folder.text("out/" + table), false);
  }

  /// The left and the right contact on a rail of this name.
  std::vector<Record> contacts(const std::string& rail, const std::string& inclination,
                               const std::string& wheel) {
    return records(
        "[load]\nvertical_force = 10e3\n[friction]\ncoefficient = 0.3\n[rail]\nprofile = \"" +
            rail + "\"\n[track]\ninclination = \"" + inclination +
            "\"\n[wheelset]\nside = \"both\"\n[rolling]\nlongitudinal_creepage = 0.001\n[wheel]\n"
            "rolling_radius = 460.0\nprofile = " +
            wheel,
        "contacts.csv");
  }
};

/// The band of the crown's radius is wider than the patch.
TEST_F(StandardRailContacts, ACylinderOnTheCrownIsHertzs) {
  for (const auto& [rail, radius] :
       {std::pair{"60E2", "200.0"}, {"54E1", "300.0"}, {"56E1", "305.0"}}) {
    SCOPED_TRACE(rail);
    const auto found =
        contacts(rail, "none", "\"arcs\"\n[wheel_profile]\nradii = [inf]\nends = [-60.0, 60.0]\n");
    ASSERT_EQ(found.size(), 2u);
    const Record hertz =
        records(
            "models = [\"hertz\"]\n[load]\nnormal_force = 10e3\n[friction]\ncoefficient = 0.3\n"
            "[wheel]\nrolling_radius = 460.0\ntransverse_radius = inf\n[rail]\n"
            "transverse_radius = " +
                std::string(radius) + "\n[rolling]\nlongitudinal_creepage = 0.001\n",
            "creep_curve.csv")
            .front();
    for (const Record& contact : found) {
      EXPECT_NEAR(number(contact, "y_rail [mm]"), 0.0, 1e-9);
      EXPECT_NEAR(number(contact, "max_pressure [MPa]"), number(hertz, "max_pressure [MPa]"),
                  number(contact, "error_estimate max_pressure [MPa]"));
      for (const char* size : {"contact_length [mm]", "contact_width [mm]"})
        EXPECT_NEAR(number(contact, size), number(hertz, size),
                    number(contact, std::string("error_estimate ") + size))
            << size;
    }
  }
}

TEST_F(StandardRailContacts, S1002TouchesLeftAndRightAlikeWithinOnePercent) {
  for (const char* rail : {"60E2", "54E1", "56E1"}) {
    SCOPED_TRACE(rail);
    const auto found = contacts(rail, "1:40", "\"S1002\"\n");
    ASSERT_EQ(found.size(), 2u);
    const auto both = [&](const std::string& heading) {
      return std::pair{number(found[0], heading), number(found[1], heading)};
    };
    for (const char* heading :
         {"y_rail [mm]", "y_wheel [mm]", "max_pressure [MPa]", "longitudinal_force [N]"}) {
      const auto [left, right] = both(heading);
      EXPECT_NEAR(left, right, 1e-6 * (1.0 + std::abs(left))) << heading;
    }
    const auto [left, right] = both("lateral_force [N]");
    EXPECT_NEAR(left, -right, 1e-3);
    EXPECT_LT(number(found[0], "error_estimate max_pressure [MPa]"),
              0.01 * number(found[0], "max_pressure [MPa]"));
  }
}

}  // namespace
