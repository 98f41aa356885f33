// SPDX-License-Identifier: LGPL-2.1-or-later
// Small input files in CONTACT's format, made for the tests: tests/support/contact.
#pragma once

#include "support/places.hpp"
#include "support/temporary_folder.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline std::string contact_input(const std::string& name) {
  return contents(std::string(ROLLFEM_SOURCE_DIR) + "/tests/support/contact/" + name + ".inp");
}

/// A ball of radius 25 mm on a plane, G = 300 MPa, nu = 0.25, pressed with 20 N and pushed by half
/// of what friction (0.3) bears.
inline const std::string pushed_ball = contact_input("pushed_ball");

/// Rolling of an ellipse of 5 by 3 mm, three creepages.
inline const std::string rolling_ellipse = contact_input("rolling_ellipse");

/// A roller of 300 mm on a plane, 250 mm wide, driven by 0.4 of what friction bears; rolls along
/// -x.
inline const std::string driven_roller = contact_input("driven_roller");

/// An ellipse of 5 by 3 mm under Hertz's pressure, pushed by half of what friction bears.
inline const std::string pushed_ellipse = contact_input("pushed_ellipse");

/// The left wheel of a wheelset that is 1.5 mm to the right, yawed and turns a little too fast.
inline const std::string left_wheel = contact_input("left_wheel");

/// A text with one piece of it replaced by another.
inline std::string replaced(std::string text, const std::string& piece, const std::string& by) {
  return text.replace(text.find(piece), piece.size(), by);  // at throws where there is none
}

/// The ball, pushed by a force and then rolled at a creepage.
inline const std::string pushed_then_rolled = replaced(pushed_ball, " 0 module", R"( 3 module
 002100
 102000
 0111341
 20.0 0.0001 0.0 0.0
 0.0 0.1 1000.
 0.25 0.25 300. 300.
 0 module)");

/// The first two cases of the ellipse are the same.
inline const std::string rolled_twice = replaced(rolling_ellipse, "40000. 0.0008", "40000. 0.0004");

}  // namespace rollfem::testing
