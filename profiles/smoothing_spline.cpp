// SPDX-License-Identifier: LGPL-2.1-or-later
#include "profiles/smoothing_spline.hpp"

#include "base/pi.hpp"
#include "base/root.hpp"
#include "base/text_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rollfem::profiles {

namespace {

// Symmetric positive definite matrices with a few diagonals, for smoothing along a profile.

template <class Number, std::size_t diagonals>
struct Banded {
  using Row = std::array<Number, diagonals>;
  /// The lower half: [0] holds the main diagonal, [j] the place j columns to its left; places
  /// outside the matrix are not read.
  std::vector<Row> rows;

  /// Puts the factors L and D of L D L^T in place of the matrix.
  void factorise() {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      Row scaled{};
      for (std::size_t j = std::min(diagonals - 1, k); j > 0; --j) {
        scaled[j] = rows[k][j];
        for (std::size_t i = j + 1; i < diagonals && i <= k; ++i)
          scaled[j] -= scaled[i] * rows[k - j][i - j];
      }
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) {
        rows[k][j] = scaled[j] / rows[k - j][0];
        rows[k][0] -= scaled[j] * rows[k][j];
      }
    }
  }

  /// By the factors.
  void solve(std::vector<Number>& b) const {
    const std::size_t n = rows.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 1; j < diagonals && j <= k; ++j) b[k] -= rows[k][j] * b[k - j];
    for (std::size_t k = 0; k < n; ++k) b[k] /= rows[k][0];
    for (std::size_t k = n; k-- > 0;)
      for (std::size_t j = 1; j < diagonals && k + j < n; ++j) b[k] -= rows[k + j][j] * b[k + j];
  }
};

using Values = std::vector<double>;
// The condition number grows with the sixth power of the number of points smoothed together: 1e18
// with 1000.
using Long = long double;
using BandRow = Banded<Long, 4>::Row;

/// A row of points as a polygon, with its curvature.
struct Polygon {
  Values step;       ///< mm, between points
  Values curvature;  ///< 1/mm at the points; the ends copy their neighbours
  Values normal_y, normal_z;
};

Polygon polygon_of(const PointRow& row) {
  const std::size_t n = row.y.size();
  Polygon result{Values(n - 1), Values(n), Values(n), Values(n)};
  Values angle(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double dy = row.y[k + 1] - row.y[k], dz = row.z[k + 1] - row.z[k];
    result.step[k] = std::hypot(dy, dz);
    angle[k] = std::atan2(dz, dy);
    if (k > 0) angle[k] = angle[k - 1] + std::remainder(angle[k] - angle[k - 1], 2.0 * contact::pi);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t j = std::clamp<std::size_t>(k, 1, n - 2);
    const double a = result.step[j - 1], b = result.step[j];
    const double bend = 2.0 * (angle[j] - angle[j - 1]) / (a + b);
    result.curvature[k] = bend;
    // The chord is parallel to the curve at its middle.
    const double direction = k == 0       ? angle[0] - 0.5 * a * bend
                             : k == n - 1 ? angle[n - 2] + 0.5 * b * bend
                                          : angle[j] - 0.5 * b * bend;
    result.normal_y[k] = -std::sin(direction);
    result.normal_z[k] = std::cos(direction);
  }
  return result;
}

/// Linear change of (curvature at k + 2) - (curvature at k + 1) with the offsets of points k to k+3
/// along their normals.
std::vector<BandRow> change_rows(const Values& step) {
  const std::size_t n = step.size() + 1;
  std::vector<BandRow> rows(n - 3);
  for (std::size_t k = 0; k + 3 < n; ++k) {
    const Long a = step[k], b = step[k + 1], c = step[k + 2];
    const Long left = 0.5L * (a + b), right = 0.5L * (b + c);
    rows[k] = {-1.0L / (a * left), (1.0L / a + 1.0L / b) / left + 1.0L / (b * right),
               -(1.0L / b + 1.0L / c) / right - 1.0L / (b * left), 1.0L / (c * right)};
  }
  return rows;
}

