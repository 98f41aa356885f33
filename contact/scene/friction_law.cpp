// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/scene/friction_law.hpp"

#include <cmath>

namespace rollfem::contact {

namespace {

/// What is left of part `i` of the fall at s, the slip over that at which it is halved.
FrictionLaw::Coefficient part_left(FallShape shape, std::size_t i, double s) {
  switch (shape) {
    case FallShape::linear:
      return s < 2.0 ? FrictionLaw::Coefficient{1.0 - 0.5 * s, -0.5} : FrictionLaw::Coefficient{};
    case FallShape::rational: {
      const double left = i == 0 ? 1.0 / (1.0 + s) : 1.0 / (1.0 + s * s);
      return {left, i == 0 ? -left * left : -2.0 * s * left * left};
    }
    case FallShape::exponential:
      break;
    case FallShape::none:
      return {1.0, 0.0};
  }
  const double rate = std::log(2.0);
  const double left = std::exp(-rate * s);
  return {left, -rate * left};
}

}  // namespace

FrictionLaw::Coefficient FallingFriction::at(double slip) const {
  Coefficient sum{kinetic_, 0.0};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto& [size, half_slip] = parts_[i];
    if (size == 0.0) continue;
    const Coefficient left = part_left(shape_, i, slip / half_slip);
    sum.value += size * left.value;
    sum.by_slip += size * left.by_slip / half_slip;
  }
  return sum;
}

Friction coulomb(double coefficient) {
  return coefficient == 0.0 ? nullptr : std::make_shared<CoulombFriction>(coefficient);
}

namespace {

std::shared_ptr<FrictionLaw> law_of(const Case& input) {
  const double mu = input.friction_coefficient;
  const FrictionFall& fall = input.friction_fall;
  if (mu == 0.0) return nullptr;
  if (fall.shape == FallShape::none) return std::make_shared<CoulombFriction>(mu);
  // A shift has no speed: its slip in mm is taken as that of one second.
  const double speed = input.rolling.problem == Problem::shift ? 1.0 : input.rolling.speed;
  double kinetic = fall.kinetic_coefficient.value_or(mu);
  double half = fall.half_velocity.value_or(infinity);
  if (fall.polach_a) {
    kinetic = *fall.polach_a * mu;
    half = 1e3 * std::log(2.0) / fall.polach_b.value_or(1.0);  // B is in s/m
  }
  const double second = fall.second_part;
  std::optional<FrictionMemory> memory;
  if (fall.memory_distance > 0.0)
    memory = FrictionMemory{fall.memory_distance, fall.memory_velocity / speed};
  return std::make_shared<FallingFriction>(
      fall.shape, kinetic,
      std::array<FallingFriction::Part, 2>{
          {{mu - kinetic - second, half / speed}, {second, fall.second_half_velocity / speed}}},
      memory);
}

}  // namespace

Friction friction_of(const Case& input) {
  const std::shared_ptr<FrictionLaw> law = law_of(input);
  if (law && input.layer && input.layer->yield_stress)
    law->plasticity = Plasticity{*input.layer->yield_stress, input.layer->hardening.value_or(0.0)};
  return law;
}

double coefficient_of(const Friction& friction) {
  return friction ? friction->coefficient() : 0.0;
}

Field traction_bound(const Friction& friction, const Field& pressure) {
  return coefficient_of(friction) * pressure;
}

}  // namespace rollfem::contact
