// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::addon {

namespace {

constexpr int longest = 4'000'000;

}  // namespace

Values finite_values(Real values, int count) {
  if (count > longest) throw Refusal(err_other, "an array of impossible length");
  if (count > 0 && values == nullptr) throw Refusal(err_other, "an argument is null");
  Values given(values, values + std::max(count, 0));
  for (const double value : given)
    if (!std::isfinite(value)) throw Refusal(err_other, "a value is not finite");
  return given;
}

void set_values(const char* function, Int ire, Int icp, Int kind, Int count, Real values,
                void (*work)(int, const Values&, Problem&)) {
  guarded(function, {ire, icp, kind, count}, [&] {
    const Values given = finite_values(values, *count);
    const auto set = [&](Problem& problem) { work(*kind, given, problem); };
    *icp == of_pair ? for_pair(*ire, set) : for_problems(*ire, *icp, set);
  });
}

void set_numbers(const char* function, Int ire, Int icp,
                 std::initializer_list<const double*> numbers,
                 void (*work)(const Values&, Problem&)) {
  guarded(function, {ire, icp}, [&] {
    Values given;
    for (const double* number : numbers) given.push_back(finite_values(number, 1).front());
    for_problems(*ire, *icp, [&](Problem& problem) { work(given, problem); });
  });
}

void get_numbers(const char* function, Int ire, Int icp, std::initializer_list<double*> numbers,
                 Values (*work)(Problem&, const Patch&)) {
  guarded(function, {ire, icp}, [&] {
    for (double* number : numbers) {
      if (number == nullptr) throw Refusal(err_other, "an argument is null");
      *number = none;
    }
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      const Values found = work(problem, patch);
      std::size_t k = 0;
      for (double* number : numbers) *number = found.at(k++);
    });
  });
}

void fill(const char* function, std::initializer_list<const void*> arguments, Int length,
          double* values, const std::function<void(Values&)>& work) {
  guarded(function, arguments, [&] {
    if (length == nullptr || values == nullptr) throw Refusal(err_other, "an argument is null");
    if (*length < 0 || *length > longest) throw Refusal(err_other, "an array of impossible length");
    std::fill_n(values, *length, none);
    Values found;
    work(found);
    std::copy_n(found.begin(), std::min(found.size(), static_cast<std::size_t>(*length)), values);
  });
}

void get_array(const char* function, Int ire, Int icp, Int length, double* values,
               Values (*work)(Problem&, const Patch&)) {
  fill(function, {ire, icp}, length, values, [&](Values& found) {
    for_patch(*ire, *icp,
              [&](Problem& problem, const Patch& patch) { found = work(problem, patch); });
  });
}

void get_fields(const char* function, Int ire, Int icp, Int length,
                std::initializer_list<int> codes, std::initializer_list<double*> fields) {
  const int* code = codes.begin();
  for (double* field : fields) {
    fill(function, {ire, icp}, length, field, [&](Values& found) {
      for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
        found = field_values(*code, problem, patch);
        if (*length < patch.size())
          throw Refusal(err_other, fmt::format("the array has {} values, the patch {} elements",
                                               *length, patch.size()));
      });
    });
    ++code;
  }
}

Values taken(const Units& units, Values values, const std::vector<int>& powers) {
  if (values.size() < powers.size())
    throw Refusal(err_other,
                  fmt::format("{} values are given, {} are needed", values.size(), powers.size()));
  values.resize(powers.size());
  return units.in(std::move(values), powers);
}

}  // namespace rollfem::addon
