// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies displaced or moving by themselves: moved all together nothing changes, and every velocity
// is the difference of two displaced poses over the way rolled between them.
#include "track/motion/placed_scenes.hpp"
#include "track/motion/wheelset_motion.hpp"

#include "support/wheel_rail_cases.hpp"
#include <functional>
#include <string>

namespace {

using contact::Vector3;

constexpr double endless = contact::infinity;

/// On rails, rollers or in a ring, with the wheelset moving in every way.
contact::Case moving_case(double rail_radius) {
  contact::Case input = manchester_case(4.0, 0.012);
  input.rail.rolling_radius = rail_radius;
  input.wheelset.roll = {0.002};
  input.wheelset.lateral_velocity = 0.003;
  input.wheelset.yaw_velocity = 2e-6;
  input.wheelset.roll_velocity = 3e-6;
  input.wheel_displacement.lateral_velocity = {1e-3, -2e-3};
  input.wheel_displacement.yaw_velocity = {2e-6, 1e-6};
  input.wheel_displacement.rotation = {1e-6, -2e-6};
  input.rail_displacement.roll_velocity = {1e-6, -2e-6};
  return input;
}

std::vector<double> numbers_of(const contact::Case& input, bool left) {
  const track::WheelRailContact contact = contacts_of(input, left).at(0);
  const track::Motion motion = track::motion_of(input, 0.001);
  const contact::Creepage creepage = track::creepage_of(contact, motion);
  const Vector3 beside = track::slip_at(contact, motion, {5.0, -3.0, 1.0});
  return {contact.place.y_rail,
          contact.place.y_wheel,
          contact.place.contact_angle,
          contact.place.rolling_radius,
          contact.geometry.distance(4.0, 2.0),
          creepage.longitudinal,
          creepage.lateral,
          1e3 * creepage.spin,
          beside[0],
          beside[1],
          1e-6 * track::driving_moment(contact, {-700.0, 400.0, 9000.0, 1200.0})};
}

void expect_the_same(const contact::Case& a, const contact::Case& b, bool left) {
  const std::vector<double> before = numbers_of(a, left), after = numbers_of(b, left);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NEAR(after[k], before[k], 1e-9 * std::max(std::abs(before[k]), 1e-2)) << k;
}

TEST(DisplacedBodies, MovedTogetherChangeNothing) {
  for (const double radius : {endless, 500.0, -3000.0})
    for (const bool left : {true, false}) {
      const contact::Case input = moving_case(radius);
      contact::Case moved = input;
      moved.wheel_displacement.lateral = moved.rail_displacement.lateral = {3.0, -2.0};
      moved.wheel_displacement.vertical = moved.rail_displacement.vertical = {5.0, -4.0};
      if (radius == endless) moved.wheel_displacement.longitudinal = {10.0, -20.0};
      expect_the_same(input, moved, left);
    }
}

TEST(DisplacedBodies, ALoweredWheelRollsOnItsOwnRadius) {
  contact::Case input = manchester_case(2.0, 0.0);
  input.wheelset.roll = {0.0};
  input.wheel_displacement.vertical = {0.5, -5.0};
  for (const bool left : {true, false}) {
    const auto contact = contacts_of(input, left).at(0);
    const auto creepage = track::creepage_of(contact, track::motion_of(input, 0.001));
    EXPECT_NEAR(creepage.longitudinal, 1.0 - 1.001 * contact.place.rolling_radius / 460.0, 1e-9);
  }
}

TEST(DisplacedBodies, ATurnedWheelRollsLikeATurnedWheelset) {
  // A wheel turned about its origin and the wheelset turned about its middle differ by where the
  // wheel then is.
  contact::Case input = manchester_case(0.0, 0.0), turned = input;
  const double yaw = 0.012, roll = 0.003, middle = 680.0 + 70.0, radius = 460.0;
  input.wheelset.yaw = {yaw};
  input.wheelset.roll = {roll};
  turned.wheelset.roll = {0.0};
  for (const bool left : {true, false}) {
    const double sign = left ? -1.0 : 1.0, away = sign * middle;
    const std::size_t side = left ? 0 : 1;
    contact::Displacement& moved = turned.wheel_displacement;
    moved.yaw[side] = yaw;
    moved.roll[side] = roll;
    const Vector3 axle{-std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll),
                       std::sin(roll)};
    const Vector3 down = contact::cross({std::cos(yaw), std::sin(yaw), 0.0}, axle);
    moved.longitudinal[side] = away * axle[0] + radius * down[0];
    moved.lateral[side] = away * (axle[1] - 1.0) + radius * down[1];
    expect_the_same(input, turned, left);
  }
}

