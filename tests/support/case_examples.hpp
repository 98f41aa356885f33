// SPDX-License-Identifier: LGPL-2.1-or-later
// A small valid case file for the tests, and variations of it.
#pragma once

#include "base/errors.hpp"
#include "case/reading/case_reader.hpp"

#include "support/temporary_folder.hpp"
#include "support/test.hpp"

namespace rollfem::testing {

inline const std::string small_case = R"([load]
normal_force = 50e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 405.0
transverse_radius = inf
[rail]
transverse_radius = 2000.0
)";

/// The left wheel of a wheelset in the middle of the track.
inline const std::string wheel_on_rail = R"([load]
vertical_force = 100e3
[friction]
coefficient = 0.55
[wheel]
rolling_radius = 450.0
profile = "S1002"
[rail]
profile = "UIC60-manchester"
[track]
inclination = "1:40"
)";

/// A case with keys changed as by `--set`.
inline std::string edited(const std::string& text, const std::vector<std::string>& changes) {
  return contact::with_changes(text, "case.toml", changes, {{"auto", "halfspace", "fem"}, {}, {}});
}

/// The small case with lines added at the end.
inline std::string plus(const std::string& lines) {
  return small_case + lines;
}

}  // namespace rollfem::testing
