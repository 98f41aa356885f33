#include "halfspace/closed_forms/line_hertz.hpp"

#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::halfspace {

using contact::pi;

LineHertz line_hertz(double radius, double contact_modulus, double force_per_length,
                     double reference) {
  for (const double value : {radius, contact_modulus, force_per_length, reference})
    if (!(value > 0.0) || !std::isfinite(value))
      throw contact::InputError(fmt::format(
          "Hertz's line contact: radius {:g} mm, contact modulus {:g} MPa, force {:g} N/mm, "
          "reference distance {:g} mm; allowed: all above 0 and finite; do: correct the case",
          radius, contact_modulus, force_per_length, reference));
  LineHertz hertz;
  hertz.half_width = 2.0 * std::sqrt(force_per_length * radius / (pi * contact_modulus));
  hertz.max_pressure = 2.0 * force_per_length / (pi * hertz.half_width);
  hertz.approach = 2.0 * force_per_length / (pi * contact_modulus) *
                   (std::log(2.0 * reference / hertz.half_width) + 0.5);
  return hertz;
}

/// Beyond the contact the slope is -(2 p0/E*) (t - sqrt(t^2 - 1)), t = x/a.
double line_displacement(const LineHertz& contact, double contact_modulus, double x) {
  const double a = contact.half_width;
  const double t = std::abs(x) / a;
  const double scale = contact.max_pressure * a / contact_modulus;
  if (t <= 1.0) return contact.approach - scale * t * t;
  const double root = std::sqrt((t - 1.0) * (t + 1.0));
  return contact.approach - scale * (t * t - t * root + std::log(t + root));
}

}  // namespace rollfem::halfspace
