// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/stress/stress_output.hpp"

#include "base/errors.hpp"
#include "base/root.hpp"
#include "fem/stress/body_nodes.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "fem/stress/surface_stress.hpp"
#include "halfspace/stress/subsurface.hpp"
#include "result/bars.hpp"
#include "result/stress_extremes.hpp"
#include "result/stress_measures.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rollfem::fem {

namespace {

using contact::StressMaximum;
using contact::SubsurfaceField;
using contact::SubsurfaceRequest;
using contact::ValueAt;

/// Signs of the mirror image at -y: u_x u_y u_z; xx yy zz; xy yz xz.
constexpr std::array<int, 3> displacement_mirror{1, -1, 1};
constexpr std::array<int, 3> direct_mirror{1, 1, 1};
constexpr std::array<int, 3> shear_mirror{-1, -1, 1};

/// Where "below the surface" begins, in sizes of a cell: nearer the surface the nodal field is that
/// of the surface.
constexpr double least_depth = 0.4;

/// Up to here, in sizes of a cell, the largest stress converges as slowly as on the surface.
constexpr double near_surface = 0.5;

std::vector<Place> places_of(const SubsurfaceRequest& request, const SurfaceShape& shape) {
  std::vector<Place> places = halfspace::subsurface_points(request);
  if (request.kind == SubsurfaceRequest::Kind::surface)
    for (Place& p : places) p = place_below(shape, p[0], p[1], request.depth);
  return places;
}

[[noreturn]] void refuse_point(const contact::Scene& scene, std::size_t request, const Place& place,
                               const Body& body, double reach) {
  const bool wheel = scene.subsurface[request].wheel;
  const dealii::Point<3> chart =
      body.shape().coordinates(dealii::Point<3>(place[0], place[1], place[2]));
  const double extent = body.options().extent;
  const bool above = chart[2] < 0.0 && std::max(std::abs(chart[0]), std::abs(chart[1])) <= extent;
  const std::string where = above ? fmt::format("{:.4g} mm above its surface", -chart[2])
                                  : fmt::format(
                                        "beyond the segment, which extends {:.4g} mm along, across "
                                        "and down from the middle of the patch",
                                        extent);
  throw contact::InputError(
      scene.where(),
      "[[subsurface.{}]] (request {} of the case): ({:.6g}, {:.6g}, {:.6g}) mm is not in the {}, "
      "but {}; allowed: points of the segment, at most {:.3g} mm (one finite element) above a "
      "curved surface, which are moved onto it; do: {}",
      word_of(scene.subsurface[request].kind), request + 1, place[0], place[1], place[2],
      wheel ? "wheel" : "rail", where, reach,
      above ? "move the points into the body, or follow its surface with [[subsurface.surface]]"
            : "request closer points, or give a larger [fem] extent");
}

/// The nodes of a body on the potential contact area, where half of the stress is known: the
/// recovered one is too far off there to search for the largest.
class SurfaceNodes {
 public:
  SurfaceNodes(const Body& body, const BodyLocator& locator, const StressRecovery& recovery,
               const contact::ContactGrid& grid, const contact::ContactSurface& surface)
      : recovery_(recovery), own_(recovery.nodes([&](const Place& p) {
          const auto chart = body.shape().coordinates({p[0], p[1], p[2]});
          return std::abs(chart[2]) <= surface_depth * body.options().cell_size &&
                 chart[0] >= grid.x(0) && chart[0] <= grid.x(grid.nx - 1) &&
                 chart[1] >= grid.y(0) && chart[1] <= grid.y(grid.ny - 1);
        })) {
    std::vector<Place> places;
    for (const auto& node : own_) places.push_back(node.place);
    const MPI_Comm communicator = body.dofs().get_communicator();
    const unsigned int me = dealii::Utilities::MPI::this_mpi_process(communicator);
    std::vector<Place> all;
    const auto of_processes = dealii::Utilities::MPI::all_gather(communicator, places);
    for (unsigned int process = 0; process < of_processes.size(); ++process) {
      if (process == me) first_ = all.size();
      all.insert(all.end(), of_processes[process].begin(), of_processes[process].end());
    }
    points_ = locator.find(all, surface_depth * body.options().cell_size);
    stress_.emplace(body, locator, points_, grid, surface);
  }

