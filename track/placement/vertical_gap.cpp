// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/vertical_gap.hpp"

#include "base/errors.hpp"
#include "base/knots.hpp"
#include "base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace rollfem::track {

using contact::Axle;
using contact::CurveValue;
using contact::HeightKnot;
using contact::Vector3;

namespace {

/// Directions across the axle: `down` in the plane x = 0, `ahead` as close to x as possible.
struct AxleFrame {
  Vector3 down{}, ahead{};
  double tangent_of_yaw = 0.0;  ///< d_x / sqrt(1 - d_x^2)
};

AxleFrame axle_frame(const Axle& axle) {
  const Vector3& d = axle.direction;
  const double across = std::sqrt(1.0 - d[0] * d[0]);
  AxleFrame frame;
  frame.tangent_of_yaw = d[0] / across;
  frame.ahead = {across, -d[0] * d[1] / across, -d[0] * d[2] / across};
  frame.down = {0.0, -d[2] / across, d[1] / across};
  return frame;
}

struct Seen {
  Vector3 place{};     ///< z over a roller radial
  double slope = 0.0;  ///< dz/dy of the outline
  double profile_y = 0.0;
};

/// A circle of the wheel: points at an angle a from straight down, and normals of the wheel's
/// surface n = u - r' d there, with u = cos(a) down + sin(a) ahead.
struct Circle {
  const Axle& axle;
  const AxleFrame& frame;
  double axial, radius;  ///< mm
  double by_axial;       ///< r', of its radius

  Vector3 outward(double sine, double cosine) const {
    Vector3 across{};
    for (int d = 0; d < 3; ++d) across[d] = cosine * frame.down[d] + sine * frame.ahead[d];
    return across;
  }
  Vector3 place(const Vector3& across) const {
    return contact::plus(contact::plus(axle.point, axle.direction, axial), across, radius);
  }
  Vector3 normal(const Vector3& across) const {
    return contact::plus(across, axle.direction, -by_axial);
  }
};

/// Finds by Newton's method, from the angle for a straight rail, the angle at which the normal has
/// no component along the roller's circle: n_x (R_r - z) + n_z x = 0. False if there is none.
bool face_roller(const Circle& circle, double roller_axle_z, double& sine, double& cosine) {
  double angle = std::atan2(sine, cosine);
  for (int step = 0; step < 30; ++step) {
    const Vector3 across = circle.outward(sine, cosine), turn = circle.outward(cosine, -sine);
    const Vector3 place = circle.place(across), normal = circle.normal(across);
    const double up = 1.0 - place[2] / roller_axle_z, x = place[0] / roller_axle_z;
    const double moved = circle.radius / roller_axle_z;
    const double along = normal[0] * up + normal[2] * x;
    const double by_angle = turn[0] * (up + normal[2] * moved) + turn[2] * (x - normal[0] * moved);
    const double change = along / by_angle;
    if (std::abs(change) < 1e-14) return true;
    angle -= change;
    if (!(std::abs(angle) < 1.2)) return false;
    sine = std::sin(angle);
    cosine = std::cos(angle);
  }
  return false;
}

std::optional<Seen> seen(const profiles::ProfilePoint& at, double rolling_radius, const Axle& axle,
                         const AxleFrame& frame, double roller_axle_z) {
  if (!(at.tangent_y > 0.0)) return {};
  const Circle circle{axle, frame, at.y, rolling_radius + at.z, at.tangent_z / at.tangent_y};
  // Along a straight rail n_x = 0.
  double sine = circle.by_axial * frame.tangent_of_yaw;
  if (std::abs(sine) > 0.9) return {};
  double cosine = std::sqrt(1.0 - sine * sine);
  const bool straight = std::isinf(roller_axle_z);
  if (!straight && !face_roller(circle, roller_axle_z, sine, cosine)) return {};
  const Vector3 across = circle.outward(sine, cosine);
  const Vector3 normal = circle.normal(across);
  Seen result;
  result.place = circle.place(across);
  double down = normal[2];
  if (!straight) {
    const double up = roller_axle_z - result.place[2], x = result.place[0];
    result.place[2] = AlongRail::height_at_top(result.place, roller_axle_z);
    down = (normal[2] * up - normal[0] * x) / (roller_axle_z - result.place[2]);
  }
  if (!(down > 0.0)) return {};
  result.slope = -normal[1] / down;
  result.profile_y = at.y;
  if (std::abs(result.slope) > profiles::steepest) return {};
  return result;
}

/// Interpolates values between knots. Slopes from chords are accurate enough for x and the profile
/// coordinate, which only position a contact.
double value_over_y(const std::vector<HeightKnot>& knots, const std::vector<double>& values,
                    double y) {
  const auto slope = [&](std::size_t k) {
    const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k + 1, knots.size() - 1);
    return (values[b] - values[a]) / (knots[b].y - knots[a].y);
  };
  const auto [k, h, part] =
      contact::piece_of(knots, y, [](const HeightKnot& knot) { return knot.y; });
  // Beyond the ends, along the tangent.
  const double t = std::clamp(part, 0.0, 1.0);
  const double inside =
      contact::hermite(h, t, values[k], values[k + 1], slope(k), slope(k + 1)).value;
  return inside + (y - (knots[k].y + h * t)) * slope(t > 0.5 ? k + 1 : k);
}

