// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/keys/key_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// One number for the whole rail, or one per point; `path` leads to it in a point.
template <class Path>
Access<Case> of_points(Path path) {
  const Access<Point> number = access_to<Point>(path);
  const auto get = [number](const Case& c) -> KeyValue {
    std::vector<Point> points = c.friction_variation.points;
    if (points.empty()) points.push_back({c.friction_coefficient, c.friction_fall});
    Point without;
    without.coefficient = -1.0;  // `check` always shows the coefficient
    Numbers numbers;
    bool given = false;
    for (const Point& point : points) {
      const KeyValue one = number.get(point);
      given = given || one != number.get(without);
      if (const auto* value = std::get_if<double>(&one)) numbers.push_back(*value);
    }
    if (!given) return {};
    const KeyValue list = shortened(numbers);
    return std::get<Numbers>(list).size() == 1 ? KeyValue(numbers.front()) : list;
  };
  const auto set = [number](Case& c, const KeyValue& value) {
    const auto& numbers = std::get<Numbers>(value);
    if (numbers.size() > 1) points_of(c, numbers.size());
    Point whole{c.friction_coefficient, c.friction_fall};
    number.set(whole, numbers.front());
    c.friction_coefficient = whole.coefficient;
    c.friction_fall = whole.fall;
    std::vector<Point>& points = c.friction_variation.points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      number.set(points[k], numbers.at(numbers.size() == 1 ? 0 : k));
      c.friction_coefficient = std::max(c.friction_coefficient, points[k].coefficient);
    }
  };
  return {get, set};
}

template <class Member>
Access<Case> of_falls(Member FrictionFall::*member) {
  return of_points(inside(&Point::fall, member));
}

Choices<FallShape> laws() {
  Choices<FallShape> choices;
  for (const FallShape& shape : fall_shapes()) choices.emplace_back(shape.word, shape);
  return choices;
}

/// The constants that one law has beside those of all.
void add_constants(Keys<Case>& keys, const FallShape& shape) {
  for (std::size_t k = 0; k < shape.constants.size(); ++k) {
    const FallShape::Constant& own = shape.constants[k];
    if (own.name == nullptr) continue;
    Access<Case> access =
        of_points([k](auto& point) -> decltype(auto) { return (point.fall.constants[k]); });
    access.get = [get = access.get, shape](const Case& c) {
      return c.friction_fall.shape == shape ? get(c) : KeyValue();
    };
    keys.add(KeyKind::numbers, own.name, access, per("friction points"), symbol(own.symbol),
             unit(own.unit), between(own.lower, own.upper),
             otherwise(std::isnan(own.otherwise)
                           ? fmt::format("required by the law `{}`", shape.word)
                           : fmt::format("{:g} with the law `{}`", own.otherwise, shape.word)),
             std::string(own.sentence));
  }
}

void add_fall(Keys<Case>& keys) {
  const auto kind = KeyKind::numbers;
  const auto each = per("friction points");
  keys.add("law", inside(&Case::friction_fall, &FrictionFall::shape), laws(),
           "How friction falls with slip velocity or follows temperature (docs/friction.md); all "
           "but `constant` need rolling.speed, except in a shift.");
  keys.add(
      kind, "kinetic_coefficient", of_falls(&FrictionFall::kinetic_coefficient), each,
      symbol("mu_kin"), between(1e-14, 1000.0), otherwise("required by falling laws"),
      "Coefficient to which friction falls, 0.01 to 1 times the coefficient; mu_1 is the rest.");
  keys.add(kind, "half_velocity", of_falls(&FrictionFall::half_velocity), each, symbol("s_h1"),
           unit("mm/s"), between(smallest, 1e12), otherwise("required by falling laws"),
           "Slip velocity at which mu_1 is halved; in a shift, slip in mm over one second.");
  keys.add(kind, "second_part", of_falls(&FrictionFall::second_part), each, symbol("mu_2"),
           zero_or(1e-14, 1000.0), otherwise("0"),
           "Part of the fall that has its own second_half_velocity.");
  keys.add(kind, "second_half_velocity", of_falls(&FrictionFall::second_half_velocity), each,
           symbol("s_h2"), unit("mm/s"), between(smallest, 1e12),
           otherwise("required with second_part"), "Slip velocity at which mu_2 is halved.");
  keys.add(kind, "polach_a", of_falls(&FrictionFall::polach_a), each, symbol("A"),
           between(0.01, 1.0), otherwise("kinetic_coefficient is given"),
           "Polach's A, mu_kin over mu, for `exponential` instead of kinetic_coefficient.");
  keys.add(kind, "polach_b", of_falls(&FrictionFall::polach_b), each, symbol("B"), unit("s/m"),
           between(1e-9, 1e9), otherwise("half_velocity is given"),
           "Polach's B in 2^-r = exp(-B s), instead of half_velocity.");
  for (const FallShape& shape : fall_shapes()) add_constants(keys, shape);
}

