// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/trace/fem_compliance.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/linear/root_process.hpp"
#include "fem/mesh/chart_face.hpp"
#include "fem/trace/far_field.hpp"
#include "scene/geometry.hpp"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace rollfem::fem {

namespace {

constexpr double lattice_tolerance = 1e-6;
/// Tolerance for faces on the lattice of the elements: on a wheel they are slightly longer or
/// shorter beside the running circle.
constexpr double lattice_misfit = 0.03;
/// Relative excess over the contact elements allowed for faces without lattice.
constexpr double size_tolerance = 2e-3;

/// Number of an unknown of the body and int N_i e_k dA over one contact element, e_k the local
/// frame: rolling, lateral, normal; dA on the contact surface.
struct Entry {
  dealii::types::global_dof_index dof;
  std::array<double, 3> weight;
};

/// Index of a contact element's mirror image at -y in the grid.
int mirrored(const contact::ContactGrid& grid, int element) {
  const int j = element / grid.nx;
  return grid.index(element % grid.nx, grid.ny - 1 - j);
}

constexpr double sign_of[2] = {1.0,
                               -1.0};  // tractions act on the wheel, their reaction on the rail

}  // namespace

struct SurfaceCoupling::Implementation {
  Implementation(const Body& the_body, const contact::ContactGrid& the_grid,
                 const contact::ContactSurface& the_surface)
      : body(the_body),
        grid(the_grid),
        surface(the_surface),
        area(grid.element_area() * contact::patch_shape(the_surface, the_grid).stretch) {
    check_symmetry();
    std::vector<std::map<dealii::types::global_dof_index, std::array<double, 3>>> rows(grid.size());
    covered.assign(grid.size(), 0.0);
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      if (!cell->is_locally_owned() || !cell->at_boundary()) continue;
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == contact_surface)
          couple_face(cell, face, rows);
    }
    start.assign(1, 0);
    for (const auto& row : rows) {
      for (const auto& [dof, weight] : row) entries.push_back({dof, weight});
      start.push_back(entries.size());
    }
    check_coverage();
  }

  Interval element_x(int i) const { return {grid.x(i) - 0.5 * grid.dx, grid.x(i) + 0.5 * grid.dx}; }
  Interval element_y(int j) const { return {grid.y(j) - 0.5 * grid.dy, grid.y(j) + 0.5 * grid.dy}; }

  void check_symmetry() const {
    const double middle = grid.y_first + 0.5 * (grid.ny - 1) * grid.dy;
    if (body.options().half && std::abs(middle) > lattice_tolerance * grid.dy)
      throw contact::InputError(fmt::format(
          "a half body needs a contact grid symmetric about y = 0; its middle is at {} mm",
          middle));
  }

  template <class Cell>
  void couple_face(
      const Cell& cell, unsigned int face,
      std::vector<std::map<dealii::types::global_dof_index, std::array<double, 3>>>& rows) {
    const ChartFace chart(face_corners(cell, face));
    // On a whole wheel one row of faces crosses the jump of the arc length from one end to the
    // other.
    if (chart.s().length() > std::abs(body.shape().streamline_radius(0.0))) return;
    const auto [i0, i1] = overlapped(chart.s(), grid.x_first, grid.dx, grid.nx);
    const auto [j0, j1] = overlapped(chart.t(), grid.y_first, grid.dy, grid.ny);
    if (i0 > i1 || j0 > j1) return;
    distorted = distorted || !chart.is_convex();
    std::vector<dealii::types::global_dof_index> indices(cell->get_fe().dofs_per_cell);
    cell->get_dof_indices(indices);
    std::vector<FacePoint> rule;
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        // degree + 1 points integrate the shape functions exactly; one more for the rotating frame.
        const double shared =
            chart.overlap(element_x(i), element_y(j), cell->get_fe().degree + 2, rule);
        if (rule.empty()) continue;
        largest_face = {std::max(largest_face[0], chart.s().length()),
                        std::max(largest_face[1], chart.t().length())};
        lattice_fit = std::max(
            {lattice_fit, misfit(chart.s(), element_x(i)), misfit(chart.t(), element_y(j))});
        inwards = std::max(inwards, cell->measure() / cell->face(face)->measure());
        covered[grid.index(i, j)] += shared;
        integrate(cell->get_fe(), face, rule, indices, rows[grid.index(i, j)]);
      }
  }

  /// In the standard orientation of this cell's face, independent of the neighbour.
  template <class Cell>
  std::array<dealii::Point<2>, 4> face_corners(const Cell& cell, unsigned int face) const {
    std::array<dealii::Point<2>, 4> corners;
    for (unsigned int k = 0; k < 4; ++k) {
      const auto vertex = dealii::GeometryInfo<3>::face_to_cell_vertices(face, k);
      const auto chart = body.shape().coordinates(cell->vertex(vertex));
      corners[k] = {chart[0], chart[1]};
    }
    return corners;
  }

  /// Faces along the side of an element for the degree and contact grid of the model.
  int faces_along() const { return body.dofs().get_fe().degree == 1 ? 2 : 1; }

  /// Deviation of a face from those faces of an element, in faces.
  double misfit(const Interval& face, const Interval& element) const {
    const double size = element.length() / faces_along();
    const double place = (face.lower - element.lower) / size;
    return std::max(std::abs(place - std::round(place)), std::abs(face.length() / size - 1.0));
  }

  static std::pair<int, int> overlapped(const Interval& face, double first, double step,
                                        int count) {
    const double lower = (face.lower - first) / step + 0.5;
    const double upper = (face.upper - first) / step + 0.5;
    if (upper <= 0 || lower >= count) return {0, -1};
    return {std::max(0, static_cast<int>(std::floor(lower - lattice_tolerance))),
            std::min(count - 1, static_cast<int>(std::floor(upper + lattice_tolerance)))};
  }

  void integrate(const dealii::FiniteElement<3>& element, unsigned int face,
                 const std::vector<FacePoint>& rule,
                 const std::vector<dealii::types::global_dof_index>& indices,
                 std::map<dealii::types::global_dof_index, std::array<double, 3>>& row) const {
    using Geometry = dealii::GeometryInfo<3>;
    for (const FacePoint& point : rule) {
      dealii::Point<3> reference;
      for (unsigned int k = 0; k < 4; ++k)
        reference += dealii::GeometryInfo<2>::d_linear_shape_function(point.reference, k) *
                     Geometry::unit_cell_vertex(Geometry::face_to_cell_vertices(face, k));
      const double climb = surface.climb(point.t);
      const double piece = point.weight * std::sqrt(1.0 + climb * climb);
      const SurfaceFrame frame = body.shape().tilted_frame(point.s, point.t, climb);
      for (unsigned int i = 0; i < element.dofs_per_cell; ++i) {
        if (!element.has_support_on_face(i, face)) continue;
        const unsigned int component = element.system_to_component_index(i).first;
        const double value = piece * element.shape_value(i, reference);
        auto& weight = row[indices[i]];
        for (unsigned int k = 0; k < 3; ++k) weight[k] += value * frame[k][component];
      }
    }
  }

  void check_coverage() {
    const MPI_Comm communicator = body.dofs().get_communicator();
    dealii::Utilities::MPI::sum(covered, communicator, covered);
    for (double& size : largest_face) size = dealii::Utilities::MPI::max(size, communicator);
    lattice_fit = dealii::Utilities::MPI::max(lattice_fit, communicator);
    inwards = dealii::Utilities::MPI::max(inwards, communicator);
    if (dealii::Utilities::MPI::max(distorted ? 1 : 0, communicator) == 1)
      throw contact::InputError(
          "a face of the finite-element mesh under the contact is not convex in (arc length, "
          "lateral coordinate): smooth the mesh there");
    const double finest = 1 - size_tolerance;
    if (grid.dx < finest * largest_face[0] || grid.dy < finest * largest_face[1])
      throw contact::InputError(
          fmt::format("contact elements of {:.4g} x {:.4g} mm are finer than the finite elements "
                      "under them ({:.4g} x {:.4g} mm), which is unstable: enlarge "
                      "fem.fine_extent, or give a smaller fem.cell_size or a coarser contact grid",
                      grid.dx, grid.dy, largest_face[0], largest_face[1]));
    for (int element = 0; element < grid.size(); ++element) {
      const double expected = grid.element_area() * share(element);
      if (std::abs(covered[element] - expected) > lattice_tolerance * grid.element_area())
        throw contact::InputError(
            fmt::format("the contact grid extends beyond the finite-element body at x = {:.4g}, y "
                        "= {:.4g} mm: enlarge fem.extent",
                        grid.x(element % grid.nx), grid.y(element / grid.nx)));
    }
  }

  /// Part of the element on the meshed side of the symmetry plane.
  double share(int element) const {
    if (!body.options().half) return 1.0;
    const auto y = element_y(element / grid.nx);
    return std::clamp(y.upper / grid.dy, 0.0, 1.0);
  }

  const Body& body;
  const contact::ContactGrid grid;
  const contact::ContactSurface surface;
  const contact::Field area;  ///< true area of the elements on the contact surface, mm^2
  std::vector<std::size_t> start;
  std::vector<Entry> entries;
  std::vector<double> covered;
  std::array<double, 2> largest_face{0.0, 0.0};
  bool distorted = false;
  double lattice_fit = 0.0;  ///< largest misfit
  double inwards = 0.0;      ///< mm, depth of the cells under the grid
};

