// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/stress/surface_stress.hpp"

#include "fem/trace/surface_tractions.hpp"

#include <cmath>

namespace rollfem::fem {

namespace {

using Tensor1 = dealii::Tensor<1, 3>;
using Tensor2 = dealii::Tensor<2, 3>;

/// Depth in cells up to which a point is on the surface: deviation of a curved element from the
/// surface.
constexpr double surface_depth = 1e-3;

/// Distance in cells by which its neighbours may be off the surface of coarser elements.
constexpr double around_reach = 0.1;

Tensor1 vector(const std::array<double, 3>& v) {
  return Tensor1({v[0], v[1], v[2]});
}

Tensor2 tensor(const std::array<double, 6>& s) {
  Tensor2 result;
  for (unsigned int c = 0; c < 3; ++c) result[c][c] = s[c];
  result[0][1] = result[1][0] = s[3];
  result[1][2] = result[2][1] = s[4];
  result[0][2] = result[2][0] = s[5];
  return result;
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
std::array<double, 6> in_global(const SurfaceStrain& strain, const Tensor1& load,
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
  return {s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[0][2]};
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
                            std::vector<std::array<double, 6>>& stress) const {
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
    std::array<double, 6>& here = stress[on_surface_[k]];
    const SurfaceStrain strain = inside ? strain_of(way, change, own)
                                        : strain_of(in_frame(tensor(here), own), body_.material());
    here = in_global(strain, surface_load(tractions.at(s, t), own, shared), own, body_.material());
  }
}

}  // namespace rollfem::fem
