#include "contact/solve/rayleigh.hpp"

#include "contact/scene/geometry.hpp"

#include <cmath>

namespace rollfem::contact {

double rayleigh_speed(const Material& material) {
  const double nu = material.poisson_ratio;
  const double k = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
  const auto excess = [k](double e) {
    return ((e - 8.0) * e + (24.0 - 16.0 * k)) * e - 16.0 * (1.0 - k);
  };
  // Negative at 0, positive at 1, and one root between for nu >= 0.
  double lower = 0.0, upper = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (lower + upper);
    (excess(middle) < 0.0 ? lower : upper) = middle;
  }
  return std::sqrt(lower * shear_modulus(material) / material.density);
}

}  // namespace rollfem::contact
