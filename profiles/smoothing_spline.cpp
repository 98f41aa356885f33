// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/smoothing_spline.hpp"

#include "contact/base/root.hpp"
#include "contact/base/text_fields.hpp"
#include "profiles/banded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rollfem::profiles {

namespace {

using Values = std::vector<double>;
using Matrix = Banded<double, 3>;

/// One coordinate: values at the points and the moments m, with f'' = c m on every interval.
struct Fit {
  Values value, moment;
};

class Smoother {
 public:
  /// `weight`: w of every interval.
  Smoother(Values step, const Values& weight) : h_(std::move(step)), c_(weight.size()) {
    for (std::size_t k = 0; k < weight.size(); ++k) c_[k] = 1.0 / (weight[k] * weight[k]);
  }

  /// (R + lambda Q^T Q) m = Q^T x, f = x - lambda Q m: stationarity of the sum, with Q the second
  /// divided differences and R the Gram matrix of hat functions, divided by w^2.
  std::array<Fit, 2> fit(const Values& y, const Values& z, double lambda) const {
    const std::size_t n = y.size();
    Matrix matrix{std::vector<Matrix::Row>(n - 2)};
    std::vector<Matrix::Row>& rows = matrix.rows;
    for (std::size_t k = 0; k + 2 < n; ++k) {
      const double a = 1.0 / h_[k], b = 1.0 / h_[k + 1];
      rows[k][0] = (c_[k] * h_[k] + c_[k + 1] * h_[k + 1]) / 3.0 +
                   lambda * (a * a + (a + b) * (a + b) + b * b);
      if (k + 3 == n) continue;
      const double d = 1.0 / h_[k + 2];
      rows[k + 1][1] = c_[k + 1] * h_[k + 1] / 6.0 - lambda * b * (a + 2.0 * b + d);
      if (k + 4 < n) rows[k + 2][2] = lambda * d * b;
    }
    matrix.factorise();
    return {one(matrix, y, lambda), one(matrix, z, lambda)};
  }

  /// Derivative at the knots, exact for the cubic pieces.
  Values slopes(const Fit& fit) const {
    const std::size_t n = fit.value.size();
    Values result(n);
    for (std::size_t k = 0; k + 1 < n; ++k)
      result[k] = (fit.value[k + 1] - fit.value[k]) / h_[k] -
                  c_[k] * h_[k] / 6.0 * (2.0 * fit.moment[k] + fit.moment[k + 1]);
    result[n - 1] = (fit.value[n - 1] - fit.value[n - 2]) / h_[n - 2] +
                    c_[n - 2] * h_[n - 2] / 6.0 * (fit.moment[n - 2] + 2.0 * fit.moment[n - 1]);
    return result;
  }

 private:
  Fit one(const Matrix& matrix, const Values& x, double lambda) const {
    const std::size_t n = x.size();
    Values m(n - 2);
    for (std::size_t k = 0; k + 2 < n; ++k)
      m[k] = (x[k + 2] - x[k + 1]) / h_[k + 1] - (x[k + 1] - x[k]) / h_[k];
    matrix.solve(m);
    Fit result;
    result.moment.assign(n, 0.0);
    std::copy(m.begin(), m.end(), result.moment.begin() + 1);
    result.value = x;
    if (lambda == 0.0) return result;
    const Values& all = result.moment;
    for (std::size_t k = 0; k < n; ++k) {
      double change = 0.0;
      if (k + 1 < n) change += (all[k + 1] - all[k]) / h_[k];
      if (k > 0) change -= (all[k] - all[k - 1]) / h_[k - 1];
      result.value[k] -= lambda * change;
    }
    return result;
  }

  Values h_, c_;
};

double rms_distance(const std::array<Fit, 2>& fit, const Values& y, const Values& z) {
  double sum = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double dy = fit[0].value[k] - y[k], dz = fit[1].value[k] - z[k];
    sum += dy * dy + dz * dz;
  }
  return std::sqrt(sum / static_cast<double>(y.size()));
}

