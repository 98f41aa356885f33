// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/stress/surface_stress.hpp"

#include "fem/discretisation/elastic_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rollfem::fem {

namespace {

using Tensor1 = dealii::Tensor<1, 3>;
using Tensor2 = dealii::Tensor<2, 3>;

/// Distance in cells by which its neighbours may be off the surface of coarser elements.
constexpr double around_reach = 0.1;

Tensor1 vector(const std::array<double, 3>& v) {
  return Tensor1({v[0], v[1], v[2]});
}

/// Within the surface, along the first two axes.
struct SurfaceStrain {
  double ss, tt, st;
};

/// From differences of the displacement along two directions in the surface.
SurfaceStrain strain_of(const std::array<Tensor1, 2>& way, const std::array<Tensor1, 2>& change,
                        const SurfaceFrame& axes) {
  const dealii::Tensor<2, 2> ways(
      {{way[0] * axes[0], way[1] * axes[0]}, {way[0] * axes[1], way[1] * axes[1]}});
  const dealii::Tensor<2, 2> changes(
      {{change[0] * axes[0], change[1] * axes[0]}, {change[0] * axes[1], change[1] * axes[1]}});
  const dealii::Tensor<2, 2> gradient = changes * dealii::invert(ways);
  return {gradient[0][0], gradient[1][1], 0.5 * (gradient[0][1] + gradient[1][0])};
}

SurfaceStrain strain_of(const Tensor2& stress, const contact::Material& material) {
  const double e = material.young_modulus;
  const double nu = material.poisson_ratio;
  return {(stress[0][0] - nu * (stress[1][1] + stress[2][2])) / e,
          (stress[1][1] - nu * (stress[0][0] + stress[2][2])) / e, (1.0 + nu) / e * stress[0][1]};
}

/// Stress vector on the plane of the body's normal into the wheel: the same for both bodies.
/// Tractions are per area of the common surface; the ratio of areas is the ratio of cosines.
Tensor1 surface_load(const std::array<double, 3>& on_wheel, const SurfaceFrame& own,
                     const SurfaceFrame& shared) {
  const double own_tilt = own[2][1];
  const double shared_tilt = shared[2][1];
  const double areas = std::sqrt((1.0 - own_tilt * own_tilt) / (1.0 - shared_tilt * shared_tilt));
  Tensor1 load;
  for (unsigned int k = 0; k < 3; ++k) load -= areas * on_wheel[k] * shared[k];
  return load;
}

Tensor2 in_frame(const Tensor2& global, const SurfaceFrame& axes) {
  Tensor2 local;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b) local[a][b] = axes[a] * (global * axes[b]);
  return local;
}

/// Hooke's law with the strain within the surface and the stress on it given.
contact::SymmetricTensor in_global(const SurfaceStrain& strain, const Tensor1& load,
                                   const SurfaceFrame& axes, const contact::Material& material) {
  const double nu = material.poisson_ratio;
  const double plane = material.young_modulus / (1.0 - nu * nu);
  const double of_normal = nu / (1.0 - nu) * (load * axes[2]);
  Tensor2 local;
  local[0][0] = plane * (strain.ss + nu * strain.tt) + of_normal;
  local[1][1] = plane * (strain.tt + nu * strain.ss) + of_normal;
  local[0][1] = local[1][0] = plane * (1.0 - nu) * strain.st;
  for (unsigned int a = 0; a < 3; ++a) local[a][2] = local[2][a] = load * axes[a];
  Tensor2 s;
  for (unsigned int a = 0; a < 3; ++a)
    for (unsigned int b = 0; b < 3; ++b) s += local[a][b] * dealii::outer_product(axes[a], axes[b]);
  return components_of(s);
}

/// Cubic convolution: weights of four equally spaced values around a position that is `f` of a step
/// behind the second. Exact for parabolas.
std::array<double, 4> cubic_weights(double f) {
  return {0.5 * f * (-1.0 + f * (2.0 - f)), 1.0 + f * f * (-2.5 + 1.5 * f),
          0.5 * f * (1.0 + f * (4.0 - 3.0 * f)), 0.5 * f * f * (f - 1.0)};
}

