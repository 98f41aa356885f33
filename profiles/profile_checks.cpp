// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of the points of a profile, in the order in which a user can fix defects: size, side,
// order, duplicates, zig-zag, gaps, kinks (profile_corners.cpp). Repairs happen only on request.
#include "contact/base/errors.hpp"
#include "profiles/profile_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::ProfileSource;

constexpr std::size_t fewest_points = 8;
constexpr double narrowest = 10.0, widest = 1000.0;  // mm
constexpr double same_point = 1e-6;                  // mm

void reverse(ProfilePoints& points) {
  std::reverse(points.list.begin(), points.list.end());
}

void sort(ProfilePoints& points) {
  std::stable_sort(points.list.begin(), points.list.end(),
                   [](const ListedPoint& a, const ListedPoint& b) { return a.y < b.y; });
}

/// Least and largest of one coordinate.
std::array<double, 2> range(const ProfilePoints& points, double ListedPoint::*coordinate) {
  const auto [low, high] = std::minmax_element(
      points.list.begin(), points.list.end(),
      [&](const ListedPoint& a, const ListedPoint& b) { return a.*coordinate < b.*coordinate; });
  return {(*low).*coordinate, (*high).*coordinate};
}

double distance(const ListedPoint& a, const ListedPoint& b) {
  return std::hypot(b.y - a.y, b.z - a.z);
}

void check_count(const ProfilePoints& points) {
  if (points.list.size() >= fewest_points) return;
  throw InputError(
      fmt::format("{}: has {} points; allowed: at least {} (some hundred for a meaningful "
                  "curvature); do: give more points",
                  points.file, points.list.size(), fewest_points));
}

void check_size(const ProfilePoints& points, bool wheel) {
  const auto [left, right] = range(points, &ListedPoint::y);
  const auto [lowest, highest] = range(points, &ListedPoint::z);
  const double width = right - left, height = highest - lowest;
  if (width >= narrowest && width <= widest && height <= widest) return;
  std::string action = "do: check the columns and the unit";
  if (width > 0.0 && width < 1.0)
    action = fmt::format("are the lengths in m? do: put `unit = \"m\"` under {}",
                         section_of_profile(wheel));
  else if (width < narrowest && width > 1.0)
    action = fmt::format("are the lengths in inches? do: put `unit = \"inch\"` under {}",
                         section_of_profile(wheel));
  throw InputError(
      fmt::format("{}: the points span {:.4g} mm in y and {:.4g} mm in z; allowed: {} to {} mm; {}",
                  points.file, width, height, narrowest, widest, action));
}

/// Height z of the curve at the middle of every step of y, so that dense points get no extra
/// weight.
std::vector<double> heights_by_width(const ProfilePoints& points) {
  const auto [low, high] = range(points, &ListedPoint::y);
  constexpr std::size_t bins = 64;
  std::vector<double> sum(bins, 0.0);
  std::vector<int> count(bins, 0);
  for (const ListedPoint& point : points.list) {
    const double place = (point.y - low) / (high - low) * bins;
    const std::size_t bin = std::min(bins - 1, static_cast<std::size_t>(place));
    sum[bin] += point.z;
    ++count[bin];
  }
  std::vector<double> heights;
  for (std::size_t b = 0; b < bins; ++b)
    if (count[b] > 0) heights.push_back(sum[b] / count[b]);
  return heights;
}

/// The wheel's flange and the sides of the rail's head must point from the tread towards +z; the
/// flange is at small y.
void check_side(const ProfilePoints& points, bool wheel) {
  const std::vector<double> heights = heights_by_width(points);
  const double level = median(heights);
  const auto [lowest, highest] = range(points, &ListedPoint::z);
  const double below = highest - level;
  const double above = level - lowest;
  constexpr double clear = 2.0;  // mm; a lower one may be a measured tread without flange
  if (above > clear && above > 1.5 * below)
    throw InputError(
        fmt::format("{}: z seems to point upward: {}; allowed: z down, on the wheel outward from "
                    "the axle; do: put `flip = true` under {}",
                    points.file,
                    wheel ? fmt::format("the flange is {:.4g} mm towards -z", above)
                          : fmt::format("the sides of the head are {:.4g} mm towards -z", above),
                    section_of_profile(wheel)));
  constexpr double flange = 8.0;  // mm
  if (!wheel || below < flange) return;
  // The last of several equal heights.
  const auto tip =
      std::find_if(points.list.rbegin(), points.list.rend(),
                   [top = highest](const ListedPoint& point) { return point.z == top; });
  const auto [left, right] = range(points, &ListedPoint::y);
  if (tip->y <= 0.5 * (left + right)) return;
  throw InputError(fmt::format(
      "{}: the flange is on the wrong side, at y = {:.4g} mm (the points span {:.4g} to {:.4g} "
      "mm); allowed: the flange at the smaller y; do: put `mirror = true` under {}",
      points.file, tip->y, left, right, section_of_profile(wheel)));
}

void check_direction(ProfilePoints& points, bool free, bool wheel) {
  if (points.list.back().y >= points.list.front().y) return;
  if (free) {
    reverse(points);
    return;
  }
  // An unordered list may also end where it should begin; reversing does not help then.
  std::size_t falling = 0;
  for (std::size_t k = 1; k < points.list.size(); ++k)
    falling += points.list[k].y < points.list[k - 1].y;
  if (10 * falling < 9 * (points.list.size() - 1)) return;
  throw InputError(fmt::format(
      "{}:{}: the points run from large to small y ({:.4g} to {:.4g} mm); allowed: from the {} to "
      "the field side; do: put `reverse = true` under {}",
      points.file, points.list.front().line, points.list.front().y, points.list.back().y,
      wheel ? "flange" : "gauge", section_of_profile(wheel)));
}

