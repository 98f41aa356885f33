// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction/smooth_parts.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/discretisation/case_bodies.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/linear/multigrid.hpp"
#include "fem/mesh/run_layout.hpp"
#include "fem/trace/far_field.hpp"
#include "fem/trace/fem_compliance.hpp"
#include "halfspace/elasticity/influence.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "hybrid/correction/below_parts.hpp"
#include "hybrid/correction/flat_twin.hpp"
#include "hybrid/correction_scene.hpp"
#include "scene/below_surface.hpp"
#include "scene/scene.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace rollfem::hybrid {

namespace {

using contact::ContactGrid;
using contact::Field;
using contact::Scene;
using contact::SurfaceField;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using fem::Body;
using fem::BodyOptions;
using fem::LinearSolver;
using fem::RunLayout;
using fem::Vector;

// The correction of a flat body in the frame of the common surface, without a mesh: the
// body is a half-space itself, but loaded and evaluated along the local tangents and
// normals of a surface that is curved where the other body is.

/// Elements in a line along rolling.
struct Row {
  double middle;  ///< mm, across
  double width;   ///< mm
  Matrix3d axes;  ///< columns: tangents along rolling and across, normal
  double force;   ///< of traction times area in the plane
};

/// [displacement][traction] in axes of the plane.
Matrix3d block(const halfspace::Influence& h) {
  Matrix3d values;
  values << h.xx, h.xy, h.xn, h.xy, h.yy, h.yn, -h.xn, -h.yn, h.nn;
  return values;
}

/// For a surface with dz/dy = climb.
Matrix3d local_axes(double climb) {
  const double stretch = contact::stretch_of(climb);
  Matrix3d axes;
  axes << 1.0, 0.0, 0.0, 0.0, 1.0 / stretch, -climb / stretch, 0.0, climb / stretch, 1.0 / stretch;
  return axes;
}

/// One row for each element, so that sums run contiguously over the shapes.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds `sign` times the displacement of a half-space in the axes of its rows.
void add_displacement(const ContactGrid& grid, const std::vector<Row>& rows,
                      const contact::CombinedMaterial& material, const RowMajor& shapes,
                      double sign, std::array<RowMajor, 3>& sums) {
  const auto add = [&](const Matrix3d& values, int at, int from) {
    if (shapes.row(from).isZero(0.0)) return;
    for (Index p = 0; p < 3; ++p)
      for (Index u = 0; u < 3; ++u)
        sums[static_cast<std::size_t>(p)].row(u * grid.size() + at) +=
            values(u, p) * shapes.row(from);
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int k = 0; k < grid.ny; ++k)
      for (int apart = 1 - grid.nx; apart < grid.nx; ++apart) {
        const Row &at = rows[static_cast<std::size_t>(j)],
                  &from = rows[static_cast<std::size_t>(k)];
        const Matrix3d values =
            sign * from.force * at.axes.transpose() *
            block(halfspace::rectangle_influence(apart * grid.dx, at.middle - from.middle, grid.dx,
                                                 from.width, material)) *
            from.axes;
        for (int i = std::max(0, apart); i < std::min(grid.nx, grid.nx + apart); ++i)
          add(values, grid.index(i, j), grid.index(i - apart, k));
      }
}

/// Whether a body has a plane surface and is so large that it has no far boundary.
bool is_half_space(const contact::Scene& scene, bool wheel) {
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (surface.profiles || fem::far_boundary_of(scene) != fem::FarBoundary::point_load) return false;
  return wheel ? std::isinf(surface.wheel_transverse_radius) && std::isinf(surface.rolling_radius)
               : std::isinf(surface.rail_transverse_radius) && !surface.rail_is_roller();
}

/// Contribution of the body to u_wheel - u_rail, mm: the displacement of its plane less that of the
/// rolled-out half-space, under tractions on the wheel. `shapes`: a row for each element of the
/// grid (laid along the plane), a column for each traction, MPa. Returned for tractions along x, y
/// and n: a column for each shape, with u_x, then u_y, then u_n of all elements. `arc`: arc length
/// of the common surface, at least over the grid.
std::array<MatrixXd, 3> beyond_flat_body(const contact::Scene& scene, bool wheel,
                                         const ContactGrid& grid, const ArcLength& arc,
                                         const MatrixXd& shapes) {
  const contact::Material rigid = contact::rigid_material();
  const contact::CombinedMaterial material =
      wheel ? combine(scene.wheel.material, rigid) : combine(rigid, scene.rail.material);
  const contact::PatchShape shape = contact::patch_shape(scene.geometry.surface, grid);
  std::vector<Row> plane, rolled_out;
  for (int j = 0; j < grid.ny; ++j) {
    const double y = grid.y(j), lower = arc.at(y - 0.5 * grid.dy),
                 upper = arc.at(y + 0.5 * grid.dy);
    const int element = grid.index(0, j);
    plane.push_back({y, grid.dy, local_axes(shape.climb[element]), shape.stretch[element]});
    rolled_out.push_back({0.5 * (lower + upper), upper - lower, Matrix3d::Identity(), 1.0});
  }
  const RowMajor loads = shapes;
  std::array<RowMajor, 3> sums;
  for (RowMajor& sum : sums) sum = RowMajor::Zero(3 * grid.size(), shapes.cols());
  add_displacement(grid, plane, material, loads, 1.0, sums);
  add_displacement(grid, rolled_out, material, loads, -1.0, sums);
  return {sums[0], sums[1], sums[2]};
}

/// Degrees of the polynomials: tractions (times Hertz's ellipsoid) and fit of displacements.
constexpr int load_degree = 4;
constexpr int field_degree = 8;
/// Weight of displacements beside the patch, where they flatten and only must not close the gap;
/// their derivative in the patch matters more. With degree 6 and equal weights the slip of a sphere
/// at rest had an error of 5.6 %, now 0.8 % (verification.Hybrid.HasTheSlipOfAnElasticSphere).
constexpr double weight_beside = 0.2;
constexpr double patch_ends = 1.15;  ///< in semi-axes
/// Cells in the smaller semi-axis of the patch. With five instead of three, p0 of case f changes by
/// 0.02 % and its forces by 2e-4 of mu.
constexpr double usual_cells_in_semi_axis = 3.0;
/// Elements of linear cells are two cells wide (fem/mesh/run_layout.cpp): cells of half the size
/// give as many elements as quadratic cells do, enough to separate the polynomials of displacement.
constexpr double times_cells_of_degree_one = 2.0;
/// Smallest pivot of the displacement fit as a fraction of the largest; below it the fit cannot
/// separate some polynomials. Usual values are 0.01 and above.
constexpr double least_pivot = 1e-4;
/// Size of the ellipsoid relative to the patch.
constexpr double room = 1.05;

/// Depth to which stresses are mapped, in semi-axes of the patch; deeper they fade with the square
/// of the depth.
constexpr double below_beside = 1.5;
constexpr double below_depth = 3.0;

/// Bodies with factors larger than this, in bytes (four are held at a time), are solved by
/// multigrid, which takes longer for 45 loads; this happens only for very long patches. A residual
/// of 1e-8 is 1e-4 of the difference between body and twin, which is a hundredth of the
/// displacement.
constexpr double largest_factor = 3e9;

std::unique_ptr<LinearSolver> make_solver(const Body& body) {
  if (fem::predicted_factor_bytes(static_cast<double>(body.unknowns())) < largest_factor ||
      body.material().poisson_ratio > fem::largest_multigrid_poisson_ratio)
    return fem::make_factorisation(body.problem());
  return fem::make_multigrid(body.problem(), {1e-8});
}

/// One body under tractions on the contact grid.
class SolvedBody {
 public:
  SolvedBody(const Scene& scene, const Body& body, const ContactGrid& grid, bool flat)
      : body_(body),
        coupling_(body, grid, scene.geometry.surface),
        shape_(contact::patch_shape(scene.geometry.surface, grid)),
        grid_(grid),
        flat_(flat),
        unbounded_(fem::far_boundary_of(scene) == fem::FarBoundary::point_load),
        nothing_(fem::make_vector(body.dofs())) {}

