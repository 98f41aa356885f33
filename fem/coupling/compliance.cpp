#include "fem/coupling/compliance.hpp"

#include "fem/body/profile_shape.hpp"
#include "fem/coupling/far_field.hpp"
#include "fem/solver/factorisation.hpp"

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <future>
#include <optional>

namespace rollfem::fem {

namespace {

constexpr double sign_of[2] = {1.0,
                               -1.0};  // tractions act on the wheel, their reaction on the rail

}  // namespace

contact::TangentialField curvature_slip(const contact::ContactSurface& surface,
                                        const contact::ContactGrid& grid,
                                        const contact::SurfaceField& displacement) {
  const contact::PatchShape shape = contact::patch_shape(surface, grid);
  const contact::Field radius =
      grid.sample([&](double, double y) { return surface.local_rolling_radius(y); });
  // Lateral tangent and normal along the way from the contact to the axle.
  const double tilt_sine = std::sin(surface.axle_tilt());
  const double tilt_cosine = std::cos(surface.axle_tilt());
  const contact::Field sine =
      (shape.climb.array() * tilt_cosine - tilt_sine).matrix().cwiseQuotient(shape.stretch);
  const contact::Field cosine =
      (tilt_cosine + shape.climb.array() * tilt_sine).matrix().cwiseQuotient(shape.stretch);
  const contact::Field towards_axle =
      displacement.n.cwiseProduct(cosine) + displacement.y.cwiseProduct(sine);
  return {towards_axle.cwiseQuotient(radius),
          -displacement.x.cwiseProduct(sine).cwiseQuotient(radius)};
}

contact::ContactSurface common_surface(const SurfaceShape& wheel, const SurfaceShape& rail) {
  if (wheel.profile) return profile_contact(*wheel.profile);
  return {wheel.rolling_radius, wheel.transverse_radius, rail.transverse_radius};
}

struct FemCompliance::Implementation {
  Implementation(const Part& wheel, const Part& rail, const contact::ContactGrid& the_grid,
                 FarBoundary far)
      : grid(the_grid),
        parts{wheel, rail},
        surface(common_surface(wheel.body->shape(), rail.body->shape())),
        shape(contact::patch_shape(surface, the_grid)),
        coupling{{*wheel.body, the_grid, surface}, {*rail.body, the_grid, surface}} {
    for (int k = 0; k < 2; ++k) {
      loads[k] = make_vector(parts[k].body->dofs());
      displacements[k] = make_vector(parts[k].body->dofs());
    }
    const MPI_Comm communicator = wheel.body->dofs().get_communicator();
    concurrent = dealii::Utilities::MPI::n_mpi_processes(communicator) == 1 &&
                 is_factorisation(*wheel.solver) && is_factorisation(*rail.solver) &&
                 wheel.solver != rail.solver;
    if (far == FarBoundary::point_load)
      for (int k = 0; k < 2; ++k)
        far_field[k].emplace(*parts[k].body, *parts[k].solver, coupling[k]);
  }

  /// Force on body k.
  std::array<double, 3> force_on(int k, const contact::SurfaceField& traction) const {
    auto force = resultant_force(shape, grid, traction);
    for (double& component : force) component *= sign_of[k];
    return force;
  }

  /// Of body k under the tractions it was last solved for.
  contact::SurfaceField surface_displacement(int k, const contact::SurfaceField& traction) const {
    contact::SurfaceField result = coupling[k].sample(displacements[k]);
    if (far_field[k]) far_field[k]->add(force_on(k, traction), result);
    return result;
  }

  void solve_part(int k, const contact::SurfaceField& traction) {
    coupling[k].load({sign_of[k] * traction.x, sign_of[k] * traction.y, sign_of[k] * traction.n},
                     loads[k]);
    parts[k].solver->solve(displacements[k], loads[k]);
  }

  /// Stresses ask for the bodies under the tractions that the contact iteration has just ended
  /// with.
  void solve(const contact::SurfaceField& traction) {
    if (solved_for && same(*solved_for, traction)) return;
    solved_for.reset();
    if (concurrent) {
      auto rail = std::async(std::launch::async, [&] { solve_part(1, traction); });
      solve_part(0, traction);
      rail.get();
    } else {
      solve_part(0, traction);
      solve_part(1, traction);
    }
    solved_for = traction;
  }

  static bool same(const contact::SurfaceField& a, const contact::SurfaceField& b) {
    return a.x == b.x && a.y == b.y && a.n == b.n;
  }

  contact::ContactGrid grid;
  Part parts[2];
  contact::ContactSurface surface;
  contact::PatchShape shape;
  SurfaceCoupling coupling[2];
  std::optional<FarField> far_field[2];  ///< none: clamped
  Vector loads[2];
  Vector displacements[2];
  std::optional<contact::SurfaceField> solved_for;  ///< what `displacements` belong to
  bool concurrent = false;
  int solves = 0;
};

FemCompliance::FemCompliance(const Part& wheel, const Part& rail, const contact::ContactGrid& grid,
                             FarBoundary far)
    : implementation_(std::make_unique<Implementation>(wheel, rail, grid, far)) {}

FemCompliance::~FemCompliance() = default;

const contact::ContactGrid& FemCompliance::grid() const {
  return implementation_->grid;
}

contact::SurfaceField FemCompliance::apply(const contact::SurfaceField& traction) const {
  return respond(traction).displacement;
}

contact::Response FemCompliance::respond(const contact::SurfaceField& traction) const {
  auto& model = *implementation_;
  model.solve(traction);
  ++model.solves;
  const auto wheel = model.surface_displacement(0, traction);
  const auto rail = model.surface_displacement(1, traction);
  return {{wheel.x - rail.x, wheel.y - rail.y, wheel.n - rail.n},
          curvature_slip(model.surface, model.grid, wheel)};
}

std::vector<Vector> FemCompliance::body_displacements(const contact::SurfaceField& traction) const {
  auto& model = *implementation_;
  model.solve(traction);
  std::vector<Vector> displacements(model.displacements, model.displacements + 2);
  // Copying a vector leaves its ghost values behind.
  for (int k = 0; k < 2; ++k) {
    displacements[k].update_ghost_values();
    if (model.far_field[k]) model.far_field[k]->add(model.force_on(k, traction), displacements[k]);
  }
  return displacements;
}

int FemCompliance::solves() const {
  return implementation_->solves;
}

}  // namespace rollfem::fem
