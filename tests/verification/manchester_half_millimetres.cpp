// The Manchester benchmark between whole millimetres of shift, both wheels, against CONTACT's
// shipped results: the left wheel's of open version r2707, the right one's of r2447
// (github.com/eve70a/CONTACT, examples/mbench_a22_left.ref_out and mbench_a22_right.ref_out).
#include "halfspace/model/model.hpp"
#include "track/balance/balance.hpp"

#include <gtest/gtest.h>

#include "support/manchester.hpp"
#include <cmath>
#include <vector>

namespace {

using namespace rollfem;

/// Columns of CONTACT's output: mm, rad, N; friction along and across over mu F_n; MPa. Its
/// longitudinal creepage and force along are minus ours.
struct Row {
  double shift, y_track, angle, normal_force, along, across, approach, max_pressure;
  double cksi, ceta, cphi;
};

const std::vector<Row> left_rows{
    {0.5, -754.2092, 0.0211, 10050, 0.2942, -0.7860, 1.859e-2, 395.3, -3.708e-4, 1.200e-3,
     -4.592e-5},
    {1.5, -755.9669, 0.0152, 10050, 0.2127, -0.9763, 2.007e-2, 446.5, -7.530e-4, 3.599e-3,
     -3.330e-5},
    {2.5, -756.9177, 0.0121, 10040, 0.1634, -0.9863, 2.094e-2, 483.1, -9.792e-4, 5.998e-3,
     -2.655e-5},
    {3.5, -757.4801, 0.0102, 10030, 0.1472, -0.9890, 2.158e-2, 513.4, -1.241e-3, 8.395e-3,
     -2.263e-5},
    {4.5, -757.7990, 0.0091, 10030, 0.1465, -0.9892, 2.209e-2, 540.2, -1.591e-3, 1.079e-2,
     -2.049e-5},
    {5.5, -757.9746, 0.0085, 10020, 0.3106, -0.9505, 2.255e-2, 565.8, -4.292e-3, 1.317e-2,
     -1.959e-5},
    {6.5, -758.6243, 0.0064, 10010, 0.7524, -0.6587, 2.369e-2, 637.0, -1.764e-2, 1.546e-2,
     -2.319e-5},
    {7.5, -758.4440, 0.0070, 10010, 0.7748, -0.6322, 2.438e-2, 685.9, -2.180e-2, 1.781e-2,
     -3.146e-5},
    {8.5, -757.9681, 0.0086, 10020, 0.7605, -0.6493, 2.474e-2, 714.0, -2.360e-2, 2.017e-2,
     -3.864e-5},
    {9.5, -757.4008, 0.0105, 10020, 0.7407, -0.6718, 2.501e-2, 735.2, -2.482e-2, 2.253e-2,
     -4.549e-5},
};

const std::vector<Row> right_rows{
    {0.5, 744.5026, 0.0568, 9870, -0.2972, -0.8711, 1.948e-2, 632.5, 4.948e-4, 1.202e-3, 1.233e-4},
    {1.5, 741.3771, 0.0753, 9811, -0.2106, -0.9774, 2.489e-2, 754.1, 7.903e-4, 3.612e-3, 1.633e-4},
    {2.5, 740.4620, 0.0862, 9787, -0.1554, -0.9878, 2.461e-2, 730.4, 9.607e-4, 6.025e-3, 1.866e-4},
    {3.5, 739.4071, 0.0994, 9760, -0.1342, -0.9909, 2.410e-2, 691.6, 1.154e-3, 8.447e-3, 2.150e-4},
    {4.5, 737.8905, 0.1185, 9726, -0.1291, -0.9915, 2.310e-2, 625.5, 1.430e-3, 1.088e-2, 2.559e-4},
    {5.5, 726.1169, 0.3363, 9629, -0.2943, -0.9552, 2.926e-2, 1486, 4.379e-3, 1.401e-2, 7.122e-4},
    {6.5, 718.4931, 1.1591, 15440, -0.4289, -0.9003, 3.623e-2, 2603, 1.828e-2, 3.905e-2, 1.937e-3},
    {7.5, 719.4632, 1.0006, 13260, -0.5242, -0.8481, 3.524e-2, 2630, 2.044e-2, 3.333e-2, 1.765e-3},
    {8.5, 720.1709, 0.9065, 12310, -0.5537, -0.8299, 3.469e-2, 2638, 2.200e-2, 3.309e-2, 1.642e-3},
    {9.5, 720.7950, 0.8321, 11680, -0.5652, -0.8228, 3.428e-2, 2641, 2.325e-2, 3.388e-2, 1.536e-3},
};

/// How close: CONTACT prints four digits, its differences are of first order, and its elements lie
/// otherwise. Relative where no unit is given.
struct Bounds {
  double y_track = 0.03;  // mm
  double angle = 1.5e-4;  // rad
  double force = 1e-3;
  double pressure = 5e-3;
  double approach = 2e-3;
  double friction = 4e-3;  // of mu F_n
  double creepage = 0.02;
};

Bounds bounds_at(contact::WheelSide side, double shift) {
  Bounds bounds;
  if (side == contact::WheelSide::left) {
    // A third adheres at 0.5 mm, where first and second order differ most. At 6.5 mm the right
    // wheel has just come onto its flange, and the creepage follows it.
    if (shift == 0.5 || shift == 6.5) bounds.friction = 0.012;
    return bounds;
  }
  bounds.angle = 1e-3;
  bounds.approach = 5e-3;
  // The contact moves by 10 mm/mm: it is where 0.015 mm less of shift would have it.
  if (shift == 0.5) bounds.y_track = 0.15, bounds.creepage = 0.04;
  // A flange patch is three or four elements across.
  if (shift > 6.0) bounds.pressure = 0.05;
  // Beside where it climbs: as 0.03 mm of shift.
  if (shift == 6.5)
    bounds.y_track = 0.04, bounds.angle = 5e-3, bounds.force = 5e-3, bounds.friction = 0.008;
  return bounds;
}

void expect_row(const Row& row, const Bounds& bounds, contact::Scene scene) {
  SCOPED_TRACE(::testing::Message() << "shift " << row.shift);
  scene.contact_grid.cell_size = {0.2, 0.2};
  const auto point = halfspace::run_halfspace(scene, {}).points.front();
  const auto near = [](double ours, double theirs, double part, const char* what) {
    EXPECT_NEAR(ours, theirs, part * std::abs(theirs)) << what;
  };
  EXPECT_NEAR(scene.place->y_track, row.y_track, bounds.y_track);
  EXPECT_NEAR(scene.place->contact_angle, row.angle, bounds.angle);
  near(point.normal_force, row.normal_force, bounds.force, "F_n");
  near(point.max_pressure, row.max_pressure, bounds.pressure, "p0");
  near(point.approach, row.approach, bounds.approach, "approach");
  const double bound = 0.3 * point.normal_force;
  EXPECT_NEAR(point.longitudinal_force / bound, -row.along, bounds.friction);
  EXPECT_NEAR(point.lateral_force / bound, row.across, bounds.friction);
  near(point.creepage.longitudinal, -row.cksi, bounds.creepage, "xi");
  near(point.creepage.lateral, row.ceta, bounds.creepage, "eta");
  near(point.creepage.spin, row.cphi, bounds.creepage, "spin");
}

void expect_rows(contact::WheelSide side, const std::vector<Row>& rows) {
  std::vector<double> shifts;
  for (const Row& row : rows) shifts.push_back(row.shift);
  const auto balanced = track::balance(rollfem::testing::manchester_wheelset(side, shifts));
  ASSERT_EQ(balanced.scenes.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    expect_row(rows[k], bounds_at(side, rows[k].shift), balanced.scenes[k]);
}

}  // namespace

TEST(ManchesterHalfMillimetres, LeftWheelAgreesWithContact) {
  expect_rows(contact::WheelSide::left, left_rows);
}

TEST(ManchesterHalfMillimetres, RightWheelAgreesWithContact) {
  expect_rows(contact::WheelSide::right, right_rows);
}
