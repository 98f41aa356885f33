#include "halfspace/closed_forms/persson.hpp"

#include <cmath>

namespace rollfem::halfspace {

namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

double PerssonContact::clearance_number() const {
  const double b2 = std::pow(std::tan(half_angle / 2), 2);
  return (2 * (1 - b2 * b2) - std::log1p(b2)) / (pi * b2 * (1 + b2));
}

double PerssonContact::pressure(double phi) const {
  const double b2 = std::pow(std::tan(half_angle / 2), 2);
  const double y2 = std::pow(std::tan(phi / 2), 2);
  if (y2 >= b2) return 0.0;
  const double root = std::sqrt(b2 - y2);
  const double whole = std::sqrt(1 + b2);
  return 2 / (pi * whole) * root / (1 + y2) +
         std::log((whole + root) / (whole - root)) / (2 * pi * b2 * (1 + b2));
}

}  // namespace rollfem::halfspace