  /// Collective.
  void correct(const Vector& displacement, const contact::SurfaceField& traction,
               NodalStress& stress) const {
    auto known = stress_at(points_, stress);
    stress_->combine(displacement, traction, known);
    const auto mine = known.begin() + static_cast<std::ptrdiff_t>(first_);
    recovery_.replace(own_, {mine, mine + static_cast<std::ptrdiff_t>(own_.size())}, stress);
  }

 private:
  const StressRecovery& recovery_;
  std::vector<StressRecovery::Node> own_;
  std::size_t first_ = 0;  ///< of own_ among those of all processes
  BodyPoints points_;      ///< of all processes
  std::optional<SurfaceStress> stress_;
};

}  // namespace

std::vector<contact::SymmetricTensor> stress_at(const BodyPoints& points,
                                                const NodalStress& stress) {
  const auto direct = points.values(stress.direct, direct_mirror);
  const auto shear = points.values(stress.shear, shear_mirror);
  std::vector<contact::SymmetricTensor> result;
  for (std::size_t k = 0; k < points.size(); ++k)
    result.push_back(
        {direct[k][0], direct[k][1], direct[k][2], shear[k][0], shear[k][1], shear[k][2]});
  return result;
}

Place place_below(const SurfaceShape& shape, double x, double y, double depth) {
  const double on_surface = shape.streamline_radius(y);
  // Depth is along z, which is not perpendicular to a tilted axle.
  const double inwards = shape.is_wheel ? depth : -depth;
  const double radius = on_surface - inwards * shape.axle().cosine;
  double arc = x;
  if (shape.is_revolved()) {
    if (!(std::abs(x) < std::abs(radius)))
      throw contact::InputError(
          fmt::format("[[subsurface.surface]]: the {} does not reach x = {} mm",
                      shape.is_wheel ? "wheel" : "roller", x));
    arc = on_surface * std::asin(x / radius);
  }
  const auto place = shape.place(arc, y, depth);
  return {place[0], place[1], place[2]};
}

struct StressOutput::Implementation {
  /// A body with its requests.
  struct Part {
    Part(const Body& the_body, const std::string& the_name)
        : body(the_body), name(the_name), recovery(the_body), locator(the_body) {}
    const Body& body;
    std::string name;
    StressRecovery recovery;
    BodyLocator locator;
    std::optional<SurfaceNodes> skin;
    std::vector<std::size_t> requests;   ///< of the case
    std::vector<BodyPoints> points;      ///< of each
    std::vector<SurfaceStress> surface;  ///< of each
    std::unique_ptr<BodyNodes> nodes;    ///< for load points that store nodal values
  };

  Implementation(const contact::Scene& the_input, const BodyPair& bodies,
                 const contact::ContactGrid& the_grid, double reach, bool fields)
      : scene(the_input), grid(the_grid), maxima(the_input.output.stress_maxima), keeps(fields) {
    const std::size_t last = count() - 1;
    if (!wanted(last)) return;
    for (std::size_t b = 0; b < 2; ++b) {
      if (bodies[b] == nullptr) continue;
      parts[b] = std::make_unique<Part>(*bodies[b], body_names[b]);
      parts[b]->skin.emplace(*bodies[b], parts[b]->locator, parts[b]->recovery, grid,
                             scene.geometry.surface);
      if (keeps_bodies(last))
        parts[b]->nodes = std::make_unique<BodyNodes>(*bodies[b], body_names[b]);
    }
    for (std::size_t k = 0; k < scene.subsurface.size(); ++k) {
      Part& part = *parts[scene.subsurface[k].wheel ? 0 : 1];
      const auto places = places_of(scene.subsurface[k], part.body.shape());
      part.requests.push_back(k);
      part.points.push_back(part.locator.find(places, reach));
      for (std::size_t p = 0; p < places.size(); ++p)
        if (!std::isfinite(part.points.back().moved(p)))
          refuse_point(scene, k, places[p], part.body, reach);
      part.surface.emplace_back(part.body, part.locator, part.points.back(), grid,
                                scene.geometry.surface);
    }
  }

