// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of wheel and rail: chart coordinates to points and back, local frames, the manifold.
#include "fem/mesh/chart.hpp"
#include "fem/mesh/profile_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::fem {

namespace {

/// Central differences, accurate enough for tangents, the only use.
dealii::DerivativeForm<1, 3, 3> difference_gradient(const ChartFunctions& functions,
                                                    const dealii::Point<3>& chart) {
  constexpr double step = 1e-4;  // mm
  dealii::DerivativeForm<1, 3, 3> gradient;
  for (unsigned int d = 0; d < 3; ++d) {
    auto ahead = chart, behind = chart;
    ahead[d] += step;
    behind[d] -= step;
    const auto change = (functions.place(ahead) - functions.place(behind)) / (2.0 * step);
    for (unsigned int c = 0; c < 3; ++c) gradient[c][d] = change[c];
  }
  return gradient;
}

}  // namespace

SurfaceShape profile_surface(std::shared_ptr<const contact::PatchGeometry> geometry,
                             bool is_wheel) {
  SurfaceShape shape;
  shape.is_wheel = is_wheel;
  shape.profile = std::make_shared<ProfileShape>(std::move(geometry), is_wheel);
  shape.rolling_radius = shape.profile->radius(0.0);
  return shape;
}

bool SurfaceShape::is_revolved() const {
  return is_wheel && std::isfinite(rolling_radius);
}

double SurfaceShape::lower_t() const {
  return profile ? profile->lower() : -contact::infinity;
}

double SurfaceShape::upper_t() const {
  return profile ? profile->upper() : contact::infinity;
}

contact::ProfileDrop SurfaceShape::drop_at(double t) const {
  return contact::profile_drop(transverse_radius, t, round_to);
}

double SurfaceShape::streamline_radius(double t) const {
  if (profile) return profile->radius(t);
  return rolling_radius - drop_at(t).value;
}

dealii::Point<3> SurfaceShape::place(double s, double t, double depth) const {
  if (functions) return functions->place({s, t, depth});
  if (profile) return profile->place(s, t, depth);
  const double drop = drop_at(t).value;
  if (!is_revolved()) return {s, t, is_wheel ? drop + depth : -drop - depth};
  const double angle = s / (rolling_radius - drop);
  const double inwards = drop + depth;  // towards the axle at z = rolling_radius
  const double half_sine = std::sin(0.5 * angle);
  // 1 - cos = 2 sin^2(angle/2) keeps all digits near the contact point.
  return {(rolling_radius - inwards) * std::sin(angle), t,
          2.0 * rolling_radius * half_sine * half_sine + inwards * std::cos(angle)};
}

dealii::Point<3> SurfaceShape::coordinates(const dealii::Point<3>& place) const {
  if (functions) return functions->coordinates(place);
  if (profile) return profile->coordinates(place);
  const double t = place[1];
  const double drop = drop_at(t).value;
  if (!is_revolved()) return {place[0], t, (is_wheel ? place[2] : -place[2]) - drop};
  const double below_axle = rolling_radius - place[2];
  const double radius = std::hypot(place[0], below_axle);
  const double angle = std::atan2(place[0], below_axle);
  return {(rolling_radius - drop) * angle, t, rolling_radius - drop - radius};
}

SurfaceFrame SurfaceShape::frame(double s, double t) const {
  if (profile) return profile->frame(s, t, profile->height(t).slope);
  // Slope of the surface along t, positive towards the wheel.
  const double drop_slope = drop_at(t).slope;
  return tilted_frame(s, t, is_wheel ? drop_slope : -drop_slope);
}

SurfaceFrame SurfaceShape::tilted_frame(double s, double t, double climb) const {
  if (functions) return functions->frame(s, t);
  if (profile) return profile->frame(s, t, climb);
  const double angle = is_revolved() ? s / streamline_radius(t) : 0.0;
  const double length = std::sqrt(1.0 + climb * climb);
  const dealii::Tensor<1, 3> rolling({std::cos(angle), 0.0, std::sin(angle)});
  const dealii::Tensor<1, 3> up({-std::sin(angle), 0.0, std::cos(angle)});
  const dealii::Tensor<1, 3> across({0.0, 1.0, 0.0});
  return {rolling, (across + climb * up) / length, (up - climb * across) / length};
}

std::unique_ptr<dealii::Manifold<3, 3>> SurfaceManifold::clone() const {
  return std::make_unique<SurfaceManifold>(shape_);
}

dealii::Point<3> SurfaceManifold::pull_back(const dealii::Point<3>& place) const {
  return shape_.coordinates(place);
}

dealii::Point<3> SurfaceManifold::push_forward(const dealii::Point<3>& chart) const {
  return shape_.place(chart[0], chart[1], chart[2]);
}

dealii::DerivativeForm<1, 3, 3> SurfaceManifold::push_forward_gradient(
    const dealii::Point<3>& chart) const {
  if (shape_.functions) return difference_gradient(*shape_.functions, chart);
  if (shape_.profile) return shape_.profile->gradient(chart);
  const auto drop = shape_.drop_at(chart[1]);
  dealii::DerivativeForm<1, 3, 3> gradient;
  if (!shape_.is_revolved()) {
    const double sign = shape_.is_wheel ? 1.0 : -1.0;
    gradient[0][0] = gradient[1][1] = 1.0;
    gradient[2][1] = sign * drop.slope;
    gradient[2][2] = sign;
    return gradient;
  }
  const double on_surface = shape_.streamline_radius(chart[1]);
  const double radius = on_surface - chart[2];
  const double angle = chart[0] / on_surface;
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double stretch = radius / on_surface;
  // The angle of a given arc length grows where the radius decreases.
  const double turn = radius * angle / on_surface * drop.slope;
  gradient[0][0] = stretch * cosine;
  gradient[0][1] = -drop.slope * sine + turn * cosine;
  gradient[0][2] = -sine;
  gradient[1][1] = 1.0;
  gradient[2][0] = stretch * sine;
  gradient[2][1] = drop.slope * cosine + turn * sine;
  gradient[2][2] = cosine;
  return gradient;
}

std::unique_ptr<dealii::Manifold<3, 3>> AxleManifold::clone() const {
  return std::make_unique<AxleManifold>(wheel_);
}

dealii::Point<3> AxleManifold::pull_back(const dealii::Point<3>& place) const {
  return wheel_->turned_to_section(place);
}

dealii::Point<3> AxleManifold::push_forward(const dealii::Point<3>& chart) const {
  return wheel_->turned_about_axle(chart[1], chart[2], chart[0]);
}

}  // namespace rollfem::fem
