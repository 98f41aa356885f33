// Stress at the surface of a finite-element body from the tractions and the strain within the
// surface: against Hertz's closed forms inside and outside of a circle, and better than the
// recovered stress alone.
#include "fem/linear/multigrid.hpp"
#include "fem/linear/prescribed.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "fem/stress/surface_stress.hpp"
#include "fem/trace/compliance.hpp"
#include "halfspace/stress/subsurface.hpp"

#include "support/fem_manufactured.hpp"
#include <algorithm>
#include <cmath>

using namespace rollfem;
using namespace rollfem::testing;

namespace {

using Stress6 = std::array<double, 6>;

constexpr double p0 = 1000.0;
constexpr double a = 4.0;
constexpr double cell = 0.5;
constexpr double nu = 0.3;
const contact::Material material{210e3, nu};

contact::SurfaceField hertz(const contact::ContactGrid& grid, double friction) {
  contact::SurfaceField field;
  field.n = grid.sample([&](double x, double y) {
    // The mean over the element, as a contact solver finds it.
    constexpr int parts = 20;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const double u = (x + grid.dx * ((i + 0.5) / parts - 0.5)) / a;
        const double v = (y + grid.dy * ((j + 0.5) / parts - 0.5)) / a;
        sum += std::sqrt(std::max(0.0, 1.0 - u * u - v * v));
      }
    return p0 * sum / (parts * parts);
  });
  field.x = -friction * field.n;
  field.y = 0.0 * field.n;
  return field;
}

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

/// A flat rail under tractions on a circle.
class LoadedSurface {
 public:
  explicit LoadedSurface(double friction) : traction_(hertz(grid_, friction)) {
    fem::BodyOptions options;
    options.cell_size = cell;
    options.fine_half_length = options.fine_half_width = 6.5;
    options.extent = 160.0;
    options.half = true;
    body_ = std::make_unique<fem::Body>(rail_shape(contact::infinity), material, options,
                                        MPI_COMM_WORLD);
    displacement_ = fem::make_vector(body_->dofs());
    auto load = fem::make_vector(body_->dofs());
    fem::SurfaceCoupling(*body_, grid_).load({-traction_.x, -traction_.y, -traction_.n}, load);
    fem::MultigridOptions solver;
    solver.tolerance = 1e-9;
    fem::make_multigrid(body_->problem(), solver)->solve(displacement_, load);
    displacement_.update_ghost_values();
    locator_ = std::make_unique<fem::BodyLocator>(*body_);
    stress_ = fem::StressRecovery(*body_).recover(displacement_);
  }

  /// Against `exact(places)` in MPa, in the ring from `from` to `to` (in a) along three rays, at
  /// middles of the elements of fine_grid.
  template <class Exact>
  Errors errors(double from, double to, Exact&& exact) const {
    std::vector<fem::Place> places;
    for (int k = 0; k <= 24; ++k)
      for (const double angle : {0.0, 0.7, -pi / 2}) {
        const double r = a * (from + (to - from) * k / 24.0);
        const auto middle = [](double x) { return (std::floor(x / 0.1) + 0.5) * 0.1; };
        places.push_back({middle(r * std::cos(angle)), middle(r * std::sin(angle)), 0.0});
      }
    const auto found = locator_->find(places, 1e-6);
    const auto direct = found.values(stress_.direct, {1, 1, 1});
    const auto shear = found.values(stress_.shear, {-1, -1, 1});
    std::vector<Stress6> recovered;
    for (std::size_t k = 0; k < places.size(); ++k)
      recovered.push_back(
          {direct[k][0], direct[k][1], direct[k][2], shear[k][0], shear[k][1], shear[k][2]});
    auto combined = recovered;
    fem::SurfaceStress(*body_, *locator_, found, grid_, {})
        .combine(displacement_, traction_, combined);
    const std::vector<Stress6> expected = exact(places);
    const auto largest = [&](const std::vector<Stress6>& stress) {
      double result = 0.0;
      for (std::size_t k = 0; k < places.size(); ++k)
        for (int c = 0; c < 6; ++c)
          result = std::max(result, std::abs(stress[k][c] - expected[k][c]) / p0);
      return result;
    };
    return {largest(recovered), largest(combined)};
  }

  static constexpr double pi = 3.14159265358979323846;

 private:
  contact::ContactGrid grid_ = contact::ContactGrid::centred(20, 20, cell, cell);
  contact::SurfaceField traction_;
  std::unique_ptr<fem::Body> body_;
  fem::NodalStress stress_;
  fem::Vector displacement_;
  std::unique_ptr<fem::BodyLocator> locator_;
};

