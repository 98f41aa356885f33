// SPDX-License-Identifier: LGPL-2.1-or-later
// The Manchester benchmark A-2.2 (Shackleton and Iwnicki 2008): a wheelset of 20 kN, shifted and
// yawed, rolling without torque, at every half millimetre of shift. Against CONTACT's shipped
// results (user guide, section 5.7; github.com/eve70a/CONTACT, examples/mbench_a22_left.ref_out of
// open version r2707 and mbench_a22_right.ref_out of r2447).
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

/// Yaw that the benchmark prescribes, rad/mm of lateral shift.
constexpr double yaw_of_shift = 2.4e-3;

/// One wheel at these lateral shifts, mm, with the profiles of the program.
rollfem::contact::Case manchester_wheelset(WheelSide side, const std::vector<double>& shifts) {
  auto input = manchester_case(0.0, 0.0);
  input.file = "manchester";
  // CONTACT lays the patch in a plane and knows creepages and spin alone.
  input.rolling.extra_slip = rollfem::contact::ExtraSlip::none;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.wheelset.side = side;
  input.wheelset.free_rolling = rollfem::contact::FreeRolling::torque;
  input.wheelset.lateral_shift = shifts;
  input.wheelset.yaw.clear();
  for (const double shift : shifts) input.wheelset.yaw.push_back(yaw_of_shift * shift);
  return input;
}

/// Columns of CONTACT's output: mm, rad, N; friction along and across over mu F_n; MPa. Its
/// longitudinal creepage and force along are minus ours. For the left wheel its lateral axis points
/// to the right: eta and spin change their sign twice.
struct Row {
  double shift, y_track, angle, normal_force, along, across, approach, max_pressure;
  double cksi, ceta;  ///< 1e-3
  double cphi;        ///< 1e-5 rad/mm
  int elements = 0;   ///< of 0.2 mm in contact; 0: not noted
};

/// A row whose friction is printed in N.
Row in_newtons(Row row) {
  row.along /= 0.3 * row.normal_force;
  row.across /= 0.3 * row.normal_force;
  return row;
}

const std::vector<Row> left_rows{
    {0, -751.8726, 0.0290, 9997, 9.281e-5, 0.08458, 1.596e-2, 338.3, -0.05665, 0, -6.302, 1291},
    {0.5, -754.2092, 0.0211, 10050, 0.2942, -0.7860, 1.859e-2, 395.3, -0.3708, 1.200, -4.592},
    {1, -755.2440, 0.0176, 10050, 0.2749, -0.9592, 1.946e-2, 423.9, -0.6297, 2.400, -3.848, 916},
    {1.5, -755.9669, 0.0152, 10050, 0.2127, -0.9763, 2.007e-2, 446.5, -0.7530, 3.599, -3.330},
    {2, -756.5056, 0.0134, 10040, 0.1814, -0.9830, 2.054e-2, 465.9, -0.8651, 4.798, -2.947, 830},
    {2.5, -756.9177, 0.0121, 10040, 0.1634, -0.9863, 2.094e-2, 483.1, -0.9792, 5.998, -2.655},
    {3, -757.2358, 0.0110, 10030, 0.1530, -0.9881, 2.128e-2, 498.8, -1.103, 7.197, -2.432, 766},
    {3.5, -757.4801, 0.0102, 10030, 0.1472, -0.9890, 2.158e-2, 513.4, -1.241, 8.395, -2.263},
    {4, -757.6645, 0.0096, 10030, 0.1451, -0.9893, 2.185e-2, 527.2, -1.399, 9.594, -2.138, 727},
    {4.5, -757.7990, 0.0091, 10030, 0.1465, -0.9892, 2.209e-2, 540.2, -1.591, 10.79, -2.049},
    {5, -757.8958, 0.0088, 10030, 0.2785, -0.9604, 2.232e-2, 552.8, -3.462, 11.98, -1.990, 692},
    {5.5, -757.9746, 0.0085, 10020, 0.3106, -0.9505, 2.255e-2, 565.8, -4.292, 13.17, -1.959},
    {6, -758.0210, 0.0084, 10020, 0.3236, -0.9462, 2.278e-2, 578.5, -4.901, 14.37, -1.957, 658},
    {6.5, -758.6243, 0.0064, 10010, 0.7524, -0.6587, 2.369e-2, 637.0, -17.64, 15.46, -2.319},
    {7, -758.6092, 0.0064, 10010, 0.7746, -0.6325, 2.412e-2, 666.7, -20.35, 16.63, -2.761, 575},
    {7.5, -758.4440, 0.0070, 10010, 0.7748, -0.6322, 2.438e-2, 685.9, -21.80, 17.81, -3.146},
    {8, -758.2223, 0.0077, 10020, 0.7689, -0.6394, 2.458e-2, 701.1, -22.81, 18.99, -3.511, 549},
    {8.5, -757.9681, 0.0086, 10020, 0.7605, -0.6493, 2.474e-2, 714.0, -23.60, 20.17, -3.864},
    {9, -757.6922, 0.0095, 10020, 0.7509, -0.6604, 2.489e-2, 725.3, -24.25, 21.35, -4.210, 532},
    {9.5, -757.4008, 0.0105, 10020, 0.7407, -0.6718, 2.501e-2, 735.2, -24.82, 22.53, -4.549},
    {10, -757.0975, 0.0115, 10020, 0.7302, -0.6832, 2.511e-2, 744.0, -25.32, 23.71, -4.883, 515},
};

