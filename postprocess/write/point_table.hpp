// SPDX-License-Identifier: LGPL-2.1-or-later
// The fields of a load point and the numbers of its place with units, meanings and signs, declared
// once for all files. Its scalars: contact/result/quantities.hpp.
#pragma once

#include "contact/result/result.hpp"

#include <type_traits>
#include <variant>
#include <vector>

namespace rollfem::postprocess {

/// A field over the contact grid with its description.
struct PointField {
  const char* name;
  const char* unit;
  const char* description;
  const char* sign;
  const contact::Field& (*value)(const contact::ContactFields&);
};

/// All floating-point fields of a load point. A field of size 0 is not given by the model.
const std::vector<PointField>& point_fields();

/// A scalar of the place of a patch on track and profiles, the same in every file.
struct PlaceScalar {
  const char* name;
  const char* unit;
  const char* description;
  std::variant<int contact::ContactPlace::*, double contact::ContactPlace::*> member;
  double value(const contact::ContactPlace& place) const {
    return std::visit([&](auto of) { return static_cast<double>(place.*of); }, member);
  }
  void set(contact::ContactPlace& place, double value) const {
    std::visit([&](auto of) { place.*of = static_cast<std::decay_t<decltype(place.*of)>>(value); },
               member);
  }
};
const std::vector<PlaceScalar>& place_scalars();

/// Where along its way a wheel is, a number for each position of the case.
struct WayScalar {
  const char *name, *unit, *description;
  std::vector<double> contact::Wheelset::*list;
  double at(const contact::Case& input, int position) const {
    return (input.wheelset.*list).at(static_cast<std::size_t>(position) - 1);
  }
};
/// Those that the case gives, because bodies or friction change along the way.
std::vector<WayScalar> ways_of(const contact::Case& input);

}  // namespace rollfem::postprocess
