// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/root.hpp"

#include "base/errors.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace rollfem::contact {

namespace {

using Function = std::function<double(double)>;

/// Searches whose end depends on the case have messages of their own.
constexpr const char* remedy =
    "check the units of lengths, loads and materials; if they are right, please report the case as "
    "a defect of the program";

/// The same function, whose values have to be finite.
Function finite(const Function& f, const char* what) {
  return [&f, what](double at) {
    const double found = f(at);
    if (!std::isfinite(found))
      throw SolveError(
          fmt::format("{}: the function is {} at {:.9g}; do: {}", what, found, at, remedy));
    return found;
  };
}

}  // namespace

double root_between(const Function& f, double a, double at_a, double b, double at_b,
                    double tolerance, const char* what) {
  if (b < a) return root_between(f, b, at_b, a, at_a, tolerance, what);
  const auto close = [tolerance](double lower, double upper) {
    constexpr double digits = 4.0 * std::numeric_limits<double>::epsilon();
    return upper - lower <=
           std::max(tolerance, digits * std::max(std::abs(lower), std::abs(upper)));
  };
  // TOMS 748 halves the bracket at least every third evaluation.
  std::uintmax_t evaluations = 400;
  const auto bracket = boost::math::tools::toms748_solve(f, a, b, at_a, at_b, close, evaluations);
  if (!close(bracket.first, bracket.second))
    throw SolveError(fmt::format("{}: not found between {:.17g} and {:.17g} to {:.1e}", what,
                                 bracket.first, bracket.second, tolerance));
  return 0.5 * (bracket.first + bracket.second);
}

double bracketed_root(const Function& f, double a, double b, double tolerance, const char* what) {
  const Function value = finite(f, what);
  if (b < a) std::swap(a, b);
  const double at_a = value(a);
  if (at_a == 0.0) return a;
  const double at_b = value(b);
  if (at_b == 0.0) return b;
  if ((at_a < 0.0) == (at_b < 0.0))
    throw SolveError(
        fmt::format("{}: no change of sign between {:.9g} and {:.9g}: {:.3g}, {:.3g}; do: {}", what,
                    a, b, at_a, at_b, remedy));
  return root_between(value, a, at_a, b, at_b, tolerance, what);
}

std::optional<double> root_from(const Function& f, double start, double at_start, double next,
                                double largest, double tolerance, const char* what) {
  constexpr double growth = 4.0;
  if (at_start == 0.0) return start;
  const Function value = finite(f, what);
  for (double step = next - start;; step *= growth) {
    const double at_next = value(next);
    if (at_next == 0.0) return next;
    if ((at_start < 0.0) != (at_next < 0.0))
      return root_between(value, start, at_start, next, at_next, tolerance, what);
    start = next;
    at_start = at_next;
    next += growth * step;
    if (!(std::abs(next) <= largest)) return {};
  }
}

namespace {

/// Smaller improvements are rounding; without this limit the search could alternate between
/// symmetric points forever.
constexpr double worth_moving = 1e-10;
constexpr int most_moves = 60;

std::vector<std::array<double, 3>> around(const std::array<double, 3>& middle, double step) {
  std::vector<std::array<double, 3>> places;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (i != 0 || j != 0 || k != 0)
          places.push_back({middle[0] + i * step, middle[1] + j * step, middle[2] + k * step});
  return places;
}

}  // namespace

ValueAt local_maximum(const ValuesAt& values, ValueAt start, double step) {
  const double last = 0.01 * step;
  for (int move = 0; move < most_moves && step > last; ++move) {
    const ValueAt before = start;
    for (const ValueAt& other : values(around(before.place, step)))
      if (other.value > start.value + worth_moving * std::abs(start.value)) start = other;
    if (start.value == before.value) step *= 0.5;
  }
  return start;
}

}  // namespace rollfem::contact
