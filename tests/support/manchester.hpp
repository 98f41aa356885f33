// The Manchester benchmark A-2.2 (Shackleton and Iwnicki 2008) as CONTACT's example has it: S1002
// on the benchmark's UIC60, a wheelset of 20 kN, shifted and yawed, rolling without torque.
#pragma once

#include "contact/case/case.hpp"

#include <vector>

namespace rollfem::testing {

/// Yaw that the benchmark prescribes, rad/mm of lateral shift.
inline constexpr double manchester_yaw = 2.4e-3;

/// One wheel at these lateral shifts, mm.
inline contact::Case manchester_wheelset(contact::WheelSide side,
                                         const std::vector<double>& shifts) {
  contact::Case input;
  input.file = "manchester";
  input.load.vertical_force = 10e3;
  input.friction_coefficient = 0.3;
  // CONTACT lays the patch in a plane and knows creepages and spin alone.
  input.rolling.extra_slip = contact::ExtraSlip::none;
  input.wheel.rolling_radius = 460.0;
  input.wheel.profile.name = "S1002";
  input.rail.profile.name = "UIC60-manchester";
  for (auto* material : {&input.wheel.material, &input.rail.material}) {
    material->poisson_ratio = 0.28;
    material->young_modulus = 2.0 * 1.28 * 82000.0;
  }
  input.track.inclination = 1.0 / 40.0;
  input.wheelset.side = side;
  input.wheelset.free_rolling = contact::FreeRolling::torque;
  input.wheelset.lateral_shift = shifts;
  input.wheelset.yaw.clear();
  for (const double shift : shifts) input.wheelset.yaw.push_back(manchester_yaw * shift);
  return input;
}

}  // namespace rollfem::testing