  std::size_t count() const { return scene.points.size(); }
  bool keeps_bodies(std::size_t k) const { return keeps && scene.output.keeps_bodies(k, count()); }
  bool wanted(std::size_t k) const { return scene.asks_for_stress() || keeps_bodies(k); }

  static contact::BodyValues values(const Part& part, const Vector& displacement,
                                    const NodalStress& stress, const Vector* expansion,
                                    const YieldedFields* yielded) {
    if (expansion == nullptr) return part.nodes->values(displacement, stress, yielded);
    Vector total(displacement);
    total += *expansion;
    total.update_ghost_values();
    NodalStress sum = part.recovery.recover(*expansion);
    add(1.0, stress, sum);
    return part.nodes->values(total, sum);
  }

  void fill_part(const Part& part, const Vector& displacement, const Vector* expansion,
                 const YieldedFields* yielded, bool keep, contact::PointResult& point) const {
    NodalStress stress = part.recovery.recover(displacement);
    point.error_estimate[fmt::format("energy_norm_{}", part.name)] =
        energy_error(part.body, displacement, stress).relative();
    if (yielded != nullptr)
      add(-1.0, yielded->excess, stress);
    else
      part.skin->correct(displacement, point.fields.traction, stress);
    if (keep) point.bodies.push_back(values(part, displacement, stress, expansion, yielded));
    for (std::size_t k = 0; k < part.requests.size(); ++k) {
      const BodyPoints& points = part.points[k];
      SubsurfaceField& field = point.subsurface[part.requests[k]];
      field.request = scene.subsurface[part.requests[k]];
      for (std::size_t p = 0; p < points.size(); ++p) field.points.push_back(points.place(p));
      field.displacement = points.values(displacement, displacement_mirror);
      field.stress = stress_at(points, stress);
      // From the strain along the surface by Hooke's law.
      if (yielded == nullptr)
        part.surface[k].combine(displacement, point.fields.traction, field.stress);
    }
    if (!maxima) return;
    const auto starts = largest_at_nodes(part, stress);
    for (std::size_t m = 0; m < starts.size(); ++m) {
      const StressMaximum found = refined(part, stress, m, starts[m]);
      if (depth_of(part, found.place) < near_surface * starts[m].size)
        point.no_bar[found.bar_name()] = contact::NoBar::near_surface;
      point.stress_maxima.push_back(found);
    }
    point.stress_maxima.push_back(contact::largest_surface_shear(part.name, grid, point));
    point.stress_maxima.push_back(xz_range(part, stress, point));
  }

  static StressMaximum xz_range(const Part& part, const NodalStress& stress,
                                const contact::PointResult& point) {
    // Only the first process knows the patch.
    const auto known = dealii::Utilities::MPI::broadcast(
        part.body.dofs().get_communicator(),
        std::vector<double>{point.semi_axis_x, point.semi_axis_y,
                            point.patch_x_middle.value_or(0.0), point.patch_y_middle.value_or(0.0)},
        0);
    contact::PointResult patch;
    patch.semi_axis_x = known[0];
    patch.semi_axis_y = known[1];
    patch.patch_x_middle = known[2];
    patch.patch_y_middle = known[3];
    const double step = contact::rolling_step(patch);
    const auto lines = contact::rolling_lines(
        patch, step, contact::rolling_layers,
        [&](double x, double y, double z) { return place_below(part.body.shape(), x, y, z); });
    std::vector<double> xz;
    for (const auto& value : stress_at(part.locator.find(lines.places, step), stress))
      xz.push_back(value[contact::component::xz]);
    return contact::largest_xz_range(part.name, lines, xz);
  }

  /// Depth below the surface of the body, which may be curved.
  static double depth_of(const Part& part, const Place& place) {
    return part.body.shape().coordinates({place[0], place[1], place[2]})[2];
  }

