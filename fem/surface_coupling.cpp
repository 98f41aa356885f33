// Contact grid and FE surface: overlap of contact elements and FE faces in chart coordinates, and
// the exact integrals of the shape functions over it.
#include "contact/errors.hpp"
#include "fem/chart.hpp"
#include "fem/compliance.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rollfem::fem {

namespace {

constexpr double lattice_tolerance = 1e-6;

/// Number of an unknown of the body and int N_i e_k dA over one contact element, e_k the local
/// frame: rolling, lateral, normal; dA on the contact surface.
struct Entry {
  dealii::types::global_dof_index dof;
  std::array<double, 3> weight;
};

struct Interval {
  double lower;
  double upper;
  double length() const { return upper - lower; }
};

Interval intersect(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// Where a contact element's mirror image at -y lies in the grid.
int mirrored(const contact::ContactGrid& grid, int element) {
  const int j = element / grid.nx;
  return grid.index(element % grid.nx, grid.ny - 1 - j);
}

/// What a body shares with another of exactly its shape.
contact::ContactSurface own_surface(const SurfaceShape& shape) {
  const double radius = shape.transverse_radius;
  return shape.is_wheel ? contact::ContactSurface{shape.rolling_radius, radius, -radius}
                        : contact::ContactSurface{contact::infinity, -radius, radius};
}

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

  /// `face` is the side of the reference cell on the surface: reference axes 0 and 1 run along s
  /// and t there, by construction of the mesh.
  template <class Cell>
  void couple_face(
      const Cell& cell, unsigned int face,
      std::vector<std::map<dealii::types::global_dof_index, std::array<double, 3>>>& rows) {
    const auto box = chart_box(body.shape(), cell->face(face));
    const Interval s{box.lower[0], box.upper[0]};
    const Interval t{box.lower[1], box.upper[1]};
    const auto [i0, i1] = overlapped(s, grid.x_first, grid.dx, grid.nx);
    const auto [j0, j1] = overlapped(t, grid.y_first, grid.dy, grid.ny);
    if (i0 > i1 || j0 > j1) return;
    std::vector<dealii::types::global_dof_index> indices(cell->get_fe().dofs_per_cell);
    cell->get_dof_indices(indices);
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        const auto part_s = intersect(s, element_x(i));
        const auto part_t = intersect(t, element_y(j));
        // Slivers from rounding are no overlap.
        if (part_s.length() < 1e-9 * grid.dx || part_t.length() < 1e-9 * grid.dy) continue;
        largest_face = {std::max(largest_face[0], s.length()),
                        std::max(largest_face[1], t.length())};
        covered[grid.index(i, j)] += part_s.length() * part_t.length();
        integrate(cell->get_fe(), face, s, t, part_s, part_t, indices, rows[grid.index(i, j)]);
      }
  }

  static std::pair<int, int> overlapped(const Interval& face, double first, double step,
                                        int count) {
    const double lower = (face.lower - first) / step + 0.5;
    const double upper = (face.upper - first) / step + 0.5;
    if (upper <= 0 || lower >= count) return {0, -1};
    return {std::max(0, static_cast<int>(std::floor(lower - lattice_tolerance))),
            std::min(count - 1, static_cast<int>(std::floor(upper + lattice_tolerance)))};
  }

  void integrate(const dealii::FiniteElement<3>& element, unsigned int face, const Interval& s,
                 const Interval& t, const Interval& part_s, const Interval& part_t,
                 const std::vector<dealii::types::global_dof_index>& indices,
                 std::map<dealii::types::global_dof_index, std::array<double, 3>>& row) const {
    // The shape functions are exact with degree + 1 points; one more for the turning frame.
    const dealii::QGauss<2> rule(element.degree + 2);
    for (unsigned int q = 0; q < rule.size(); ++q) {
      const double at_s = part_s.lower + rule.point(q)[0] * part_s.length();
      const double at_t = part_t.lower + rule.point(q)[1] * part_t.length();
      const dealii::Point<3> reference((at_s - s.lower) / s.length(), (at_t - t.lower) / t.length(),
                                       face % 2);
      const double climb = surface.climb(at_t);
      const double piece =
          rule.weight(q) * part_s.length() * part_t.length() * std::sqrt(1.0 + climb * climb);
      std::array<dealii::Tensor<1, 3>, 3> frame;
      body.shape().tilted_frame(at_s, at_t, climb, frame[0], frame[1], frame[2]);
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
    const double finest = 1 - lattice_tolerance;
    if (grid.dx < finest * largest_face[0] || grid.dy < finest * largest_face[1])
      throw contact::InputError(fmt::format(
          "contact elements of {:.4g} x {:.4g} mm are finer than the finite elements under them "
          "({:.4g} x {:.4g} mm), which is unstable: enlarge fem.fine_extent, take a smaller "
          "fem.cell_size or a coarser contact grid",
          grid.dx, grid.dy, largest_face[0], largest_face[1]));
    for (int element = 0; element < grid.size(); ++element) {
      const double expected = grid.element_area() * share(element);
      if (std::abs(covered[element] - expected) > lattice_tolerance * grid.element_area())
        throw contact::InputError(fmt::format(
            "the contact grid reaches beyond the finite-element body at x = {:.4g}, y = {:.4g} "
            "mm: enlarge fem.extent",
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
};

SurfaceCoupling::SurfaceCoupling(const Body& body, const contact::ContactGrid& grid,
                                 const contact::ContactSurface& surface)
    : implementation_(std::make_unique<Implementation>(body, grid, surface)) {}

SurfaceCoupling::SurfaceCoupling(const Body& body, const contact::ContactGrid& grid)
    : SurfaceCoupling(body, grid, own_surface(body.shape())) {}

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
      // What the unmeshed side adds: nothing to an element beyond the plane, the same again with
      // mirrored signs to one that straddles it.
      const int image = mirrored(grid, element);
      u = {u[0] + mean[3 * image], u[1] - mean[3 * image + 1], u[2] + mean[3 * image + 2]};
    }
    field.x[element] = u[0];
    field.y[element] = u[1];
    field.n[element] = u[2];
  }
  return field;
}

}  // namespace rollfem::fem
