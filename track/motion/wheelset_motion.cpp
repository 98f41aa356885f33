#include "track/motion/wheelset_motion.hpp"

#include <cmath>

namespace rollfem::track {

using contact::Vector3;

namespace {

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 sum(const Vector3& a, const Vector3& b, double factor = 1.0) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// Angular velocity in the track frame. The axle's direction points to the right; a wheel that
/// rolls forward turns from z (down) to x the other way round, which is the minus.
Vector3 angular_velocity(const WheelRailContact& contact, const Motion& motion) {
  const Vector3 turning = sum({}, contact.axle.direction, -motion.rotation);
  return sum(turning, {0.0, 0.0, motion.yaw_velocity});
}

Vector3 velocity(const WheelRailContact& contact, const Motion& motion, const Vector3& place) {
  const Vector3 arm = sum(place, contact.axle.point, -1.0);
  return sum({1.0, motion.lateral_velocity, 0.0}, cross(angular_velocity(contact, motion), arm));
}

contact::Creepage creepage_at(const WheelRailContact& contact, const Motion& motion,
                              const Vector3& place) {
  const Vector3 slip = slip_at(contact, motion, place);
  return {slip[0], slip[1], dot(angular_velocity(contact, motion), contact.normal)};
}

}  // namespace

Motion motion_of(const contact::Case& input, double rotation_change) {
  return {(1.0 + rotation_change) / input.wheel.rolling_radius, input.wheelset.lateral_velocity,
          input.wheelset.yaw_velocity};
}

Vector3 slip_at(const WheelRailContact& contact, const Motion& motion, const Vector3& place) {
  Vector3 at = contact.origin;
  at = sum(at, contact.along, place[0]);
  at = sum(at, contact.across, place[1]);
  at = sum(at, contact.normal, place[2]);
  Vector3 slip = velocity(contact, motion, at);
  // Vertical speed that keeps the bodies together; z points down, the normal up. Turning about the
  // axle moves the wheel along its own surface and parts nothing.
  const Vector3 arm = sum(contact.origin, contact.axle.point, -1.0);
  const Vector3 aside =
      sum({0.0, motion.lateral_velocity, 0.0}, cross({0.0, 0.0, motion.yaw_velocity}, arm));
  const double parting = dot(aside, contact.normal);
  slip[2] -= parting / contact.normal[2];
  return {dot(slip, contact.along), dot(slip, contact.across), dot(slip, contact.normal)};
}

Vector3 surface_place(const WheelRailContact& contact) {
  // The geometry is sunk until this contact touches, the axle until the first of the wheel does.
  return {0.0, 0.0, contact.geometry.distance(0.0, 0.0) + contact.place.separation};
}

contact::Creepage creepage_of(const WheelRailContact& contact, const Motion& motion) {
  return creepage_at(contact, motion, surface_place(contact));
}

contact::Creepage creepage_on_rail(const WheelRailContact& contact, const Motion& motion) {
  return creepage_at(contact, motion, {});
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
  const double sign = place.left ? 1.0 : -1.0;
  return normal * std::cos(place.contact_angle) + sign * lateral * std::sin(place.contact_angle);
}

}  // namespace rollfem::track
