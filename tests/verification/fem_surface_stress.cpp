// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress at the surface of a finite-element body from the tractions and the strain within the
// surface: against Hertz's closed forms inside and outside of a circle, and better than the
// recovered stress alone.
#include "fem/stress/surface_stress.hpp"
#include "fem/trace/far_field.hpp"

#include "support/fem_fields.hpp"
#include "support/fem_loaded_rail.hpp"

namespace {

constexpr double nu = 0.3;

/// Johnson (1985) eqs. 3.42 and 3.43: radial, hoop and normal stress at the surface over p0.
std::array<double, 3> exact_circle(double r) {
  const double outside = (1.0 - 2.0 * nu) / 3.0;
  if (r >= 1.0) return {outside / (r * r), -outside / (r * r), 0.0};
  const double root = std::sqrt(1.0 - r * r);
  const double ratio = (1.0 + root + root * root) / (1.0 + root);  // (1 - root^3) / r^2
  return {outside * ratio - root, -outside * ratio - 2.0 * nu * root, -root};
}

struct Errors {
  double recovered = 0.0;  ///< largest difference of a component, in p0
  double combined = 0.0;
};

/// Against `exact(places)` in MPa, in the ring from `from` to `to` (in a) along three rays, at
/// middles of the elements of a fine grid.
template <class Exact>
Errors errors(const LoadedRail& rail, double from, double to, Exact&& exact) {
  std::vector<fem::Place> places;
  for (int k = 0; k <= 24; ++k)
    for (const double angle : {0.0, 0.7, -M_PI / 2}) {
      const double r = LoadedRail::a * (from + (to - from) * k / 24.0);
      const auto middle = [](double x) { return (std::floor(x / 0.1) + 0.5) * 0.1; };
      places.push_back({middle(r * std::cos(angle)), middle(r * std::sin(angle)), 0.0});
    }
  const auto found = rail.locator->find(places, 1e-6);
  const std::vector<SymmetricTensor> recovered = rail.recovered(found), expected = exact(places);
  auto combined = recovered;
  fem::SurfaceStress(*rail.body, *rail.locator, found, rail.grid, {})
      .combine(rail.displacement, rail.traction, combined);
  return {LoadedRail::largest_difference(recovered, expected),
          LoadedRail::largest_difference(combined, expected)};
}

std::vector<SymmetricTensor> hertz_surface(const std::vector<fem::Place>& places) {
  std::vector<SymmetricTensor> result;
  for (const fem::Place& place : places) {
    const double r = std::hypot(place[0], place[1]);
    const auto [radial, hoop, normal] = exact_circle(r / LoadedRail::a);
    const double c = place[0] / r, s = place[1] / r;
    result.push_back({radial * c * c + hoop * s * s, radial * s * s + hoop * c * c, normal,
                      (radial - hoop) * c * s, 0.0, 0.0});
    for (double& component : result.back()) component *= LoadedRail::p0;
  }
  return result;
}

/// Uniform strain, and the tractions on the wheel that hold a body in it.
struct UniformStrain {
  dealii::Tensor<2, 3> gradient{{{1e-3, 2e-4, 3e-4}, {-1e-4, 5e-4, 2e-4}, {1e-4, -3e-4, -3e-3}}};

  dealii::Tensor<2, 3> stress() const { return stress_of(gradient, LoadedRail::material); }

  fem::Vector displacement(const fem::Body& body) const {
    return fem::nodal_values(body.problem(),
                             [this](const dealii::Point<3>& p) { return gradient * p; });
  }

  contact::SurfaceField tractions(const fem::SurfaceShape& shape,
                                  const contact::ContactSurface& shared,
                                  const contact::ContactGrid& grid) const {
    std::array<contact::Field, 3> part;
    for (unsigned int k = 0; k < 3; ++k)
      part[k] = grid.sample([&](double s, double t) {
        const fem::SurfaceFrame own = shape.frame(s, t);
        const fem::SurfaceFrame common = shape.tilted_frame(s, t, shared.climb(t));
        const double slope = contact::profile_drop(shape.transverse_radius, t).slope;
        const double own_area = std::sqrt(1.0 + slope * slope);
        const double common_area = std::sqrt(1.0 + shared.climb(t) * shared.climb(t));
        return -own_area / common_area * (stress() * own[2] * common[k]);
      });
    return {part[0], part[1], part[2]};
  }
};

/// Largest errors allowed in p0, with cells of a/8: within 0.75 a, from there to 0.9 a, and from
/// one cell outside of the edge on. Nearer to the edge the staircase of its elements shows.
template <class Exact>
void expect_close(const LoadedRail& rail, Exact&& exact, double at_edge) {
  const std::pair<const char*, std::array<double, 3>> rings[] = {{"middle", {0.05, 0.75, 0.01}},
                                                                 {"edge", {0.75, 0.9, at_edge}},
                                                                 {"outside", {1.125, 1.6, 0.01}}};
  for (const auto& [name, ring] : rings) {
    const Errors found = errors(rail, ring[0], ring[1], exact);
    EXPECT_LT(found.combined, ring[2]) << name;
    EXPECT_LT(found.combined, 0.8 * found.recovered) << name;
  }
}

}  // namespace

TEST(SurfaceStress, IsHertzsInsideAndOutsideTheCircle) {
  expect_close(LoadedRail(0.0, 20, 6.5, 160.0), hertz_surface, 0.03);
}

TEST(SurfaceStress, IsThatOfTheHalfSpaceUnderFriction) {
  // The direct stress along x falls from +1.2 mu p0 more steeply than the pressure.
  const LoadedRail rail(0.3, 20, 6.5, 160.0);
  expect_close(
      rail, [&](const auto& places) { return rail.of_half_space(places); }, 0.05);
}

TEST(SurfaceStress, OfUniformStrainIsUniformOnACurvedBodyWithASharedSurfaceOfAnotherSlope) {
  const UniformStrain uniform;
  const contact::ContactGrid grid = contact::ContactGrid::centred(8, 8, 1.0, 1.0);
  for (const auto& shape : {wheel_shape(60, -40), rail_shape(20)}) {
    const fem::Body body(shape, LoadedRail::material, small_options(), MPI_COMM_WORLD);
    // Between the bodies, 10 % off the slope of this one.
    const contact::ContactSurface shared = shape.is_wheel ? contact::ContactSurface{60, -40, 33}
                                                          : contact::ContactSurface{60, -25, 20};
    std::vector<fem::Place> places;
    for (const double s : {-2.0, 0.3, 1.7})
      for (const double t : {-2.3, -0.4, 0.0, 1.9}) {
        const auto p = shape.place(s, t, 0.0);
        places.push_back({p[0], p[1], p[2]});
      }
    const fem::BodyLocator locator(body);
    const auto points = locator.find(places, 0.1);
    std::vector<SymmetricTensor> stress(places.size());
    fem::SurfaceStress(body, locator, points, grid, shared)
        .combine(uniform.displacement(body), uniform.tractions(shape, shared, grid), stress);
    const auto s = uniform.stress();
    const SymmetricTensor expected = components_of(s);
    for (const SymmetricTensor& here : stress)
      for (int c = 0; c < 6; ++c)
        EXPECT_NEAR(here[c], expected[c], 2e-4 * std::abs(s[2][2])) << shape.is_wheel << c;
  }
}