  /// The node with the largest value of each measure, and the size of its cell in mm. Of equal
  /// values, as with symmetry, the node with the largest x, then y, so that the result is the same
  /// on any number of processes.
  struct Start {
    ValueAt best{-contact::infinity, {}};
    double size = 0.0;
    template <class Archive>
    void serialize(Archive& archive, unsigned int /*version*/) {
      archive& best.value& best.place& size;
    }
    bool loses_to(const Start& other) const {
      const double tie = 1e-7 * std::abs(best.value);
      if (std::abs(other.best.value - best.value) > tie || !std::isfinite(best.value))
        return other.best.value > best.value;
      return other.best.place > best.place;
    }
  };

  static std::vector<Start> largest_at_nodes(const Part& part, const NodalStress& stress) {
    const auto& measures = contact::reported_measures();
    std::vector<Start> starts(measures.size());
    part.recovery.for_each_node(
        stress, [&](const Place& place, const contact::SymmetricTensor& value, double size) {
          const bool below = depth_of(part, place) > least_depth * size;
          for (std::size_t m = 0; m < measures.size(); ++m) {
            if (contact::only_below(measures[m]) && !below) continue;
            const Start here{{measures[m].value(value), place}, size};
            if (starts[m].loses_to(here)) starts[m] = here;
          }
        });
    const MPI_Comm communicator = part.body.dofs().get_communicator();
    for (const auto& other : dealii::Utilities::MPI::all_gather(communicator, starts))
      for (std::size_t m = 0; m < measures.size(); ++m)
        if (starts[m].loses_to(other[m])) starts[m] = other[m];
    return starts;
  }

  /// Searches between the nodes. Points above the surface are moved onto it, so that a maximum on a
  /// curved surface is followed along it.
  static StressMaximum refined(const Part& part, const NodalStress& stress, std::size_t measure,
                               const Start& start) {
    const contact::StressMeasure& of = contact::reported_measures()[measure];
    const double step = 0.5 * start.size;
    const ValueAt best = contact::local_maximum(
        [&](const std::vector<Place>& places) {
          const BodyPoints points = part.locator.find(places, 2.0 * step);
          const auto values = stress_at(points, stress);
          std::vector<ValueAt> result;
          for (std::size_t k = 0; k < places.size(); ++k)
            result.push_back({std::isfinite(points.moved(k)) &&
                                      (!contact::only_below(of) ||
                                       depth_of(part, points.place(k)) > least_depth * start.size)
                                  ? of.value(values[k])
                                  : -contact::infinity,
                              points.place(k)});
          return result;
        },
        start.best, step);
    return {part.name, of.name, best.value, best.place};
  }

  const contact::Scene& scene;
  contact::ContactGrid grid;
  bool maxima;
  bool keeps;
  std::array<std::unique_ptr<Part>, 2> parts;  ///< wheel, rail; null: rigid, or nothing requested
};

StressOutput::StressOutput(const contact::Scene& scene, const BodyPair& bodies,
                           const contact::ContactGrid& grid, double reach, bool fields)
    : implementation_(std::make_unique<Implementation>(scene, bodies, grid, reach, fields)) {}

StressOutput::~StressOutput() = default;

bool StressOutput::wanted(std::size_t k) const {
  return implementation_->wanted(k);
}

void StressOutput::fill(std::size_t k, contact::PointResult& point,
                        const std::vector<Vector>& displacement, const Vector* expansion,
                        const std::array<const YieldedFields*, 2>& yielded) const {
  const Implementation& all = *implementation_;
  point.subsurface.resize(all.scene.subsurface.size());
  const bool keep = all.keeps_bodies(k);
  for (std::size_t b = 0; b < 2; ++b)
    if (all.parts[b])
      all.fill_part(*all.parts[b], displacement[b], b == 0 ? expansion : nullptr, yielded[b], keep,
                    point);
}

std::vector<contact::BodyField> StressOutput::bodies() const {
  std::vector<contact::BodyField> meshes;
  for (const auto& part : implementation_->parts)
    if (part && part->nodes) meshes.push_back(part->nodes->mesh());
  return meshes;
}

}  // namespace rollfem::fem
