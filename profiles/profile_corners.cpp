// SPDX-License-Identifier: LGPL-2.1-or-later
// Error messages name the smallest repair that would help.
#include "profiles/profile_corners.hpp"

#include "base/pi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rollfem::profiles {

namespace {

using contact::ProfileSource;

constexpr double shortest_distance = 1e-6;  // mm
constexpr double degree = contact::pi / 180.0;
/// Marks of corners().
constexpr char kink = 1, step = 2;

/// Angle from the chord a-b to the chord b-c, rad, > 0 towards +z.
double turn(const ProfilePoints& p, std::size_t a, std::size_t b, std::size_t c) {
  const double y1 = p.list[b].y - p.list[a].y, z1 = p.list[b].z - p.list[a].z;
  const double y2 = p.list[c].y - p.list[b].y, z2 = p.list[c].z - p.list[b].z;
  return std::atan2(y1 * z2 - z1 * y2, y1 * y2 + z1 * z2);
}

/// Largest turn at a point explained by scatter (mm, standard deviation across the profile), rad:
/// five standard deviations of (n2 - n1) / b - (n1 - n0) / a, with the chords a and b that meet
/// there. A chord turns by an arc tangent, two chords by twice the arc tangent of half as much.
double turn_by_scatter(const ProfilePoints& p, std::size_t k, double scatter) {
  if (scatter == 0.0) return 0.0;
  // Scatter makes the chords longer than the spacing of the points along the profile.
  const std::size_t from = k < 3 ? 0 : k - 3, to = std::min(k + 3, p.list.size() - 1);
  const double y = p.list[to].y - p.list[from].y, z = p.list[to].z - p.list[from].z;
  const auto along = [&](std::size_t i) {
    const double distance =
        (y * (p.list[i + 1].y - p.list[i].y) + z * (p.list[i + 1].z - p.list[i].z)) /
        std::hypot(y, z);
    return std::max(std::abs(distance), shortest_distance);
  };
  const double a = 1.0 / along(k - 1), b = 1.0 / along(k);
  const double deviation = scatter * std::sqrt(a * a + b * b + (a + b) * (a + b));
  return 2.0 * std::atan(0.5 * 5.0 * deviation);
}

/// Points at which the profile has a kink (one turn) or a step (there and back), marked 1 and 2,
/// beyond the effect of the scatter of the points.
std::vector<char> corners(const ProfilePoints& points, double largest_kink, double scatter) {
  const std::size_t n = points.list.size();
  std::vector<double> turns(n, 0.0), sizes;
  sizes.reserve(n);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    turns[k] = turn(points, k - 1, k, k + 1);
    sizes.push_back(std::abs(turns[k]));
  }
  // A step smaller than the allowed kinks still stands out from the turns of the other points.
  const double least_step =
      std::min(largest_kink * degree, std::max(5.0 * degree, 10.0 * median(sizes)));
  const auto size = [&](std::size_t k) { return k < n ? std::abs(turns[k]) : 0.0; };
  std::vector<double> noise(n, 0.0);
  for (std::size_t k = 1; k + 1 < n; ++k) noise[k] = turn_by_scatter(points, k, scatter);
  std::vector<char> found(n, 0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    // The profile's own turn and the turn by scatter are independent.
    const double largest = std::hypot(largest_kink * degree, noise[k]);
    if (size(k) > largest && found[k] == 0) found[k] = kink;
    if (k + 2 >= n) continue;
    const double both = size(k) + size(k + 1);
    if (turns[k] * turns[k + 1] < 0.0) {
      if (size(k) > std::max(least_step, noise[k]) &&
          size(k + 1) > std::max(least_step, noise[k + 1]))
        found[k] = found[k + 1] = step;
    } else if (both > largest && 4.0 * std::max(size(k - 1), size(k + 2)) < both) {
      // A kink between two points is shared by both.
      found[k] = found[k + 1] = kink;
    }
  }
  return found;
}

/// Removes the points within `rounding` (mm along the profile) on both sides of a corner.
ProfilePoints rounded(const ProfilePoints& points, const std::vector<char>& found,
                      double rounding) {
  std::vector<double> length(points.list.size(), 0.0);
  for (std::size_t k = 1; k < length.size(); ++k)
    length[k] = length[k - 1] + std::hypot(points.list[k].y - points.list[k - 1].y,
                                           points.list[k].z - points.list[k - 1].z);
  std::vector<char> kept(points.list.size(), 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k] == 0) continue;
    for (std::size_t i = k; i > 0 && length[k] - length[i] < rounding; --i) kept[i] = 0;
    for (std::size_t i = k; i + 1 < found.size() && length[i] - length[k] < rounding; ++i)
      kept[i] = 0;
  }
  ProfilePoints rest{points.file, {}, points.any_direction};
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (kept[k] != 0) rest.list.push_back(points.list[k]);
  return rest;
}

