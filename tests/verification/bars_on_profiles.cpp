// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of contacts on profiles. References: grids three times as fine; the same profile with
// nine decimals for one that is rounded to four.
#include "case/reading/case_reader.hpp"
#include "profiles/formula_profiles.hpp"
#include "track/motion/placed_scenes.hpp"

#include <fmt/format.h>

#include "support/half_space_models.hpp"
#include "support/temporary_folder.hpp"

namespace {

using rollfem::testing::half_space_models;
using rollfem::testing::TemporaryFolder;

/// The first patch by the half-space.
PointResult point_of(const TemporaryFolder& folder, const std::string& text, int across = 40) {
  const contact::Case input = contact::read_case(folder.file("case.toml", text));
  contact::Scene scene = track::make_scenes(input).front().scene;
  scene.contact_grid.elements_across = across;
  return half_space_models().run("halfspace", scene, {}).points.front();
}

void expect_within_bar(const PointResult& point, const PointResult& truth, const char* name) {
  const double value = *contact::quantity_named(name).value(point);
  EXPECT_NEAR(value, *contact::quantity_named(name).value(truth), point.error_estimate.at(name))
      << name;
}

constexpr const char* s1002_wheel =
    "[friction]\ncoefficient = 0.0\n[wheel]\nrolling_radius = 460.0\nprofile = \"S1002\"\n"
    "[rolling]\nproblem = \"frictionless\"\n";

std::string shifted(double shift) {
  return fmt::format(
      "{}[load]\nvertical_force = 60e3\n[rail]\nprofile = \"60E1\"\n[track]\ninclination = "
      "\"1:40\"\n[wheelset]\nside = \"right\"\nlateral_shift = {}\nyaw = 0.003\n",
      s1002_wheel, shift);
}

std::string on_roller(double place) {
  return fmt::format(
      "{}[load]\nvertical_force = 40e3\n[rail]\nprofile = \"60E1\"\nrolling_radius = 300.0\n"
      "[placement]\nlateral_position = {}\nroll = -0.02\n",
      s1002_wheel, place);
}

/// The rail's profile at points `step` apart along it.
std::string listed(const profiles::ProfileCurve& curve, double step, int decimals) {
  std::string text;
  for (double at = curve.first(); at <= curve.last(); at += step)
    text += fmt::format("{:.{}f} {:.{}f}\n", curve.at(at).y, decimals, curve.at(at).z, decimals);
  return text;
}

profiles::ProfileCurve crown(double radius) {
  contact::ProfileSource arc;
  arc.radii = {radius};
  arc.ends = {20.0};
  arc.symmetric = true;
  return profiles::arc_profile_curve(arc, false, "");
}

}  // namespace

TEST(BarsOnProfiles, SizesOfPlacedWheelsHoldAgainstFineGrids) {
  const TemporaryFolder folder;
  for (const std::string& text :
       {shifted(-1.5), shifted(0.4), shifted(1.1), on_roller(-0.6), on_roller(0.3)}) {
    SCOPED_TRACE(text);
    const PointResult point = point_of(folder, text), fine = point_of(folder, text, 120);
    for (const char* name : {"semi_axis_x", "semi_axis_y", "max_pressure", "approach"})
      expect_within_bar(point, fine, name);
    // The value is close, not only its bar large.
    EXPECT_NEAR(point.semi_axis_x, fine.semi_axis_x, 5e-4 * fine.semi_axis_x);
  }
}

TEST(BarsOnProfiles, KnowTheRoundingOfPoints) {
  const TemporaryFolder folder;
  const auto text = [](double place) {
    return fmt::format(
        "[load]\nvertical_force = 60e3\n[friction]\ncoefficient = 0.0\n[wheel]\nrolling_radius = "
        "460.0\nprofile = \"arcs\"\n[wheel_profile]\nradii = [inf]\nends = [-40.0, 40.0]\n[rail]\n"
        "profile = \"rail.txt\"\n[placement]\nlateral_position = 0.0\nroll = {}\n[rolling]\n"
        "problem = \"frictionless\"\n",
        place);
  };
  const profiles::ProfileCurve head = profiles::find_built_in_profile("60E1")->make();
  const double middle = head.parameter_at(0.0);
  for (const profiles::ProfileCurve& curve :
       {crown(300.0), head.part(middle - 20.0, middle + 20.0)})
    for (const double roll : {0.0, 0.005, -0.011}) {
      folder.file("rail.txt", listed(curve, 0.2, 9));
      const PointResult exact = point_of(folder, text(roll));
      EXPECT_LT(exact.error_estimate.at("max_pressure"), 2e-3 * exact.max_pressure);
      for (const double step : {0.005, 0.01, 0.05}) {
        SCOPED_TRACE(fmt::format("{} mm, roll {}", step, roll));
        folder.file("rail.txt", listed(curve, step, 4));
        const PointResult rounded = point_of(folder, text(roll));
        for (const char* name : {"max_pressure", "semi_axis_x", "semi_axis_y", "approach"})
          expect_within_bar(rounded, exact, name);
      }
    }
}