  /// Before it is loaded; unlike constructors, side by side.
  void prepare() {
    solver_ = make_solver(body_);
    if (unbounded_) far_.emplace(body_, *solver_, coupling_);
  }

  /// Displacement of the surface under each of the tractions.
  std::vector<SurfaceField> under(const std::vector<SurfaceField>& tractions) {
    std::vector<Vector> loads(tractions.size(), nothing_);
    for (std::size_t k = 0; k < tractions.size(); ++k) coupling_.load(tractions[k], loads[k]);
    displacements_.assign(tractions.size(), nothing_);
    solver_->solve_all(displacements_, loads);
    std::vector<SurfaceField> fields;
    for (std::size_t k = 0; k < tractions.size(); ++k) {
      fields.push_back(coupling_.sample(displacements_[k]));
      if (far_) far_->add(resultant(tractions[k]), fields[k]);
    }
    return fields;
  }
  /// Displacement of the whole body under traction k of the last set of loads.
  Vector displacement(std::size_t k, const SurfaceField& traction) const {
    Vector all(displacements_[k]);
    if (far_) far_->add(resultant(traction), all);
    all.update_ghost_values();
    return all;
  }

 private:
  std::array<double, 3> resultant(const SurfaceField& traction) const {
    if (!flat_) return fem::resultant_force(shape_, grid_, traction);
    const Field area = grid_.element_area() * shape_.stretch;
    return {area.dot(traction.x), area.dot(traction.y), area.dot(traction.n)};
  }

