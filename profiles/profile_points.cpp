// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of the points of a profile, in the order in which a user can fix defects: size, side,
// order, duplicates, zig-zag, gaps, kinks (profile_corners.cpp). Repairs happen only on request.
#include "profiles/profile_points.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "profiles/profile_corners.hpp"
#include "profiles/profiles.hpp"
#include "profiles/smoothing_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rollfem::profiles {

namespace {

using contact::InputError;
using contact::LengthUnit;
using contact::ProfileSource;

// Places at which the curve through the points turns back, and which points to drop there.

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t no_point = std::numeric_limits<std::size_t>::max();

/// Cost of the curve a-b-c: `never` where it turns back, by more than a right angle with y falling;
/// otherwise it grows with the turn, and stays far below that of a dropped point.
double cost_of_turn(const ListedPoint& a, const ListedPoint& b, const ListedPoint& c) {
  const double y1 = b.y - a.y, z1 = b.z - a.z;
  const double y2 = c.y - b.y, z2 = c.z - b.z;
  const double along = y1 * y2 + z1 * z2;
  if (along < 0.0 && std::min(y1, y2) < 0.0) return never;
  const double turn = std::atan2(y1 * z2 - z1 * y2, along) / contact::pi;
  return 1e-3 * turn * turn;
}

/// The points at which the curve turns back.
std::vector<std::size_t> turns_back(const std::vector<ListedPoint>& list) {
  std::vector<std::size_t> places;
  for (std::size_t k = 2; k < list.size(); ++k)
    if (cost_of_turn(list[k - 2], list[k - 1], list[k]) == never) places.push_back(k - 1);
  return places;
}

/// The cheapest curve that ends with a point and one before it: its cost, and how many points it
/// drops before that one, `no_point` where that one is the first.
struct Way {
  double cost = never;
  std::size_t before = no_point;
};

/// Ways to every point, by the number of points dropped right before it; none where the curve turns
/// back. `run[k]`: how many points right before k may be dropped.
std::vector<std::vector<Way>> ways_along(const std::vector<ListedPoint>& list,
                                         const std::vector<std::size_t>& run) {
  std::vector<std::vector<Way>> ways(list.size());
  for (std::size_t k = 1; k < list.size(); ++k) {
    ways[k].resize(std::min(run[k], k - 1) + 1);
    for (std::size_t dropped = 0; dropped < ways[k].size(); ++dropped) {
      const std::size_t j = k - 1 - dropped;
      Way& best = ways[k][dropped];
      if (run[j] >= j) best.cost = static_cast<double>(j + dropped);
      for (std::size_t before = 0; before < ways[j].size(); ++before) {
        const double cost = ways[j][before].cost + static_cast<double>(dropped) +
                            cost_of_turn(list[j - 1 - before], list[j], list[k]);
        if (cost < best.cost) best = {cost, before};
      }
    }
  }
  return ways;
}

/// The points of the cheapest curve; empty if dropping up to `reach` points in a row is not enough.
std::vector<ListedPoint> cheapest(const std::vector<ListedPoint>& list, std::size_t reach) {
  const std::size_t n = list.size();
  std::vector<char> loose(n, 0);
  for (const std::size_t place : turns_back(list))
    for (std::size_t k = place - std::min(place, reach); k <= std::min(place + reach, n - 1); ++k)
      loose[k] = 1;
  std::vector<std::size_t> run(n + 1, 0);
  for (std::size_t k = 0; k < n; ++k)
    if (loose[k] != 0) run[k + 1] = std::min(run[k] + 1, reach);
  const std::vector<std::vector<Way>> ways = ways_along(list, run);
  double least = never;
  std::size_t last = 0, dropped = 0;
  for (std::size_t k = n; k-- > 1 && run[n] >= n - 1 - k;)
    for (std::size_t d = 0; d < ways[k].size(); ++d)
      if (const double cost = ways[k][d].cost + static_cast<double>(n - 1 - k); cost < least)
        least = cost, last = k, dropped = d;
  std::vector<ListedPoint> kept;
  if (least == never) return kept;
  for (std::size_t k = last;;) {
    kept.push_back(list[k]);
    const std::size_t before = ways[k][dropped].before;
    k -= 1 + dropped;
    dropped = before;
    if (before != no_point) continue;
    kept.push_back(list[k]);
    break;
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

constexpr std::size_t fewest_points = 8;
constexpr double narrowest = 10.0, widest = 1000.0;  // mm
constexpr double same_point = 1e-6;                  // mm
constexpr double least_flange = 8.0;                 // mm

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
  if (points.list.size() < fewest_points)
    throw PointFault{
        0, fmt::format("has {} points", points.list.size()),
        fmt::format("at least {} (some hundred for a meaningful curvature)", fewest_points),
        "give more points"};
}

double mm_in(LengthUnit unit) {
  return unit == LengthUnit::m ? 1000.0 : unit == LengthUnit::inch ? 25.4 : 1.0;
}

PointRepair unit_repair(LengthUnit unit, const char* name) {
  return {"unit", fmt::format("\"{}\"", name), "",
          [unit](ProfileSource& source) { source.unit = unit; }};
}

void check_size(const ProfilePoints& points, LengthUnit unit) {
  const auto [left, right] = range(points, &ListedPoint::y);
  const auto [lowest, highest] = range(points, &ListedPoint::z);
  const double width = right - left, height = highest - lowest;
  if (width >= narrowest && width <= widest && height <= widest) return;
  PointFault fault{0,
                   fmt::format("the points span {:.4g} mm in y and {:.4g} mm in z", width, height),
                   fmt::format("{} to {} mm", narrowest, widest), "check the columns and the unit"};
  const double listed = points.own_unit ? 0.0 : width / mm_in(unit);
  if (listed > 0.0 && listed < 1.0 && unit != LengthUnit::m)
    fault.wrong += "; are the lengths in m?", fault.repairs = {unit_repair(LengthUnit::m, "m")};
  else if (listed > 1.0 && listed < narrowest && unit != LengthUnit::inch)
    fault.wrong += "; are the lengths in inches?",
        fault.repairs = {unit_repair(LengthUnit::inch, "inch")};
  else if (listed >= narrowest && unit != LengthUnit::mm)
    fault.wrong += "; are the lengths in mm?", fault.repairs = {unit_repair(LengthUnit::mm, "mm")};
  throw fault;
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

/// The wheel's flange and the sides of the rail's head must point from the tread towards +z. A
/// flange measured on both sides is a valley of the heights, whatever else reaches far up or down;
/// a tread between two flanges is wider.
void check_upward(const ProfilePoints& points, const ProfileSource& source, bool wheel) {
  const auto [least_y, largest_y] = range(points, &ListedPoint::y);
  const double widest_flange = 0.6 * (largest_y - least_y);
  const auto valley = [&](double sign) {
    std::vector<double> heights = row_of(points).z;
    for (double& z : heights) z *= sign;
    const Valley found = deepest_valley(heights);
    const double near = heights[found.bottom] - std::min(0.5 * found.depth, least_flange);
    std::size_t first = found.bottom, last = found.bottom;
    while (first > found.left && heights[first - 1] > near) --first;
    while (last < found.right && heights[last + 1] > near) ++last;
    const double width = std::abs(points.list[last].y - points.list[first].y);
    return width < widest_flange ? found.depth : 0.0;
  };
  const double flange = wheel ? valley(1.0) : 0.0, reverse_flange = wheel ? valley(-1.0) : 0.0;
  const double level = median(heights_by_width(points));
  const auto [lowest, highest] = range(points, &ListedPoint::z);
  const double above = level - lowest;
  constexpr double clear = 2.0;  // mm; a lower one may be a measured tread without flange
  if (std::max(flange, reverse_flange) > least_flange
          ? flange > reverse_flange
          : above <= clear || above <= 1.5 * (highest - level))
    return;
  throw PointFault{0,
                   fmt::format("z seems to point upward: {} {:.4g} mm towards -z",
                               wheel ? "the flange is" : "the sides of the head are", above),
                   "z down, on the wheel outward from the axle",
                   "",
                   {repair("flip", &ProfileSource::flip, !source.flip)}};
}

/// A rail's head falls on both sides; a flange is the only valley, beside a tread that stays up.
void check_head(const ProfilePoints& points) {
  constexpr double least_fall = 2.0;  // mm
  std::vector<double> heights = row_of(points).z;
  Valley flange = deepest_valley(heights);
  if (flange.depth < least_flange) return;
  const double tip = points.list[flange.bottom].y;
  double tread = points.list.back().y, back = points.list.front().y;
  if (std::abs(tread - tip) < std::abs(back - tip)) {
    std::reverse(heights.begin(), heights.end());
    flange = deepest_valley(heights);
    std::swap(tread, back);
  }
  const std::vector<double> side(heights.begin() + static_cast<std::ptrdiff_t>(flange.bottom),
                                 heights.end());
  if (std::abs(tread - tip) < 2.0 * std::abs(back - tip) ||
      side.back() - heights[flange.right] > least_fall ||
      deepest_valley(side).depth > 2.0 * least_fall)
    return;
  throw PointFault{0,
                   fmt::format("seems to be a wheel: a flange with its tip at y = {:.4g} mm, and "
                               "beside it a tread up to y = {:.4g} mm",
                               tip, tread),
                   "the head of a rail, which falls on both sides",
                   "give it as the profile of the wheel"};
}

/// The head of a rail ends in steep sides on both sides, below all else. A wheel has the tip of a
/// flange, and a tread that does not fall, or that lies between two flanges, which are less steep.
void check_wheel(const ProfilePoints& points) {
  constexpr double of_side = 5.0, least_slope = 5.0;  // mm, -
  const auto is_side = [](auto end, auto last) {
    const auto above = std::find_if(
        end, last, [&](const ListedPoint& point) { return point.z < end->z - of_side; });
    return above != last && std::abs(above->y - end->y) * least_slope < end->z - above->z;
  };
  const auto& list = points.list;
  const auto [top, lowest] = range(points, &ListedPoint::z);
  const double shallow = std::min(list.front().z, list.back().z);
  if (shallow - top < least_flange ||
      lowest > std::max(list.front().z, list.back().z) + same_point ||
      !is_side(list.begin(), list.end()) || !is_side(list.rbegin(), list.rend()))
    return;
  throw PointFault{0,
                   fmt::format("seems to be the head of a rail, which falls by {:.4g} mm to both "
                               "its ends",
                               shallow - top),
                   "the profile of a wheel: a flange, and beside it a tread",
                   "give it as the profile of the rail"};
}

/// The flange, or one of two, is at small y.
void check_side(const ProfilePoints& points, const ProfileSource& source) {
  const auto [lowest, highest] = range(points, &ListedPoint::z);
  const double level = median(heights_by_width(points));
  if (highest - level < least_flange) return;
  // The last of several equal heights.
  const auto tip =
      std::find_if(points.list.rbegin(), points.list.rend(),
                   [top = highest](const ListedPoint& point) { return point.z == top; });
  const auto [left, right] = range(points, &ListedPoint::y);
  const double middle = 0.5 * (left + right);
  if (std::any_of(points.list.begin(), points.list.end(), [&](const ListedPoint& point) {
        return point.y <= middle && point.z - level >= least_flange;
      }))
    return;
  throw PointFault{0,
                   fmt::format("the flange is on the wrong side, at y = {:.4g} mm (the points span "
                               "{:.4g} to {:.4g} mm)",
                               tip->y, left, right),
                   "the flange at the smaller y",
                   "",
                   {repair("mirror", &ProfileSource::mirror, !source.mirror)}};
}

void check_direction(ProfilePoints& points, const ProfileSource& source, bool wheel) {
  if (points.list.back().y >= points.list.front().y) return;
  // Mirroring reverses the direction, so either direction is right then.
  if (points.any_direction || source.mirror) {
    reverse(points);
    return;
  }
  // An unordered list may also end where it should begin; reversing does not help then.
  std::size_t falling = 0;
  for (std::size_t k = 1; k < points.list.size(); ++k)
    falling += points.list[k].y < points.list[k - 1].y;
  if (10 * falling < 9 * (points.list.size() - 1)) return;
  throw PointFault{points.list.front().line,
                   fmt::format("the points run from large to small y ({:.4g} to {:.4g} mm)",
                               points.list.front().y, points.list.back().y),
                   fmt::format("from the {} to the field side", wheel ? "flange" : "gauge"),
                   "",
                   {repair("reverse", &ProfileSource::reverse, !source.reverse)}};
}

void treat_duplicates(ProfilePoints& points, bool drop) {
  std::vector<ListedPoint> kept;
  for (const ListedPoint& point : points.list) {
    if (kept.empty() || distance(kept.back(), point) > same_point)
      kept.push_back(point);
    else if (!drop)
      throw PointFault{point.line,
                       fmt::format("the point y = {:.6g}, z = {:.6g} mm repeats line {}", point.y,
                                   point.z, kept.back().line),
                       fmt::format("points more than {} mm apart", same_point),
                       "remove it",
                       {repair("drop_duplicates", &ProfileSource::drop_duplicates, true)}};
  }
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
void check_smoothing(const ProfilePoints& points, double smoothing) {
  constexpr std::size_t most = 20000;
  if (smoothing == 0.0 || points.list.size() <= most) return;
  throw PointFault{0,
                   fmt::format("smoothing of {} points", points.list.size()),
                   fmt::format("{}", most),
                   "",
                   {repair("thinning", &ProfileSource::thinning, 0.1,
                           " (mm, replaces the points in each such length by their mean)")}};
}

void check_gaps(const ProfilePoints& points, double longest) {
  std::size_t first = 0;
  double largest = 0.0;
  for (std::size_t k = 1; k < points.list.size(); ++k) {
    const double gap = distance(points.list[k - 1], points.list[k]);
    if (gap > longest && first == 0) first = k;
    largest = std::max(largest, gap);
  }
  if (first == 0) return;
  const ListedPoint &before = points.list[first - 1], &here = points.list[first];
  throw PointFault{here.line,
                   fmt::format("gap of {:.4g} mm between y = {:.6g} and {:.6g} mm",
                               distance(before, here), before.y, here.y),
                   fmt::format("{} mm", longest),
                   "add points",
                   {repair("longest_gap", &ProfileSource::longest_gap, std::ceil(largest + 0.5))}};
}

/// Points that would pass without smoothing, but scatter.
void check_scatter(const ProfilePoints& points, const ProfileSource& source) {
  const double scatter = std::max(scatter_of(row_of(points)), least_smoothing(points, source));
  if (scatter < least_scatter) return;
  check_smoothing(points, scatter);
  throw PointFault{0,
                   fmt::format("the points scatter by {:.2g} mm across the profile", scatter),
                   fmt::format("{} mm", least_scatter),
                   "",
                   {repair("smoothing", &ProfileSource::smoothing, smoothing_for(scatter))}};
}

/// `all`: also reports scatter, which is no defect by itself.
void mend(ProfilePoints& points, const ProfileSource& source, bool wheel, bool all) {
  check_count(points);
  const double scale = mm_in(source.unit);
  for (ListedPoint& point : points.list) {
    point.y *= source.mirror ? -scale : scale;
    point.z *= source.flip ? -scale : scale;
  }
  check_size(points, source.unit);
  if (source.for_track) {
    check_upward(points, source, wheel);
    if (wheel) check_wheel(points);
    wheel ? check_side(points, source) : check_head(points);
  }
  if (source.reverse) reverse(points);
  if (source.sort) sort(points);
  check_direction(points, source, wheel);
  if (source.thinning > 0.0) thin(points, source.thinning);
  treat_duplicates(points, source.drop_duplicates);
  if (source.drop_zigzag) {
    drop_zigzag(points);
    // The neighbours of a removed point may now be equal.
    treat_duplicates(points, true);
  }
  check_order(points, source.drop_zigzag);
  check_smoothing(points, source.smoothing);
  check_gaps(points, source.longest_gap);
  check_count(points);
  if (all && source.smoothing == 0.0) check_scatter(points, source);
  treat_corners(points, source);
  check_count(points);
}

std::optional<PointFault> first_fault(ProfilePoints& points, const ProfileSource& source,
                                      bool wheel, bool all) {
  try {
    mend(points, source, wheel, all);
    return {};
  } catch (const PointFault& fault) {
    return fault;
  }
}

/// Of the best repair; empty where there is none.
std::string key_of(const PointFault& fault) {
  return fault.repairs.empty() ? "" : fault.repairs.front().key;
}

/// Defects and the keys that repair them, in one line.
std::string message_of(const std::vector<PointFault>& faults, const std::string& file, bool wheel) {
  std::string wrong, keys, by_hand;
  for (const PointFault& fault : faults) {
    wrong += file + (fault.line > 0 ? fmt::format(":{}: ", fault.line) : ": ") + fault.wrong +
             "; allowed: " + fault.allowed + "; ";
    std::string ways;
    for (const PointRepair& way : fault.repairs)
      ways += fmt::format("{}`{}`{}", ways.empty() ? "" : " or ", way.line(), way.note);
    if (!ways.empty()) keys += (keys.empty() ? "" : ", ") + ways;
    if (faults.size() == 1 || ways.empty()) by_hand = fault.by_hand;
  }
  if (!keys.empty())
    keys = fmt::format("put {} under [{}_profile]", keys, wheel ? "wheel" : "rail");
  if (!keys.empty() && !by_hand.empty()) by_hand += faults.size() == 1 ? ", or " : ", and ";
  return wrong + "do: " + by_hand + keys;
}

}  // namespace

void check_order(const ProfilePoints& points, bool drop_zigzag) {
  const std::vector<std::size_t> places = turns_back(points.list);
  if (places.empty()) return;
  const ListedPoint& at = points.list[places.front() + 1];
  const char* const allowed = "points in order along the profile";
  // An outlier makes two or three of them.
  if (places.size() > std::max<std::size_t>(8, points.list.size() / 4))
    throw PointFault{
        at.line,
        fmt::format("the points are unordered: the curve turns back {} times", places.size()),
        allowed,
        "",
        {repair("sort", &contact::ProfileSource::sort, true, " if z is a function of y")}};
  PointFault fault{at.line,
                   fmt::format("zig-zag: the curve turns back at y = {:.6g}, z = {:.6g} mm ({} "
                               "such places)",
                               at.y, at.z, places.size()),
                   allowed, "correct them"};
  if (!drop_zigzag)
    fault.repairs = {repair("drop_zigzag", &contact::ProfileSource::drop_zigzag, true)};
  throw fault;
}

void drop_zigzag(ProfilePoints& points) {
  // check_order reports longer ways back (a profile measured twice), lists without order, and cases
  // that would take too long here.
  constexpr std::size_t longest = 128, most_work = 200'000'000;
  const std::size_t turns = turns_back(points.list).size();
  if (turns == 0) return;
  for (std::size_t reach = 8; reach <= longest; reach *= 2) {
    if (turns * reach * reach * reach > most_work) return;
    std::vector<ListedPoint> kept = cheapest(points.list, reach);
    if (kept.empty()) continue;
    if (3 * kept.size() > 2 * points.list.size()) points.list = std::move(kept);
    return;
  }
}

PointRow row_of(const ProfilePoints& points) {
  PointRow row;
  for (const ListedPoint& point : points.list) {
    row.y.push_back(point.y);
    row.z.push_back(point.z);
  }
  return row;
}

void mend_and_check(ProfilePoints& points, const ProfileSource& source, bool wheel) {
  const ProfilePoints listed = points;
  if (!first_fault(points, source, wheel, false)) return;
  // Every defect is repaired on trial, so that one message names them all.
  std::vector<PointFault> faults;
  ProfileSource trial = source;
  constexpr int most_tries = 16;  // more only where two repairs undo each other
  for (int k = 0; k < most_tries; ++k) {
    ProfilePoints mended = listed;
    const auto fault = first_fault(mended, trial, wheel, true);
    if (!fault) break;
    const std::string key = key_of(*fault);
    // A key that has to be changed once more supersedes its earlier value.
    faults.erase(std::remove_if(faults.begin(), faults.end(),
                                [&](const PointFault& one) { return key_of(one) == key; }),
                 faults.end());
    faults.push_back(*fault);
    if (key.empty()) break;
    fault->repairs.front().apply(trial);
  }
  std::vector<std::string> repairs;
  for (const PointFault& fault : faults)
    if (!fault.repairs.empty()) repairs.push_back(fault.repairs.front().line());
  const std::string text = message_of(faults, points.file, wheel);
  if (repairs.size() == faults.size()) throw RepairableProfile(text, wheel, std::move(repairs));
  throw InputError(text);
}

}  // namespace rollfem::profiles