/// What the velocities change, and how far the wheel has rolled.
struct State {
  contact::Case input;
  track::WheelsetPose pose;
  double rolled = 0.0;  ///< rad, forward
};

/// The body's frame of wheel or rail in the track frame: origin and directions in columns.
struct Body {
  Vector3 origin;
  Eigen::Matrix3d axes;
};

Body wheel_of(const State& now, bool left) {
  const contact::Displacement& moved = now.input.wheel_displacement;
  const contact::Axle axle = place_axle(now.pose, now.input, left);
  const double sign = left ? -1.0 : 1.0, yaw = now.pose.yaw + moved.yaw[left ? 0 : 1];
  const Eigen::Vector3d side(sign * axle.direction[0], axle.direction[1], sign * axle.direction[2]);
  const Eigen::Vector3d ahead(std::cos(yaw), std::sin(yaw), 0.0), down = ahead.cross(side);
  Body body{{axle.point[0], sign * axle.point[1], axle.point[2]}, {}};
  // What points ahead goes down as the wheel rolls forward.
  const double c = std::cos(now.rolled), s = std::sin(now.rolled);
  body.axes << c * ahead + s * down, side, c * down - s * ahead;
  return body;
}

Body rail_of(const State& now, bool left) {
  const track::RailPlace place = make_search_scene(now.input, manchester_pair()).rail(left).place;
  const double sign = left ? -1.0 : 1.0, turned = sign * place.angle;
  Body body{{0.0, sign * place.shift_y, place.shift_z}, {}};
  body.axes << 1.0, 0.0, 0.0, 0.0, std::cos(turned), -std::sin(turned), 0.0, std::sin(turned),
      std::cos(turned);
  return body;
}

/// Change of a place of the material from one pose to the other.
Vector3 moved(const Body& before, const Body& now, const Body& after, const Vector3& at) {
  const auto vector = [](const Vector3& v) { return Eigen::Vector3d(v[0], v[1], v[2]); };
  const Eigen::Vector3d own = now.axes.transpose() * (vector(at) - vector(now.origin));
  const Eigen::Vector3d change =
      vector(after.origin) - vector(before.origin) + (after.axes - before.axes) * own;
  return {change[0], change[1], change[2]};
}

/// A velocity of the case, on both sides alike, and the displacement by it.
struct Velocity {
  const char* name;
  bool of_rail;
  double step;  ///< mm or rad
  std::function<void(contact::Case&, double)> set;
  std::function<void(State&, double)> displace;
};

