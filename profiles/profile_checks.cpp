// What can be wrong with the points of a profile, in the order in which a user can do something
// about it: size, side, order, duplicates, zig-zag, gaps, kinks (profile_corners.cpp). Nothing is
// mended unless told.
#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include "profiles/profile_points.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::ProfileSource;

constexpr std::size_t fewest_points = 8;
constexpr double narrowest = 10.0, widest = 1000.0;  // mm
constexpr double same_point = 1e-6;                  // mm

void reverse(ProfilePoints& points) {
  std::reverse(points.y.begin(), points.y.end());
  std::reverse(points.z.begin(), points.z.end());
  std::reverse(points.line.begin(), points.line.end());
}

void sort(ProfilePoints& points) {
  std::vector<std::size_t> order(points.y.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points.y[a] < points.y[b]; });
  ProfilePoints sorted = points;
  for (std::size_t k = 0; k < order.size(); ++k) {
    sorted.y[k] = points.y[order[k]];
    sorted.z[k] = points.z[order[k]];
    sorted.line[k] = points.line[order[k]];
  }
  points = std::move(sorted);
}

void check_count(const ProfilePoints& points) {
  if (points.y.size() >= fewest_points) return;
  throw InputError(
      fmt::format("{}: has {} points; allowed: at least {}, better some hundred for a meaningful "
                  "curvature; do: give more",
                  points.file, points.y.size(), fewest_points));
}