/// The element before a position, and how far it is from there to the next.
struct Between {
  int element;
  double share;
};

Between between(double at, double first, double step) {
  const double elements = (at - first) / step;
  const double floor = std::floor(elements);
  return {static_cast<int>(floor), elements - floor};
}

/// One more ring of elements around the known ones, at most `largest` there.
void continue_outwards(const contact::ContactGrid& grid, contact::Field& values,
                       std::vector<char>& known, double largest) {
  const contact::Field old = values;
  const std::vector<char> was_known = known;
  const auto inside = [&](int i, int j) { return i >= 0 && i < grid.nx && j >= 0 && j < grid.ny; };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (was_known[grid.index(i, j)]) continue;
      double sum = 0.0;
      int count = 0;
      for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (!inside(i + di, j + dj) || !was_known[grid.index(i + di, j + dj)]) continue;
        const double near = old[grid.index(i + di, j + dj)];
        const double far =
            inside(i + 2 * di, j + 2 * dj) ? old[grid.index(i + 2 * di, j + 2 * dj)] : 0.0;
        sum += std::min(2.0 * near - far, largest);
        ++count;
      }
      if (count == 0) continue;
      values[grid.index(i, j)] = sum / count;
      known[grid.index(i, j)] = 1;
    }
}

/// Tractions anywhere on the contact surface, with the edge of the patch resolved below the element
/// size: near the edge of a smooth contact pressure squared falls linearly to zero. It is
/// extrapolated linearly to the unloaded elements beside the patch and interpolated between the
/// elements by cubic convolution (Keys 1981); there is no contact where it is negative. The ratio
/// of tangential traction to pressure is bilinear over the surrounding loaded elements, which
/// preserves the traction bound.
class SurfaceTractions {
 public:
  /// `traction`: MPa, on the wheel.
  SurfaceTractions(const contact::ContactGrid& grid, const contact::SurfaceField& traction);
  /// {x, y, n} in MPa at (s, t) = (x, y) of the grid, zero outside of the patch.
  std::array<double, 3> at(double s, double t) const;

 private:
  double pressure_at(double s, double t) const;

  contact::ContactGrid grid_;
  contact::SurfaceField traction_;
  contact::Field squared_;  ///< p^2, extrapolated to negative values
};

SurfaceTractions::SurfaceTractions(const contact::ContactGrid& grid,
                                   const contact::SurfaceField& traction)
    : grid_(grid), traction_(traction), squared_(traction.n.cwiseAbs2()) {
  const double scale = squared_.size() > 0 ? squared_.maxCoeff() : 0.0;
  std::vector<char> known(static_cast<std::size_t>(grid.size()));
  for (int k = 0; k < grid.size(); ++k) known[k] = traction.n[k] > 0.0;
  // The second ring gives the corners between a row and a column.
  for (int ring = 0; ring < 2; ++ring) continue_outwards(grid, squared_, known, -1e-6 * scale);
  for (int k = 0; k < grid.size(); ++k)
    if (!known[k]) squared_[k] = -0.05 * scale;
}

double SurfaceTractions::pressure_at(double s, double t) const {
  const Between x = between(s, grid_.x_first, grid_.dx);
  const Between y = between(t, grid_.y_first, grid_.dy);
  const auto weights_x = cubic_weights(x.share);
  const auto weights_y = cubic_weights(y.share);
  double squared = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int column = std::clamp(x.element - 1 + i, 0, grid_.nx - 1);
      const int row = std::clamp(y.element - 1 + j, 0, grid_.ny - 1);
      squared += weights_x[i] * weights_y[j] * squared_[grid_.index(column, row)];
    }
  return std::sqrt(std::max(squared, 0.0));
}

