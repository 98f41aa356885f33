// SPDX-License-Identifier: LGPL-2.1-or-later
// `auto` on the contacts of a wheelset, with real half-spaces and a stand-in for finite elements:
// one model for all of them.
#include "case/reading/case_reader.hpp"
#include "halfspace/halfspace_models.hpp"
#include "models/registry.hpp"
#include "models/solving/auto_model.hpp"
#include "models/solving/solving.hpp"
#include "result/quantities.hpp"

#include "support/case_examples.hpp"
#include "support/temporary_folder.hpp"

namespace {

/// Half-spaces that count as finite bodies.
contact::ModelInfo bodies() {
  contact::ModelInfo model = contact::ModelInfo{"bodies", "bodies", "a stand-in"};
  model.takes = halfspace::models().at("halfspace").takes;
  model.run = [](const contact::ModelInput& input, const contact::Progress& progress,
                 contact::Checkpoint* checkpoint) {
    contact::ModelResult result = halfspace::models().run("halfspace", input, progress, checkpoint);
    result.name = "bodies";
    return result;
  };
  model.choosable = contact::Choosable::finite_bodies;
  model.parallel = true;
  return model;
}

/// The right wheel: on its tread in the middle of the track (a model error of 0.4 % of mu), near
/// its flange root at 6 mm (1.6 % of the width).
result::RunRecord solve(const std::string& shifts, const std::string& head) {
  contact::ModelRegistry models;
  models.add(modelling::auto_model()).add(halfspace::models().at("halfspace")).add(bodies());
  result::RunRecord record;
  record.input = contact::parse_case(
      head + edited(two_positions, {"wheelset.side=right", "wheelset.lateral_shift=" + shifts}),
      "a.toml", modelling::known_names(models));
  modelling::Solving how;
  how.models = &models;
  modelling::solve(record, how);
  return record;
}

TEST(AutoOfRuns, OneContactThatNeedsAnotherModelChangesTheModelOfAll) {
  const std::string asked = "models = [\"auto\"]\naccuracy = 0.01\n";
  ASSERT_EQ(solve("[2.0]", asked).models.at(0).name, "halfspace");
  ASSERT_EQ(solve("[6.0]", asked).models.at(0).name, "bodies");
  const result::RunRecord both = solve("[2.0, 6.0]", asked);
  ASSERT_EQ(both.models.size(), 2U);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(both.models[k].name, "bodies");
    EXPECT_EQ(both.models[k].label, "bodies");
    EXPECT_EQ(both.models[k].place->position, k + 1);
    EXPECT_EQ(both.models[k].notes.front(), both.models[0].notes.front());
    EXPECT_EQ(both.models[k].shortfall, "");
  }
  EXPECT_EQ(both.verdict, "");
}

TEST(AutoOfRuns, WithoutTimeForAllOfThemAllKeepTheHalfSpaceAndTheRunSaysSo) {
  const result::RunRecord some = solve("[2.0, 6.0, 2.0, 2.0, 2.0, 6.0]", "models = [\"auto\"]\n");
  ASSERT_EQ(some.models.size(), 6U);
  for (const contact::ModelResult& result : some.models) EXPECT_EQ(result.name, "halfspace");
  EXPECT_TRUE(says(some.verdict, "2 of 6 contacts miss 1 %: worst ", "(b)",
                   "`--set accuracy=0.01` allows more time: finite elements would take about"));
  for (const char* name : {"max_pressure", "traction_coefficient", "semi_axis_y"})
    EXPECT_EQ(contact::quantity(some.models[0].points[0], name),
              contact::quantity(some.models[4].points[0], name));
}

}  // namespace
