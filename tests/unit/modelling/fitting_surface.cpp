// SPDX-License-Identifier: LGPL-2.1-or-later
// halfspace.surface = "auto" on a worn wheel whose contacts at tread and root, 0.38 rad apart, grow
// into each other on a coarse grid: it takes the common surface there, and only there.
#include "case/reading/case_reader.hpp"
#include "halfspace/halfspace_models.hpp"
#include "modelling/registry.hpp"
#include "modelling/solving/solving.hpp"
#include "result/quantities.hpp"

#include "support/case_examples.hpp"
#include "support/profile_texts.hpp"

namespace {

/// S1002 worn by 0.5 mm from the root to the field side, less by 0.2 mm around y = -22.
std::string worn_wheel() {
  Points points = points_of("S1002");
  for (auto& [y, z] : points)
    z += 0.2 * std::exp(-std::pow((y + 22.0) / 5.0, 2)) - 0.5 / (1.0 + std::exp(-(y + 33.4)));
  return columns(points);
}

class FittingSurface : public ::testing::TestWithParam<const char*> {
 protected:
  FittingSurface() {
    folder_.file("worn.txt", worn_wheel());
    models_.add(halfspace::models().at("halfspace"));
  }

  /// Shifts towards the flange of the wheel.
  result::RunRecord solve(const std::vector<double>& shifts, const std::string& surface,
                          bool go_on = false) {
    std::string list;
    const bool left = GetParam() == std::string("left");
    for (const double shift : shifts)
      list += (list.empty() ? "" : ", ") + std::to_string(left ? -shift : shift);
    const std::string text =
        edited("models = [\"halfspace\"]\n" + wheel_on_rail,
               {"wheel.profile=\"worn.txt\"", "wheel.rolling_radius=460.0", "rail.profile=60E1",
                "friction.coefficient=0.3", "wheelset.side=" + std::string(GetParam()),
                "wheelset.lateral_shift=[" + list + "]", "wheelset.roll=0.0",
                "contact_grid.elements_across=10", "halfspace.surface=" + surface});
    result::RunRecord record;
    record.input =
        contact::parse_case(text, folder_.path("case.toml"), modelling::known_names(models_));
    modelling::Solving how;
    how.models = &models_;
    how.go_on = go_on;
    missing_ = modelling::solve(record, how);
    return record;
  }

  static bool notes_the_surface(const contact::ModelResult& result) {
    return result.note_about("surface") != nullptr;
  }

  TemporaryFolder folder_;
  contact::ModelRegistry models_;
  std::vector<result::MissingModel> missing_;
};

constexpr double both_touch = 5.87;  // mm

TEST_P(FittingSurface, IsTheCommonOneWherePlanesDoNotFit) {
  EXPECT_TRUE(says(refusal<contact::ConformalContact>([&] { solve({both_touch}, "planar"); }),
                   "another contact of the same wheel begins", "halfspace.surface = \"curved\""));
  const auto chosen = solve({both_touch}, "auto"), curved = solve({both_touch}, "curved");
  ASSERT_EQ(chosen.models.size(), 1U);
  EXPECT_TRUE(notes_the_surface(chosen.models[0]));
  EXPECT_FALSE(notes_the_surface(curved.models[0]));
  const contact::PointResult &here = chosen.models[0].points[0],
                             &there = curved.models[0].points[0];
  for (const char* name : {"normal_force", "lateral_force_track", "max_pressure", "loaded_height"})
    EXPECT_EQ(contact::quantity(here, name), contact::quantity(there, name)) << name;
  // It carries the load, and its rows say where the profiles wear.
  EXPECT_NEAR(*here.vertical_force, 100e3, 1e-3);
  EXPECT_GT(*here.max_pass_work, 0.0);
  EXPECT_EQ(chosen.models[0].rows.y_wheel.size(), chosen.models[0].grid.ny);
}

TEST_P(FittingSurface, OtherPositionsKeepTheirs) {
  const auto sweep = solve({1.0, both_touch}, "auto"), alone = solve({1.0}, "auto");
  ASSERT_EQ(sweep.models.size(), 2U);
  EXPECT_FALSE(notes_the_surface(sweep.models[0]));
  EXPECT_TRUE(notes_the_surface(sweep.models[1]));
  EXPECT_EQ(sweep.models[1].place->position, 2);
  for (const char* name : {"normal_force", "lateral_force_track", "max_pressure", "loaded_height"})
    EXPECT_EQ(contact::quantity(sweep.models[0].points[0], name),
              contact::quantity(alone.models[0].points[0], name))
        << name;
}

TEST_P(FittingSurface, IsAlsoFoundWhereFailuresAreListed) {
  EXPECT_TRUE(notes_the_surface(solve({both_touch}, "auto", true).models.at(0)));
  EXPECT_TRUE(missing_.empty());
}

INSTANTIATE_TEST_SUITE_P(Sides, FittingSurface, ::testing::Values("left", "right"),
                         [](const auto& side) { return std::string(side.param); });

}  // namespace
