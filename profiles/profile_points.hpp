// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a profile from a file: repairs as the case requests, and checks.
#pragma once

#include "case/track.hpp"
#include "profiles/profile_curve.hpp"

#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::profiles {

struct ListedPoint {
  double y = 0.0, z = 0.0;  ///< mm after mending
  unsigned line = 0;        ///< of the file
};

struct ProfilePoints {
  std::string file;  ///< as named in messages
  std::vector<ListedPoint> list;
  bool any_direction = false;  ///< the format does not prescribe the direction of the list
  bool own_unit = false;       ///< the file states its unit
  std::string neglected{};     ///< warning of what the file asks for and is not done
};

PointRow row_of(const ProfilePoints& points);

/// Repairs the points as requested by `source` and rejects remaining defects. Throws one
/// contact::InputError that names all defects and the keys that repair them together.
void mend_and_check(ProfilePoints& points, const contact::ProfileSource& source, bool wheel);

// Parts of mend_and_check.

/// A key of [wheel_profile] or [rail_profile] that repairs a defect.
struct PointRepair {
  std::string key, value;
  std::string note;  ///< follows them in a message, or empty
  std::function<void(contact::ProfileSource&)> apply;

  std::string line() const { return key + " = " + value; }  ///< "flip = true"
};

template <class Value>
PointRepair repair(const char* key, Value contact::ProfileSource::*member, Value value,
                   std::string note = "") {
  return {key, fmt::format("{}", value), std::move(note),
          [member, value](contact::ProfileSource& source) { source.*member = value; }};
}

/// A defect of the points; thrown.
struct PointFault {
  unsigned line = 0;  ///< of the file; 0: of no single line
  std::string wrong, allowed;
  std::string by_hand;                 ///< the remedy without a key, or empty
  std::vector<PointRepair> repairs{};  ///< keys that repair it, the best one first
};

/// Throws PointFault where the curve turns back.
void check_order(const ProfilePoints& points, bool drop_zigzag);

/// Drops the fewest points such that the curve nowhere turns back.
void drop_zigzag(ProfilePoints& points);

}  // namespace rollfem::profiles