bool has(const std::vector<char>& found, char mark) {
  return std::find(found.begin(), found.end(), mark) != found.end();
}

/// The smallest of these that leaves no step; the turn of a kink remains, spread over the removed
/// points.
std::optional<double> least_rounding(const ProfilePoints& points, const std::vector<char>& found,
                                     const ProfileSource& source) {
  for (const double rounding : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0}) {
    const ProfilePoints rest = rounded(points, found, rounding);
    if (rest.list.size() < points.list.size() / 2) break;
    if (!has(corners(rest, source.largest_kink, source.smoothing), step)) return rounding;
  }
  return {};
}

/// The largest of the kinks, rad; two points may share one.
double largest_kink_of(const ProfilePoints& points, const std::vector<char>& found) {
  double largest = 0.0, before = 0.0;
  for (std::size_t k = 1; k + 1 < found.size(); ++k) {
    const double here = found[k] == kink ? turn(points, k - 1, k, k + 1) : 0.0;
    largest = std::max({largest, std::abs(here), std::abs(here + before)});
    before = here;
  }
  return largest;
}

[[noreturn]] void refuse_corner(const ProfilePoints& points, const std::vector<char>& found,
                                const ProfileSource& source) {
  auto k = static_cast<std::size_t>(
      std::find_if(found.begin(), found.end(), [](char c) { return c != 0; }) - found.begin());
  const bool is_step = found[k] == step;
  const auto turn_at = [&](std::size_t i) { return turn(points, i - 1, i, i + 1); };
  const bool shared = k + 2 < found.size() && found[k + 1] == kink;
  const double whole = turn_at(k) + (shared && !is_step ? turn_at(k + 1) : 0.0);
  // The point with the larger turn of two that share a kink.
  if (shared && !is_step && std::abs(turn_at(k + 1)) > std::abs(turn_at(k))) ++k;
  const double chord =
      std::hypot(points.list[k + 1].y - points.list[k].y, points.list[k + 1].z - points.list[k].z);
  const std::string what =
      is_step ? fmt::format("step of {:.2g} mm", chord * std::abs(std::sin(turn_at(k))))
              : fmt::format("kink of {:.3g} degrees", std::abs(whole) / degree);
  const std::string allowed =
      is_step ? "points on one smooth curve"
              : fmt::format("{:.4g} degrees between two chords", source.largest_kink);
  PointFault fault{
      points.list[k].line,
      fmt::format("{} at y = {:.6g}, z = {:.6g} mm", what, points.list[k].y, points.list[k].z),
      allowed, "correct the points"};
  if (const double scatter = least_smoothing(points, source); scatter > 0.0)
    fault.repairs.push_back(repair("smoothing", &ProfileSource::smoothing, scatter,
                                   " (mm, the scatter that would explain it)"));
  if (const auto rounding = least_rounding(points, found, source))
    fault.repairs.push_back(
        repair("rounding", &ProfileSource::rounding, *rounding, " (mm, bridged on both sides)"));
  if (const double largest = largest_kink_of(points, found) / degree; !is_step && largest < 100.0)
    fault.repairs.push_back(
        repair("largest_kink", &ProfileSource::largest_kink, std::ceil(largest + 0.01)));
  throw fault;
}

}  // namespace

double least_smoothing(const ProfilePoints& points, const ProfileSource& source) {
  const std::vector<char> found = corners(points, source.largest_kink, source.smoothing);
  const auto places = std::count_if(found.begin(), found.end(), [](char c) { return c != 0; });
  if (places <= 8 || 50 * static_cast<std::size_t>(places) < found.size()) return 0.0;
  for (const double scatter :
       {0.001, 0.002, 0.003, 0.005, 0.007, 0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1}) {
    if (scatter <= source.smoothing) continue;
    const std::vector<char> left = corners(points, source.largest_kink, scatter);
    if (!has(left, kink) && !has(left, step)) return scatter;
  }
  return 0.0;
}

std::vector<double> kinks_of(const ProfileCurve& curve) {
  ProfilePoints points;
  for (const ProfileKnot& knot : curve.knots()) points.list.push_back({knot.y, knot.z, 0});
  const std::vector<char> found = corners(points, ProfileSource{}.largest_kink, 0.0);
  std::vector<double> kinks;
  for (std::size_t k = 1, first = 0; k + 1 < found.size(); ++k) {
    if (found[k] == kink && found[k - 1] != kink) first = k;
    if (found[k] == kink && found[k + 1] != kink)
      kinks.push_back(curve.knots()[(first + k) / 2].parameter);
  }
  return kinks;
}

void treat_corners(ProfilePoints& points, const ProfileSource& source) {
  const std::vector<char> found = corners(points, source.largest_kink, source.smoothing);
  if (!has(found, kink) && !has(found, step)) return;
  if (source.rounding == 0.0) refuse_corner(points, found, source);
  points = rounded(points, found, source.rounding);
}

}  // namespace rollfem::profiles
