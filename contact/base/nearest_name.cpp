#include "contact/base/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace rollfem::contact {

namespace {

/// Number of insertions, deletions and replacements that make one word the other (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string nearest;
  // Half of the letters may be wrong, or else the guess would puzzle more than it helps.
  std::size_t smallest = (std::min<std::size_t>(name.size(), 40) + 1) / 2 + 1;
  if (name.size() > 80) return nearest;
  for (const std::string& candidate : candidates) {
    const bool part = name.size() > 2 && candidate.find(name) != std::string::npos;
    const std::size_t distance = part ? 1 : edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = nearest_name(name, candidates);
  return near.empty() ? "" : fmt::format("did you mean {}? ", near);
}

}  // namespace rollfem::contact
