// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/friction_law.hpp"

#include "base/knots.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::contact {

FrictionLaw::Coefficient FallingFriction::at(double slip) const {
  Coefficient sum{kinetic_, 0.0};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto& [size, half_slip] = parts_[i];
    if (size == 0.0) continue;
    const FallShape::Left left = shape_.left(i, slip / half_slip, own_);
    sum.value += size * left.value;
    sum.by_slip += size * left.slope / half_slip;
  }
  return sum;
}

FrictionLaw::Coefficient TemperatureFriction::warm(double temperature) const {
  const double slope =
      (hot_.coefficient - cold_.coefficient) / (hot_.temperature - cold_.temperature);
  if (temperature < cold_.temperature) return {cold_.coefficient, 0.0};
  if (temperature > hot_.temperature) return {hot_.coefficient, 0.0};
  return {cold_.coefficient + slope * (temperature - cold_.temperature), slope};
}

Friction coulomb(double coefficient) {
  return coefficient == 0.0 ? nullptr : std::make_shared<CoulombFriction>(coefficient);
}

namespace {

/// What a law has at one place.
struct LawNumbers {
  double rest = 0.0, kinetic = 0.0, half_velocity = 0.0, second = 0.0, second_half_velocity = 0.0;
  FallShape::Constants own{};
};

/// The kind of law is that of the case.
LawNumbers numbers_of(const FallShape& shape, double mu, const FrictionFall& fall) {
  LawNumbers made{mu, fall.kinetic_coefficient.value_or(mu), fall.half_velocity.value_or(infinity),
                  fall.second_part, fall.second_half_velocity};
  if (fall.polach_a) made.kinetic = *fall.polach_a * mu;
  if (fall.polach_b) made.half_velocity = 1e3 * std::log(2.0) / *fall.polach_b;  // B is in s/m
  for (std::size_t k = 0; k < made.own.size(); ++k)
    made.own[k] = fall.constants[k].value_or(shape.constants[k].otherwise);
  return made;
}

std::shared_ptr<FrictionLaw> law_of(const Case& input, const LawNumbers& at) {
  const FrictionFall& fall = input.friction_fall;
  if (fall.shape == FallShape::none) return std::make_shared<CoulombFriction>(at.rest);
  const double speed = input.rolling.slip_speed();
  std::optional<FrictionMemory> memory;
  if (fall.memory_distance > 0.0)
    memory = FrictionMemory{fall.memory_distance, fall.memory_velocity / speed};
  if (fall.shape.by_temperature)
    return std::make_shared<TemperatureFriction>(TemperatureFriction::Point{at.own[0], at.rest},
                                                 TemperatureFriction::Point{at.own[1], at.own[2]},
                                                 surface_heat(input).value(), memory);
  return std::make_shared<FallingFriction>(
      fall.shape, at.kinetic,
      std::array<FallingFriction::Part, 2>{
          {{at.rest - at.kinetic - at.second, at.half_velocity / speed},
           {at.second, at.second_half_velocity / speed}}},
      memory, at.own);
}

/// The numbers at a place: linear between the points, constant outside. Equal ones stay as they
/// are to the last bit.
LawNumbers numbers_at(const Case& input, const std::vector<double>& places, double place) {
  const auto of = [&](std::size_t k) {
    const FrictionVariation::Point& point = input.friction_variation.points[k];
    return numbers_of(input.friction_fall.shape, point.coefficient, point.fall);
  };
  if (places.size() < 2) return of(0);
  const KnotPiece piece = piece_of(places, place);
  if (piece.part >= 1.0) return of(piece.first + 1);
  LawNumbers made = of(piece.first);
  const LawNumbers to = of(piece.first + 1);
  const double part = std::max(0.0, piece.part);
  const auto move = [part](double& a, double b) { a = a == b ? a : a + part * (b - a); };
  for (double LawNumbers::*number :
       {&LawNumbers::rest, &LawNumbers::kinetic, &LawNumbers::half_velocity, &LawNumbers::second,
        &LawNumbers::second_half_velocity})
    move(made.*number, to.*number);
  for (std::size_t i = 0; i < made.own.size(); ++i) move(made.own[i], to.own[i]);
  return made;
}

std::shared_ptr<FrictionLaw> without_layer(const Case& input, std::size_t position,
                                           const std::function<double(double y)>& inclination) {
  const FallShape& shape = input.friction_fall.shape;
  const auto& [points, inclinations, track_positions, lateral] = input.friction_variation;
  if (points.empty())
    return law_of(input, numbers_of(shape, input.friction_coefficient, input.friction_fall));
  if (!track_positions.empty())
    return law_of(input,
                  numbers_at(input, track_positions, input.wheelset.track_position.at(position)));
  const auto most =
      std::max_element(points.begin(), points.end(),
                       [](const auto& a, const auto& b) { return a.coefficient < b.coefficient; });
  return std::make_shared<VaryingFriction>(
      law_of(input, numbers_of(shape, most->coefficient, most->fall)),
      [input, inclination](double y) {
        const FrictionVariation& over = input.friction_variation;
        if (over.inclination.empty())
          return law_of(input, numbers_at(input, over.lateral_position, y));
        const double place = inclination ? inclination(y) : 0.0;
        return law_of(input, numbers_at(input, over.inclination, place));
      });
}

}  // namespace

Friction friction_of(const Case& input, std::size_t position,
                     const std::function<double(double y)>& inclination) {
  if (input.friction_coefficient == 0.0) return nullptr;
  const std::shared_ptr<FrictionLaw> law = without_layer(input, position, inclination);
  law->branch = input.friction_fall.branch;
  if (input.layer && input.layer->yield_stress)
    law->plasticity = Plasticity{*input.layer->yield_stress, input.layer->hardening.value_or(0.0)};
  return law;
}

double coefficient_of(const Friction& friction) {
  return friction ? friction->coefficient() : 0.0;
}

Field coefficients_of(const Friction& friction, const ContactGrid& grid) {
  Field values = Field::Constant(grid.size(), coefficient_of(friction));
  if (!friction || !friction->varies()) return values;
  for (int j = 0; j < grid.ny; ++j)
    values.segment(grid.index(0, j), grid.nx)
        .setConstant(friction->of_row(grid.y(j))->coefficient());
  return values;
}

double mean_coefficient(const Friction& friction, const ContactGrid& grid, const Field& pressure) {
  const double sum = pressure.sum();
  if (!friction) return 0.0;
  if (!friction->varies() || !(sum > 0.0)) return friction->largest();
  return friction->largest() / friction->coefficient() *
         coefficients_of(friction, grid).dot(pressure) / sum;
}

Field traction_bound(const Friction& friction, const ContactGrid& grid, const Field& pressure) {
  if (!friction || !friction->varies()) return coefficient_of(friction) * pressure;
  return coefficients_of(friction, grid).cwiseProduct(pressure);
}

}  // namespace rollfem::contact
