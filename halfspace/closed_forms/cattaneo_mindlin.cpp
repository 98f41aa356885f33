#include "halfspace/closed_forms/cattaneo_mindlin.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

CattaneoMindlin::CattaneoMindlin(const HertzContact& contact,
                                 const contact::CombinedMaterial& material, double friction)
    : contact_(contact),
      friction_(friction),
      compliance_(2.0 * (2.0 - material.poisson_ratio) / material.shear_modulus) {
  if (std::abs(contact.semi_axis_x - contact.semi_axis_y) > 1e-9 * contact.semi_axis_x)
    throw contact::InputError("Cattaneo and Mindlin's theory needs a circular patch");
  if (!(friction > 0.0))
    throw contact::InputError(
        "Cattaneo and Mindlin's theory needs a positive friction coefficient");
}

/// |Q| / (mu P).
double CattaneoMindlin::used(double force) const {
  const double limit = friction_ * contact_.normal_force;
  // The last digits of forces that were computed as mu P are forgiven.
  if (!(std::abs(force) <= limit * (1.0 + 1e-12)))
    throw contact::InputError(
        fmt::format("a tangential force of {:g} N slides: friction allows {:g} N", force, limit));
  return std::min(1.0, std::abs(force) / limit);
}

double CattaneoMindlin::stick_radius(double force) const {
  return contact_.semi_axis_x * std::cbrt(1.0 - used(force));
}

double CattaneoMindlin::shift(double force) const {
  const double scale =
      3.0 * friction_ * contact_.normal_force * compliance_ / (16.0 * contact_.semi_axis_x);
  const double q = used(force);
  // 1 - (1 - q)^(2/3) without cancellation at small forces.
  const double share = q < 1.0 ? -std::expm1(2.0 / 3.0 * std::log1p(-q)) : 1.0;
  return std::copysign(scale * share, force);
}

double CattaneoMindlin::traction(double force, double r) const {
  const double a = contact_.semi_axis_x;
  const double c = stick_radius(force);
  const auto bump = [r](double radius) {
    const double t = r / radius;
    return t < 1.0 ? std::sqrt((1.0 - t) * (1.0 + t)) : 0.0;
  };
  const double value = bump(a) - (c > 0.0 ? c / a * bump(c) : 0.0);
  return std::copysign(friction_ * contact_.max_pressure * value, force);
}

double CattaneoMindlin::unloading_shift(double turned, double force) const {
  return shift(turned) - 2.0 * shift(0.5 * (turned - force));
}

double CattaneoMindlin::unloading_traction(double turned, double force, double r) const {
  return traction(turned, r) - 2.0 * traction(0.5 * (turned - force), r);
}

double CattaneoMindlin::cyclic_loss(double amplitude) const {
  const double q = used(amplitude);
  const double limit = friction_ * contact_.normal_force;
  const double rest = std::cbrt(1.0 - q);
  const double bracket = 1.0 - std::pow(rest, 5) - 5.0 * q / 6.0 * (1.0 + rest * rest);
  return 9.0 * limit * limit * compliance_ / (10.0 * contact_.semi_axis_x) * bracket;
}

}  // namespace rollfem::halfspace
