// SPDX-License-Identifier: LGPL-2.1-or-later
// The fields of a load point over the contact grid, each declared once for all files. Its scalars:
// contact/result/quantities.hpp.
#pragma once

#include "contact/result/result.hpp"

#include <vector>

namespace rollfem::contact {

struct PointField {
  const char* name;
  const char* unit;
  const char* description;
  const char* sign;
  Field& (*member)(ContactFields&);
  /// Of size 0 where the model does not give it.
  const Field& value(const ContactFields& fields) const {
    return member(const_cast<ContactFields&>(fields));  // a member of it
  }
};

/// All fields of numbers; ContactFields::state is beside them.
const std::vector<PointField>& point_fields();

/// Of ContactFields::state.
inline constexpr const char* state_meaning =
    "state of the element: 0 exterior, 1 adhesion, 2 slip, 3 plastic";

}  // namespace rollfem::contact