std::vector<Velocity> velocities() {
  using D = contact::Displacement;
  std::vector<Velocity> all{
      {"lateral", false, 1e-2, [](auto& c, double v) { c.wheelset.lateral_velocity = v; },
       [](State& s, double by) { s.pose.lateral_shift += by; }},
      {"yaw", false, 1e-4, [](auto& c, double v) { c.wheelset.yaw_velocity = v; },
       [](State& s, double by) { s.pose.yaw += by; }},
      {"roll", false, 1e-4, [](auto& c, double v) { c.wheelset.roll_velocity = v; },
       [](State& s, double by) { s.pose.roll += by; }},
      {"vertical", false, 1e-2, [](auto& c, double v) { c.wheelset.vertical_velocity = v; },
       [](State& s, double by) { s.pose.height += by; }},
      {"wheel rotation", false, 1e-4,
       [](auto& c, double v) {
         c.wheel_displacement.rotation = {v, v};
       },
       [](State& s, double by) { s.rolled += by; }}};
  struct Pair {
    const char* name;
    double step;
    D::Sides D::*velocity;
    D::Sides D::*place;
    bool rail_too;
  };
  for (const Pair& pair :
       {Pair{"longitudinal", 1e-2, &D::longitudinal_velocity, &D::longitudinal, false},
        Pair{"lateral", 1e-2, &D::lateral_velocity, &D::lateral, true},
        Pair{"vertical", 1e-2, &D::vertical_velocity, &D::vertical, true},
        Pair{"roll", 1e-4, &D::roll_velocity, &D::roll, true},
        Pair{"yaw", 1e-4, &D::yaw_velocity, &D::yaw, false}})
    for (const bool rail : {false, true}) {
      if (rail && !pair.rail_too) continue;
      const auto body =
          rail ? &contact::Case::rail_displacement : &contact::Case::wheel_displacement;
      all.push_back({pair.name, rail, pair.step,
                     [=](auto& c, double v) {
                       c.*body.*pair.velocity = {v, v};
                     },
                     [=](State& s, double by) {
                       for (double& value : s.input.*body.*pair.place) value += by;
                     }});
    }
  return all;
}

TEST(DisplacedBodies, VelocitiesAreDifferencesOfPoses) {
  for (const bool follows : {true, false})
    for (const double radius : {endless, 500.0})
      for (const bool left : {true, false}) {
        contact::Case input = manchester_case(4.0, 0.012);
        input.rail.rolling_radius = radius;
        input.wheelset.roll = {0.002};
        if (!follows) input.wheelset.vertical_velocity = 0.0;
        input.wheel_displacement.longitudinal = {2.0, -3.0};
        input.wheel_displacement.lateral = {-1.0, 0.5};
        input.wheel_displacement.vertical = {1.0, 2.0};
        input.wheel_displacement.roll = {0.003, -0.002};
        input.rail_displacement.vertical = {-1.0, 0.5};
        input.rail_displacement.roll = {0.001, 0.004};
        const auto still = contacts_of(input, left).at(0);
        const State now{input, still.pose};
        for (const Velocity& velocity : velocities()) {
          const bool given = std::string(velocity.name) == "vertical";
          if (given && follows) continue;
          SCOPED_TRACE(velocity.name);
          State before = now, after = now;
          velocity.displace(before, -velocity.step);
          velocity.displace(after, velocity.step);
          const auto body = velocity.of_rail ? rail_of : wheel_of;
          const double sign = velocity.of_rail ? -1.0 : 1.0;
          const auto rate_at = [&](const Vector3& place) {
            Vector3 by = moved(body(before, left), body(now, left), body(after, left), place);
            for (double& value : by) value *= 0.5 * sign / velocity.step;
            return by;
          };
          contact::Case moving = input;
          const double rate = 1e-3;
          velocity.set(moving, rate);
          const auto contact = contacts_of(moving, left).at(0);
          const Vector3 beside{4.0, -3.0, 0.5};
          const Vector3 a = slip_at(still, track::motion_of(input, 0.0), beside);
          const Vector3 b = slip_at(contact, track::motion_of(moving, 0.0), beside);
          Vector3 place = contact.origin;
          for (int d = 0; d < 3; ++d)
            place[d] += beside[0] * contact.along[d] + beside[1] * contact.across[d] +
                        beside[2] * contact.normal[d];
          Vector3 expected = rate_at(place);
          if (follows)
            expected[2] -=
                contact::dot(rate_at(contact.origin), contact.normal) / contact.normal[2];
          const double within =
              1e-6 * std::max(1.0, 10.0 * std::sqrt(contact::dot(expected, expected)));
          EXPECT_NEAR((b[0] - a[0]) / rate, contact::dot(expected, contact.along), within);
          EXPECT_NEAR((b[1] - a[1]) / rate, contact::dot(expected, contact.across), within);
        }
      }
}

}  // namespace