  const Body& body_;
  std::unique_ptr<LinearSolver> solver_;
  fem::SurfaceCoupling coupling_;
  contact::PatchShape shape_;
  ContactGrid grid_;
  bool flat_;
  bool unbounded_;
  std::optional<fem::FarField> far_;
  Vector nothing_;
  std::vector<Vector> displacements_;
};

/// The polynomials at the elements of the loading and sampling grid.
struct Basis {
  Basis(const Scene& scene, const RunLayout& layout)
      : grid(layout.grid),
        half(layout.bodies.half),
        arc(scene.geometry.surface, std::abs(layout.patch.middle) + grid.ny * grid.dy) {
    const contact::ContactSurface& surface = scene.geometry.surface;
    const Field x = grid.sample([](double s, double) { return s; });
    const Field y = grid.sample([&](double, double t) { return arc.at(t); });
    const double lower = arc.at(layout.patch.middle - layout.patch.half_width);
    const double upper = arc.at(layout.patch.middle + layout.patch.half_width);
    loads = {room * layout.patch.half_length, room * 0.5 * (upper - lower), 0.5 * (lower + upper)};
    fields = {0.5 * grid.nx * grid.dx, 0.5 * (y.maxCoeff() - y.minCoeff() + grid.dy),
              0.5 * (y.maxCoeff() + y.minCoeff())};
    in = polynomials(loads, load_degree, x, y);
    out = polynomials(fields, field_degree, x, y);
    ellipsoid = weight = Field(grid.size());
    for (Index k = 0; k < ellipsoid.size(); ++k) {
      const double a = x[k] / loads.half_length;
      const double b = (y[k] - loads.middle) / loads.half_width;
      ellipsoid[k] = std::sqrt(std::max(0.0, 1.0 - a * a - b * b));
      weight[k] = room * std::hypot(a, b) < patch_ends ? 1.0 : weight_beside;
    }
    fit.setThreshold(least_pivot);
    fit.compute(weight.asDiagonal() * out);
    if (fit.rank() < fit.cols())
      throw contact::SolveError(
          scene.where(),
          "model hybrid: {} by {} elements are too few to compute the correction; "
          "do: run with --model fem",
          grid.nx, grid.ny);
    below = {below_beside * layout.patch.half_length, 0.5 * below_beside * (upper - lower),
             loads.middle};
    deep = below_depth * layout.patch.smaller();
    set_flat_loads();
    const Field area = grid.element_area() * contact::patch_shape(surface, grid).stretch;
    moments.compute(in.transpose() * area.cwiseProduct(ellipsoid).asDiagonal() * in);
  }

