#include "halfspace/closed_forms/hertz_fields.hpp"

#include "contact/base/errors.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <cmath>

namespace rollfem::halfspace {

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

double hertz_circle_displacement(const HertzContact& contact, double contact_modulus,
                                 double radius) {
  const double a = contact.semi_axis_x;
  if (std::abs(contact.semi_axis_y - a) > 1e-9 * a)
    throw contact::InputError("hertz_circle_displacement needs a circular patch");
  const double r2 = radius * radius;
  if (radius <= a)
    return pi * contact.max_pressure * (2.0 * a * a - r2) / (4.0 * a * contact_modulus);
  const double ratio = a / radius;
  return contact.max_pressure / (2.0 * a * contact_modulus) *
         ((2.0 * a * a - r2) * std::asin(ratio) +
          r2 * ratio * std::sqrt((1.0 - ratio) * (1.0 + ratio)));
}

double uniform_circle_displacement(double pressure, double a, double contact_modulus, double r) {
  const double scale = 4.0 * pressure / (pi * contact_modulus);
  if (r <= a) return scale * a * boost::math::ellint_2(r / a);
  const double k = a / r;
  return scale * r * (boost::math::ellint_2(k) - (1.0 - k) * (1.0 + k) * boost::math::ellint_1(k));
}

}  // namespace rollfem::halfspace