void treat_duplicates(ProfilePoints& points, bool drop, bool wheel) {
  std::vector<ListedPoint> kept;
  for (const ListedPoint& point : points.list) {
    if (kept.empty() || distance(kept.back(), point) > same_point)
      kept.push_back(point);
    else if (!drop)
      throw InputError(fmt::format(
          "{}:{}: the point y = {:.6g}, z = {:.6g} mm repeats line {}; allowed: points more than "
          "{} mm apart; do: remove it, or put `drop_duplicates = true` under {}",
          points.file, point.line, point.y, point.z, kept.back().line, same_point,
          section_of_profile(wheel)));
  }
  points.list = std::move(kept);
}

/// The curve turns back at a point when it turns by more than a right angle and y falls.
bool goes_back(const ListedPoint& a, const ListedPoint& b, const ListedPoint& c) {
  const double y1 = b.y - a.y, z1 = b.z - a.z;
  const double y2 = c.y - b.y, z2 = c.z - b.z;
  return y1 * y2 + z1 * z2 < 0.0 && std::min(y1, y2) < 0.0;
}

void check_order(const ProfilePoints& points, bool wheel) {
  std::size_t back = 0, first = 0;
  for (std::size_t k = 2; k < points.list.size(); ++k) {
    if (!goes_back(points.list[k - 2], points.list[k - 1], points.list[k])) continue;
    if (back == 0) first = k;
    ++back;
  }
  if (back == 0) return;
  const ListedPoint& at = points.list[first];
  const std::string where = fmt::format("{}:{}: ", points.file, at.line);
  if (back > std::max<std::size_t>(8, points.list.size() / 10))
    throw InputError(fmt::format(
        "{}the points are unordered: the curve turns back {} times; allowed: points in order along "
        "the profile; do: put `sort = true` under {} if z is a function of y",
        where, back, section_of_profile(wheel)));
  throw InputError(fmt::format(
      "{}zig-zag: the curve turns back at y = {:.6g}, z = {:.6g} mm ({} such places); allowed: "
      "points in order along the profile; do: correct them, or put `drop_zigzag = true` under {}",
      where, at.y, at.z, back, section_of_profile(wheel)));
}

void drop_zigzag(ProfilePoints& points) {
  std::vector<ListedPoint> kept;
  for (const ListedPoint& point : points.list)
    if (kept.size() < 2 || !goes_back(kept[kept.size() - 2], kept.back(), point))
      kept.push_back(point);
  points.list = std::move(kept);
}

/// Replaces the points of every stretch of this length, including the shorter last one, by their
/// mean.
void thin(ProfilePoints& points, double length) {
  std::vector<ListedPoint> means;
  for (auto first = points.list.begin(); first != points.list.end();) {
    auto end = first;
    ListedPoint mean{0.0, 0.0, first->line};
    // Straight distance, because the path along noisy points is much longer than the profile.
    for (; end != points.list.end() && distance(*first, *end) < length; ++end) {
      mean.y += end->y;
      mean.z += end->z;
    }
    const auto count = static_cast<double>(end - first);
    mean.y /= count;
    mean.z /= count;
    means.push_back(mean);
    first = end;
  }
  points.list = std::move(means);
}

/// Rejects smoothing of too many points at once, which takes seconds and loses digits.
void check_smoothing(const ProfilePoints& points, double smoothing, bool wheel) {
  constexpr std::size_t most = 20000;
  if (smoothing == 0.0 || points.list.size() <= most) return;
  throw InputError(
      fmt::format("{}: smoothing of {} points; allowed: {}; do: put `thinning = 0.1` (mm, replaces "
                  "the points in each such length by their mean) under {}",
                  points.file, points.list.size(), most, section_of_profile(wheel)));
}

void check_gaps(const ProfilePoints& points, double longest, bool wheel) {
  for (std::size_t k = 1; k < points.list.size(); ++k) {
    const ListedPoint &before = points.list[k - 1], &here = points.list[k];
    const double gap = distance(before, here);
    if (gap <= longest) continue;
    throw InputError(fmt::format(
        "{}:{}: gap of {:.4g} mm between y = {:.6g} and {:.6g} mm; allowed: {} mm; do: add points, "
        "or put `longest_gap = {:.4g}` under {} to bridge it",
        points.file, here.line, gap, before.y, here.y, longest, std::ceil(gap + 0.5),
        section_of_profile(wheel)));
  }
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string section_of_profile(bool wheel) {
  return wheel ? "[wheel_profile]" : "[rail_profile]";
}

void mend_and_check(ProfilePoints& points, const ProfileSource& source, bool wheel) {
  check_count(points);
  check_size(points, wheel);
  if (source.flip)
    for (ListedPoint& point : points.list) point.z = -point.z;
  if (source.mirror)
    for (ListedPoint& point : points.list) point.y = -point.y;
  check_side(points, wheel);
  if (source.reverse) reverse(points);
  if (source.sort) sort(points);
  // Mirroring reverses the direction, so either direction is right then.
  check_direction(points, points.any_direction || source.mirror, wheel);
  if (source.thinning > 0.0) thin(points, source.thinning);
  treat_duplicates(points, source.drop_duplicates, wheel);
  if (source.drop_zigzag) {
    drop_zigzag(points);
    // The neighbours of a removed point may now be equal.
    treat_duplicates(points, true, wheel);
  }
  check_order(points, wheel);
  check_smoothing(points, source.smoothing, wheel);
  check_gaps(points, source.longest_gap, wheel);
  check_count(points);
  treat_corners(points, source, wheel);
  check_count(points);
}

}  // namespace rollfem::profiles
