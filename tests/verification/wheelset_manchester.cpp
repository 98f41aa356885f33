// SPDX-License-Identifier: LGPL-2.1-or-later
// The Manchester benchmark A-2.2 (Shackleton and Iwnicki 2008): a wheelset of 20 kN, shifted and
// yawed, rolling without torque, digit by digit against CONTACT's shipped results (user guide,
// section 5.7; github.com/eve70a/CONTACT, examples/mbench_a22_left.ref_out of open version r2707).
// All positions and both wheels: the book.
#include "halfspace/model/halfspace_model.hpp"
#include "track/balance/balance.hpp"

#include "support/wheel_rail_cases.hpp"

namespace {

/// At these lateral shifts, mm, with the profiles of the program.
rollfem::contact::Case shifted_left_wheel(const std::vector<double>& shifts) {
  auto input = manchester_case(0.0, 0.0);
  input.file = "manchester";
  // CONTACT lays the patch in a plane and knows creepages and spin alone.
  input.rolling.extra_slip = rollfem::contact::ExtraSlip::none;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  input.wheelset.side = WheelSide::left;
  input.wheelset.free_rolling = rollfem::contact::FreeRolling::torque;
  input.wheelset.lateral_shift = shifts;
  input.wheelset.yaw.clear();
  for (const double shift : shifts) input.wheelset.yaw.push_back(2.4e-3 * shift);
  return input;
}

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
  std::vector<double> shifts;
  for (const FrictionRow& row : friction_rows) shifts.push_back(row.shift);
  const auto balanced = rollfem::track::balance(shifted_left_wheel(shifts));
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
