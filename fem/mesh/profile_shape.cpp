// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/profile_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::fem {

contact::ContactSurface profile_contact(const ProfileShape& shape) {
  return contact::ContactSurface::of(shape.geometry());
}

ProfileShape::ProfileShape(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel)
    : geometry_(std::move(geometry)), is_wheel_(is_wheel) {
  const contact::HeightCurve& section = is_wheel ? geometry_->wheel() : geometry_->rail();
  const auto [lower, upper] = section.gentle_part(steepest);
  lower_ = lower;
  upper_ = upper;
  if (!is_wheel) return;
  const contact::Axle& axle = geometry_->axle();
  const double across = std::hypot(axle.direction[1], axle.direction[2]);
  cosine_ = axle.direction[1] / across;
  sine_ = axle.direction[2] / across;
  // A yawed axle crosses the plane x = 0 approximately above y = 0: the normal intersects the axle.
  const double way = -axle.point[1] / axle.direction[1];
  axle_y_ = 0.0;
  axle_z_ = axle.point[2] + way * axle.direction[2];
}

ProfileShape::Height ProfileShape::height(double t) const {
  const contact::HeightCurve& section = is_wheel_ ? geometry_->wheel() : geometry_->rail();
  const double inside = std::min(std::max(t, lower_), upper_);
  const contact::CurveValue at = section.at(inside);
  return {at.value + at.slope * (t - inside), at.slope};
}

double ProfileShape::distance_from_axle(double y, double z) const {
  return (y - axle_y_) * sine_ - (z - axle_z_) * cosine_;
}

double ProfileShape::radius(double t) const {
  return is_wheel_ ? distance_from_axle(t, height(t).value) : contact::infinity;
}

dealii::Tensor<1, 3> ProfileShape::axle_direction() const {
  return dealii::Tensor<1, 3>({0.0, cosine_, sine_});
}

dealii::Point<3> ProfileShape::turned_about_axle(double y, double z, double angle) const {
  const double radius = distance_from_axle(y, z);
  // 1 - cos = 2 sin^2(angle/2) keeps all digits near the contact point.
  const double half_sine = std::sin(0.5 * angle);
  const double inwards = 2.0 * radius * half_sine * half_sine;
  return {radius * std::sin(angle), y - inwards * sine_, z + inwards * cosine_};
}

dealii::Point<3> ProfileShape::turned_to_section(const dealii::Point<3>& place) const {
  const double below = distance_from_axle(place[1], place[2]);
  const double radius = std::hypot(place[0], below);
  // From the difference of both distances, without cancellation.
  const double outwards = place[0] * place[0] / (radius + below);
  return {std::atan2(place[0], below), place[1] + outwards * sine_, place[2] - outwards * cosine_};
}

dealii::Point<3> ProfileShape::place(double s, double t, double depth) const {
  const double z = height(t).value;
  if (!is_wheel_) return {s, t, z - depth};
  return turned_about_axle(t, z + depth, s / distance_from_axle(t, z));
}

dealii::Point<3> ProfileShape::coordinates(const dealii::Point<3>& place) const {
  if (!is_wheel_) return {place[0], place[1], height(place[1]).value - place[2]};
  const dealii::Point<3> back = turned_to_section(place);
  const double surface = height(back[1]).value;
  return {distance_from_axle(back[1], surface) * back[0], back[1], back[2] - surface};
}

dealii::DerivativeForm<1, 3, 3> ProfileShape::gradient(const dealii::Point<3>& chart) const {
  const Height at = height(chart[1]);
  dealii::DerivativeForm<1, 3, 3> gradient;
  gradient[1][1] = 1.0;
  if (!is_wheel_) {
    gradient[0][0] = 1.0;
    gradient[2][1] = at.slope;
    gradient[2][2] = -1.0;
    return gradient;
  }
  const double on_surface = distance_from_axle(chart[1], at.value);
  const double radius = on_surface - chart[2] * cosine_;
  const double by_t = sine_ - at.slope * cosine_;
  const double angle = chart[0] / on_surface;
  const double sine = std::sin(angle);
  const double half_sine = std::sin(0.5 * angle);
  const double fall = 2.0 * half_sine * half_sine;
  // The angle of a given arc length changes with the radius.
  const double turn = -radius * angle / on_surface * by_t;
  const double cosine = std::cos(angle);
  const double stretch = radius / on_surface;
  // Along x, and towards the axle, that is along (0, -sin, cos) of the tilt.
  const double along[3] = {stretch * cosine, by_t * sine + turn * cosine, -cosine_ * sine};
  const double inwards[3] = {stretch * sine, by_t * fall + turn * sine, -cosine_ * fall};
  gradient[2][1] = at.slope;
  gradient[2][2] = 1.0;
  for (unsigned int d = 0; d < 3; ++d) {
    gradient[0][d] += along[d];
    gradient[1][d] -= sine_ * inwards[d];
    gradient[2][d] += cosine_ * inwards[d];
  }
  return gradient;
}

SurfaceFrame ProfileShape::frame(double s, double t, double climb) const {
  const double length = std::sqrt(1.0 + climb * climb);
  const double angle = is_wheel_ ? s / radius(t) : 0.0;
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const dealii::Tensor<1, 3> rolling({cosine, -sine_ * sine, cosine_ * sine});
  // Towards the axle after rotation.
  const dealii::Tensor<1, 3> up({-sine, -sine_ * cosine, cosine_ * cosine});
  const dealii::Tensor<1, 3> axle = axle_direction();
  // (0, 1, climb) and (0, -climb, 1) along the axle and towards it.
  return {rolling, ((cosine_ + climb * sine_) * axle + (climb * cosine_ - sine_) * up) / length,
          ((sine_ - climb * cosine_) * axle + (cosine_ + climb * sine_) * up) / length};
}

}  // namespace rollfem::fem
