// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions of the interface that differ only in their work: one row each. A row names the function
// and its work; the arguments are checked here, and errors go to `guarded`.
#pragma once

#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"

#include <vector>

namespace rollfem::addon {

using Values = std::vector<double>;

/// A setting by finite values. `icp` of a setting of wheel and rail: of_pair.
inline constexpr int of_pair = -1'000'000;
void set_values(const char* function, Int ire, Int icp, Int kind, Int count, Real values,
                void (*work)(int kind, const Values& values, Problem& problem));
void set_numbers(const char* function, Int ire, Int icp,
                 std::initializer_list<const double*> numbers,
                 void (*work)(const Values& numbers, Problem& problem));

/// Numbers of a patch; nan where there are none.
void get_numbers(const char* function, Int ire, Int icp, std::initializer_list<double*> numbers,
                 Values (*work)(Problem& problem, const Patch& patch));
/// As many as the client's array holds; the rest is nan.
void get_array(const char* function, Int ire, Int icp, Int length, double* values,
               Values (*work)(Problem& problem, const Patch& patch));
/// The fields of these codes.
void get_fields(const char* function, Int ire, Int icp, Int length,
                std::initializer_list<int> codes, std::initializer_list<double*> fields);
/// Of an array: `arguments` without it.
void fill(const char* function, std::initializer_list<const void*> arguments, Int length,
          double* values, const std::function<void(Values&)>& work);

/// Throws Refusal for a null array and for values that are not finite.
Values finite_values(Real values, int count);
/// In mm, as many values as there are powers, which must be given.
Values taken(const Units& units, Values values, const std::vector<int>& powers);

// NOLINTBEGIN(bugprone-macro-parentheses)
#define ADDON_VALUES(function, work)                                  \
  void function(Int ire, Int icp, Int kind, Int count, Real values) { \
    set_values(#function, ire, icp, kind, count, values, work);       \
  }
#define ADDON_PAIR_VALUES(function, work)                            \
  void function(Int ire, Int kind, Int count, Real values) {         \
    set_values(#function, ire, &of_pair, kind, count, values, work); \
  }
#define ADDON_NUMBER(function, ...)                                                          \
  void function(Int ire, Int icp, Real a) {                                                  \
    set_numbers(#function, ire, icp, {a}, [](const Values& v, Problem& p) { __VA_ARGS__; }); \
  }
#define ADDON_NUMBERS_2(function, ...)                                                          \
  void function(Int ire, Int icp, Real a, Real b) {                                             \
    set_numbers(#function, ire, icp, {a, b}, [](const Values& v, Problem& p) { __VA_ARGS__; }); \
  }
#define ADDON_WORK [](Problem & problem, const Patch& patch)
#define ADDON_NAMES                                \
  const Units& u = problem.units;                  \
  const contact::PointResult& point = patch.point; \
  static_cast<void>(u);                            \
  static_cast<void>(point);
#define ADDON_RESULT(function, ...)                                                        \
  void function(Int ire, Int icp, double* a) {                                             \
    get_numbers(                                                                           \
        #function, ire, icp, {a}, ADDON_WORK { ADDON_NAMES return Values{__VA_ARGS__}; }); \
  }
#define ADDON_RESULTS_2(function, ...)                                                        \
  void function(Int ire, Int icp, double* a, double* b) {                                     \
    get_numbers(                                                                              \
        #function, ire, icp, {a, b}, ADDON_WORK { ADDON_NAMES return Values{__VA_ARGS__}; }); \
  }
#define ADDON_RESULTS_3(function, work)                              \
  void function(Int ire, Int icp, double* a, double* b, double* c) { \
    get_numbers(#function, ire, icp, {a, b, c}, work);               \
  }
#define ADDON_ARRAY(function, work)                             \
  void function(Int ire, Int icp, Int length, double* values) { \
    get_array(#function, ire, icp, length, values, work);       \
  }
#define ADDON_FIELDS_2(function, ...)                                 \
  void function(Int ire, Int icp, Int length, double* a, double* b) { \
    get_fields(#function, ire, icp, length, {__VA_ARGS__}, {a, b});   \
  }
#define ADDON_FIELDS_3(function, ...)                                            \
  void function(Int ire, Int icp, Int length, double* a, double* b, double* c) { \
    get_fields(#function, ire, icp, length, {__VA_ARGS__}, {a, b, c});           \
  }
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace rollfem::addon
