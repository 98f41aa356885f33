// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/profile_curve.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "base/knots.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace rollfem::profiles {

namespace {

bool usable(const ProfilePoint& point) {
  return point.tangent_y > 0.0 && std::abs(point.tangent_z) <= steepest * point.tangent_y;
}

/// Point between `good` (usable) and `bad` (not) at which the curve becomes too steep, on the
/// usable side. By bisection, because a property changes there and no value vanishes.
double steep_place(const ProfileCurve& curve, double good, double bad) {
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (good + bad);
    (usable(curve.at(middle)) ? good : bad) = middle;
  }
  return good;
}

/// Steps in y that keep the cubic of z over y as accurate as the curve's own: z'' of a circle
/// changes by its own size over 1 / (3 s sqrt(1 + s^2) k), with the slope s and the curvature k.
int subdivisions(const ProfilePoint& a, const ProfilePoint& b) {
  double rate = 0.0;
  for (const ProfilePoint* point : {&a, &b}) {
    const double slope = std::abs(point->tangent_z / point->tangent_y);
    rate = std::max(rate, 3.0 * slope * std::hypot(1.0, slope) * std::abs(point->curvature));
  }
  constexpr double fraction = 0.03;
  return static_cast<int>(std::clamp(std::ceil((b.y - a.y) * rate / fraction), 1.0, 64.0));
}

bool is_before(double parameter, const ProfileKnot& knot) {
  return parameter < knot.parameter;
}

}  // namespace

ProfileCurve::ProfileCurve(std::vector<ProfileKnot> knots, double rounding)
    : knots_(std::move(knots)), rounding_(rounding) {
  if (knots_.size() < 2) throw std::invalid_argument("a profile curve needs at least two knots");
  for (std::size_t k = 1; k < knots_.size(); ++k)
    if (!(knots_[k].parameter > knots_[k - 1].parameter))
      throw std::invalid_argument("the parameters of a profile curve must increase");
  for (auto* list : {&highest_y_, &lowest_y_}) list->reserve(knots_.size());
  double highest = knots_.front().y, lowest = highest;
  for (const ProfileKnot& knot : knots_) {
    highest_y_.push_back(highest = std::max(highest, knot.y));
    lowest_y_.push_back(lowest = std::min(lowest, knot.y));
  }
}

std::array<contact::CurveValue, 2> ProfileCurve::by_parameter(double parameter) const {
  const auto [k, length, part] =
      contact::piece_of(knots_, parameter, [](const ProfileKnot& knot) { return knot.parameter; });
  const ProfileKnot &a = knots_[k], &b = knots_[k + 1];
  return {contact::hermite(length, part, a.y, b.y, a.dy, b.dy),
          contact::hermite(length, part, a.z, b.z, a.dz, b.dz)};
}

ProfilePoint ProfileCurve::at(double parameter) const {
  const auto [y, z] = by_parameter(parameter);
  const double speed = std::hypot(y.slope, z.slope);
  return {y.value, z.value, y.slope / speed, z.slope / speed,
          (y.slope * z.second - z.slope * y.second) / (speed * speed * speed)};
}