/// The locus may jump from one place along x to another.
constexpr double longest_step = 1.0;  // mm along x between neighbours

OutlinePoint on_locus(const std::vector<LocusPoint>& locus, const contact::HeightCurve& outline,
                      const Axle& axle, double y) {
  const auto [k, length, part] =
      contact::piece_of(locus, y, [](const LocusPoint& point) { return point.y; });
  const LocusPoint &a = locus[k], &b = locus[k + 1];
  // Beside a jump, of the nearer side.
  const double t = std::abs(b.x - a.x) < longest_step ? part : (part < 0.5 ? 0.0 : 1.0);
  const auto at = [&, t = t](double LocusPoint::*value) {
    return a.*value + t * (b.*value - a.*value);
  };
  OutlinePoint point;
  point.y = y;
  point.z = outline.at(y).value;
  point.along =
      AlongRail::sloping(at(&LocusPoint::x), at(&LocusPoint::rail_z), at(&LocusPoint::along));
  const contact::AxlePlace place = contact::axle_place(axle, {point.along.x, y, point.z});
  point.profile_y = place.axial;
  point.radius = place.radius;
  point.relative_radius = at(&LocusPoint::relative_radius);
  return point;
}

constexpr double y_tolerance = 1e-12;  // mm

/// Difference between dz/dy along the locus, where x changes with y, and dz/dy at a fixed x:
/// dz/dx dx/dy of each point.
std::vector<double> climb_over_y(const std::vector<LocusPoint>& locus) {
  std::vector<double> climb;
  for (std::size_t k = 0; k < locus.size(); ++k) {
    // The neighbours on this side of a jump.
    std::size_t a = k > 0 ? k - 1 : k, b = std::min(k + 1, locus.size() - 1);
    if (std::abs(locus[a].x - locus[k].x) >= longest_step) a = k;
    if (std::abs(locus[b].x - locus[k].x) >= longest_step) b = k;
    const double by_y = a == b ? 0.0 : (locus[b].x - locus[a].x) / (locus[b].y - locus[a].y);
    climb.push_back(locus[k].along * by_y);
  }
  return climb;
}

/// A height of the points over y.
contact::HeightCurve curve_over(const std::vector<LocusPoint>& locus, double LocusPoint::*height,
                                double LocusPoint::*slope) {
  const std::vector<double> climb = climb_over_y(locus);
  std::vector<HeightKnot> knots;
  for (std::size_t k = 0; k < locus.size(); ++k)
    knots.push_back({locus[k].y, locus[k].*height, locus[k].*slope + climb[k]});
  return contact::HeightCurve(std::move(knots));
}

}  // namespace

WheelPoints wheel_points(const profiles::ProfileCurve& wheel, double tread_y) {
  WheelPoints result;
  const std::vector<double> at = profiles::dense_parameters(wheel, 0.1, 0.01);
  for (const double parameter : at) result.points.push_back(wheel.at(parameter));
  result.start = static_cast<std::size_t>(
      std::lower_bound(at.begin(), at.end(), wheel.parameter_at(tread_y)) - at.begin());
  return result;
}

