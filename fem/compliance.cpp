#include "fem/compliance.hpp"

#include "fem/factorisation.hpp"

#include <deal.II/base/mpi.h>

#include <future>

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
  const contact::Field sine = shape.climb.cwiseQuotient(shape.stretch);
  const contact::Field towards_axle =
      displacement.n.cwiseQuotient(shape.stretch) + displacement.y.cwiseProduct(sine);
  return {towards_axle.cwiseQuotient(radius),
          -displacement.x.cwiseProduct(sine).cwiseQuotient(radius)};
}

contact::ContactSurface common_surface(const SurfaceShape& wheel, const SurfaceShape& rail) {
  return {wheel.rolling_radius, wheel.transverse_radius, rail.transverse_radius};
}

struct FemCompliance::Implementation {
  Implementation(const Part& wheel, const Part& rail, const contact::ContactGrid& the_grid)
      : grid(the_grid),
        parts{wheel, rail},
        surface(common_surface(wheel.body->shape(), rail.body->shape())),
        coupling{{*wheel.body, the_grid, surface}, {*rail.body, the_grid, surface}} {
    for (int k = 0; k < 2; ++k) {
      loads[k] = make_vector(parts[k].body->dofs());
      displacements[k] = make_vector(parts[k].body->dofs());
    }
    const MPI_Comm communicator = wheel.body->dofs().get_communicator();
    concurrent = dealii::Utilities::MPI::n_mpi_processes(communicator) == 1 &&
                 is_factorisation(*wheel.solver) && is_factorisation(*rail.solver) &&
                 wheel.solver != rail.solver;
  }

  void solve_part(int k, const contact::SurfaceField& traction) {
    coupling[k].load({sign_of[k] * traction.x, sign_of[k] * traction.y, sign_of[k] * traction.n},
                     loads[k]);
    parts[k].solver->solve(displacements[k], loads[k]);
  }

  void solve(const contact::SurfaceField& traction) {
    if (concurrent) {
      auto rail = std::async(std::launch::async, [&] { solve_part(1, traction); });
      solve_part(0, traction);
      rail.get();
    } else {
      solve_part(0, traction);
      solve_part(1, traction);
    }
  }

  contact::ContactGrid grid;
  Part parts[2];
  contact::ContactSurface surface;
  SurfaceCoupling coupling[2];
  Vector loads[2];
  Vector displacements[2];
  bool concurrent = false;
  int solves = 0;
};

FemCompliance::FemCompliance(const Part& wheel, const Part& rail, const contact::ContactGrid& grid)
    : implementation_(std::make_unique<Implementation>(wheel, rail, grid)) {}

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
  const auto wheel = model.coupling[0].sample(model.displacements[0]);
  const auto rail = model.coupling[1].sample(model.displacements[1]);
  return {{wheel.x - rail.x, wheel.y - rail.y, wheel.n - rail.n},
          curvature_slip(model.surface, model.grid, wheel)};
}

std::vector<Vector> FemCompliance::body_displacements(const contact::SurfaceField& traction) const {
  auto& model = *implementation_;
  model.solve(traction);
  std::vector<Vector> displacements(model.displacements, model.displacements + 2);
  // Copying a vector leaves its ghost values behind.
  for (auto& displacement : displacements) displacement.update_ghost_values();
  return displacements;
}

int FemCompliance::solves() const {
  return implementation_->solves;
}

}  // namespace rollfem::fem
