// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/compliance.hpp"

#include "contact/base/threads.hpp"
#include "contact/scene/geometry.hpp"
#include "fem/trace/far_field.hpp"
#include "fem/trace/middle_displacement.hpp"

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <optional>

namespace rollfem::fem {

namespace {

constexpr double sign_of[2] = {1.0,
                               -1.0};  // tractions act on the wheel, their reaction on the rail

}  // namespace

struct FemCompliance::Implementation {
  Implementation(const Part& wheel, const Part& rail, const contact::ContactSurface& the_surface,
                 const contact::ContactGrid& the_grid, FarBoundary far)
      : grid(the_grid),
        parts{wheel, rail},
        surface(the_surface),
        shape(contact::patch_shape(surface, the_grid)),
        curvature_slip(surface, the_grid) {
    concurrent = wheel.solver != rail.solver;
    for (int k = 0; k < 2; ++k) {
      const auto [body, solver] = parts[k];
      concurrent = concurrent && body != nullptr && solver->runs_beside_others();
      if (body == nullptr) continue;
      coupling[k].emplace(*body, grid, surface);
      loads[k] = make_vector(body->dofs());
      displacements[k] = make_vector(body->dofs());
      const MPI_Comm communicator = body->dofs().get_communicator();
      first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
      const auto lattice = coupling[k]->lattice();
      if (first) middle[k].emplace(grid, body->material(), shape.stretch, lattice);
      if (far == FarBoundary::point_load) far_field[k].emplace(*body, *solver, *coupling[k]);
    }
  }

  static contact::SurfaceField on_body(int k, const contact::SurfaceField& traction) {
    return {sign_of[k] * traction.x, sign_of[k] * traction.y, sign_of[k] * traction.n};
  }

  /// Force on body k.
  std::array<double, 3> force_on(int k, const contact::SurfaceField& traction) const {
    auto force = resultant_force(shape, grid, traction);
    for (double& component : force) component *= sign_of[k];
    return force;
  }

  /// Displacement of body k under its last tractions.
  contact::SurfaceField surface_displacement(int k, const contact::SurfaceField& traction) const {
    const contact::Field none = contact::Field::Zero(grid.size());
    if (!coupling[k]) return {none, none, none};
    contact::SurfaceField result = coupling[k]->sample(displacements[k]);
    if (!first) return result;
    middle[k]->add(on_body(k, traction), result);
    if (far_field[k]) far_field[k]->add(force_on(k, traction), result);
    return result;
  }

  void solve_part(int k, const contact::SurfaceField& traction) {
    if (!coupling[k]) return;
    coupling[k]->load(on_body(k, traction), loads[k]);
    parts[k].solver->solve(displacements[k], loads[k]);
  }

  /// Stresses use the bodies under the tractions with which the contact iteration has just ended.
  void solve(const contact::SurfaceField& traction) {
    if (solved_for && same(*solved_for, traction)) return;
    solved_for.reset();
    if (concurrent) {
      contact::for_each_index(2, [&](std::size_t k) { solve_part(static_cast<int>(k), traction); });
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
  contact::CurvatureSlip curvature_slip;
  std::optional<SurfaceCoupling> coupling[2];  ///< none: rigid
  std::optional<MiddleDisplacement> middle[2];
  std::optional<FarField> far_field[2];  ///< none: clamped
  Vector loads[2];
  Vector displacements[2];
  std::optional<contact::SurfaceField> solved_for;  ///< tractions of `displacements`
  bool concurrent = false;
  bool first = true;  ///< process, whose surface displacement is whole
  int solves = 0;
};

FemCompliance::FemCompliance(const Part& wheel, const Part& rail,
                             const contact::ContactSurface& surface,
                             const contact::ContactGrid& grid, FarBoundary far)
    : implementation_(std::make_unique<Implementation>(wheel, rail, surface, grid, far)) {}

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
  if (!model.first) return {};
  return {{wheel.x - rail.x, wheel.y - rail.y, wheel.n - rail.n}, model.curvature_slip(wheel)};
}

std::vector<Vector> FemCompliance::body_displacements(const contact::SurfaceField& traction) const {
  auto& model = *implementation_;
  model.solve(traction);
  std::vector<Vector> displacements(model.displacements, model.displacements + 2);
  // Copying a vector drops its ghost values.
  for (int k = 0; k < 2; ++k) {
    if (!model.coupling[k]) continue;
    displacements[k].update_ghost_values();
    if (model.far_field[k]) model.far_field[k]->add(model.force_on(k, traction), displacements[k]);
  }
  return displacements;
}

int FemCompliance::solves() const {
  return implementation_->solves;
}

}  // namespace rollfem::fem