SurfaceCoupling::SurfaceCoupling(const Body& body, const contact::ContactGrid& grid,
                                 const contact::ContactSurface& surface)
    : implementation_(std::make_unique<Implementation>(body, grid, surface)) {}

SurfaceCoupling::~SurfaceCoupling() = default;

void SurfaceCoupling::load(const contact::SurfaceField& traction, Vector& b) const {
  const auto& coupling = *implementation_;
  const bool half = coupling.body.options().half;
  b = 0.0;
  b.zero_out_ghost_values();
  for (int element = 0; element < coupling.grid.size(); ++element) {
    std::array<double, 3> p{traction.x[element], traction.y[element], traction.n[element]};
    if (half) {
      const int image = mirrored(coupling.grid, element);
      p = {0.5 * (p[0] + traction.x[image]), 0.5 * (p[1] - traction.y[image]),
           0.5 * (p[2] + traction.n[image])};
    }
    for (auto k = coupling.start[element]; k < coupling.start[element + 1]; ++k) {
      const auto& entry = coupling.entries[k];
      b(entry.dof) += entry.weight[0] * p[0] + entry.weight[1] * p[1] + entry.weight[2] * p[2];
    }
  }
  b.compress(dealii::VectorOperation::add);
}

contact::SurfaceField SurfaceCoupling::sample(const Vector& displacement) const {
  const auto& coupling = *implementation_;
  const auto& grid = coupling.grid;
  const int size = grid.size();
  std::vector<double> mean(3 * static_cast<std::size_t>(size), 0.0);
  for (int element = 0; element < size; ++element)
    for (auto k = coupling.start[element]; k < coupling.start[element + 1]; ++k) {
      const auto& entry = coupling.entries[k];
      const double value = displacement(entry.dof) / coupling.area[element];
      for (int c = 0; c < 3; ++c) mean[3 * element + c] += entry.weight[c] * value;
    }
  const MPI_Comm communicator = coupling.body.dofs().get_communicator();
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
    dealii::Utilities::MPI::sum(mean, communicator, mean);

  contact::SurfaceField field{contact::Field(size), contact::Field(size), contact::Field(size)};
  for (int element = 0; element < size; ++element) {
    std::array<double, 3> u{mean[3 * element], mean[3 * element + 1], mean[3 * element + 2]};
    if (coupling.body.options().half) {
      // Contribution of the unmeshed side: nothing for an element beyond the plane, the same again
      // with mirrored signs for one that straddles it.
      const int image = mirrored(grid, element);
      u = {u[0] + mean[3 * image], u[1] - mean[3 * image + 1], u[2] + mean[3 * image + 2]};
    }
    field.x[element] = u[0];
    field.y[element] = u[1];
    field.n[element] = u[2];
  }
  return field;
}

std::optional<Lattice> SurfaceCoupling::lattice() const {
  const auto& coupling = *implementation_;
  if (coupling.distorted || coupling.lattice_fit > lattice_misfit) return std::nullopt;
  const int cells = coupling.faces_along();
  return Lattice{coupling.body.material(),
                 static_cast<int>(coupling.body.dofs().get_fe().degree),
                 cells,
                 {coupling.grid.dx / cells, coupling.grid.dy / cells, coupling.inwards}};
}

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
