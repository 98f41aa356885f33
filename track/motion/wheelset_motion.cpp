// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/motion/wheelset_motion.hpp"

#include "base/knots.hpp"
#include "base/pi.hpp"
#include "halfspace/patch/load_sharing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::track {

using contact::cross;
using contact::dot;
using contact::pi;
using contact::Vector3;

namespace {

Vector3 sum(const Vector3& a, const Vector3& b, double factor = 1.0) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// Angular velocity of the wheelset without its rotation about the axle, track frame.
Vector3 carried(const WheelRailContact& contact, const Motion& motion) {
  return sum({0.0, 0.0, motion.yaw_velocity}, ahead_of(contact.axle.direction),
             motion.roll_velocity);
}

/// Angular velocity of the wheel over its rail in the track frame. The axle's direction points to
/// the right; a wheel that rolls forward turns from x to z (down), hence the minus sign.
Vector3 angular_velocity(const WheelRailContact& contact, const Motion& motion) {
  const Vector3 turning = sum(carried(contact, motion), contact.axle.direction, -motion.rotation);
  return sum(turning, contact.own_turning);
}

/// Velocity of the wheel's material over its rail at a place of the track frame.
Vector3 velocity(const WheelRailContact& contact, const Motion& motion, const Vector3& place) {
  const auto about = [&](const Vector3& turning, const Vector3& centre) {
    return cross(turning, sum(place, centre, -1.0));
  };
  Vector3 total = sum(contact.own_velocity, {0.0, motion.lateral_velocity, 0.0});
  total = sum(total, about(contact.own_turning, contact.origin));
  total = sum(total, about(carried(contact, motion), contact.middle));
  return sum(total, about(contact.axle.direction, contact.axle.point), -motion.rotation);
}

contact::Creepage creepage_at(const WheelRailContact& contact, const Motion& motion,
                              const Vector3& place) {
  const Vector3 slip = slip_at(contact, motion, place);
  return {slip[0], slip[1], dot(angular_velocity(contact, motion), contact.normal)};
}

}  // namespace

Motion motion_of(const contact::Case& input, double rotation_change) {
  const contact::Wheelset& given = input.wheelset;
  const double sign = frame_sign(given);
  return {(1.0 + rotation_change) / input.wheel.rolling_radius, sign * given.lateral_velocity,
          sign * given.yaw_velocity, sign * given.roll_velocity, given.vertical_velocity};
}

Vector3 slip_at(const WheelRailContact& contact, const Motion& motion, const Vector3& place) {
  Vector3 at = contact.origin;
  at = sum(at, contact.along, place[0]);
  at = sum(at, contact.across, place[1]);
  at = sum(at, contact.normal, place[2]);
  Vector3 slip = velocity(contact, motion, at);
  // Vertical speed that keeps the bodies together at the reference point; z points down, the normal
  // up. The plane there is not quite tangent to the wheel, so rolling parts or presses them too.
  const double parting = dot(velocity(contact, motion, contact.origin), contact.normal);
  slip[2] += motion.vertical_velocity.value_or(-parting / contact.normal[2]);
  return {dot(slip, contact.along), dot(slip, contact.across), dot(slip, contact.normal)};
}

Vector3 surface_place(const WheelRailContact& contact) {
  // The geometry is lowered until this contact touches, the axle until the wheel's first contact
  // does.
  return {0.0, 0.0, contact.geometry.distance(0.0, 0.0) + contact.place.separation};
}

contact::Creepage creepage_of(const WheelRailContact& contact, const Motion& motion) {
  return creepage_at(contact, motion, surface_place(contact));
}

contact::Creepage creepage_on_rail(const WheelRailContact& contact, const Motion& motion) {
  return creepage_at(contact, motion, {});
}

Eigen::Matrix3d creepage_by_motion(const WheelRailContact& contact, bool on_rail) {
  const auto at = [&](const Motion& motion) {
    const contact::Creepage found =
        on_rail ? creepage_on_rail(contact, motion) : creepage_of(contact, motion);
    return Eigen::Vector3d(found.longitudinal, found.lateral, found.spin);
  };
  const Eigen::Vector3d rest = at({});
  Eigen::Matrix3d by;
  by << at({1.0, 0.0, 0.0}) - rest, at({0.0, 1.0, 0.0}) - rest, at({0.0, 0.0, 1.0}) - rest;
  return by;
}

