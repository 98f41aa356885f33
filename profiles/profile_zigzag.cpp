// SPDX-License-Identifier: LGPL-2.1-or-later
// Places at which the curve through the points turns back, and which points to drop there.
#include "contact/base/pi.hpp"
#include "profiles/profile_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rollfem::profiles {

namespace {

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

/// The points of the cheapest curve; none where dropping up to `reach` points in a row does not do.
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
  // A longer way back, as of a profile measured twice, or a list without order is left for the
  // check; so is what would take long.
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

}  // namespace rollfem::profiles