void add_memory(Keys<Case>& keys) {
  keys.add("branch", inside(&Case::friction_fall, &FrictionFall::branch),
           {{"sticking", FrictionBranch::sticking}, {"sliding", FrictionBranch::sliding}},
           silent_default, otherwise("sticking"),
           "If a steep law without memory has several states: `sticking`, the one with the most "
           "friction, or `sliding`, the least.");
  keys.add("memory_distance", inside(&Case::friction_fall, &FrictionFall::memory_distance),
           silent_default, symbol("d_c"), unit("mm"), zero_or(smallest, largest), otherwise("0"),
           "Sliding distance over which friction follows the slip velocity, some micrometres.");
  keys.add("memory_velocity", inside(&Case::friction_fall, &FrictionFall::memory_velocity),
           silent_default, symbol("s_0"), unit("mm/s"), between(smallest, 1e12), otherwise("1.0"),
           "Below this slip velocity friction follows as if it slid at it.");
}

/// The places of the points, of which there is one per place.
Access<Case> of_places(std::vector<double> FrictionVariation::*member) {
  return {[member](const Case& c) { return value_of(c.friction_variation.*member); },
          [member](Case& c, const KeyValue& value) {
            assign(c.friction_variation.*member, value);
            points_of(c, (c.friction_variation.*member).size());
          }};
}

void add_places(Keys<Case>& keys) {
  const auto places = [&](const auto& name, const auto& member, const auto&... traits) {
    keys.add(KeyKind::numbers, name, of_places(member), per("friction points"), counts, ascending,
             traits...);
  };
  const auto same = otherwise("the same everywhere");
  places("inclination", &FrictionVariation::inclination, same, unit("rad"), within(1.6),
         "Inclinations of the rail's surface, ascending, negative on the gauge face (minus the "
         "contact angle), for lists of the law's numbers: linear between, constant outside. With "
         "profiles.");
  places("track_position", &FrictionVariation::track_position, same, unit("mm"), within(largest),
         "The same over wheelset.track_position.");
  places("lateral_position", &FrictionVariation::lateral_position, same, unit("mm"),
         within(largest), "The same over y, without profiles.");
}

SectionWithKeys friction_section() {
  Keys<Case> keys("friction", "Friction between wheel and rail", whole_case());
  keys.section().alternatives = true;
  // Below this value squares of tractions underflow.
  const auto no_underflow = zero_or(1e-12, 1000.0);
  keys.add(KeyKind::numbers, "coefficient", of_points(&Point::coefficient), per("friction points"),
           symbol("mu"), no_underflow, Required{"0.55"},
           "Coefficient of friction, of a falling law at rest. Lists, here and below, go with "
           "inclination, track_position or lateral_position.");
  add_fall(keys);
  add_memory(keys);
  add_places(keys);
  return keys;
}

SectionWithKeys layer_section() {
  Keys<Layer> keys("layer", "A layer between wheel and rail that yields to shear alone",
                   &Case::layer);
  keys.section().alternatives = true;
  keys.add("thickness", &Layer::thickness, symbol("h_3"), unit("mm"), positive(),
           otherwise("no elastic layer"), "Thickness of dirt, sand, wear particles or roughness.");
  keys.add("shear_modulus", &Layer::shear_modulus, symbol("G_3"), unit("MPa"), positive(),
           otherwise("no elastic layer"),
           "Its shear modulus; tractions p_t move the surfaces by p_t h_3/G_3 against each other.");
  keys.add("yield_stress", &Layer::yield_stress, symbol("tau_c0"), unit("MPa"), positive(),
           otherwise("it does not yield"),
           "Shear stress at which it yields; tractions are at most the smaller of it and mu p_n.");
  keys.add("hardening", &Layer::hardening, symbol("k_tau"), unit("MPa/mm"), within(largest),
           otherwise("0, perfectly plastic"),
           "Rise of the yield stress per mm of yielding since a particle entered the patch; below "
           "0 the layer softens.");
  return keys;
}

}  // namespace

Sections friction_sections() {
  return {friction_section(), layer_section()};
}

}  // namespace rollfem::contact
