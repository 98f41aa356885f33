// SPDX-License-Identifier: LGPL-2.1-or-later
// The dip of wheels whose ways are two straight lines: the angle is the sum of both slopes.
#include "result/write/contents.hpp"
#include "result/write/wheelset_rows.hpp"

#include "support/test.hpp"

namespace rollfem::result {
namespace {

/// Both wheels over positions out of order, each down to 3 mm at 40 mm: the left one on slopes of 4
/// and 9 mrad, the right one on 2 and 5 mrad.
RunRecord two_lines(const std::vector<double>& along) {
  RunRecord run;
  run.input.wheelset.track_position = along;
  run.input.wheelset.lateral_shift.assign(along.size(), 0.0);
  for (std::size_t p = 0; p < along.size(); ++p)
    for (const auto& [left, fall, rise] :
         {std::tuple{true, 4e-3, 9e-3}, std::tuple{false, 2e-3, 5e-3}}) {
      contact::ModelResult& model = run.models.emplace_back();
      model.name = "halfspace";
      model.place.emplace();
      model.place->left = left;
      model.place->position = static_cast<int>(p) + 1;
      const double way = along[p] - 40.0;
      model.points.emplace_back().loaded_height = 3.0 - (way < 0.0 ? -fall : rise) * way;
    }
  return run;
}

TEST(WheelDips, AreTheFallAndTheRiseOfTwoStraightLinesOnBothSides) {
  const std::vector<WheelDip> dips = wheel_dips(two_lines({70.0, 10.0, 40.0, 55.0, -20.0}));
  ASSERT_EQ(dips.size(), 2U);
  for (const WheelDip& dip : dips) {
    EXPECT_EQ(dip.model, "halfspace");
    EXPECT_DOUBLE_EQ(dip.track_position, 40.0);
    EXPECT_DOUBLE_EQ(dip.loaded_height, 3.0);
  }
  EXPECT_EQ(dips[0].wheel, "left");
  EXPECT_NEAR(dips[0].dip_angle, 13e-3, 1e-15);
  EXPECT_EQ(dips[1].wheel, "right");
  EXPECT_NEAR(dips[1].dip_angle, 7e-3, 1e-15);
}

TEST(WheelDips, NeedALowestPlaceInsideTheWay) {
  for (const std::vector<double>& along :
       {std::vector<double>{}, {10.0, 40.0}, {40.0, 50.0, 60.0}, {0.0, 20.0, 40.0}})
    EXPECT_TRUE(dips_tree(two_lines(along)).parts.empty());
  EXPECT_EQ(dips_tree(two_lines({0.0, 40.0, 60.0})).parts.size(), 1U);
}

}  // namespace
}  // namespace rollfem::result
