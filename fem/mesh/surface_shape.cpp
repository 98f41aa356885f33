// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of wheel and rail: chart coordinates to points and back, local frames, the manifold.
#include "fem/mesh/surface_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rollfem::fem {

namespace {

/// Sign of z into the material.
double inwards_of(const SurfaceShape& shape) {
  return shape.is_wheel ? 1.0 : -1.0;
}

/// From the axle to (y, z) in the plane x = 0, towards the material's outside.
double distance_from(const meshes::AxleTrace& axle, double y, double z) {
  return y * axle.sine - (z - axle.height) * axle.cosine;
}

}  // namespace

ProfileShape::ProfileShape(std::shared_ptr<const contact::PatchGeometry> geometry, bool is_wheel)
    : geometry_(std::move(geometry)), section_(is_wheel ? geometry_->wheel() : geometry_->rail()) {
  const auto [lower, upper] = section_.gentle_part(steepest);
  lower_ = lower;
  upper_ = upper;
}

SurfaceHeight ProfileShape::height(double t) const {
  const double inside = std::min(std::max(t, lower_), upper_);
  const contact::CurveValue at = section_.at(inside);
  return {at.value + at.slope * (t - inside), at.slope};
}

SurfaceShape profile_surface(std::shared_ptr<const contact::PatchGeometry> geometry,
                             bool is_wheel) {
  SurfaceShape shape;
  shape.is_wheel = is_wheel;
  shape.profile = std::make_shared<ProfileShape>(std::move(geometry), is_wheel);
  if (is_wheel || shape.profile->geometry().is_roller())
    shape.rolling_radius = distance_from(shape.axle(), 0.0, shape.height(0.0).value);
  return shape;
}

bool SurfaceShape::is_revolved() const {
  return std::isfinite(rolling_radius);
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

SurfaceHeight SurfaceShape::height(double t) const {
  if (profile) return profile->height(t);
  const contact::ProfileDrop drop = drop_at(t);
  const double inwards = inwards_of(*this);
  return {inwards * drop.value, inwards * drop.slope};
}

meshes::AxleTrace SurfaceShape::axle() const {
  if (profile && is_wheel) return meshes::axle_trace(profile->geometry().axle());
  if (profile && profile->geometry().is_roller())
    return meshes::axle_trace(profile->geometry().rail_axle());
  return {1.0, 0.0, rolling_radius, 0.0};
}

double SurfaceShape::streamline_radius(double t) const {
  return is_revolved() ? distance_from(axle(), t, height(t).value) : contact::infinity;
}

dealii::Point<3> SurfaceShape::turned_about_axle(double y, double z, double angle) const {
  const meshes::AxleTrace about = axle();
  const double radius = distance_from(about, y, z);
  // 1 - cos = 2 sin^2(angle/2) keeps all digits near the contact point.
  const double half_sine = std::sin(0.5 * angle);
  const double inwards = 2.0 * radius * half_sine * half_sine;
  return {radius * std::sin(angle), y - inwards * about.sine, z + inwards * about.cosine};
}

dealii::Point<3> SurfaceShape::turned_to_section(const dealii::Point<3>& place) const {
  const meshes::AxleTrace about = axle();
  const double below = distance_from(about, place[1], place[2]);
  const double radius = std::copysign(std::hypot(place[0], below), below);
  // From the difference of both distances, without cancellation.
  const double outwards = place[0] * place[0] / (radius + below);
  return {std::atan2(std::copysign(1.0, below) * place[0], std::abs(below)),
          place[1] + outwards * about.sine, place[2] - outwards * about.cosine};
}

dealii::Point<3> SurfaceShape::place(double s, double t, double depth) const {
  if (functions) return functions->place({s, t, depth});
  const double z = height(t).value;
  if (!is_revolved()) return {s, t, z + inwards_of(*this) * depth};
  return turned_about_axle(t, z + inwards_of(*this) * depth, s / distance_from(axle(), t, z));
}

dealii::Point<3> SurfaceShape::coordinates(const dealii::Point<3>& place) const {
  if (functions) return functions->coordinates(place);
  if (!is_revolved())
    return {place[0], place[1], inwards_of(*this) * (place[2] - height(place[1]).value)};
  const dealii::Point<3> back = turned_to_section(place);
  const double surface = height(back[1]).value;
  return {distance_from(axle(), back[1], surface) * back[0], back[1],
          inwards_of(*this) * (back[2] - surface)};
}

SurfaceFrame SurfaceShape::frame(double s, double t) const {
  return tilted_frame(s, t, height(t).slope);
}

SurfaceFrame SurfaceShape::tilted_frame(double s, double t, double climb) const {
  if (functions) return functions->frame(s, t);
  const auto [cosine_of_tilt, sine_of_tilt, height, axial] = axle();
  const double length = std::sqrt(1.0 + climb * climb);
  const double angle = is_revolved() ? s / streamline_radius(t) : 0.0;
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const dealii::Tensor<1, 3> rolling({cosine, -sine_of_tilt * sine, cosine_of_tilt * sine});
  // Towards the axle after rotation.
  const dealii::Tensor<1, 3> up({-sine, -sine_of_tilt * cosine, cosine_of_tilt * cosine});
  const dealii::Tensor<1, 3> along({0.0, cosine_of_tilt, sine_of_tilt});
  // (0, 1, climb) and (0, -climb, 1) along the axle and towards it.
  const double tangent = cosine_of_tilt + climb * sine_of_tilt;
  const double normal = climb * cosine_of_tilt - sine_of_tilt;
  return {rolling, (tangent * along + normal * up) / length,
          (tangent * up - normal * along) / length};
}

dealii::DerivativeForm<1, 3, 3> MeansInChart::push_forward_gradient(
    const dealii::Point<3>& chart) const {
  constexpr double step = 1e-4;  // mm
  dealii::DerivativeForm<1, 3, 3> gradient;
  for (unsigned int d = 0; d < 3; ++d) {
    auto ahead = chart, behind = chart;
    ahead[d] += step;
    behind[d] -= step;
    const auto change = (to_space_(ahead) - to_space_(behind)) / (2.0 * step);
    for (unsigned int c = 0; c < 3; ++c) gradient[c][d] = change[c];
  }
  return gradient;
}

MeansInChart surface_manifold(const SurfaceShape& shape, const GradedDepth& rows) {
  return {[shape, rows](const dealii::Point<3>& place) {
            dealii::Point<3> chart = shape.coordinates(place);
            chart[2] = rows.even(chart[2]);
            return chart;
          },
          [shape, rows](const dealii::Point<3>& chart) {
            return shape.place(chart[0], chart[1], rows.depth(chart[2]));
          }};
}

MeansInChart axle_manifold(const SurfaceShape& wheel) {
  return {[wheel](const dealii::Point<3>& place) { return wheel.turned_to_section(place); },
          [wheel](const dealii::Point<3>& chart) {
            return wheel.turned_about_axle(chart[1], chart[2], chart[0]);
          }};
}

}  // namespace rollfem::fem