std::vector<Stress6> hertz_surface(const std::vector<fem::Place>& places) {
  std::vector<Stress6> result;
  for (const fem::Place& place : places) {
    const double r = std::hypot(place[0], place[1]);
    const auto [radial, hoop, normal] = exact_circle(r / a);
    const double c = place[0] / r, s = place[1] / r;
    result.push_back({p0 * (radial * c * c + hoop * s * s), p0 * (radial * s * s + hoop * c * c),
                      p0 * normal, p0 * (radial - hoop) * c * s, 0.0, 0.0});
  }
  return result;
}

constexpr double friction = 0.3;

/// The half-space under tractions on elements so small that their steps do not show.
std::vector<Stress6> sliding_surface(const std::vector<fem::Place>& places) {
  const auto fine = contact::ContactGrid::centred(86, 86, 0.1, 0.1);
  std::vector<halfspace::SubsurfacePoint> points;
  for (const fem::Place& place : places) points.push_back({place[0], place[1], 0.0});
  std::vector<Stress6> result;
  for (const auto& state : halfspace::subsurface_at(
           {halfspace::Body::rail, material, fine, hertz(fine, friction)}, points))
    result.push_back(state.stress.as_array());
  return result;
}

/// Uniform strain, and the tractions on the wheel that hold a body in it.
struct UniformStrain {
  dealii::Tensor<2, 3> gradient{{{1e-3, 2e-4, 3e-4}, {-1e-4, 5e-4, 2e-4}, {1e-4, -3e-4, -3e-3}}};

  dealii::Tensor<2, 3> stress() const {
    const double mu = material.young_modulus / (2.0 * (1.0 + nu));
    dealii::Tensor<2, 3> result = mu * (gradient + transpose(gradient));
    for (unsigned int d = 0; d < 3; ++d)
      result[d][d] += 2.0 * mu * nu / (1.0 - 2.0 * nu) * trace(gradient);
    return result;
  }

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

}  // namespace

namespace {

/// Largest errors allowed in p0, with cells of a/8: within 0.75 a, from there to 0.9 a, and from
/// one cell outside of the edge on. Nearer to the edge the staircase of its elements shows.
template <class Exact>
void expect_close(const LoadedSurface& surface, Exact&& exact, double at_edge) {
  const std::pair<const char*, std::array<double, 3>> rings[] = {{"middle", {0.05, 0.75, 0.01}},
                                                                 {"edge", {0.75, 0.9, at_edge}},
                                                                 {"outside", {1.125, 1.6, 0.01}}};
  for (const auto& [name, ring] : rings) {
    const Errors errors = surface.errors(ring[0], ring[1], exact);
    EXPECT_LT(errors.combined, ring[2]) << name;
    EXPECT_LT(errors.combined, 0.8 * errors.recovered) << name;
    ::testing::Test::RecordProperty(
        name, std::to_string(errors.recovered) + " recovered, " + std::to_string(errors.combined));
  }
}

}  // namespace

TEST(SurfaceStress, IsHertzsInsideAndOutsideTheCircle) {
  expect_close(LoadedSurface(0.0), hertz_surface, 0.03);
}

TEST(SurfaceStress, IsThatOfTheHalfSpaceUnderFriction) {
  // The direct stress along x falls from +1.2 mu p0 more steeply than the pressure.
  expect_close(LoadedSurface(friction), sliding_surface, 0.05);
}

TEST(SurfaceStress, OfUniformStrainIsUniformOnACurvedBodyWithASharedSurfaceOfAnotherSlope) {
  const UniformStrain uniform;
  const contact::ContactGrid grid = contact::ContactGrid::centred(8, 8, 1.0, 1.0);
  for (const auto& shape : {wheel_shape(60, -40), rail_shape(20)}) {
    const fem::Body body(shape, material, small_options(), MPI_COMM_WORLD);
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
    std::vector<Stress6> stress(places.size());
    fem::SurfaceStress(body, locator, points, grid, shared)
        .combine(uniform.displacement(body), uniform.tractions(shape, shared, grid), stress);
    const auto s = uniform.stress();
    const Stress6 expected{s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[0][2]};
    for (const Stress6& here : stress)
      for (int c = 0; c < 6; ++c)
        EXPECT_NEAR(here[c], expected[c], 2e-4 * std::abs(s[2][2])) << shape.is_wheel << c;
  }
}
