// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/frames.hpp"

#include "halfspace/patch/patch_search.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>

namespace rollfem::addon {

using contact::Vector3;
using Eigen::Vector3d;
using Values = std::vector<double>;

namespace {

struct Marker {
  Vector3d place = Vector3d::Zero();                   ///< mm, on the track
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, on the track
  double roll = 0.0, yaw = 0.0;                        ///< rad
  Vector3d seen(const Vector3d& point) const { return axes.transpose() * (point - place); }
};

/// Of CONTACT: rail and wheel profile, wheelset.
struct Markers {
  Marker rail, wheel, wheelset;
};

Vector3d vector(const Vector3& v) {
  return {v[0], v[1], v[2]};
}

Marker marker(const Vector3d& place, double roll, double yaw) {
  return {place,
          (Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(roll, Vector3d::UnitX()))
              .toRotationMatrix(),
          roll, yaw};
}

/// The contact reference point on the track.
Vector3d reference_of(const Patch& patch) {
  return vector(patch.placed->contact.origin);
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

/// From z to the contact's normal (down).
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
  pose.height = patch.placed->height();
  const contact::Axle axle = track::place_axle(pose, input, left);
  const Vector3 origin = track::profile_origin(axle, radius);
  const std::size_t k = left ? 0 : 1;
  const contact::Displacement& moved = input.wheel_displacement;
  const auto& [aside, down] = patch.placed->rail_moved;
  return {marker({0.0, side * rail.shift_y + aside, rail.shift_z + down}, side * rail.angle, 0.0),
          marker({origin[0], side * origin[1], origin[2]}, pose.roll + moved.roll[k],
                 pose.yaw + moved.yaw[k]),
          marker({0.0, pose.lateral_shift, pose.height - radius}, pose.roll, pose.yaw)};
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

void append(const Vector3d& place, const Units& units, Values& to) {
  for (const double value : place) to.push_back(units.out(value));
}

}  // namespace

double arc_length(const profiles::ProfileCurve& curve, bool wheel, double y) {
  return (wheel ? -1.0 : 1.0) * (curve.parameter_at(y) - curve.parameter_at(0.0));
}

std::array<double, 2> on_track(const Problem& problem, const Patch& patch, double y, double z) {
  const double side = track::side_sign(patch.placed->contact.place.left);
  const Marker wheel = markers_of(problem, patch).wheel;
  const Vector3d place = wheel.place + wheel.axes * Vector3d(0.0, side * y, z);
  return {place.y(), place.z()};
}

Values location_of(Problem& problem, const Patch& patch) {
  if (!patch.placed) throw Refusal(err_icp, "only module 1 has locations");
  const auto& [rail, wheel, set] = markers_of(problem, patch);
  const Vector3d at = reference_of(patch), middle = pressure_centre(patch);
  const double angle = angle_of(patch);
  const contact::ContactPlace& touched = patch.placed->contact.place;
  const track::ProfilePair& profiles = problem.solver.search().profiles;
  const auto& [aside, down] = patch.placed->rail_moved;
  const auto out = [&](double mm) { return problem.units.out(mm); };
  Values v;
  const auto add = [&](const Vector3d& place, std::initializer_list<double> rest) {
    append(place, problem.units, v);
    v.insert(v.end(), rest);
  };
  add(at, {angle});
  add(rail.seen(at), {out(arc_length(profiles.rail, false, touched.y_rail)), angle - rail.roll});
  add(wheel.seen(at), {out(arc_length(profiles.wheel, true, touched.y_wheel)), angle - wheel.roll});
  add({middle.x(), middle.y(), none}, {out(aside), out(down), none});
  add(wheel.place, {wheel.roll, wheel.yaw});
  add(rail.place, {rail.roll, none});
  v.erase(v.end() - 5);  // x
  add(set.seen(at), {angle - set.roll});
  add(set.seen(wheel.place), {wheel.roll - set.roll, wheel.yaw - set.yaw});
  return v;
}

Values global_forces(const Problem& problem, const std::vector<Patch*>& patches) {
  Values v(24, 0.0);
  const double body = -problem.units.body;  // of forces on the wheel
  for (const Patch* patch : patches) {
    const Markers markers = markers_of(problem, *patch);
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for_elements(*patch, [&](const Vector3d& place, const Vector3d& one, double) {
      force += one;
      moment += place.cross(one);
    });
    const auto add = [&](std::size_t first, const Marker& axes, const Marker& about) {
      const Vector3d f = body * (axes.axes.transpose() * force);
      const Vector3d m = body * (axes.axes.transpose() * (moment - about.place.cross(force)));
      for (std::size_t k = 0; k < 3; ++k) {
        v[first + k] += f[static_cast<Eigen::Index>(k)];
        v[first + 3 + k] += problem.units.out(m[static_cast<Eigen::Index>(k)]);
      }
    };
    add(0, Marker{}, markers.rail);
    add(6, markers.wheelset, markers.wheel);
    add(12, markers.rail, markers.rail);
    add(18, markers.wheel, markers.wheel);
  }
  return v;
}

}  // namespace rollfem::addon
