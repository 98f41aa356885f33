// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/closed_forms/hertz.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "base/root.hpp"
#include "scene/geometry.hpp"
#include "scene/hertz_ellipse.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <fmt/format.h>

#include <cmath>

namespace rollfem::halfspace {

using boost::math::ellint_rd;
using boost::math::ellint_rf;
using contact::pi;

namespace {

void check(double A, double B, double contact_modulus) {
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(A) || !positive(B))
    throw contact::InputError(
        fmt::format("Hertz: the relative curvatures are A = {:.6g} /mm along rolling and B = "
                    "{:.6g} /mm across; both must be positive for an elliptic contact; do: check "
                    "rolling_radius and transverse_radius",
                    A, B));
  if (!positive(contact_modulus))
    throw contact::InputError("Hertz: the contact modulus must be positive");
}

double modulus_of(const contact::Scene& scene) {
  return scene.material.contact_modulus;
}

}  // namespace

double HertzContact::pressure(double x, double y) const {
  const double u = x / semi_axis_x;
  const double v = y / semi_axis_y;
  const double rest = 1.0 - u * u - v * v;
  return rest > 0.0 ? max_pressure * std::sqrt(rest) : 0.0;
}

HertzContact hertz_from_force(double A, double B, double contact_modulus, double normal_force) {
  check(A, B, contact_modulus);
  if (!(normal_force > 0.0))
    throw contact::InputError(
        fmt::format("Hertz: the normal force is {} N, it must be positive", normal_force));
  const contact::HertzEllipse shape = contact::hertz_ellipse(A, B);
  HertzContact hertz;
  hertz.normal_force = normal_force;
  hertz.semi_axis_x = std::cbrt(normal_force * shape.rd / (2.0 * pi * contact_modulus * A));
  hertz.semi_axis_y = shape.k * hertz.semi_axis_x;
  hertz.max_pressure = 1.5 * normal_force / (pi * hertz.semi_axis_x * hertz.semi_axis_y);
  hertz.approach = hertz.max_pressure * hertz.semi_axis_y * shape.rf / contact_modulus;
  return hertz;
}

HertzContact hertz_from_approach(double A, double B, double contact_modulus, double approach) {
  check(A, B, contact_modulus);
  if (!(approach > 0.0))
    throw contact::InputError(
        fmt::format("Hertz: the approach is {} mm, it must be positive", approach));
  const contact::HertzEllipse shape = contact::hertz_ellipse(A, B);
  HertzContact hertz;
  hertz.approach = approach;
  hertz.semi_axis_x = std::sqrt(approach * shape.rd / (3.0 * A * shape.rf));
  hertz.semi_axis_y = shape.k * hertz.semi_axis_x;
  hertz.max_pressure = approach * contact_modulus / (hertz.semi_axis_y * shape.rf);
  hertz.normal_force = hertz.max_pressure * pi * hertz.semi_axis_x * hertz.semi_axis_y / 1.5;
  return hertz;
}

contact::Curvatures hertz_curvatures(const HertzContact& contact, double contact_modulus) {
  const double a2 = contact.semi_axis_x * contact.semi_axis_x;
  const double b2 = contact.semi_axis_y * contact.semi_axis_y;
  const double scale =
      contact.semi_axis_x * contact.semi_axis_y * contact.max_pressure / (3.0 * contact_modulus);
  return {scale * ellint_rd(0.0, b2, a2), scale * ellint_rd(0.0, a2, b2)};
}

contact::Curvatures curvatures_of_scene(const contact::Scene& scene) {
  if (scene.given_pressure) return hertz_curvatures(hertz_of_scene(scene), modulus_of(scene));
  if (scene.geometry.distance_values)
    throw contact::InputError(
        scene.where(),
        "undeformed_distance.file: bodies given point by point have no Hertz "
        "ellipse; allowed: radii or geometry.quadratic; do: run with --model halfspace");
  const contact::Curvatures curvatures = contact::relative_curvatures(scene.geometry);
  if (scene.has_profiles() && !(curvatures.A > 0.0 && curvatures.B > 0.0))
    throw contact::InputError(
        scene.where(),
        "Hertz: at the contact point the profiles have the relative curvatures A = {:.4g} "
        "/mm along rolling and B = {:.4g} /mm across, which do not form an ellipse{}; allowed: "
        "both above 0; do: run with --model halfspace or strip, which use the profiles "
        "themselves",
        curvatures.A, curvatures.B,
        curvatures.B > 0.0 ? ""
                           : ": it lies in a valley, between two patches or on a wave of a "
                             "measured profile");
  return curvatures;
}