/// The least-squares problem sum (n - d)^2 + sum w (g + R n)^2 / softness for the offsets n along
/// the normals, with the changes of curvature g + R n, in the multipliers
/// u = w (g + R n) / softness: (softness / w + R R^T) u = g + R d, n = d - R^T u.
class Offsets {
 public:
  Offsets(const Polygon& polygon, Values distance)
      : rows_(change_rows(polygon.step)),
        distance_(std::move(distance)),
        product_(rows_.size()),
        right_(rows_.size()),
        change_(rows_.size()) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      right_[k] = static_cast<Long>(polygon.curvature[k + 2]) - polygon.curvature[k + 1];
      for (std::size_t i = 0; i < 4; ++i) right_[k] += rows_[k][i] * distance_[k + i];
      for (std::size_t below = 0; below < 4 && below <= k; ++below) {
        product_[k][below] = 0.0L;
        for (std::size_t i = 0; i + below < 4; ++i)
          product_[k][below] += rows_[k][i] * rows_[k - below][i + below];
      }
    }
  }

  /// Minus twice the log-likelihood of the points, up to a constant, for normal scatter and normal
  /// changes of curvature with the variance softness * scatter^2 / weight: g + R d is the sum of
  /// both. Infinite when undetermined.
  double solve(const Values& weight, double softness, double scatter) {
    factor_.rows = product_;
    // Keeps the matrix from becoming numerically singular where points are dense.
    constexpr Long least = 1e-16L;
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      factor_.rows[k][0] +=
          std::max(static_cast<Long>(softness) / weight[k], least * product_[k][0]);
    factor_.factorise();
    std::vector<Long> u = right_;
    factor_.solve(u);
    off_.assign(distance_.size(), 0.0L);
    Long squares = 0.0L, logarithms = 0.0L;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < 4; ++i) off_[k + i] += rows_[k][i] * u[k];
      change_[k] = static_cast<double>(u[k] * static_cast<Long>(softness) / weight[k]);
      squares += right_[k] * u[k];
      logarithms += std::log(factor_.rows[k][0]);
    }
    const auto sum = static_cast<double>(squares / scatter / scatter + logarithms);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  /// Changes of curvature between neighbours in the last solution, 1/mm: the expected values.
  const Values& changes() const { return change_; }
  double offset(std::size_t k) const { return static_cast<double>(distance_[k] - off_[k]); }

  /// Their posterior variances given the points, over scatter^2.
  Values variances(const Values& weight, double softness) const {
    const std::size_t n = rows_.size();
    const std::vector<BandRow>& factor = factor_.rows;
    // Inverse near its diagonal (Takahashi): inverse[k][j] is at (k, k + j).
    std::vector<BandRow> inverse(n + 4);
    Values result(n);
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = 3; j > 0; --j) {
        inverse[k][j] = 0.0L;
        if (k + j >= n) continue;
        for (std::size_t i = 1; i < 4 && k + i < n; ++i) {
          const std::size_t low = std::min(i, j), high = std::max(i, j);
          inverse[k][j] -= factor[k + i][i] * inverse[k + low][high - low];
        }
      }
      inverse[k][0] = 1.0L / factor[k][0];
      for (std::size_t i = 1; i < 4 && k + i < n; ++i)
        inverse[k][0] -= factor[k + i][i] * inverse[k][i];
      const Long prior = static_cast<Long>(softness) / weight[k];
      result[k] = std::max(0.0, static_cast<double>(prior - prior * prior * inverse[k][0]));
    }
    return result;
  }

 private:
  std::vector<BandRow> rows_;
  Values distance_;
  std::vector<BandRow> product_;
  Banded<Long, 4> factor_;
  std::vector<Long> right_, off_;
  Values change_;
};

/// Searches the (logarithm of the) softness with the highest likelihood, in steps from its previous
/// value.
void find_most_likely(Offsets& offsets, const Values& weight, double scatter, double& softness) {
  constexpr double extreme = 90.0;
  const auto at = [&](double place) { return offsets.solve(weight, std::exp(place), scatter); };
  double best = at(softness);
  for (double stride = 2.0; stride > 0.02;) {
    const double up = at(softness + stride), down = at(softness - stride);
    if (std::min(up, down) < best && std::abs(softness) < extreme) {
      softness += up <= down ? stride : -stride;
      best = std::min(up, down);
    } else {
      stride *= 0.5;
    }
  }
  at(softness);
}

/// Means over stretches of a row of points of values that are linear between them.
class StretchMeans {
 public:
  /// `step`: mm between the points.
  StretchMeans(const Values& step, const Values& values)
      : place_(values.size(), 0.0), integral_(values.size(), 0.0) {
    for (std::size_t k = 1; k < values.size(); ++k) {
      place_[k] = place_[k - 1] + step[k - 1];
      integral_[k] = integral_[k - 1] + 0.5 * step[k - 1] * (values[k] + values[k - 1]);
    }
  }