double ProfileCurve::parameter_at(double y) const {
  const double start = knots_.front().y;
  const bool up = y >= start;
  const auto& reached = up ? highest_y_ : lowest_y_;
  if (up ? y > reached.back() : y < reached.back())
    return std::abs(y - start) < std::abs(y - knots_.back().y) ? first() : last();
  const auto found =
      up ? std::lower_bound(reached.begin(), reached.end(), y)
         : std::lower_bound(reached.begin(), reached.end(), y, std::greater<double>());
  const auto knot = static_cast<std::size_t>(found - reached.begin());
  if (knot == 0) return first();
  double below = knots_[knot - 1].parameter;
  double above = knots_[knot].parameter;
  for (int step = 0; step < 60 && above - below > 1e-14 * std::abs(above); ++step) {
    const double middle = 0.5 * (below + above);
    ((at(middle).y < y) == up ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

ProfileCurve ProfileCurve::moved(double angle, double y, double z) const {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::vector<ProfileKnot> result;
  result.reserve(knots_.size());
  for (const ProfileKnot& knot : knots_)
    result.push_back({knot.parameter, c * knot.y - s * knot.z + y, s * knot.y + c * knot.z + z,
                      c * knot.dy - s * knot.dz, s * knot.dy + c * knot.dz});
  return ProfileCurve(std::move(result), rounding_);
}

ProfileCurve ProfileCurve::part(double from, double to) const {
  auto begin = std::upper_bound(knots_.begin(), knots_.end() - 1, from, is_before);
  auto end = std::partition_point(begin, knots_.end(),
                                  [&](const ProfileKnot& knot) { return knot.parameter < to; });
  if (begin != knots_.begin()) --begin;
  if (end != knots_.end()) ++end;
  if (end - begin < 2) begin = end - 2;
  return ProfileCurve({begin, end}, rounding_);
}

ProfileCurve ProfileCurve::mirrored() const {
  std::vector<ProfileKnot> result(knots_.rbegin(), knots_.rend());
  for (ProfileKnot& knot : result)
    for (double* value : {&knot.parameter, &knot.y, &knot.dz}) *value = -*value;
  return ProfileCurve(std::move(result), rounding_);
}

Valley deepest_valley(const std::vector<double>& z) {
  std::vector<std::size_t> right(z.size());  // the highest place from each one on
  for (std::size_t k = z.size(); k-- > 0;)
    right[k] = k + 1 < z.size() && z[right[k + 1]] < z[k] ? right[k + 1] : k;
  Valley deepest;
  std::size_t left = 0;
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (z[k] < z[left]) left = k;
    const double depth = z[k] - std::max(z[left], z[right[k]]);
    if (depth > deepest.depth) deepest = {k, left, right[k], depth};
  }
  return deepest;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double parameter_near(const ProfileCurve& curve, double y, double z) {
  const auto square = [&](const ProfileKnot& knot) {
    return (knot.y - y) * (knot.y - y) + (knot.z - z) * (knot.z - z);
  };
  return std::min_element(curve.knots().begin(), curve.knots().end(),
                          [&](const auto& a, const auto& b) { return square(a) < square(b); })
      ->parameter;
}

std::vector<double> dense_parameters(const ProfileCurve& curve, double step, double least) {
  std::vector<double> result;
  for (auto knot = curve.knots().begin(); knot + 1 != curve.knots().end(); ++knot) {
    const double here = knot->parameter, length = (knot + 1)->parameter - here;
    if (!result.empty() && here - result.back() < least) continue;
    const int parts =
        std::max(1, contact::count_of(std::ceil(length / step), "points along a profile"));
    for (int i = 0; i < parts; ++i) result.push_back(here + length * i / parts);
  }
  if (curve.last() - result.back() < least && result.size() > 1) result.pop_back();
  result.push_back(curve.last());
  return result;
}

contact::HeightCurve height_over_y(const ProfileCurve& curve, double parameter) {
  const double middle = std::clamp(parameter, curve.first(), curve.last());
  if (const ProfilePoint here = curve.at(middle); !usable(here))
    throw contact::SolveError(fmt::format(
        "the profile is steeper than 85 degrees at y = {:.4g} mm, where the bodies would "
        "touch; allowed: contact on parts that are heights over y; do: correct the "
        "profile, its rotation or mirror, or move the wheel",
        here.y));
  const auto& knots = curve.knots();
  // Knots of the usable part, searched outwards from the requested parameter.
  std::vector<double> places{middle};
  places.reserve(knots.size() + 3);
  const auto add_place = [&](double next) {
    const bool gentle = usable(curve.at(next));
    places.push_back(gentle ? next : steep_place(curve, places.back(), next));
    return gentle;
  };
  const auto above = std::upper_bound(knots.begin(), knots.end(), middle, is_before);
  for (auto k = above; k != knots.end(); ++k)
    if (!add_place(k->parameter)) break;
  std::reverse(places.begin(), places.end());
  for (auto k = above; k != knots.begin();)
    if ((--k)->parameter < middle && !add_place(k->parameter)) break;
  std::reverse(places.begin(), places.end());

  std::vector<contact::HeightKnot> heights;
  heights.reserve(2 * places.size());
  const auto add = [&](const ProfilePoint& point) {
    // Two points may coincide to rounding where the profile becomes too steep exactly at a knot.
    if (heights.empty() || point.y > heights.back().y + 1e-12 * (1.0 + std::abs(point.y)))
      heights.push_back({point.y, point.z, point.tangent_z / point.tangent_y});
  };
  ProfilePoint before;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const ProfilePoint here = curve.at(places[k]);
    if (k > 0) {
      const int parts = subdivisions(before, here);
      for (int part = 1; part < parts; ++part)
        add(curve.at(places[k - 1] + (places[k] - places[k - 1]) * part / parts));
    }
    add(here);
    before = here;
  }
  return contact::HeightCurve(std::move(heights));
}

namespace {

constexpr double last_digits = 1e-13;  // mm along a profile

/// Length of a piece by Simpson's rule on the speed of the parameter, which is close to 1.
double length_of(const ProfileKnot& a, const ProfileKnot& b) {
  const double h = b.parameter - a.parameter;
  const double middle_y = 1.5 * (b.y - a.y) / h - 0.25 * (a.dy + b.dy),
               middle_z = 1.5 * (b.z - a.z) / h - 0.25 * (a.dz + b.dz);
  return h / 6.0 *
         (std::hypot(a.dy, a.dz) + 4.0 * std::hypot(middle_y, middle_z) + std::hypot(b.dy, b.dz));
}

/// Just before a knot, on the piece that ends there.
ProfilePoint before(const ProfileCurve& curve, std::size_t k) {
  const double here = curve.knots()[k].parameter;
  return curve.at(here - 1e-9 * (here - curve.knots()[k - 1].parameter));
}

/// Parameter of the extreme height nearest to the knot.
ProfilePoint extreme(const ProfileCurve& curve, std::size_t knot) {
  const auto& knots = curve.knots();
  const double low = knots[knot > 0 ? knot - 1 : 0].parameter;
  const double high = knots[std::min(knot + 1, knots.size() - 1)].parameter;
  const bool rising = curve.at(low).tangent_z > 0.0;
  if (rising == (curve.at(high).tangent_z > 0.0)) return curve.at(knots[knot].parameter);
  return curve.at(contact::bracketed_root([&](double at) { return curve.at(at).tangent_z; }, low,
                                          high, last_digits, "extreme height of the profile"));
}

/// y at which z crosses a height, searching from parameter `from` towards smaller ones.
std::optional<double> face(const ProfileCurve& curve, std::size_t from, double height) {
  for (std::size_t k = from; k > 0; --k) {
    const ProfileKnot &here = curve.knots()[k], &before = curve.knots()[k - 1];
    if ((here.z - height) * (before.z - height) > 0.0) continue;
    const auto above = [&](double at) { return curve.at(at).z - height; };
    return curve
        .at(contact::bracketed_root(above, before.parameter, here.parameter, last_digits,
                                    "face of the profile"))
        .y;
  }
  return {};
}

}  // namespace

ProfileFeatures profile_features(const ProfileCurve& curve, bool wheel) {
  const std::vector<ProfileKnot>& knots = curve.knots();
  const std::size_t n = knots.size();
  ProfileFeatures result;
  result.start = curve.at(curve.first());
  result.end = curve.at(curve.last());
  std::size_t top = 0, bottom = 0;
  const auto sharper = [&](const ProfilePoint& place) {
    // Takes the first point of an arc, whose curvature is constant to rounding.
    constexpr double clearly = 1.0 + 1e-4;
    if (place.curvature > clearly * result.sharpest_up.curvature) result.sharpest_up = place;
    if (place.curvature < clearly * result.sharpest_down.curvature) result.sharpest_down = place;
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (k + 1 < n) result.length += length_of(knots[k], knots[k + 1]);
    if (knots[k].z < knots[top].z) top = k;
    if (knots[k].z > knots[bottom].z) bottom = k;
    const ProfilePoint right = curve.at(knots[k].parameter);
    sharper(right);
    if (k == 0 || k + 1 == n) continue;
    const ProfilePoint left = before(curve, k);
    sharper(left);
    // Cubics of one formula agree within 1e-4 of their curvature; a joint differs much more.
    const double larger = std::max(std::abs(left.curvature), std::abs(right.curvature));
    if (std::abs(right.curvature - left.curvature) > 1e-4 + 0.05 * larger)
      result.joints.push_back({knots[k].parameter, right, left.curvature});
  }
  result.top = extreme(curve, top);
  result.bottom = extreme(curve, bottom);
  result.gauge_face = wheel ? face(curve, n - 1, 10.0) : face(curve, top, result.top.z + 14.0);
  return result;
}

double angle_of(const ProfilePoint& place) {
  constexpr double degrees = 180.0 / contact::pi;
  return std::atan2(place.tangent_z, place.tangent_y) * degrees;
}

std::vector<ProfileRow> profile_rows(const ProfileCurve& curve, bool wheel) {
  std::vector<ProfileRow> rows;
  const auto row = [&](double parameter, const ProfilePoint& place, double curvature) {
    rows.push_back({parameter, place.y, place.z, angle_of(place), curvature});
  };
  const auto joints = profile_features(curve, wheel).joints;
  const double length = curve.last() - curve.first();
  const int steps = contact::count_of(std::ceil(length / 0.1), "points along a profile");
  auto joint = joints.begin();
  for (int k = 0; k <= steps; ++k) {
    const double parameter = k == steps ? curve.last() : curve.first() + length * k / steps;
    for (; joint != joints.end() && joint->parameter <= parameter; ++joint) {
      row(joint->parameter, joint->place, joint->curvature_before);
      row(joint->parameter, joint->place, joint->place.curvature);
    }
    const ProfilePoint place = curve.at(parameter);
    row(parameter, place, place.curvature);
  }
  return rows;
}

}  // namespace rollfem::profiles
