#include "track/motion/conicity.hpp"

#include "contact/base/pi.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::track {

using contact::pi;

namespace {

/// Of the quarter of a wave: its integrand is smooth but for the jumps of the radii.
constexpr int quadrature_points = 2000;

}  // namespace

RadiusDifference::RadiusDifference(std::vector<double> shift, std::vector<double> difference)
    : shift_(std::move(shift)), difference_(std::move(difference)), integral_(shift_.size(), 0.0) {
  if (shift_.size() < 2 || shift_.size() != difference_.size() || shift_.front() != 0.0 ||
      !std::is_sorted(shift_.begin(), shift_.end()))
    throw std::invalid_argument("lateral shifts of rolling radii must rise from 0");
  for (std::size_t k = 1; k < shift_.size(); ++k)
    integral_[k] = integral_[k - 1] +
                   0.5 * (difference_[k] + difference_[k - 1]) * (shift_[k] - shift_[k - 1]);
}

std::size_t RadiusDifference::piece(double shift) const {
  const auto after = std::upper_bound(shift_.begin(), shift_.end(), shift);
  const auto index = static_cast<std::size_t>(after - shift_.begin());
  return std::clamp<std::size_t>(index, 1, shift_.size() - 1) - 1;
}

double RadiusDifference::at(double shift) const {
  const std::size_t k = piece(shift);
  const double part = (shift - shift_[k]) / (shift_[k + 1] - shift_[k]);
  return difference_[k] + part * (difference_[k + 1] - difference_[k]);
}

double RadiusDifference::integral(double shift) const {
  const std::size_t k = piece(shift);
  return integral_[k] + 0.5 * (difference_[k] + at(shift)) * (shift - shift_[k]);
}

double RadiusDifference::harmonic_conicity(double amplitude) const {
  // On each piece a + b A sin t, times sin t: exact.
  const auto angle = [&](double shift) {
    return std::asin(std::clamp(shift / amplitude, 0.0, 1.0));
  };
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < shift_.size() && shift_[k] < amplitude; ++k) {
    const double slope = (difference_[k + 1] - difference_[k]) / (shift_[k + 1] - shift_[k]);
    const double offset = difference_[k] - slope * shift_[k];
    const double from = angle(shift_[k]), to = angle(shift_[k + 1]);
    sum +=
        offset * (std::cos(from) - std::cos(to)) +
        slope * amplitude * 0.25 * (2.0 * (to - from) - std::sin(2.0 * to) + std::sin(2.0 * from));
  }
  return 2.0 * sum / (pi * amplitude);
}

std::optional<double> RadiusDifference::wave_length(double amplitude, double contact_distance,
                                                    double rolling_radius) const {
  // y'^2 = 2 (integral(A) - integral(y)) / (e r); y = A sin t takes the root's end away.
  const double stiffness = contact_distance * rolling_radius;
  const double energy = integral(amplitude);
  double quarter = 0.0;
  for (int k = 0; k < quadrature_points; ++k) {
    const double t = 0.5 * pi * (k + 0.5) / quadrature_points;
    const double left = energy - integral(amplitude * std::sin(t));
    if (!(left > 0.0)) return {};
    quarter += amplitude * std::cos(t) / std::sqrt(2.0 * left / stiffness);
  }
  return 4.0 * quarter * 0.5 * pi / quadrature_points;
}

double conicity_of_wave(double wave_length, double contact_distance, double rolling_radius) {
  return 2.0 * pi * pi * contact_distance * rolling_radius / (wave_length * wave_length);
}

}  // namespace rollfem::track
