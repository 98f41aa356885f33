// The Manchester benchmark A-2.2 (Shackleton and Iwnicki 2008): a wheelset of 20 kN, shifted and
// yawed, rolling without torque. Against CONTACT's shipped results for the left wheel (CONTACT user
// guide, section 5.7, open version r2707): place, normal force, pressure and creepages.
#include "halfspace/model/model.hpp"
#include "track/balance/balance.hpp"

#include <gtest/gtest.h>

#include "support/manchester.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using rollfem::contact::Case;
using rollfem::contact::Creepage;
using rollfem::contact::WheelSide;
using rollfem::testing::manchester_wheelset;

/// Columns of CONTACT's output for the left wheel. Its creepages are minus ours, and its lateral
/// axis points to the right: eta and spin change their sign twice.
struct LeftRow {
  double shift;  // mm
  double y_track, angle, normal_force, max_pressure;
  double cksi, ceta, cphi;
};

const std::vector<LeftRow> left_table{
    {0.000, -751.8726, 0.0290, 9997.0, 338.3, -5.665E-05, 0.000, -6.302E-05},
    {1.000, -755.2440, 0.0176, 10050.0, 423.9, -6.297E-04, 2.400E-03, -3.848E-05},
    {2.000, -756.5056, 0.0134, 10040.0, 465.9, -8.651E-04, 4.798E-03, -2.947E-05},
    {3.000, -757.2358, 0.0110, 10030.0, 498.8, -1.103E-03, 7.197E-03, -2.432E-05},
    {4.000, -757.6645, 0.0096, 10030.0, 527.2, -1.399E-03, 9.594E-03, -2.138E-05},
    {5.000, -757.8958, 0.0088, 10030.0, 552.8, -3.462E-03, 1.198E-02, -1.990E-05},
    {6.000, -758.0210, 0.0084, 10020.0, 578.5, -4.901E-03, 1.437E-02, -1.957E-05},
    {7.000, -758.6092, 0.0064, 10010.0, 666.7, -2.035E-02, 1.663E-02, -2.761E-05},
    {8.000, -758.2223, 0.0077, 10020.0, 701.1, -2.281E-02, 1.899E-02, -3.511E-05},
    {9.000, -757.6922, 0.0095, 10020.0, 725.3, -2.425E-02, 2.135E-02, -4.210E-05},
    {10.00, -757.0975, 0.0115, 10020.0, 744.0, -2.532E-02, 2.371E-02, -4.883E-05},
};

template <class Rows>
std::vector<double> shifts_of(const Rows& table) {
  std::vector<double> shifts;
  for (const auto& row : table) shifts.push_back(row.shift);
  return shifts;
}

/// 2 % of the value or 2e-5, of which 1.2 % at the largest creepages are a matter of definition:
/// CONTACT divides by the mean of forward and circumferential speed, we by the forward speed,
/// whichever is more.
void expect_creepage(double ours, double of_contact, const char* what) {
  EXPECT_NEAR(ours, of_contact, std::max(0.02 * std::abs(of_contact), 2e-5)) << what;
}

/// Friction across over mu N of the rows, as CONTACT prints it.
const std::vector<double> friction_across{0.08458, -0.9592, -0.9830, -0.9881, -0.9893, -0.9604,
                                          -0.9462, -0.6325, -0.6394, -0.6604, -0.6832};

/// The same along, normal approach (mm), elements of 0.2 mm in contact.
const std::vector<double> friction_along{9.281e-5, 0.2749, 0.1814, 0.1530, 0.1451, 0.2785,
                                         0.3236,   0.7746, 0.7689, 0.7509, 0.7302};
const std::vector<double> approach{1.596e-2, 1.946e-2, 2.054e-2, 2.128e-2, 2.185e-2, 2.232e-2,
                                   2.278e-2, 2.412e-2, 2.458e-2, 2.489e-2, 2.511e-2};
const std::vector<int> contact_elements{1291, 916, 830, 766, 727, 692, 658, 575, 549, 532, 515};

/// The right wheel, of the same example (open version r2447): forces on the wheel in N, creepages
/// with CONTACT's sign.
struct RightRow {
  double shift, y_track, angle, normal_force, along, across, approach, max_pressure;
  double cksi, ceta, cphi;
};

const std::vector<RightRow> right_table{
    {0, 751.8726, 0.0290, 9997, 0.2774, -253.7, 1.596e-2, 338.3, -5.665e-5, 0.0, 6.302e-5},
    {1, 741.9908, 0.0696, 9827, -814.3, -2832, 2.448e-2, 741.3, 6.943e-4, 2.407e-3, 1.510e-4},
    {2, 740.9147, 0.0806, 9799, -517.3, -2893, 2.480e-2, 744.8, 8.752e-4, 4.818e-3, 1.746e-4},
    {3, 739.9698, 0.0923, 9774, -417.5, -2902, 2.439e-2, 713.2, 1.052e-3, 7.235e-3, 1.998e-4},
    {4, 738.7381, 0.1078, 9745, -379.6, -2898, 2.370e-2, 664.4, 1.276e-3, 9.662e-3, 2.330e-4},
    {6, 725.1371, 0.4176, 9709, -880.0, -2775, 2.728e-2, 1149, 5.077e-3, 1.580e-2, 8.744e-4},
    {7, 719.0445, 1.0634, 14030, -2079, -3644, 3.563e-2, 2622, 1.949e-2, 3.457e-2, 1.838e-3},
    {8, 719.8316, 0.9501, 12720, -2070, -3195, 3.494e-2, 2634, 2.127e-2, 3.300e-2, 1.701e-3},
    {9, 720.4903, 0.8676, 11970, -2014, -2963, 3.447e-2, 2640, 2.266e-2, 3.341e-2, 1.588e-3},
    {10, 721.0880, 0.7992, 11440, -1947, -2820, 3.411e-2, 2643, 2.378e-2, 3.445e-2, 1.486e-3},
};