Silhouette::Silhouette(const WheelPoints& wheel, double rolling_radius, const Axle& axle,
                       double roller_axle_z)
    : axle_(axle), roller_axle_z_(roller_axle_z) {
  const AxleFrame frame = axle_frame(axle);
  // Walks from the tread both ways, as far as the outline remains a height over y.
  const auto start = static_cast<std::ptrdiff_t>(wheel.start);
  std::vector<Seen> inner, outer;
  inner.reserve(wheel.start);
  outer.reserve(wheel.points.size() - wheel.start);
  const auto walk = [&](std::ptrdiff_t first, int step, std::vector<Seen>& part) {
    for (std::ptrdiff_t k = first; k >= 0 && k < static_cast<std::ptrdiff_t>(wheel.points.size());
         k += step) {
      const auto point = seen(wheel.points[static_cast<std::size_t>(k)], rolling_radius, axle,
                              frame, roller_axle_z);
      if (!point) return;
      if (!part.empty() && step * (point->place[1] - part.back().place[1]) <= 1e-6) return;
      part.push_back(*point);
    }
  };
  walk(start, 1, outer);
  walk(start - 1, -1, inner);
  std::vector<Seen> all;
  all.reserve(inner.size() + outer.size());
  all.assign(inner.rbegin(), inner.rend());
  for (const Seen& point : outer)
    if (all.empty() || point.place[1] > all.back().place[1] + 1e-6) all.push_back(point);
  if (all.size() < 2)
    throw contact::InputError(
        fmt::format("wheel.profile: no part of it near y = {:.4g} mm is visible along x; allowed: "
                    "a tread there that faces away from the axle; do: check rotation, shift and "
                    "mirror under [wheel_profile]",
                    wheel.points[wheel.start].y));
  std::vector<HeightKnot> knots;
  knots.reserve(all.size());
  for (auto* list : {&x_, &profile_y_}) list->reserve(all.size());
  for (const Seen& point : all) {
    knots.push_back({point.place[1], point.place[2], point.slope});
    x_.push_back(point.place[0]);
    profile_y_.push_back(point.profile_y);
  }
  curve_ = contact::HeightCurve(std::move(knots));
}

Silhouette::Silhouette(const std::vector<LocusPoint>& locus, const Axle& axle)
    : curve_(curve_over(locus, &LocusPoint::wheel_z, &LocusPoint::wheel_slope)),
      locus_(locus),
      axle_(axle) {}

OutlinePoint Silhouette::at(double y) const {
  if (!locus_.empty()) return on_locus(locus_, curve_, axle_, y);
  OutlinePoint point;
  point.y = y;
  point.z = curve_.at(y).value;
  point.along = {value_over_y(curve_.knots(), x_, y), point.z, roller_axle_z_};
  point.profile_y = value_over_y(curve_.knots(), profile_y_, y);
  const Vector3 place = point.along.place_from_top({0.0, y, point.z});
  const Vector3 arm{place[0] - axle_.point[0], y - axle_.point[1], place[2] - axle_.point[2]};
  const Vector3 across = contact::cross(arm, axle_.direction);
  point.radius = std::sqrt(contact::dot(across, across));
  point.relative_radius = 1.0 / (1.0 / point.radius + 1.0 / (roller_axle_z_ - point.z));
  return point;
}

double GapMinimum::angle() const {
  return -std::atan(slope);
}

contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail) {
  const auto& knots = rail.knots();
  double top = knots.front().parameter, least = contact::infinity;
  for (const profiles::ProfileKnot& knot : knots)
    if (knot.dy * profiles::steepest >= std::abs(knot.dz) && knot.z < least)
      least = knot.z, top = knot.parameter;
  return profiles::height_over_y(rail, top);
}

contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail,
                                  const std::vector<double>& tops_and_grooves) {
  if (tops_and_grooves.size() < 2) return rail_heights(rail);
  std::vector<HeightKnot> knots;
  for (const double place : tops_and_grooves) {
    contact::HeightCurve part;
    try {
      part = profiles::height_over_y(rail, place);
    } catch (const contact::SolveError&) {
      continue;  // a groove without a floor
    }
    // A part that reaches several of the places comes again unchanged.
    for (const HeightKnot& knot : part.knots()) {
      const CurveValue value = part.at(knot.y);
      while (!knots.empty() && knot.y <= knots.back().y && value.value < knots.back().z)
        knots.pop_back();
      if (!knots.empty() && knot.y < knots.back().y + 1e-9) continue;
      knots.push_back({knot.y, value.value, value.slope});
    }
  }
  if (knots.size() < 2) return rail_heights(rail);
  return contact::HeightCurve(std::move(knots));
}

VerticalGap::VerticalGap(const WheelPoints& wheel, double rolling_radius, const contact::Axle& axle,
                         const contact::HeightCurve& rail, double roller_axle_z)
    : wheel_(wheel, rolling_radius, axle, roller_axle_z), rail_(rail) {
  const contact::HeightCurve& outline = wheel_.curve();
  first_ = std::max(outline.first(), rail_.first());
  last_ = std::min(outline.last(), rail_.last());
  if (!(last_ > first_))
    throw contact::SolveError(
        fmt::format("the wheel is not above the rail: it extends from {:.1f} to {:.1f} mm from the "
                    "middle of the track, the rail head from {:.1f} to {:.1f} mm",
                    outline.first(), outline.last(), rail_.first(), rail_.last()));
  places_.reserve(outline.knots().size() + rail_.knots().size() + 2);
  places_.push_back(first_);
  const auto add_knots = [this](const contact::HeightCurve& curve) {
    for (const HeightKnot& knot : curve.knots())
      if (knot.y > first_ && knot.y < last_) places_.push_back(knot.y);
    return static_cast<std::ptrdiff_t>(places_.size());
  };
  const std::ptrdiff_t middle = add_knots(outline);
  add_knots(rail_);
  std::inplace_merge(places_.begin(), places_.begin() + middle, places_.end());
  places_.push_back(last_);
  // Knots that coincide to rounding would give intervals of no length.
  places_.erase(
      std::unique(places_.begin(), places_.end(), [](double a, double b) { return b - a < 1e-9; }),
      places_.end());
  values_.reserve(places_.size());
  for (const double y : places_) values_.push_back(at(y));
  find_minima();
}

VerticalGap::VerticalGap(std::shared_ptr<const BodiesAlongWay> bodies)
    : VerticalGap(bodies, bodies->locus()) {}

VerticalGap::VerticalGap(std::shared_ptr<const BodiesAlongWay> bodies,
                         const std::vector<LocusPoint>& locus)
    : bodies_(std::move(bodies)),
      wheel_(locus, bodies_->axle()),
      rail_(curve_over(locus, &LocusPoint::rail_z, &LocusPoint::rail_slope)),
      first_(locus.front().y),
      last_(locus.back().y) {
  const std::vector<double> along = climb_over_y(locus);
  std::vector<HeightKnot> gap, climb;
  for (std::size_t k = 0; k < locus.size(); ++k) {
    const LocusPoint& point = locus[k];
    places_.push_back(point.y);
    // Along the locus the gap changes as at a fixed x, where it is least.
    gap.push_back({point.y, point.rail_z - point.wheel_z, point.rail_slope - point.wheel_slope});
    climb.push_back({point.y, along[k], 0.0});
  }
  gap_ = contact::HeightCurve(std::move(gap));
  climb_ = contact::HeightCurve(std::move(climb));
  values_.reserve(places_.size());
  for (const double y : places_) values_.push_back(at(y));
  find_minima();
}

void VerticalGap::lower_wheel(double way) {
  lowered_ += way;
  for (CurveValue& value : values_) value.value -= way;
  for (GapMinimum& minimum : minima_) minimum.gap -= way;
}

CurveValue VerticalGap::at(double y) const {
  return with_surface(y).gap;
}