/// Lambda at which the rms distance, which rises with it, is the tolerance.
double lambda_for(const Smoother& smoother, const Values& y, const Values& z, double tolerance) {
  constexpr double low = -40.0, high = 60.0;  // natural logarithms
  const auto excess = [&](double log_lambda) {
    return rms_distance(smoother.fit(y, z, std::exp(log_lambda)), y, z) - tolerance;
  };
  if (excess(high) < 0.0)
    throw std::invalid_argument("the smoothing tolerance exceeds the height of the profile");
  if (excess(low) >= 0.0) return std::exp(low);
  return std::exp(contact::bracketed_root(excess, low, high, 1e-6, "smoothing of the profile"));
}

/// Radius of curvature of the first pass, from the rms curvature within a window, mm.
Values local_radius(const std::array<Fit, 2>& fit, const Values& step) {
  constexpr double window = 4.0;     // mm to both sides
  constexpr double largest = 100.0;  // mm; curvature of larger radii is negligible
  const std::size_t n = fit[0].value.size();
  Values squares(n);
  for (std::size_t k = 0; k < n; ++k)
    squares[k] = fit[0].moment[k] * fit[0].moment[k] + fit[1].moment[k] * fit[1].moment[k];
  const StretchMeans means(step, squares);
  Values radius(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double mean = means.about(0.5 * (means.place(k) + means.place(k + 1)), window);
    radius[k] = 1.0 / std::max(std::sqrt(std::max(mean, 0.0)), 1.0 / largest);
  }
  return radius;
}

}  // namespace

double smoothing_for(double scatter) {
  return std::min(contact::number_of(fmt::format("{:.2g}", scatter)).value_or(scatter), 1.0);
}

double scatter_of(const PointRow& points) {
  const auto& [y, z] = points;
  // Third differences along the normal are (1, -3, 3, -1) times independent errors, whose squares
  // sum to 20; the median is insensitive to corners.
  Values sizes;
  for (std::size_t k = 3; k < y.size(); ++k) {
    const double ty = y[k] - y[k - 3], tz = z[k] - z[k - 3];
    const double length = std::hypot(ty, tz);
    const double dy = y[k] - 3.0 * y[k - 1] + 3.0 * y[k - 2] - y[k - 3];
    const double dz = z[k] - 3.0 * z[k - 1] + 3.0 * z[k - 2] - z[k - 3];
    sizes.push_back(std::abs(ty * dz - tz * dy) / length);
  }
  if (sizes.empty()) return 0.0;
  return median(std::move(sizes)) /
         (0.6744897501960817 * std::sqrt(20.0));  // median of |normal| is 0.674 sigma
}

ProfileCurve smoothing_spline(const PointRow& points, double scatter, SmoothingReport* report) {
  const auto& [y, z] = points;
  const std::size_t n = y.size();
  if (n < 4 || z.size() != n) throw std::invalid_argument("a spline needs at least four points");
  Values step(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) step[k] = std::hypot(y[k + 1] - y[k], z[k + 1] - z[k]);
  const Smoother plain(step, Values(n - 1, 1.0));
  PointRow smooth = points;
  if (scatter > 0.0) {
    const Smoother weighted(step,
                            local_radius(plain.fit(y, z, lambda_for(plain, y, z, scatter)), step));
    const std::array<Fit, 2> first = weighted.fit(y, z, lambda_for(weighted, y, z, scatter));
    smooth = smooth_curvature(points, {first[0].value, first[1].value}, scatter);
  }
  for (std::size_t k = 0; k + 1 < n; ++k)
    step[k] = std::hypot(smooth.y[k + 1] - smooth.y[k], smooth.z[k + 1] - smooth.z[k]);
  const Smoother through(step, Values(n - 1, 1.0));
  const std::array<Fit, 2> fit = through.fit(smooth.y, smooth.z, 0.0);
  ProfileKnots knots;
  knots.parameter.assign(n, 0.0);
  for (std::size_t k = 1; k < n; ++k) knots.parameter[k] = knots.parameter[k - 1] + step[k - 1];
  knots.y = fit[0].value;
  knots.z = fit[1].value;
  knots.dy = through.slopes(fit[0]);
  knots.dz = through.slopes(fit[1]);
  if (report != nullptr) {
    double sum = 0.0;
    report->largest = 0.0;
    for (const double distance : distances_across(points, smooth)) {
      sum += distance * distance;
      report->largest = std::max(report->largest, std::abs(distance));
    }
    report->rms = std::sqrt(sum / static_cast<double>(n));
    report->scatter = scatter_of(points);
  }
  return ProfileCurve(std::move(knots));
}

}  // namespace rollfem::profiles