/// At 5 mm it touches at two places: a test of its own.
const std::vector<Row> right_rows{
    in_newtons({0, 751.8726, 0.0290, 9997, 0.2774, -253.7, 1.596e-2, 338.3, -0.05665, 0, 6.302}),
    {0.5, 744.5026, 0.0568, 9870, -0.2972, -0.8711, 1.948e-2, 632.5, 0.4948, 1.202, 12.33},
    in_newtons({1, 741.9908, 0.0696, 9827, -814.3, -2832, 2.448e-2, 741.3, 0.6943, 2.407, 15.10}),
    {1.5, 741.3771, 0.0753, 9811, -0.2106, -0.9774, 2.489e-2, 754.1, 0.7903, 3.612, 16.33},
    in_newtons({2, 740.9147, 0.0806, 9799, -517.3, -2893, 2.480e-2, 744.8, 0.8752, 4.818, 17.46}),
    {2.5, 740.4620, 0.0862, 9787, -0.1554, -0.9878, 2.461e-2, 730.4, 0.9607, 6.025, 18.66},
    in_newtons({3, 739.9698, 0.0923, 9774, -417.5, -2902, 2.439e-2, 713.2, 1.052, 7.235, 19.98}),
    {3.5, 739.4071, 0.0994, 9760, -0.1342, -0.9909, 2.410e-2, 691.6, 1.154, 8.447, 21.50},
    in_newtons({4, 738.7381, 0.1078, 9745, -379.6, -2898, 2.370e-2, 664.4, 1.276, 9.662, 23.30}),
    {4.5, 737.8905, 0.1185, 9726, -0.1291, -0.9915, 2.310e-2, 625.5, 1.430, 10.88, 25.59},
    {5.5, 726.1169, 0.3363, 9629, -0.2943, -0.9552, 2.926e-2, 1486, 4.379, 14.01, 71.22},
    in_newtons({6, 725.1371, 0.4176, 9709, -880.0, -2775, 2.728e-2, 1149, 5.077, 15.80, 87.44}),
    {6.5, 718.4931, 1.1591, 15440, -0.4289, -0.9003, 3.623e-2, 2603, 18.28, 39.05, 193.7},
    in_newtons({7, 719.0445, 1.0634, 14030, -2079, -3644, 3.563e-2, 2622, 19.49, 34.57, 183.8}),
    {7.5, 719.4632, 1.0006, 13260, -0.5242, -0.8481, 3.524e-2, 2630, 20.44, 33.33, 176.5},
    in_newtons({8, 719.8316, 0.9501, 12720, -2070, -3195, 3.494e-2, 2634, 21.27, 33.00, 170.1}),
    {8.5, 720.1709, 0.9065, 12310, -0.5537, -0.8299, 3.469e-2, 2638, 22.00, 33.09, 164.2},
    in_newtons({9, 720.4903, 0.8676, 11970, -2014, -2963, 3.447e-2, 2640, 22.66, 33.41, 158.8}),
    {9.5, 720.7950, 0.8321, 11680, -0.5652, -0.8228, 3.428e-2, 2641, 23.25, 33.88, 153.6},
    in_newtons({10, 721.0880, 0.7992, 11440, -1947, -2820, 3.411e-2, 2643, 23.78, 34.45, 148.6}),
};

template <class Rows>
std::vector<double> shifts_of(const Rows& table) {
  std::vector<double> shifts;
  for (const auto& row : table) shifts.push_back(row.shift);
  return shifts;
}

/// How close: CONTACT prints four digits, its differences are of first order, and its elements lie
/// otherwise. Relative where no unit is given.
struct Bounds {
  double y_track = 0.03;  // mm
  double angle = 1.5e-4;  // rad
  double force = 1e-3;
  double pressure = 5e-3;
  double approach = 1e-3;
  double friction = 4e-3;  // of mu F_n, which is what differences of second order take off
  // 1.2 % at the largest are a matter of definition: CONTACT divides by the mean of forward and
  // circumferential speed, we by the forward speed.
  double creepage = 0.02;
  double least_creepage = 0.0, least_spin = 0.0;  ///< that much is allowed
};