  /// The tractions on the rolled-out surface.
  void set_flat_loads() {
    std::vector<Index> rows;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        if (ellipsoid[grid.index(i, j)] == 0.0) continue;
        const double lower = arc.at(grid.y(j) - 0.5 * grid.dy);
        const double upper = arc.at(grid.y(j) + 0.5 * grid.dy);
        flat.rectangles.push_back({grid.x(i), 0.5 * (lower + upper), grid.dx, upper - lower});
        rows.push_back(grid.index(i, j));
      }
    flat.shapes.resize(static_cast<Index>(rows.size()), in.cols());
    for (std::size_t k = 0; k < rows.size(); ++k)
      flat.shapes.row(static_cast<Index>(k)) = ellipsoid[rows[k]] * in.row(rows[k]);
  }

  /// Half a body carries only loads that are symmetric about y = 0.
  bool carries(int component, int power_of_y) const {
    return !half || (power_of_y % 2 == 1) == (component == 1);
  }

  /// Coefficients of u_x, u_y, u_n, whose values at the elements follow one after the other.
  Eigen::VectorXd fitted(const Eigen::Ref<const Eigen::VectorXd>& displacement) const {
    const MatrixXd columns = displacement.reshaped(grid.size(), 3);
    return MatrixXd(fit.solve(weight.asDiagonal() * columns)).reshaped();
  }

  ContactGrid grid;
  bool half;
  ArcLength arc;
  SmoothBox loads, fields, below;
  double deep = 0.0;  ///< mm, depth of the stress map
  FlatLoads flat;
  MatrixXd in, out;
  Field ellipsoid;
  Field weight;  ///< of the elements in the displacement fit
  Eigen::ColPivHouseholderQR<MatrixXd> fit;
  Eigen::ColPivHouseholderQR<MatrixXd> moments;  ///< of the tractions, by the polynomials
};

/// A body and its twin, both under load. `boxes`: the scene of the twin, meshed with the body's
/// cells under the patch.
struct Pair {
  Pair(const Scene& scene, const Scene& boxes, const RunLayout& layout, const Body& the_body)
      : body(the_body),
        twin(flat_twin(body.shape(), scene.geometry.surface,
                       std::abs(layout.bodies.middle) + layout.bodies.reach_t()),
             body.material(), twin_options(boxes, layout, body), MPI_COMM_SELF),
        loaded(scene, body, layout.grid, false),
        flat(boxes, twin, layout.grid, true) {}

  static BodyOptions twin_options(const Scene& boxes, const RunLayout& layout, const Body& body) {
    BodyOptions options = fem::run_layout(boxes, layout.bodies.cell_size).bodies;
    options.half = body.options().half;
    return options;
  }

  const Body& body;
  Body twin;
  SolvedBody loaded;
  SolvedBody flat;
};

/// Coefficients of body less twin, one column for each traction.
struct Responses {
  MatrixXd surface;
  MatrixXd below;  ///< empty: not requested
};