std::array<double, 3> SurfaceTractions::at(double s, double t) const {
  if (s < grid_.x(0) || s > grid_.x(grid_.nx - 1) || t < grid_.y(0) || t > grid_.y(grid_.ny - 1))
    return {};
  const Between x = between(s, grid_.x_first, grid_.dx);
  const Between y = between(t, grid_.y_first, grid_.dy);
  double loaded = 0.0, ratio_x = 0.0, ratio_y = 0.0;
  for (int dj = 0; dj < 2; ++dj)
    for (int di = 0; di < 2; ++di) {
      const int k = grid_.index(std::min(x.element + di, grid_.nx - 1),
                                std::min(y.element + dj, grid_.ny - 1));
      if (traction_.n[k] <= 0.0) continue;
      const double weight =
          (di == 1 ? x.share : 1.0 - x.share) * (dj == 1 ? y.share : 1.0 - y.share);
      loaded += weight;
      ratio_x += weight * traction_.x[k] / traction_.n[k];
      ratio_y += weight * traction_.y[k] / traction_.n[k];
    }
  if (loaded <= 0.0) return {};
  const double pressure = pressure_at(s, t);
  return {pressure * ratio_x / loaded, pressure * ratio_y / loaded, pressure};
}

}  // namespace

SurfaceStress::SurfaceStress(const Body& body, const BodyLocator& locator, const BodyPoints& points,
                             const contact::ContactGrid& grid,
                             const contact::ContactSurface& surface)
    : body_(body), grid_(grid), surface_(surface) {
  const double cell = body.options().cell_size;
  std::array<std::vector<Place>, 4> around;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Place& p = points.place(k);
    const auto chart = body.shape().coordinates(dealii::Point<3>(p[0], p[1], p[2]));
    if (!std::isfinite(points.moved(k)) || std::abs(chart[2]) > surface_depth * cell) continue;
    on_surface_.push_back(k);
    places_.push_back(p);
    for (int n = 0; n < 4; ++n) {
      const double step = n % 2 == 0 ? 0.5 * cell : -0.5 * cell;
      const auto there =
          body.shape().place(chart[0] + (n < 2 ? step : 0.0), chart[1] + (n < 2 ? 0.0 : step), 0.0);
      around[n].push_back({there[0], there[1], there[2]});
    }
  }
  for (int n = 0; n < 4; ++n) around_[n] = locator.find(around[n], around_reach * cell);
}

void SurfaceStress::combine(const Vector& displacement, const contact::SurfaceField& traction,
                            std::vector<contact::SymmetricTensor>& stress) const {
  if (places_.empty()) return;
  const SurfaceTractions tractions(grid_, traction);
  std::array<std::vector<std::array<double, 3>>, 4> moved;
  for (int n = 0; n < 4; ++n) moved[n] = around_[n].values(displacement, {1, -1, 1});
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const dealii::Point<3> chart =
        body_.shape().coordinates(dealii::Point<3>(places_[k][0], places_[k][1], places_[k][2]));
    const double s = chart[0], t = chart[1];
    const SurfaceFrame own = body_.shape().frame(s, t);
    const SurfaceFrame shared = body_.shape().tilted_frame(s, t, surface_.climb(t));
    std::array<Tensor1, 2> way, change;
    bool inside = true;
    for (int d = 0; d < 2; ++d) {
      const BodyPoints& ahead = around_[2 * d];
      const BodyPoints& behind = around_[2 * d + 1];
      way[d] = vector(ahead.place(k)) - vector(behind.place(k));
      change[d] = vector(moved[2 * d][k]) - vector(moved[2 * d + 1][k]);
      inside = inside && std::isfinite(ahead.moved(k)) && std::isfinite(behind.moved(k));
    }
    contact::SymmetricTensor& here = stress[on_surface_[k]];
    const SurfaceStrain strain = inside
                                     ? strain_of(way, change, own)
                                     : strain_of(in_frame(tensor_of(here), own), body_.material());
    here = in_global(strain, surface_load(tractions.at(s, t), own, shared), own, body_.material());
  }
}

}  // namespace rollfem::fem