double driving_moment(const WheelRailContact& contact, const PatchForce& force) {
  Vector3 total = sum({}, contact.along, force.longitudinal);
  total = sum(total, contact.across, force.lateral);
  total = sum(total, contact.normal, force.normal);
  const Vector3 surface = sum(contact.origin, contact.normal, surface_place(contact)[2]);
  const Vector3 arm = sum(surface, contact.axle.point, -1.0);
  const Vector3 moment = sum(cross(arm, total), contact.normal, force.spin_moment);
  return -dot(moment, contact.axle.direction);
}

double vertical_force(double normal, double lateral, const contact::ContactPlace& place) {
  const auto [across, along_normal] = halfspace::upwards(place);
  return normal * along_normal + lateral * across;
}

double lateral_force(double normal, double lateral, const contact::ContactPlace& place) {
  return -side_sign(place.left) * normal * std::sin(place.contact_angle) -
         lateral * std::cos(place.contact_angle);
}

namespace {

/// Points over a quarter wave, whose integrand is smooth except for the jumps of the radii.
constexpr int quadrature_points = 2000;

}  // namespace

RadiusDifference::RadiusDifference(std::vector<double> shift, std::vector<double> difference)
    : shift_(std::move(shift)), difference_(std::move(difference)), integral_(shift_.size(), 0.0) {
  if (shift_.size() < 2 || shift_.size() != difference_.size() || shift_.front() > 0.0 ||
      !std::is_sorted(shift_.begin(), shift_.end()))
    throw std::invalid_argument("lateral shifts of rolling radii must increase from 0 or less");
  for (std::size_t k = 1; k < shift_.size(); ++k)
    integral_[k] = integral_[k - 1] +
                   0.5 * (difference_[k] + difference_[k - 1]) * (shift_[k] - shift_[k - 1]);
}

double RadiusDifference::at(double shift) const {
  const auto [k, length, part] = contact::piece_of(shift_, shift);
  return difference_[k] + part * (difference_[k + 1] - difference_[k]);
}

double RadiusDifference::integral(double shift) const {
  if (shift < shift_.front()) shift = -shift;  // odd
  const std::size_t k = contact::piece_of(shift_, shift).first;
  return integral_[k] + 0.5 * (difference_[k] + at(shift)) * (shift - shift_[k]);
}

double RadiusDifference::middle(double amplitude) const {
  if (shift_.front() == 0.0) return 0.0;
  // Equal work on both sides; the difference of both rises with the middle where the radii do.
  double low = shift_.front() + amplitude, high = shift_.back() - amplitude;
  if (low > high) return std::nan("");
  while (high - low > 1e-12 * amplitude) {
    const double at = 0.5 * (low + high);
    if (at == low || at == high) break;
    (integral(at + amplitude) > integral(at - amplitude) ? high : low) = at;
  }
  return 0.5 * (low + high);
}

double RadiusDifference::harmonic_conicity(double amplitude) const {
  // On each piece a + b A sin t, times sin t: exact.
  const auto angle = [&](double shift) {
    return std::asin(std::clamp(shift / amplitude, 0.0, 1.0));
  };
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < shift_.size() && shift_[k] < amplitude; ++k) {
    const double slope = (difference_[k + 1] - difference_[k]) / (shift_[k + 1] - shift_[k]);
    const double offset = difference_[k] - slope * shift_[k];
    const double from = angle(shift_[k]), to = angle(shift_[k + 1]);
    sum +=
        offset * (std::cos(from) - std::cos(to)) +
        slope * amplitude * 0.25 * (2.0 * (to - from) - std::sin(2.0 * to) + std::sin(2.0 * from));
  }
  return 2.0 * sum / (pi * amplitude);
}

std::optional<double> RadiusDifference::wave_length(double amplitude, double contact_distance,
                                                    double rolling_radius) const {
  // y'^2 = 2 (integral(A) - integral(y)) / (e r); y = A sin t removes the singularity at the end.
  const double stiffness = contact_distance * rolling_radius, centre = middle(amplitude);
  const double energy = integral(centre + amplitude);
  double half = 0.0;
  for (const double side : {amplitude, -amplitude})
    for (int k = 0; k < quadrature_points; ++k) {
      const double t = 0.5 * pi * (k + 0.5) / quadrature_points;
      const double left = energy - integral(centre + side * std::sin(t));
      if (!(left > 0.0)) return {};
      half += amplitude * std::cos(t) / std::sqrt(2.0 * left / stiffness);
    }
  return 2.0 * half * 0.5 * pi / quadrature_points;
}

double conicity_of_wave(double wave_length, double contact_distance, double rolling_radius) {
  return 2.0 * pi * pi * contact_distance * rolling_radius / (wave_length * wave_length);
}

}  // namespace rollfem::track