Responses responses(const Basis& basis, Pair& pair, const BelowParts* below) {
  const double sign = pair.body.shape().is_wheel ? 1.0 : -1.0;
  const auto powers = polynomial_powers(load_degree);
  const Index ins = basis.in.cols();
  Responses result;
  result.surface = MatrixXd::Zero(3 * basis.out.cols(), 3 * ins);
  if (below != nullptr) result.below = MatrixXd::Zero(below->terms(), 3 * ins);
  const Field none = Field::Zero(basis.grid.size());
  for (int component = 0; component < 3; ++component) {
    std::vector<Index> shapes;
    std::vector<SurfaceField> tractions;
    for (Index k = 0; k < ins; ++k) {
      if (!basis.carries(component, powers[static_cast<std::size_t>(k)][1])) continue;
      shapes.push_back(k);
      SurfaceField& traction = tractions.emplace_back(SurfaceField{none, none, none});
      Field* const loaded[] = {&traction.x, &traction.y, &traction.n};
      *loaded[component] = sign * basis.ellipsoid.cwiseProduct(basis.in.col(k));
    }
    std::vector<SurfaceField> curved, flat;
    contact::for_each_index(2, [&](std::size_t twin) {
      (twin == 0 ? curved : flat) = (twin == 0 ? pair.loaded : pair.flat).under(tractions);
    });
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      const Index column = component * ins + shapes[j];
      Field difference(3 * basis.grid.size());
      difference << curved[j].x - flat[j].x, curved[j].y - flat[j].y, curved[j].n - flat[j].n;
      result.surface.col(column) = sign * basis.fitted(difference);
      if (below != nullptr)
        result.below.col(column) = below->fitted(
            below->beyond(component, shapes[j], pair.loaded.displacement(j, tractions[j]),
                          pair.flat.displacement(j, tractions[j])));
    }
  }
  return result;
}

/// On the surface of a body that is itself a half-space.
MatrixXd half_space_responses(const Scene& scene, const Basis& basis, bool wheel) {
  const auto fields = beyond_flat_body(scene, wheel, basis.grid, basis.arc,
                                       basis.ellipsoid.asDiagonal() * basis.in);
  const Index ins = basis.in.cols();
  MatrixXd result(3 * basis.out.cols(), 3 * ins);
  for (Index component = 0; component < 3; ++component)
    for (Index k = 0; k < ins; ++k)
      result.col(component * ins + k) =
          basis.fitted(fields[static_cast<std::size_t>(component)].col(k));
  return result;
}

/// Converts responses to tractions into responses to their moments, whose matrix is symmetric.
MatrixXd of_moments(const Basis& basis, const MatrixXd& of_loads) {
  const Index ins = basis.in.cols();
  MatrixXd result(of_loads.rows(), of_loads.cols());
  for (int component = 0; component < 3; ++component)
    result.middleCols(component * ins, ins) =
        basis.moments.solve(of_loads.middleCols(component * ins, ins).transpose()).transpose();
  return result;
}

/// `coordinates`: coordinates of the body for stresses; null: no stresses requested.
void find_maps(const Basis& basis, Pair& pair, const contact::BelowSurface* coordinates,
               SmoothMap& map, SmoothDepthMap& map_below) {
  std::optional<BelowParts> below;
  if (coordinates != nullptr)
    below.emplace(*coordinates, pair.body, pair.twin, basis.flat, basis.below, basis.deep);
  const Responses found = responses(basis, pair, below ? &*below : nullptr);
  map = {basis.loads, basis.fields, load_degree, field_degree, of_moments(basis, found.surface)};
  if (below)
    map_below = {
        {basis.loads, basis.below, load_degree, below->degree(), of_moments(basis, found.below)},
        below->depth()};
}

/// Below its surface, a body that is a half-space is evaluated at the common surface, with a mesh.
bool needs_mesh(const Scene& scene, bool wheel, bool stresses) {
  return stresses || !is_half_space(scene, wheel);
}

