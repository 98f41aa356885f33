// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/rows.hpp"

#include "bindings/contact/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::addon {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int longest = 4'000'000;

Values finite_values(const double* values, int count) {
  if (count > longest) throw Refusal(err_other, "an array of impossible length");
  if (count > 0 && values == nullptr) throw Refusal(err_other, "an argument is null");
  Values given(values, values + std::max(count, 0));
  for (const double value : given)
    if (!std::isfinite(value)) throw Refusal(err_other, "a value is not finite");
  return given;
}

}  // namespace

void set_values(const char* function, const int* ire, const int* icp, const int* kind,
                const int* count, const double* values,
                void (*work)(int, const Values&, Problem&)) {
  guarded(function, {ire, icp, kind, count}, nullptr, [&] {
    const Values given = finite_values(values, *count);
    for_problems(*ire, *icp, [&](Problem& problem) { work(*kind, given, problem); });
    return 0;
  });
}

void set_pair_values(const char* function, const int* ire, const int* kind, const int* count,
                     const double* values, void (*work)(int, const Values&, Problem&)) {
  guarded(function, {ire, kind, count}, nullptr, [&] {
    const Values given = finite_values(values, *count);
    for_pair(*ire, [&](Problem& problem) { work(*kind, given, problem); });
    return 0;
  });
}

void set_numbers(const char* function, const int* ire, const int* icp,
                 std::initializer_list<const double*> numbers,
                 void (*work)(const Values&, Problem&)) {
  guarded(function, {ire, icp}, nullptr, [&] {
    Values given;
    for (const double* number : numbers) given.push_back(finite_values(number, 1).front());
    for_problems(*ire, *icp, [&](Problem& problem) { work(given, problem); });
    return 0;
  });
}

void get_numbers(const char* function, const int* ire, const int* icp,
                 std::initializer_list<double*> numbers, Values (*work)(Problem&, const Patch&)) {
  guarded(function, {ire, icp}, nullptr, [&] {
    for (double* number : numbers) {
      if (number == nullptr) throw Refusal(err_other, "an argument is null");
      *number = none;
    }
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      const Values found = work(problem, patch);
      std::size_t k = 0;
      for (double* number : numbers) *number = found.at(k++);
    });
    return 0;
  });
}

void fill(const char* function, std::initializer_list<const void*> arguments, const int* length,
          double* values, const std::function<Values()>& work) {
  guarded(function, arguments, nullptr, [&] {
    if (length == nullptr || values == nullptr) throw Refusal(err_other, "an argument is null");
    if (*length < 0 || *length > longest) throw Refusal(err_other, "an array of impossible length");
    std::fill_n(values, *length, none);
    const Values found = work();
    std::copy_n(found.begin(), std::min(found.size(), static_cast<std::size_t>(*length)), values);
    return 0;
  });
}

void get_array(const char* function, const int* ire, const int* icp, const int* length,
               double* values, Values (*work)(Problem&, const Patch&)) {
  fill(function, {ire, icp}, length, values, [&] {
    Values found;
    for_patch(*ire, *icp,
              [&](Problem& problem, const Patch& patch) { found = work(problem, patch); });
    return found;
  });
}

void get_fields(const char* function, const int* ire, const int* icp, const int* length,
                std::initializer_list<int> codes, std::initializer_list<double*> fields) {
  const int* code = codes.begin();
  for (double* field : fields) {
    fill(function, {ire, icp}, length, field, [&] {
      Values found;
      for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
        found = field_values(*code, problem, patch);
        if (*length < patch.size())
          throw Refusal(err_other, fmt::format("the array has {} values, the patch {} elements",
                                               *length, patch.size()));
      });
      return found;
    });
    ++code;
  }
}

Values in_mm(const Units& units, const Values& values, const std::vector<int>& powers) {
  Values made = values;
  for (std::size_t k = 0; k < made.size(); ++k)
    made[k] = units.in(made[k], powers[std::min(k, powers.size() - 1)]);
  return made;
}

Values taken(const Units& units, const Values& values, const std::vector<int>& powers) {
  demand_values(static_cast<int>(values.size()), static_cast<int>(powers.size()));
  return in_mm(units,
               Values(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(powers.size())),
               powers);
}

}  // namespace rollfem::addon
