// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors of a result relative to the scale of each quantity.
#include "result/refinement.hpp"

#include "support/test.hpp"

namespace {

contact::ModelResult result() {
  contact::ModelResult made;
  contact::PointResult point;
  point.max_pressure = 500.0;
  point.semi_axis_x = 4.0;
  point.traction_coefficient = 0.02;
  point.error_estimate = {
      {"max_pressure", 1.0}, {"semi_axis_x", 0.02}, {"traction_coefficient", 0.001}};
  point.model_error = {{"max_pressure", 2.0}};
  made.points = {point, point};
  made.points[1].error_estimate["traction_coefficient"] = 0.003;
  made.points[1].model_error["traction_coefficient"] = 0.0015;
  return made;
}

TEST(Reached, IsTheWorstOfQuantitiesAndPointsByBothErrorsTogether) {
  const contact::AccuracyRequest all{0.01, {"max_pressure", "semi_axis_x", "traction_coefficient"}};
  const contact::Reached worst = reached_by(result(), all, 0.3, true);
  EXPECT_EQ(worst.quantity, "traction_coefficient");  // 1.5 % of mu; p0 0.6 %
  EXPECT_EQ(worst.point, 2);
  EXPECT_NEAR(worst.discretisation, 0.01, 1e-12);
  EXPECT_NEAR(worst.model, 0.005, 1e-12);
  EXPECT_EQ(worst.text(),
            "discretisation 1 %, model 0.5 % of mu (traction_coefficient at load point 2)");
  const contact::Reached pressure = reached_by(result(), {0.01, {"max_pressure"}}, 0.3, true);
  EXPECT_EQ(pressure.text(), "discretisation 0.2 %, model 0.4 % (max_pressure at load point 1)");
}

TEST(Reached, AMissingErrorIsUnknownUnlessTheModelIsExact) {
  contact::ModelResult made = result();
  const contact::AccuracyRequest axis{0.01, {"semi_axis_x"}};
  EXPECT_NEAR(reached_by(made, axis, 0.3, true).together(), 0.005, 1e-12);
  EXPECT_TRUE(std::isinf(reached_by(made, axis, 0.3, false).model));
  for (contact::PointResult& point : made.points) point.error_estimate.erase("semi_axis_x");
  EXPECT_TRUE(std::isinf(reached_by(made, axis, 0.3, true).discretisation));
  for (contact::PointResult& point : made.points)
    point.no_bar["semi_axis_x"] = contact::NoBar::exact;
  EXPECT_EQ(reached_by(made, axis, 0.3, true).together(), 0.0);
}

/// Chosen by auto: 0.6 % of p0 and 1.5 % of mu are its worst errors.
contact::ModelResult chosen() {
  contact::ModelResult made = result();
  made.choice = "half-space, 24 across";
  return made;
}

TEST(MissedText, CountsContactsAndNamesTheWorstOfEveryScale) {
  const contact::AccuracyRequest all{0.005,
                                     {"max_pressure", "semi_axis_x", "traction_coefficient"}};
  contact::ModelResult good = chosen(), wide = chosen();
  for (contact::PointResult& point : good.points) {
    point.error_estimate = {
        {"max_pressure", 1.0}, {"semi_axis_x", 0.0}, {"traction_coefficient", 0.0}};
    point.model_error.clear();
  }
  wide.points[0].error_estimate["semi_axis_x"] = 0.08;  // 2 % of 4 mm
  EXPECT_EQ(contact::missed_text({good, good}, all, 0.3), "");
  EXPECT_EQ(contact::missed_text({chosen(), good, wide}, all, 0.3),
            "2 of 3 contacts miss 0.5 %: worst 2 % (a), 1.5 % of mu (-F_x/F_z).");
  EXPECT_EQ(contact::missed_text({good, chosen()}, all, 0.3),
            "1 of 2 contacts misses 0.5 %: worst 0.6 % (p_0), 1.5 % of mu (-F_x/F_z).");
  EXPECT_EQ(contact::missed_text({wide}, {{}, {"semi_axis_x"}}, 0.3),
            "The result misses 1 %: worst 2 % (a).");
}

TEST(MissedText, ModelsByNameMissWhatTheyWereAskedForByTheirBarsAlone) {
  const contact::AccuracyRequest all{0.008, {"max_pressure", "traction_coefficient"}};
  contact::ModelResult named = result();
  EXPECT_EQ(contact::missed_text({named}, all, 0.3), "");
  named.shortfall = "accuracy = 0.008 was not reached";
  EXPECT_EQ(contact::missed_text({named}, all, 0.3),
            "The result misses 0.8 %: worst 1 % of mu (-F_x/F_z).");
}

TEST(MissedText, AnUnknownModelErrorIsNotMet) {
  contact::ModelResult made = chosen();
  made.notes = {{contact::about_model_error, "no result", contact::Note::warning}};
  for (contact::PointResult& point : made.points) point.model_error.clear();
  EXPECT_EQ(contact::missed_text({made}, {0.5, {"semi_axis_x"}}, 0.3),
            "The result misses 50 %: worst unknown (a).");
}

}  // namespace