/// The part of a body that needs no mesh.
void add_half_space(const Scene& scene, const Basis& basis, bool wheel, SmoothMap& map,
                    std::vector<contact::Note>& notes) {
  if ((wheel ? scene.wheel : scene.rail).material.rigid()) return;
  map = {basis.loads, basis.fields, load_degree, field_degree,
         of_moments(basis, half_space_responses(scene, basis, wheel))};
  contact::add_note(notes, fmt::format("flat_{}", wheel ? "wheel" : "rail"),
                    "the {} is flat: a half-space, which is not meshed", wheel ? "wheel" : "rail");
}

void check(const Scene& scene) {
  const auto refuse = [&](bool asked, const char* what, const char* allowed) {
    if (!asked) return;
    throw contact::InputError(
        scene.where(), "model hybrid: it cannot handle {}; allowed: {}; do: run with --model fem",
        what, allowed);
  };
  refuse(!scene.geometry.has_surfaces(), "undeformed_distance, which describes no bodies",
         "radii or profiles");
  refuse(scene.asks_for_stress() && !has_boxes(scene),
         "subsurface stresses with your own meshes or gmsh meshes",
         "subsurface stresses in bodies that are boxes under their surface");
}

}  // namespace

SmoothParts find_smooth_parts(const Scene& scene, const contact::Progress& progress) {
  return find_smooth_parts_with(usual_cells_in_semi_axis, scene, progress);
}

SmoothParts find_smooth_parts_with(double cells_in_semi_axis, const Scene& asked,
                                   const contact::Progress& progress) {
  check(asked);
  const Scene scene = correction_scene(asked);
  contact::ProgressEvent event;
  event.model = "hybrid";
  event.stage = "correction";
  contact::report(progress, event);
  const double cell = halfspace::PatchSearch(scene).box().smaller() / cells_in_semi_axis /
                      (fem::options_of(scene).degree == 1 ? times_cells_of_degree_one : 1.0);
  const RunLayout layout = fem::run_layout(scene, cell);
  const Basis basis(scene, layout);
  SmoothParts parts;
  parts.stresses = asked.asks_for_stress();
  const fem::MeshedBodies meshed{needs_mesh(scene, true, parts.stresses),
                                 needs_mesh(scene, false, parts.stresses)};
  const fem::CaseBodies bodies = fem::make_bodies(scene, layout.bodies, MPI_COMM_SELF, meshed);
  std::optional<Pair> wheel, rail;
  const Scene boxes = with_boxes(scene);
  if (bodies.wheel) wheel.emplace(scene, boxes, layout, *bodies.wheel);
  if (bodies.rail) rail.emplace(scene, boxes, layout, *bodies.rail);
  std::vector<SolvedBody*> loaded;
  for (auto* pair : {&wheel, &rail})
    if (*pair) loaded.insert(loaded.end(), {&(*pair)->loaded, &(*pair)->flat});
  contact::for_each_index(loaded.size(), [&](std::size_t k) { loaded[k]->prepare(); });
  const contact::ChartedGeometry geometry(scene.geometry, contact::Chart::arc);
  const contact::BelowSurface in_wheel(geometry, true), in_rail(geometry, false);
  contact::for_each_index(2, [&](std::size_t body) {
    if (body == 0 && wheel)
      find_maps(basis, *wheel, parts.stresses ? &in_wheel : nullptr, parts.wheel,
                parts.wheel_below);
    if (body == 1 && rail)
      find_maps(basis, *rail, parts.stresses ? &in_rail : nullptr, parts.rail, parts.rail_below);
  });
  for (const Body* body : bodies.both())
    if (body != nullptr) parts.unknowns += static_cast<long>(body->unknowns());
  parts.notes = bodies.notes;
  if (!meshed.wheel) add_half_space(scene, basis, true, parts.wheel, parts.notes);
  if (!meshed.rail) add_half_space(scene, basis, false, parts.rail, parts.notes);
  event.note = fmt::format("cells of {:.3g} mm, {} unknowns, twice", cell, parts.unknowns);
  event.finished = true;
  contact::report(progress, event);
  return parts;
}

}  // namespace rollfem::hybrid
