// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/case/keys/key_builder.hpp"

#include <algorithm>

namespace rollfem::contact {

namespace {

using Point = FrictionVariation::Point;

/// The points, at least `count`; new ones are as the case is so far.
std::vector<Point>& points_of(Case& c, std::size_t count) {
  std::vector<Point>& points = c.friction_variation.points;
  if (points.size() < count)
    points.resize(count,
                  points.empty() ? Point{c.friction_coefficient, c.friction_fall} : points.front());
  return points;
}

/// One number for the whole rail, or one per point; `member` finds it in a point.
template <class Member>
void into_points(KeyBuilder<Case> key, Member member) {
  key.per("friction points")
      .by(
          [member](const Case& c) -> KeyValue {
            std::vector<Point> points = c.friction_variation.points;
            if (points.empty()) points.push_back({c.friction_coefficient, c.friction_fall});
            Point without;
            without.coefficient = -1.0;  // `check` always shows the coefficient
            Numbers numbers;
            bool given = false;
            for (Point& point : points) {
              const KeyValue one = value_of(member(point));
              given = given || one != value_of(member(without));
              if (const auto* number = std::get_if<double>(&one)) numbers.push_back(*number);
            }
            if (!given) return {};
            const KeyValue list = shortened(numbers);
            return std::get<Numbers>(list).size() == 1 ? KeyValue(numbers.front()) : list;
          },
          [member](Case& c, const KeyValue& value) {
            const auto& numbers = std::get<Numbers>(value);
            if (numbers.size() > 1) points_of(c, numbers.size());
            Point whole{c.friction_coefficient, c.friction_fall};
            assign(member(whole), numbers.front());
            c.friction_coefficient = whole.coefficient;
            c.friction_fall = whole.fall;
            std::vector<Point>& points = c.friction_variation.points;
            for (std::size_t k = 0; k < points.size(); ++k) {
              assign(member(points[k]), numbers.at(numbers.size() == 1 ? 0 : k));
              c.friction_coefficient = std::max(c.friction_coefficient, points[k].coefficient);
            }
          });
}

/// A number of all points, of which `check` says nothing where it is as without the key.
void into_fall(KeyBuilder<Case>& key, double FrictionFall::*member) {
  key.by(
      [member](const Case& c) -> KeyValue {
        const double value = c.friction_fall.*member;
        return value == FrictionFall().*member ? KeyValue() : KeyValue(value);
      },
      [member](Case& c, const KeyValue& value) {
        c.friction_fall.*member = std::get<double>(value);
      });
}

void add_fall(Keys<Case>& keys) {
  keys.choice("law")
      .says(
          "How friction falls with the slip velocity (formulas in docs/friction.md); all but "
          "`constant` need rolling.speed, except in a shift.")
      .into(&Case::friction_fall, &FrictionFall::shape,
            words_of(
                {FallShape::none, FallShape::linear, FallShape::rational, FallShape::exponential}));
  into_points(
      keys.reals("kinetic_coefficient")
          .symbol("mu_kin")
          .between(1e-14, 1000.0)
          .otherwise("required unless the law is `constant`")
          .says("Coefficient to which friction falls, 0.01 to 1 times "
                "friction.coefficient; mu_1 is the rest."),
      [](Point & at) -> auto& { return at.fall.kinetic_coefficient; });
  into_points(
      keys.reals("half_velocity")
          .symbol("s_h1")
          .unit("mm/s")
          .between(smallest, 1e12)
          .otherwise("required unless the law is `constant`")
          .says("Slip velocity at which mu_1 is halved; in a shift, slip in mm over one "
                "second."),
      [](Point & at) -> auto& { return at.fall.half_velocity; });
}

void add_parts(Keys<Case>& keys) {
  into_points(
      keys.reals("second_part")
          .symbol("mu_2")
          .zero_or(1e-14, 1000.0)
          .otherwise("0")
          .says("Part of the fall that has its own second_half_velocity."),
      [](Point & at) -> auto& { return at.fall.second_part; });
  into_points(
      keys.reals("second_half_velocity")
          .symbol("s_h2")
          .unit("mm/s")
          .between(smallest, 1e12)
          .otherwise("required with second_part")
          .says("Slip velocity at which mu_2 is halved."),
      [](Point & at) -> auto& { return at.fall.second_half_velocity; });
  into_points(
      keys.reals("polach_a")
          .symbol("A")
          .between(0.01, 1.0)
          .otherwise("kinetic_coefficient is given")
          .says("Polach's A, mu_kin over mu, for `exponential` instead of kinetic_coefficient."),
      [](Point & at) -> auto& { return at.fall.polach_a; });
  into_points(
      keys.reals("polach_b")
          .symbol("B")
          .unit("s/m")
          .between(1e-9, 1e9)
          .otherwise("half_velocity is given")
          .says("Polach's B in 2^-r = exp(-B s), instead of half_velocity."),
      [](Point & at) -> auto& { return at.fall.polach_b; });
  keys.choice("branch")
      .otherwise("sticking")
      .says(
          "State where a steep law without memory has several: `sticking`, the one with the most "
          "friction, or `sliding`, the least, to which fast sliding slows down.")
      .among({"sticking", "sliding"})
      .by(
          [](const Case& c) {
            const bool sliding = c.friction_fall.branch == FrictionBranch::sliding;
            return sliding ? KeyValue(std::string("sliding")) : KeyValue();
          },
          [](Case& c, const KeyValue& value) {
            const bool sliding = std::get<std::string>(value) == "sliding";
            c.friction_fall.branch = sliding ? FrictionBranch::sliding : FrictionBranch::sticking;
          });
  into_fall(keys.real("memory_distance")
                .symbol("d_c")
                .unit("mm")
                .zero_or(smallest, largest)
                .otherwise("0")
                .says("Sliding distance over which friction follows the slip velocity, some "
                      "micrometres; 0: at once."),
            &FrictionFall::memory_distance);
  into_fall(keys.real("memory_velocity")
                .symbol("s_0")
                .unit("mm/s")
                .between(smallest, 1e12)
                .otherwise("1.0")
                .says("Slip velocity below which friction follows as if it slid at this one."),
            &FrictionFall::memory_velocity);
}

/// The places of the points, of which there is one per place.
void into_places(KeyBuilder<Case> key, std::vector<double> FrictionVariation::*member) {
  key.per("friction points")
      .otherwise("friction is the same everywhere")
      .by([member](const Case& c) { return value_of(c.friction_variation.*member); },
          [member](Case& c, const KeyValue& value) {
            assign(c.friction_variation.*member, value);
            points_of(c, (c.friction_variation.*member).size());
          });
}

void add_places(Keys<Case>& keys) {
  into_places(keys.reals("inclination")
                  .unit("rad")
                  .within(1.6)
                  .says("Inclinations of the rail's surface against the track plane, ascending, "
                        "negative on the gauge face (minus the contact angle), for lists of the "
                        "law's numbers: linear between, constant outside. Needs profiles."),
              &FrictionVariation::inclination);
  into_places(
      keys.reals("track_position")
          .unit("mm")
          .within(largest)
          .says("The same over the position along the track, wheelset.track_position, instead of "
                "inclination."),
      &FrictionVariation::track_position);
  into_places(keys.reals("lateral_position")
                  .unit("mm")
                  .within(largest)
                  .says("The same over y, for contacts without profiles."),
              &FrictionVariation::lateral_position);
}

}  // namespace

SectionWithKeys friction_section() {
  Keys<Case> keys("friction", "Friction between wheel and rail", whole_case());
  keys.section().alternatives = true;
  into_points(
      keys.reals("coefficient")
          .symbol("mu")
          // Below this value squares of tractions underflow.
          .zero_or(1e-12, 1000.0)
          .required("0.55")
          .says("Coefficient of friction, of a falling law at rest; 0 is frictionless. Lists, here "
                "and below, belong to inclination, track_position or "
                "lateral_position."),
      [](Point & at) -> auto& { return at.coefficient; });
  add_fall(keys);
  add_parts(keys);
  add_places(keys);
  return keys;
}

SectionWithKeys layer_section() {
  Keys<Layer> keys("layer", "A layer between wheel and rail that gives way to shear alone",
                   &Case::layer);
  keys.section().alternatives = true;
  keys.real("thickness")
      .symbol("h_3")
      .unit("mm")
      .positive()
      .otherwise("no elastic layer")
      .says("Thickness of the layer of dirt, sand or wear particles, or of the roughness.")
      .into(&Layer::thickness);
  keys.real("shear_modulus")
      .symbol("G_3")
      .unit("MPa")
      .positive()
      .otherwise("no elastic layer")
      .says("Its shear modulus; tractions p_t move the surfaces by p_t h_3/G_3 against each other.")
      .into(&Layer::shear_modulus);
  keys.real("yield_stress")
      .symbol("tau_c0")
      .unit("MPa")
      .positive()
      .otherwise("it does not yield")
      .says(
          "Shear stress at which the layer yields; tractions are at most the smaller of it and "
          "mu p_n.")
      .into(&Layer::yield_stress);
  keys.real("hardening")
      .symbol("k_tau")
      .unit("MPa/mm")
      .within(largest)
      .otherwise("0, perfectly plastic")
      .says(
          "Rise of the yield stress per mm by which a particle has yielded since it entered the "
          "patch; below 0 the layer softens.")
      .into(&Layer::hardening);
  return keys;
}

}  // namespace rollfem::contact
