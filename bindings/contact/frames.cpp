// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/frames.hpp"

#include "halfspace/patch/patch_search.hpp"

#include <cmath>
#include <functional>

namespace rollfem::addon {

using contact::Vector3;
using Eigen::Vector3d;

namespace {

Vector3d vector(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

Marker marker(const Vector3d& place, double roll, double yaw) {
  Marker made;
  made.place = place;
  made.roll = roll;
  made.yaw = yaw;
  made.axes =
      (Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(roll, Vector3d::UnitX()))
          .toRotationMatrix();
  return made;
}

/// Calls work(place on the track, force of the element on the wheel, pressure) for loaded elements.
void for_elements(const Patch& patch,
                  const std::function<void(const Vector3d&, const Vector3d&, double)>& work) {
  const track::WheelRailContact& contact = patch.placed->contact;
  const auto along = vector(contact.along), across = vector(contact.across),
             normal = vector(contact.normal), origin = reference_of(patch);
  const contact::ChartedGeometry geometry = halfspace::halfspace_geometry(*patch.scene);
  const auto& p = patch.point.fields.traction;
  const contact::ContactGrid& grid = patch.grid;
  for (int j = 0; j < grid.ny; ++j) {
    const double y = geometry.lateral_place(grid.y(j)),
                 climb = std::atan(geometry.climb(grid.y(j)));
    const Vector3d lateral = std::cos(climb) * across + std::sin(climb) * normal;
    const Vector3d upward = std::cos(climb) * normal - std::sin(climb) * across;
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (!(p.n[k] > 0.0)) continue;
      Vector3d traction = p.n[k] * upward;
      if (p.x.size() > 0) traction += p.x[k] * along + p.y[k] * lateral;
      work(origin + grid.x(i) * along + y * across, grid.element_area() * traction, p.n[k]);
    }
  }
}

}  // namespace

Vector3d reference_of(const Patch& patch) {
  return vector(patch.placed->contact.origin);
}

double angle_of(const Patch& patch) {
  const contact::ContactPlace& place = patch.placed->contact.place;
  return place.left ? place.contact_angle : -place.contact_angle;
}

Markers markers_of(const Problem& problem, const Patch& patch) {
  const contact::Case& input = problem.solver.input();
  const bool left = patch.placed->contact.place.left;
  const double side = track::side_sign(left), radius = input.wheel.rolling_radius;
  const track::RailPlace& rail = problem.solver.search().rail(left).place;
  track::WheelsetPose pose = patch.placed->contact.pose;
  pose.height += patch.placed->sinking;
  const contact::Axle axle = track::place_axle(pose, input, left);
  const Vector3 origin = track::profile_origin(axle, radius);
  Markers made;
  made.rail = marker({0.0, side * rail.shift_y, rail.shift_z}, side * rail.angle, 0.0);
  const std::size_t k = left ? 0 : 1;
  const contact::Displacement& moved = input.wheel_displacement;
  made.wheel = marker({origin[0], side * origin[1], origin[2]}, pose.roll + moved.roll[k],
                      pose.yaw + moved.yaw[k]);
  made.wheelset = marker({0.0, pose.lateral_shift, pose.height - radius}, pose.roll, pose.yaw);
  return made;
}

TrackForce force_of(const Patch& patch) {
  TrackForce sum;
  for_elements(patch, [&](const Vector3d& place, const Vector3d& force, double) {
    sum.force += force;
    sum.moment += place.cross(force);
  });
  return sum;
}

Vector3d pressure_centre(const Patch& patch) {
  Vector3d sum = Vector3d::Zero();
  double weight = 0.0;
  for_elements(patch, [&](const Vector3d& place, const Vector3d&, double pressure) {
    sum += pressure * place;
    weight += pressure;
  });
  return sum / weight;
}

}  // namespace rollfem::addon
