// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/root.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::track {

namespace {

struct End {
  double at = 0.0;
  double value = 0.0;
  bool known = false;
};

/// One function: `above` is an argument with a positive value (smaller than `below`).
struct Search {
  End above, below;
  double next = 0.0;
  double step = 0.0;
  int repeated = 0;  ///< > 0: successive replacements of `above`, < 0: of `below`
  bool done = false;
};

void take(Search& search, double value) {
  End& end = value > 0.0 ? search.above : search.below;
  const int direction = value > 0.0 ? 1 : -1;
  search.repeated = search.repeated * direction > 0 ? search.repeated + direction : direction;
  end = {search.next, value, true};
  End& other = value > 0.0 ? search.below : search.above;
  // Illinois rule: a retained end gets less weight, otherwise regula falsi creeps from one side.
  if (other.known && std::abs(search.repeated) > 1) other.value *= 0.5;
}

/// Chooses the next argument; false when the search leaves its range.
bool advance(Search& search, const RootOptions& options) {
  if (search.above.known && search.below.known) {
    const double share = search.above.value / (search.above.value - search.below.value);
    search.next = search.above.at + share * (search.below.at - search.above.at);
    search.done = std::abs(search.below.at - search.above.at) < options.tolerance;
    return true;
  }
  const double from = search.above.known ? search.above.at : search.below.at;
  if (std::abs(from) >= options.largest) return false;
  const double to = search.above.known ? from + search.step : from - search.step;
  search.next = std::clamp(to, -options.largest, options.largest);
  search.step *= 4.0;
  return true;
}

}  // namespace

std::vector<double> falling_roots(const Functions& functions, const std::vector<double>& start,
                                  const RootOptions& options, const std::string& what) {
  constexpr int most_evaluations = 60;
  std::vector<Search> searches(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    searches[k].next = start[k];
    searches[k].step = options.step;
  }
  std::vector<double> at = start;
  for (int evaluation = 0; evaluation < most_evaluations; ++evaluation) {
    const std::vector<double> values = functions(at);
    bool all_done = true;
    for (std::size_t k = 0; k < searches.size(); ++k) {
      Search& search = searches[k];
      if (search.done) continue;
      if (std::abs(values[k]) <= options.value_tolerance) {
        search.done = true;
        continue;
      }
      take(search, values[k]);
      if (!advance(search, options))
        throw contact::SolveError(fmt::format("{}: no change of sign between {:g} and {:g}", what,
                                              -options.largest, options.largest));
      at[k] = search.next;
      all_done = all_done && search.done;
    }
    if (all_done) return at;
  }
  throw contact::SolveError(fmt::format("{}: not found in {} evaluations", what, most_evaluations));
}

}  // namespace rollfem::track
