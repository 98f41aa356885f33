#include "contact/solve/maximum_search.hpp"

#include <cmath>

namespace rollfem::contact {

namespace {

/// Less than this is rounding: symmetric places must not be exchanged for ever.
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
