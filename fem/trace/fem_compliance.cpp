// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/fem_compliance.hpp"

#include "contact/base/threads.hpp"
#include "contact/scene/geometry.hpp"
#include "fem/linear/first_process.hpp"
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

/// What copies share.
struct FemCompliance::Shared {
  Shared(const Part& wheel, const Part& rail, const contact::ContactSurface& the_surface,
         const contact::ContactGrid& the_grid, FarBoundary far)
      : grid(the_grid),
        parts{wheel, rail},
        shape(contact::patch_shape(the_surface, the_grid)),
        curvature_slip(the_surface, the_grid) {
    if (the_surface.rail_is_roller()) rail_curvature_slip.emplace(the_surface, the_grid, false);
    concurrent = wheel.solver != rail.solver;
    for (int k = 0; k < 2; ++k) {
      const Body* const body = parts[k].body;
      concurrent = concurrent && (body == nullptr || parts[k].solver->runs_beside_others());
      if (body == nullptr) continue;
      one_at_a_time([&] { coupling[k].emplace(*body, grid, the_surface); });
      nothing[k] = make_vector(body->dofs());
      const MPI_Comm communicator = body->dofs().get_communicator();
      first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    }
    for_each_body([&](std::size_t k) {
      const Body* const body = parts[k].body;
      const auto lattice = coupling[k]->lattice();
      if (first) middle[k].emplace(grid, body->material(), shape.stretch, lattice);
      if (far == FarBoundary::point_load)
        far_field[k].emplace(*body, *parts[k].solver, *coupling[k]);
    });
  }

  /// For each that is not rigid, side by side if their solvers allow it.
  template <class Work>
  void for_each_body(const Work& work) const {
    const auto unless_rigid = [&](std::size_t k) {
      if (coupling[k]) work(k);
    };
    if (concurrent) return contact::for_each_index(2, unless_rigid);
    unless_rigid(0);
    unless_rigid(1);
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

  void add_sampled(const std::vector<Vector>& further,
                   const std::array<contact::SurfaceField*, 2>& surface) const {
    for (std::size_t k = 0; k < 2; ++k) {
      if (further[k].size() == 0) continue;
      const contact::SurfaceField u = coupling[k]->sample(further[k]);
      surface[k]->x += u.x;
      surface[k]->y += u.y;
      surface[k]->n += u.n;
    }
  }

  contact::ContactGrid grid;
  Part parts[2];
  contact::PatchShape shape;
  contact::CurvatureSlip curvature_slip;
  std::optional<contact::CurvatureSlip> rail_curvature_slip;  ///< of a roller
  std::optional<SurfaceCoupling> coupling[2];                 ///< none: rigid
  Vector nothing[2];  ///< of the body's layout, which only all processes together can make
  std::optional<MiddleDisplacement> middle[2];
  std::optional<FarField> far_field[2];  ///< none: clamped
  bool concurrent = false;               ///< solves may run beside each other
  bool first = true;                     ///< process, whose surface displacement is whole
};

/// The bodies under the last tractions.
struct FemCompliance::State {
  explicit State(const Shared& shared) {
    // Unlike an assignment, without the other processes.
    for (auto* vectors : {loads, displacements})
      for (int k = 0; k < 2; ++k)
        if (shared.coupling[k]) vectors[k].reinit(shared.nothing[k]);
  }

  /// Displacement of body k.
  contact::SurfaceField surface_displacement(const Shared& shared, int k,
                                             const contact::SurfaceField& traction) const {
    const contact::Field none = contact::Field::Zero(shared.grid.size());
    if (!shared.coupling[k]) return {none, none, none};
    contact::SurfaceField result = shared.coupling[k]->sample(displacements[k]);
    if (!shared.first) return result;
    shared.middle[k]->add(Shared::on_body(k, traction), result);
    if (shared.far_field[k]) shared.far_field[k]->add(shared.force_on(k, traction), result);
    return result;
  }

  /// Stresses use the bodies under the tractions with which the contact iteration has just ended.
  void solve(const Shared& shared, const contact::SurfaceField& traction) {
    if (solved_for && same(*solved_for, traction)) return;
    solved_for.reset();
    shared.for_each_body([&](std::size_t k) {
      shared.coupling[k]->load(Shared::on_body(static_cast<int>(k), traction), loads[k]);
      shared.parts[k].solver->solve(displacements[k], loads[k]);
    });
    solved_for = traction;
  }

  static bool same(const contact::SurfaceField& a, const contact::SurfaceField& b) {
    return a.x == b.x && a.y == b.y && a.n == b.n;
  }

  Vector loads[2];
  Vector displacements[2];
  std::optional<contact::SurfaceField> solved_for;  ///< tractions of `displacements`
  int solves = 0;
  Beyond beyond;
};

FemCompliance::FemCompliance(const Part& wheel, const Part& rail,
                             const contact::ContactSurface& surface,
                             const contact::ContactGrid& grid, FarBoundary far)
    : shared_(std::make_shared<const Shared>(wheel, rail, surface, grid, far)),
      state_(std::make_unique<State>(*shared_)) {}

FemCompliance::FemCompliance(const FemCompliance& other)
    : shared_(other.shared_), state_(std::make_unique<State>(*shared_)) {}

FemCompliance::~FemCompliance() = default;

const contact::ContactGrid& FemCompliance::grid() const {
  return shared_->grid;
}

bool FemCompliance::copies_run_beside_each_other() const {
  return shared_->concurrent;
}

contact::SurfaceField FemCompliance::apply(const contact::SurfaceField& traction) const {
  return respond(traction).displacement;
}

contact::Response FemCompliance::respond(const contact::SurfaceField& traction) const {
  state_->solve(*shared_, traction);
  ++state_->solves;
  auto wheel = state_->surface_displacement(*shared_, 0, traction);
  auto rail = state_->surface_displacement(*shared_, 1, traction);
  if (state_->beyond) {
    const std::vector<Vector> further = state_->beyond(body_displacements(traction));
    shared_->add_sampled(further, {&wheel, &rail});
  }
  if (!shared_->first) return {};
  contact::TangentialField slip = shared_->curvature_slip(wheel);
  if (const auto& of_rail = shared_->rail_curvature_slip) {
    const contact::TangentialField own = (*of_rail)(rail);
    slip = {slip.x - own.x, slip.y - own.y};
  }
  return {{wheel.x - rail.x, wheel.y - rail.y, wheel.n - rail.n}, std::move(slip)};
}

std::vector<Vector> FemCompliance::body_displacements(const contact::SurfaceField& traction) const {
  state_->solve(*shared_, traction);
  std::vector<Vector> displacements(state_->displacements, state_->displacements + 2);
  // Copying a vector drops its ghost values.
  for (int k = 0; k < 2; ++k) {
    if (!shared_->coupling[k]) continue;
    displacements[k].update_ghost_values();
    if (const auto& far = shared_->far_field[k])
      far->add(shared_->force_on(k, traction), displacements[k]);
  }
  return displacements;
}

void FemCompliance::set_beyond_elastic(Beyond beyond) {
  state_->beyond = std::move(beyond);
}

int FemCompliance::solves() const {
  return state_->solves;
}

}  // namespace rollfem::fem
