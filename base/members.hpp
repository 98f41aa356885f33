// SPDX-License-Identifier: LGPL-2.1-or-later
// A struct of results lists its members once, with what files say of them:
//
//   struct StressMaximum {
//     std::string body;
//     double value = 0.0;
//     static constexpr auto members() {
//       using S = StressMaximum;
//       return std::tuple(member("body", &S::body, "", "wheel or rail"),
//                         member("value", &S::value, "MPa", "largest value"));
//     }
//   };
//
// Records of unfinished runs, results.h5, summary.json, tables, the check that numbers are finite
// and Python walk along this list.
#pragma once

#include <functional>
#include <tuple>
#include <type_traits>

namespace rollfem::contact {

/// How a list of structs stands in files: by number, by the first member of each, or as a table
/// with a column for each member.
enum class Listed { numbered, by_first, as_table };

/// Who keeps a member.
enum class Kept {
  always,    ///< every file
  if_given,  ///< every file, where it is not empty
  within,    ///< records alone: what the program itself needs
};

/// `part`: a member, or a member function for a value that follows from the members.
template <Kept who, class Whole, class Part>
struct Member {
  static constexpr Kept kept = who;
  const char* name;  ///< in every file
  Part Whole::*part;
  const char* unit;  ///< "-" of a number without one; empty: not a number
  const char* meaning;
  const char* sign;
};

template <class Whole, class Part>
constexpr Member<Kept::always, Whole, Part> member(const char* name, Part Whole::*part,
                                                   const char* unit = "", const char* meaning = "",
                                                   const char* sign = "") {
  return {name, part, unit, meaning, sign};
}
template <class Whole, class Part>
constexpr Member<Kept::if_given, Whole, Part> member_if_given(const char* name, Part Whole::*part,
                                                              const char* unit = "",
                                                              const char* meaning = "") {
  return {name, part, unit, meaning, ""};
}
template <class Whole, class Part>
constexpr Member<Kept::within, Whole, Part> member_within(const char* name, Part Whole::*part) {
  return {name, part, "", "", ""};
}

template <class Whole, class = void>
inline constexpr bool has_members = false;
template <class Whole>
inline constexpr bool has_members<Whole, std::void_t<decltype(Whole::members())>> = true;

/// visit(member) for each member of a struct.
template <class Whole, class Visit>
void for_members(const Visit& visit) {
  std::apply([&](const auto&... each) { (visit(each), ...); }, Whole::members());
}
/// visit(member, value) for each.
template <class Whole, class Visit>
void for_members(Whole& whole, const Visit& visit) {
  for_members<std::remove_const_t<Whole>>(
      [&](const auto& each) { visit(each, std::invoke(each.part, whole)); });
}

}  // namespace rollfem::contact