VerticalGap::WithSurface VerticalGap::with_surface(double y) const {
  if (bodies_) {
    CurveValue gap = gap_.at(y);
    gap.value -= lowered_;
    return {gap, rail_.at(y).slope - climb_.at(y).value - 0.5 * gap.slope};
  }
  const CurveValue rail = rail_.at(y);
  const CurveValue wheel = wheel_.curve().at(y);
  const CurveValue gap{rail.value - wheel.value - lowered_, rail.slope - wheel.slope,
                       rail.second - wheel.second};
  return {gap, rail.slope - 0.5 * gap.slope};
}

void VerticalGap::find_minima() {
  constexpr std::size_t usual = 8;
  minima_.reserve(usual);
  for (std::size_t k = 0; k + 1 < places_.size(); ++k) {
    if (!(values_[k].slope < 0.0 && values_[k + 1].slope >= 0.0)) continue;
    GapMinimum minimum;
    minimum.y = contact::bracketed_root([&](double y) { return at(y).slope; }, places_[k],
                                        places_[k + 1], y_tolerance, "smallest gap");
    minimum.gap = at(minimum.y).value;
    minimum.slope = bodies_ ? with_surface(minimum.y).slope : rail_.at(minimum.y).slope;
    minimum.along = wheel_.at(minimum.y).along.slope();
    // On a roller the other slope is that in the plane which is turned to the top.
    if (!bodies_) minimum.along *= std::hypot(1.0, minimum.slope);
    minima_.push_back(minimum);
  }
}

GapMinimum VerticalGap::lowest() const {
  const auto lowest =
      std::min_element(minima_.begin(), minima_.end(),
                       [](const GapMinimum& a, const GapMinimum& b) { return a.gap < b.gap; });
  return lowest == minima_.end() ? GapMinimum{} : *lowest;
}

double VerticalGap::smallest() const {
  return std::min({values_.front().value, values_.back().value, lowest().gap});
}

GapEnd VerticalGap::end() const {
  const double inner = values_.front().value, outer = values_.back().value;
  if (lowest().gap < std::min(inner, outer)) return GapEnd::none;
  return inner < outer ? GapEnd::inner : GapEnd::outer;
}

std::array<double, 2> VerticalGap::largest_between(double lower, double upper) const {
  std::array<double, 2> largest{at(lower).value, lower};
  const auto take = [&](double y, double value) {
    if (value > largest[0]) largest = {value, y};
  };
  take(upper, at(upper).value);
  for (std::size_t k = 0; k < places_.size(); ++k)
    if (places_[k] > lower && places_[k] < upper) take(places_[k], values_[k].value);
  return largest;
}

std::array<double, 2> VerticalGap::below(double limit, double y, double lower, double upper) const {
  const auto end_of = [&](bool up) {
    double inside = y;
    auto k = static_cast<std::ptrdiff_t>(std::lower_bound(places_.begin(), places_.end(), y) -
                                         places_.begin());
    if (!up) --k;
    for (; k >= 0 && k < static_cast<std::ptrdiff_t>(places_.size()); k += up ? 1 : -1) {
      const auto at_k = static_cast<std::size_t>(k);
      const double place = places_[at_k];
      if (up ? place >= upper : place <= lower) return up ? upper : lower;
      if (values_[at_k].value < limit) {
        inside = place;
        continue;
      }
      const auto excess = [&](double y_at) { return at(y_at).value - limit; };
      if (!(excess(inside) < 0.0)) return inside;
      return contact::bracketed_root(excess, inside, place, y_tolerance, "end of the overlap");
    }
    return up ? upper : lower;
  };
  return {end_of(false), end_of(true)};
}

std::array<double, 2> VerticalGap::span_below(double limit, double y, double lower,
                                              double upper) const {
  std::array<double, 2> span{y, y};
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (places_[k] < lower || places_[k] > upper || !(values_[k].value < limit)) continue;
    span[0] = std::min(span[0], places_[k]);
    span[1] = std::max(span[1], places_[k]);
  }
  // The ends lie between knots; a minimum between two knots may be the only point below the limit.
  span[0] = below(limit, span[0], lower, upper)[0];
  span[1] = below(limit, span[1], lower, upper)[1];
  return span;
}

}  // namespace rollfem::track