Bounds left_bounds(double shift, bool whole) {
  Bounds bounds;
  if (whole) bounds.least_creepage = bounds.least_spin = 2e-5;
  if (!whole) bounds.approach = 2e-3;
  // A third adheres at 0.5 mm, where first and second order differ most. At 6.5 mm the right wheel
  // has just come onto its flange, and the creepage follows it.
  if (shift == 0.5 || shift == 6.5) bounds.friction = 0.012;
  if (shift == 5.0) bounds.friction = 0.02;
  return bounds;
}

Bounds right_bounds(double shift, bool whole) {
  Bounds bounds;
  bounds.angle = whole ? 2.5e-3 : 1e-3;
  bounds.approach = 5e-3;
  if (whole) bounds.force = 1.2e-3, bounds.pressure = 0.012, bounds.least_creepage = 2e-5;
  // From 6.5 mm on it stands on its flange, on a patch three or four elements across.
  if (shift > 6.0) bounds.pressure = 0.05;
  // The contact moves by 10 mm/mm: it is where 0.015 mm less of shift would have it.
  if (shift == 0.5) bounds.y_track = 0.15, bounds.creepage = 0.04;
  // Beside where it climbs: as 0.03 mm of shift.
  if (shift == 6.5)
    bounds.y_track = 0.04, bounds.angle = 5e-3, bounds.force = 5e-3, bounds.friction = 0.008;
  return bounds;
}

/// Of free rolling at another shift (mm).
double longitudinal_creepage_at(double shift) {
  const auto input = manchester_wheelset(WheelSide::left, {shift});
  return rollfem::track::balance(input).scenes.at(0).points.at(0).creepage.longitudinal;
}

void expect_row(const Row& row, const Bounds& bounds, rollfem::contact::Scene scene) {
  SCOPED_TRACE(::testing::Message() << "shift " << row.shift);
  scene.contact_grid.cell_size = {0.2, 0.2};
  const auto result = rollfem::halfspace::run_halfspace(scene, {});
  const auto& point = result.points.front();
  const auto near = [](double ours, double theirs, double part, const char* what,
                       double least = 0.0) {
    EXPECT_NEAR(ours, theirs, std::max(part * std::abs(theirs), least)) << what;
  };
  EXPECT_NEAR(scene.place->y_track, row.y_track, bounds.y_track);
  EXPECT_NEAR(scene.place->contact_angle, row.angle, bounds.angle);
  near(point.normal_force, row.normal_force, bounds.force, "F_n");
  near(point.max_pressure, row.max_pressure, bounds.pressure, "p0");
  near(point.approach, row.approach, bounds.approach, "approach");
  const double bound = 0.3 * point.normal_force;
  EXPECT_NEAR(point.longitudinal_force / bound, -row.along, bounds.friction);
  EXPECT_NEAR(point.lateral_force / bound, row.across, bounds.friction);
  if (row.elements > 0) near(result.contact_elements, row.elements, 0.02, "elements");
  const auto& creepage = point.creepage;
  // At 5 mm the right wheel touches at two places, and 0.01 mm of shift moves the load between them
  // so that xi changes by 3.5 %; we are 6.5 % beside CONTACT there, which is 0.018 mm.
  if (row.shift == 5.0) {
    EXPECT_GT(creepage.longitudinal, -1e-3 * row.cksi);
    EXPECT_LT(longitudinal_creepage_at(4.98), -1e-3 * row.cksi);
  } else {
    near(creepage.longitudinal, -1e-3 * row.cksi, bounds.creepage, "xi", bounds.least_creepage);
  }
  near(creepage.lateral, 1e-3 * row.ceta, bounds.creepage, "eta", bounds.least_creepage);
  near(creepage.spin, 1e-5 * row.cphi, bounds.creepage, "spin", bounds.least_spin);
}

void expect_rows(WheelSide side, const std::vector<Row>& rows,
                 Bounds (*bounds_at)(double shift, bool whole)) {
  const auto balanced = rollfem::track::balance(manchester_wheelset(side, shifts_of(rows)));
  ASSERT_EQ(balanced.scenes.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    expect_row(rows[k], bounds_at(rows[k].shift, rows[k].shift == std::floor(rows[k].shift)),
               balanced.scenes[k]);
}

}  // namespace

/// The figures of each row are copied rightly: pressure and friction carry the wheel's 10 kN.
TEST(ManchesterBenchmark, RowsOfContactAddUpVertically) {
  for (const Row& row : left_rows) {
    const double across = 0.3 * row.across * row.normal_force;
    EXPECT_NEAR(row.normal_force * std::cos(row.angle) + across * std::sin(row.angle), 10e3, 5.5)
        << row.shift;  // half of the fourth digit, and of the angle's
  }
}