  /// Mean up to `window` (mm) to both sides of a place, widened to whole steps.
  double about(double place, double window) const {
    const auto first_from = [&](double at) {
      return std::lower_bound(place_.begin(), place_.end() - 1, at) - place_.begin();
    };
    const auto right = static_cast<std::size_t>(first_from(place + window));
    const auto left = std::min(static_cast<std::size_t>(first_from(place - window)), right - 1);
    return (integral_[right] - integral_[left]) / (place_[right] - place_[left]);
  }

  double place(std::size_t k) const { return place_[k]; }  ///< mm from the first point on

 private:
  Values place_, integral_;
};

/// Mean size of the curvature within a window, in units of 1 / (100 mm) and not below one.
Values sharpness(const Polygon& polygon) {
  constexpr double window = 2.0;   // mm to both sides
  constexpr double slight = 0.01;  // 1/mm
  Values result = polygon.curvature;
  for (double& curvature : result) curvature = std::abs(curvature);
  const StretchMeans means(polygon.step, result);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = std::max(means.about(means.place(k), window) / slight, 1.0);
  return result;
}

using Matrix = Banded<double, 3>;

/// Signed normal distances (mm) of points from the corresponding points of a smooth row.
Values distances_across(const PointRow& points, const PointRow& smooth) {
  const Polygon polygon = polygon_of(smooth);
  Values result(points.y.size());
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = (points.y[k] - smooth.y[k]) * polygon.normal_y[k] +
                (points.z[k] - smooth.z[k]) * polygon.normal_z[k];
  return result;
}

/// Points on the most likely curve when `points` are normally scattered across it with the standard
/// deviation `stated` (mm; twice is assumed, so as not to follow noise) and its curvature (in
/// relation to the curvature around where that is sharper than 1 / (100 mm)) changes by normally
/// distributed amounts between one point and the next, with a variance estimated for each: nearly
/// zero within an arc, large where arcs meet (sparse Bayesian learning: M. E. Tipping, J. Machine
/// Learning Research 1, 2001; the common factor of all variances maximises the likelihood).
/// `start`: points of a first smoothing, which give the position and spacing. At least four points,
/// no duplicates in `start`. O(points).
PointRow smooth_curvature(const PointRow& points, const PointRow& start, double stated) {
  // The most likely curve follows a part of the noise, which looks like small changes of curvature.
  // Assuming twice the scatter halved the remaining noise in the contact of S1002 on 60E1;
  // docs/profiles.md.
  const double scatter = 2.0 * stated;
  constexpr int rounds = 3, passes = 8;  // further ones change the pressures less than the noise
  constexpr double slight = 3e-5;        // 1/mm^2: smaller rates count as this one
  PointRow row = start;
  double softness = 0.0;
  // 1/mm^4, of the rate at which the relative curvature changes
  Values square(row.y.size() - 3, 0.0);
  for (int round = 0; round < rounds; ++round) {
    const Polygon polygon = polygon_of(row);
    const Values sharp = sharpness(polygon);
    Offsets offsets(polygon, distances_across(points, row));
    Values weight(square.size());
    for (int pass = 0; pass < passes; ++pass) {
      const auto unit = [&](std::size_t k) { return polygon.step[k + 1] * sharp[k + 1]; };
      for (std::size_t k = 0; k < weight.size(); ++k)
        weight[k] = polygon.step[k + 1] / (unit(k) * unit(k) * (square[k] + slight * slight));
      find_most_likely(offsets, weight, scatter, softness);
      const Values variance = offsets.variances(weight, std::exp(softness));
      for (std::size_t k = 0; k < weight.size(); ++k) {
        const double change = offsets.changes()[k];
        square[k] = (change * change + variance[k] * scatter * scatter) / (unit(k) * unit(k));
      }
    }
    for (std::size_t k = 0; k < row.y.size(); ++k) {
      row.y[k] += offsets.offset(k) * polygon.normal_y[k];
      row.z[k] += offsets.offset(k) * polygon.normal_z[k];
    }
  }
  return row;
}

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
  const Values dy = through.slopes(fit[0]), dz = through.slopes(fit[1]);
  std::vector<ProfileKnot> knots;
  for (std::size_t k = 0; k < n; ++k)
    knots.push_back({k == 0 ? 0.0 : knots.back().parameter + step[k - 1], fit[0].value[k],
                     fit[1].value[k], dy[k], dz[k]});
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
