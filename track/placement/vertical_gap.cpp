// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/placement/vertical_gap.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rollfem::track {

using contact::CurveValue;

namespace {

constexpr double y_tolerance = 1e-12;  // mm

}  // namespace

double GapMinimum::angle() const {
  return -std::atan(slope);
}

contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail) {
  const auto& knots = rail.knots();
  std::size_t top = 0;
  double least = contact::infinity;
  for (std::size_t k = 0; k < knots.z.size(); ++k)
    if (knots.dy[k] * profiles::steepest >= std::abs(knots.dz[k]) && knots.z[k] < least)
      least = knots.z[k], top = k;
  return profiles::height_over_y(rail, knots.parameter[top]);
}

contact::HeightCurve rail_heights(const profiles::ProfileCurve& rail,
                                  const std::vector<double>& tops_and_grooves) {
  if (tops_and_grooves.size() < 2) return rail_heights(rail);
  std::vector<double> y, z, slope;
  for (const double place : tops_and_grooves) {
    contact::HeightCurve part;
    try {
      part = profiles::height_over_y(rail, place);
    } catch (const contact::SolveError&) {
      continue;  // a groove without a floor
    }
    // A part that reaches several of the places comes again unchanged.
    for (const double at : part.knots()) {
      const CurveValue value = part.at(at);
      while (!y.empty() && at <= y.back() && value.value < z.back())
        for (auto* list : {&y, &z, &slope}) list->pop_back();
      if (!y.empty() && at < y.back() + 1e-9) continue;
      y.push_back(at);
      z.push_back(value.value);
      slope.push_back(value.slope);
    }
  }
  if (y.size() < 2) return rail_heights(rail);
  return {std::move(y), std::move(z), std::move(slope)};
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
  std::vector<double> knots;
  knots.reserve(outline.knots().size() + rail_.knots().size());
  std::merge(outline.knots().begin(), outline.knots().end(), rail_.knots().begin(),
             rail_.knots().end(), std::back_inserter(knots));
  places_.reserve(knots.size() + 2);
  places_.push_back(first_);
  for (const double y : knots)
    if (y > first_ && y < last_) places_.push_back(y);
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
  std::vector<double> gap, slope;
  for (const LocusPoint& point : locus) {
    places_.push_back(point.y);
    gap.push_back(point.rail_z - point.wheel_z);
    // Along the locus the gap changes as at a fixed x, where it is least.
    slope.push_back(point.rail_slope - point.wheel_slope);
  }
  gap_ = {places_, gap, slope};
  climb_ = {places_, climb_over_y(locus), std::vector<double>(places_.size(), 0.0)};
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