TEST(ManchesterBenchmark, LeftWheelAgreesWithContact) {
  expect_rows(WheelSide::left, left_rows, left_bounds);
}

TEST(ManchesterBenchmark, RightWheelOfOnePatchAgreesWithContact) {
  expect_rows(WheelSide::right, right_rows, right_bounds);
}

TEST(ManchesterBenchmark, RightWheelOfTwoPatchesCarriesAsContactFinds) {
  // CONTACT joins tread and flange root of the right wheel at 5 mm: 9619 N along their normal.
  const auto balanced = rollfem::track::balance(manchester_wheelset(WheelSide::right, {5.0}));
  ASSERT_EQ(balanced.scenes.size(), 1U);
  rollfem::contact::Scene scene = balanced.scenes[0];
  scene.contact_grid.cell_size = {0.2, 0.2};
  const auto point = rollfem::halfspace::run_halfspace(scene, {}).points.at(0);
  EXPECT_NEAR(point.normal_force, 9619.0, 1e-3 * 9619.0);
  EXPECT_EQ(point.patch_count, 2);
}

namespace {

/// Tractions that CONTACT finds on the left wheel with its first-order differences, elements of
/// 0.2 mm.
struct FrictionRow {
  double shift;    // mm
  double y_track;  // of the reference point
  double cksi, ceta, cphi;
  double along, across;  // force over mu N
  int contact, adhesion;
};

const std::vector<FrictionRow> friction_rows{
    {0.0, -751.8726, -5.665E-05, 0.000, -6.302E-05, 9.281E-05, 0.08458, 1291, 943},
    {0.5, -754.2092, -3.708E-04, 1.200E-03, -4.592E-05, 0.2942, -0.7860, 989, 342},
    {1.0, -755.2440, -6.297E-04, 2.400E-03, -3.848E-05, 0.2749, -0.9592, 916, 0},
    {5.0, -757.8958, -3.462E-03, 1.198E-02, -1.990E-05, 0.2785, -0.9604, 692, 0},
};

/// Its elements, with one in the middle of its reference point, and its creepages there: ours are
/// those at our reference point, up to 0.024 mm from it.
rollfem::contact::Scene as_contact_lays_it(rollfem::contact::Scene scene, const FrictionRow& row) {
  const auto plain = rollfem::halfspace::run_halfspace(scene, {}).points.front();
  const double cell = 0.2;
  // The patch's y points to the field, -y of the track.
  const double reference =
      (scene.place->y_track - row.y_track) / std::cos(scene.place->contact_angle);
  const auto odd = [&](double extent) {
    return cell * (2.0 * std::ceil(0.5 * extent / cell) + 9.0);
  };
  scene.contact_grid.cell_size = {cell, cell};
  scene.contact_grid.extent = {odd(plain.contact_length), odd(plain.contact_width)};
  scene.contact_grid.middle = {
      0.0, reference + cell * std::round((plain.patch_y_middle.value() - reference) / cell)};
  scene.points.front().creepage = {-row.cksi + row.cphi * reference, row.ceta, row.cphi};
  scene.upwind_order = rollfem::contact::UpwindOrder::first;
  return scene;
}

}  // namespace

TEST(ManchesterBenchmark, TractionsAreContactsWhereDifferencesElementsAndReferenceAre) {
  const auto balanced =
      rollfem::track::balance(manchester_wheelset(WheelSide::left, shifts_of(friction_rows)));
  ASSERT_EQ(balanced.scenes.size(), friction_rows.size());
  for (std::size_t k = 0; k < friction_rows.size(); ++k) {
    const FrictionRow& row = friction_rows[k];
    SCOPED_TRACE(::testing::Message() << "shift " << row.shift);
    const auto result =
        rollfem::halfspace::run_halfspace(as_contact_lays_it(balanced.scenes[k], row), {});
    const auto& point = result.points.front();
    const double bound = 0.3 * point.normal_force;
    // Two in the fourth digit. In pure rolling 0.0016 of mu N along: it is a balance about zero of
    // a patch 16 mm wide, and turns by this where the patch moves by 7 um across.
    EXPECT_NEAR(point.longitudinal_force / bound, -row.along, row.shift == 0.0 ? 2e-3 : 2e-4);
    EXPECT_NEAR(point.lateral_force / bound, row.across, 2e-4);
    EXPECT_NEAR(result.contact_elements, row.contact, 1);
    const auto& state = point.fields.state;
    EXPECT_EQ(std::count(state.begin(), state.end(), rollfem::contact::ElementState::adhesion),
              row.adhesion);
  }
}