/// Of free rolling at another shift (mm).
double longitudinal_creepage_at(double shift) {
  const Case input = manchester_wheelset(WheelSide::left, {shift});
  return rollfem::track::balance(input).scenes.at(0).points.at(0).creepage.longitudinal;
}

}  // namespace

/// The figures of each row are copied rightly: pressure and friction carry the wheel's 10 kN.
TEST(ManchesterBenchmark, RowsOfContactAddUpVertically) {
  ASSERT_EQ(friction_across.size(), left_table.size());
  for (std::size_t k = 0; k < left_table.size(); ++k) {
    const LeftRow& row = left_table[k];
    const double across = 0.3 * friction_across[k] * row.normal_force;
    EXPECT_NEAR(row.normal_force * std::cos(row.angle) + across * std::sin(row.angle), 10e3, 5.5)
        << row.shift;  // half of the fourth digit, and of the angle's
  }
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

TEST(ManchesterBenchmark, LeftWheelAgreesWithContact) {
  const auto balanced =
      rollfem::track::balance(manchester_wheelset(WheelSide::left, shifts_of(left_table)));
  ASSERT_EQ(balanced.scenes.size(), left_table.size());
  for (std::size_t k = 0; k < left_table.size(); ++k) {
    SCOPED_TRACE(::testing::Message() << "shift " << left_table[k].shift);
    const LeftRow& row = left_table[k];
    rollfem::contact::Scene scene = balanced.scenes[k];
    scene.contact_grid.cell_size = {0.2, 0.2};
    const auto& place = *scene.place;
    EXPECT_NEAR(place.y_track, row.y_track, 0.03);
    EXPECT_NEAR(place.contact_angle, row.angle, 1.5e-4);
    const auto result = rollfem::halfspace::run_halfspace(scene, {});
    const auto& point = result.points.front();
    // Printed with four digits.
    EXPECT_NEAR(point.normal_force, row.normal_force, 1e-3 * row.normal_force);
    EXPECT_NEAR(point.max_pressure, row.max_pressure, 0.005 * row.max_pressure);
    EXPECT_NEAR(point.approach, approach[k], 1e-3 * approach[k]);
    // 0.004 is what differences of second order take off (CONTACT's are of first).
    const double bound = 0.3 * point.normal_force;
    const double most = row.shift == 5.0 ? 0.02 : 0.004;
    EXPECT_NEAR(-point.longitudinal_force / bound, friction_along[k], most);
    EXPECT_NEAR(point.lateral_force / bound, friction_across[k], most);
    EXPECT_NEAR(result.contact_elements, contact_elements[k], 0.02 * contact_elements[k]);
    const Creepage& creepage = point.creepage;
    // At 5 mm the right wheel touches at two places, and 0.01 mm of shift moves the load between
    // them so that xi changes by 3.5 %; we are 6.5 % beside CONTACT there, which is 0.018 mm.
    if (row.shift == 5.0) {
      EXPECT_GT(creepage.longitudinal, -row.cksi);
      EXPECT_LT(longitudinal_creepage_at(4.98), -row.cksi);
    } else {
      expect_creepage(creepage.longitudinal, -row.cksi, "xi");
    }
    expect_creepage(creepage.lateral, row.ceta, "eta");
    expect_creepage(creepage.spin, row.cphi, "spin");
  }
}

TEST(ManchesterBenchmark, RightWheelOfOnePatchAgreesWithContact) {
  // From 7 mm on it stands on its flange, 1.06 to 0.80 rad steep, on a patch of three or four
  // elements across.
  const auto balanced =
      rollfem::track::balance(manchester_wheelset(WheelSide::right, shifts_of(right_table)));
  ASSERT_EQ(balanced.scenes.size(), right_table.size());
  for (std::size_t k = 0; k < right_table.size(); ++k) {
    const RightRow& row = right_table[k];
    SCOPED_TRACE(::testing::Message() << "shift " << row.shift);
    const bool flange = row.shift > 6.0;
    rollfem::contact::Scene scene = balanced.scenes[k];
    scene.contact_grid.cell_size = {0.2, 0.2};
    EXPECT_NEAR(scene.place->y_track, row.y_track, 0.03);
    EXPECT_NEAR(scene.place->contact_angle, row.angle, 2.5e-3);
    const auto point = rollfem::halfspace::run_halfspace(scene, {}).points.front();
    EXPECT_NEAR(point.normal_force, row.normal_force, 1.2e-3 * row.normal_force);
    EXPECT_NEAR(point.max_pressure, row.max_pressure, (flange ? 0.05 : 0.012) * row.max_pressure);
    EXPECT_NEAR(point.approach, row.approach, 5e-3 * row.approach);
    const double bound = 0.3 * row.normal_force;
    EXPECT_NEAR(point.longitudinal_force, -row.along, 4e-3 * bound);
    EXPECT_NEAR(point.lateral_force, row.across, 4e-3 * bound);
    expect_creepage(point.creepage.longitudinal, -row.cksi, "xi");
    expect_creepage(point.creepage.lateral, row.ceta, "eta");
    EXPECT_NEAR(point.creepage.spin, row.cphi, 0.02 * row.cphi);
  }
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