double extent(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

void check_size(const ProfilePoints& points, bool wheel) {
  const double width = extent(points.y);
  if (width >= narrowest && width <= widest && extent(points.z) <= widest) return;
  std::string action = "do: check the columns and the unit";
  if (width > 0.0 && width < 1.0)
    action = fmt::format("are the lengths in m? do: put `unit = \"m\"` under {}",
                         section_of_profile(wheel));
  else if (width < narrowest && width > 1.0)
    action = fmt::format("are the lengths in inches? do: put `unit = \"inch\"` under {}",
                         section_of_profile(wheel));
  throw InputError(fmt::format(
      "{}: the points reach over {:.4g} mm in y and {:.4g} mm in z; allowed: {} to {} mm; {}",
      points.file, width, extent(points.z), narrowest, widest, action));
}

/// Height z of the curve at the middle of every step of y, so that dense places count no more.
std::vector<double> heights_by_width(const ProfilePoints& points) {
  const auto [low, high] = std::minmax_element(points.y.begin(), points.y.end());
  constexpr std::size_t bins = 64;
  std::vector<double> sum(bins, 0.0);
  std::vector<int> count(bins, 0);
  for (std::size_t k = 0; k < points.y.size(); ++k) {
    const double place = (points.y[k] - *low) / (*high - *low) * bins;
    const std::size_t bin = std::min(bins - 1, static_cast<std::size_t>(place));
    sum[bin] += points.z[k];
    ++count[bin];
  }
  std::vector<double> heights;
  for (std::size_t b = 0; b < bins; ++b)
    if (count[b] > 0) heights.push_back(sum[b] / count[b]);
  return heights;
}

/// The wheel's flange and the sides of the rail's head stand out from the tread to one side, which
/// has to be +z; the flange is at small y.
void check_side(const ProfilePoints& points, bool wheel) {
  const std::vector<double> heights = heights_by_width(points);
  const double level = median(heights);
  const auto [lowest, highest] = std::minmax_element(points.z.begin(), points.z.end());
  const double below = *highest - level;
  const double above = level - *lowest;
  constexpr double clear = 2.0;  // mm, less may be a measured tread without flange
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
  const auto tip = static_cast<std::size_t>(highest - points.z.begin());
  const auto [left, right] = std::minmax_element(points.y.begin(), points.y.end());
  if (points.y[tip] <= 0.5 * (*left + *right)) return;
  throw InputError(fmt::format(
      "{}: the flange is on the wrong side, at y = {:.4g} mm where the points reach from {:.4g} to "
      "{:.4g} mm; allowed: the flange at the smaller y; do: put `mirror = true` under {}",
      points.file, points.y[tip], *left, *right, section_of_profile(wheel)));
}

void check_direction(ProfilePoints& points, bool free, bool wheel) {
  if (points.y.back() >= points.y.front()) return;
  if (free) {
    reverse(points);
    return;
  }
  // A list without any order also may end where it should begin; then it is no use to reverse it.
  std::size_t falling = 0;
  for (std::size_t k = 1; k < points.y.size(); ++k) falling += points.y[k] < points.y[k - 1];
  if (10 * falling < 9 * (points.y.size() - 1)) return;
  throw InputError(fmt::format(
      "{}:{}: the points run from large to small y ({:.4g} to {:.4g} mm); allowed: from the {} to "
      "the field side; do: put `reverse = true` under {}",
      points.file, points.line.front(), points.y.front(), points.y.back(),
      wheel ? "flange" : "gauge", section_of_profile(wheel)));
}

void treat_duplicates(ProfilePoints& points, bool drop, bool wheel) {
  std::vector<char> kept(points.y.size(), 1);
  std::size_t last = 0;
  for (std::size_t k = 1; k < points.y.size(); ++k) {
    if (std::hypot(points.y[k] - points.y[last], points.z[k] - points.z[last]) > same_point) {
      last = k;
      continue;
    }
    if (!drop)
      throw InputError(fmt::format(
          "{}:{}: the point y = {:.6g}, z = {:.6g} mm repeats line {}; allowed: points more than "
          "{} mm apart; do: remove it, or put `drop_duplicates = true` under {}",
          points.file, points.line[k], points.y[k], points.z[k], points.line[last], same_point,
          section_of_profile(wheel)));
    kept[k] = 0;
  }
  if (drop) keep_marked(points, kept);
}

/// A point goes back when the curve turns there by more than a right angle and y falls.
bool goes_back(const ProfilePoints& p, std::size_t a, std::size_t b, std::size_t c) {
  const double y1 = p.y[b] - p.y[a], z1 = p.z[b] - p.z[a];
  const double y2 = p.y[c] - p.y[b], z2 = p.z[c] - p.z[b];
  return y1 * y2 + z1 * z2 < 0.0 && std::min(y1, y2) < 0.0;
}

void check_order(const ProfilePoints& points, bool wheel) {
  std::size_t back = 0, first = 0;
  for (std::size_t k = 2; k < points.y.size(); ++k) {
    if (!goes_back(points, k - 2, k - 1, k)) continue;
    if (back == 0) first = k;
    ++back;
  }
  if (back == 0) return;
  const std::string where = fmt::format("{}:{}: ", points.file, points.line[first]);
  if (back > std::max<std::size_t>(8, points.y.size() / 10))
    throw InputError(fmt::format(
        "{}the points are unordered: the curve turns back {} times; allowed: points in order along "
        "the profile; do: put `sort = true` under {} if z is a function of y",
        where, back, section_of_profile(wheel)));
  throw InputError(fmt::format(
      "{}zig-zag: the curve turns back at y = {:.6g}, z = {:.6g} mm ({} such places); allowed: "
      "points in order along the profile; do: correct them, or put `drop_zigzag = true` under {}",
      where, points.y[first], points.z[first], back, section_of_profile(wheel)));
}

void drop_zigzag(ProfilePoints& points) {
  std::vector<std::size_t> stack;
  std::vector<char> kept(points.y.size(), 1);
  for (std::size_t k = 0; k < points.y.size(); ++k) {
    if (stack.size() >= 2 && goes_back(points, stack[stack.size() - 2], stack.back(), k)) {
      kept[k] = 0;
      continue;
    }
    stack.push_back(k);
  }
  keep_marked(points, kept);
}

/// Every stretch of this length becomes the mean of its points; the last, shorter one too.
void thin(ProfilePoints& points, double length) {
  std::size_t n = 0;
  for (std::size_t first = 0; first < points.y.size();) {
    std::size_t end = first;
    double y = 0.0, z = 0.0;
    // As the crow flies: the way along noisy points is much longer than the profile.
    for (; end < points.y.size() &&
           std::hypot(points.y[end] - points.y[first], points.z[end] - points.z[first]) < length;
         ++end) {
      y += points.y[end];
      z += points.z[end];
    }
    const auto count = static_cast<double>(end - first);
    points.line[n] = points.line[first];
    points.y[n] = y / count;
    points.z[n] = z / count;
    ++n;
    first = end;
  }
  points.y.resize(n);
  points.z.resize(n);
  points.line.resize(n);
}

/// Smoothing so many points at once takes seconds and loses digits.
void check_smoothing(const ProfilePoints& points, double smoothing, bool wheel) {
  constexpr std::size_t most = 20000;
  if (smoothing == 0.0 || points.y.size() <= most) return;
  throw InputError(
      fmt::format("{}: smoothing of {} points; allowed: {}; do: put `thinning = 0.1` (mm, replaces "
                  "the points in each such length by their mean) under {}",
                  points.file, points.y.size(), most, section_of_profile(wheel)));
}

void check_gaps(const ProfilePoints& points, double longest, bool wheel) {
  for (std::size_t k = 1; k < points.y.size(); ++k) {
    const double gap = std::hypot(points.y[k] - points.y[k - 1], points.z[k] - points.z[k - 1]);
    if (gap <= longest) continue;
    throw InputError(fmt::format(
        "{}:{}: gap of {:.4g} mm between y = {:.6g} and {:.6g} mm; allowed: {} mm; do: add points, "
        "or put `longest_gap = {:.4g}` under {} to bridge it",
        points.file, points.line[k], gap, points.y[k - 1], points.y[k], longest,
        std::ceil(gap + 0.5), section_of_profile(wheel)));
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

void keep_marked(ProfilePoints& points, const std::vector<char>& kept) {
  std::size_t n = 0;
  for (std::size_t k = 0; k < points.y.size(); ++k) {
    if (kept[k] == 0) continue;
    points.y[n] = points.y[k];
    points.z[n] = points.z[k];
    points.line[n] = points.line[k];
    ++n;
  }
  points.y.resize(n);
  points.z.resize(n);
  points.line.resize(n);
}

void mend_and_check(ProfilePoints& points, const ProfileSource& source, bool wheel) {
  check_count(points);
  check_size(points, wheel);
  if (source.flip)
    for (double& z : points.z) z = -z;
  if (source.mirror)
    for (double& y : points.y) y = -y;
  check_side(points, wheel);
  if (source.reverse) reverse(points);
  if (source.sort) sort(points);
  // Mirroring turns the direction around, so that neither way is wrong then.
  check_direction(points, points.any_direction || source.mirror, wheel);
  if (source.thinning > 0.0) thin(points, source.thinning);
  treat_duplicates(points, source.drop_duplicates, wheel);
  if (source.drop_zigzag) {
    drop_zigzag(points);
    // What was between two equal points is gone.
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