HertzContact hertz_of_scene(const contact::Scene& scene) {
  if (scene.given_pressure) {
    const contact::GivenPressure& given = *scene.given_pressure;
    HertzContact hertz{given.semi_axis_x, given.semi_axis_y, given.max_pressure, 0.0, 0.0};
    hertz.normal_force = pi * given.semi_axis_x * given.semi_axis_y * given.max_pressure / 1.5;
    hertz.approach = hertz_displacement(hertz, modulus_of(scene), 0.0, 0.0);
    return hertz;
  }
  const contact::Curvatures curvatures = curvatures_of_scene(scene);
  const contact::NormalLoad load = contact::largest_load(scene);
  if (const auto& line = scene.geometry.line) {
    const double radius = 0.5 / curvatures.A, modulus = modulus_of(scene);
    const LineHertz hertz =
        load.force ? line_hertz(radius, modulus, *load.force / line->width, reference_of(*line))
                   : line_hertz_from_approach(radius, modulus, load.approach.value_or(0.0),
                                              reference_of(*line));
    return {hertz.half_width, 0.5 * line->width, hertz.max_pressure, hertz.approach,
            load.force.value_or(0.5 * pi * hertz.half_width * hertz.max_pressure * line->width)};
  }
  return load.force ? hertz_from_force(curvatures.A, curvatures.B, modulus_of(scene), *load.force)
                    : hertz_from_approach(curvatures.A, curvatures.B, modulus_of(scene),
                                          load.approach.value_or(0.0));
}

/// Potential of the semi-ellipsoidal pressure (Johnson 1985, eq. 3.57 to 3.62) in Carlson's form:
/// u = a b p0/E* [R_F - x^2/3 R_D(.., a^2 + l) - y^2/3 R_D(.., b^2 + l)] at l, l + a^2, l + b^2,
/// l = 0 inside, outside the largest root of x^2/(a^2 + l) + y^2/(b^2 + l) = 1.
double hertz_displacement(const HertzContact& contact, double contact_modulus, double x, double y) {
  const double a2 = contact.semi_axis_x * contact.semi_axis_x;
  const double b2 = contact.semi_axis_y * contact.semi_axis_y;
  const double sum = x * x + y * y - a2 - b2;
  const double product = a2 * b2 - x * x * b2 - y * y * a2;  // > 0 inside
  double l = 0.0;
  if (product < 0.0) {
    const double root = std::sqrt(0.25 * sum * sum - product);
    l = sum > 0.0 ? 0.5 * sum + root : -product / (root - 0.5 * sum);
  }
  const double scale =
      contact.semi_axis_x * contact.semi_axis_y * contact.max_pressure / contact_modulus;
  return scale * (ellint_rf(l, a2 + l, b2 + l) - x * x / 3.0 * ellint_rd(l, b2 + l, a2 + l) -
                  y * y / 3.0 * ellint_rd(l, a2 + l, b2 + l));
}

double reference_of(const contact::LineContact& line) {
  return std::isinf(line.reference) ? line.width : line.reference;
}

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

LineHertz line_hertz_from_approach(double radius, double contact_modulus, double approach,
                                   double reference) {
  // approach = a^2/(2 R) (ln(2 reference/a) + 1/2), which grows up to a = 2 reference.
  const double scaled = 2.0 * radius * approach / (reference * reference);
  if (!(scaled > 0.0 && scaled < 2.0))
    throw contact::InputError(fmt::format(
        "Hertz's line contact: approach {:g} mm; allowed: above 0 and below {:g} mm, from which on "
        "the patch is longer than twice the reference distance, {:g} mm; do: correct the case",
        approach, reference * reference / radius, reference));
  const auto excess = [&](double t) { return t * t * (std::log(2.0 / t) + 0.5) - scaled; };
  const double a =
      reference * contact::bracketed_root(excess, 1e-12, 2.0, 0.0, "Hertz's line contact");
  return line_hertz(radius, contact_modulus, 0.25 * pi * contact_modulus * a * a / radius,
                    reference);
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
