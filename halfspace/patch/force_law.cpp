#include "halfspace/patch/force_law.hpp"

#include "contact/base/count.hpp"
#include "contact/result/result.hpp"
#include "halfspace/elasticity/compliance.hpp"
#include "halfspace/elasticity/loads_beside.hpp"
#include "halfspace/patch/ridge.hpp"
#include "halfspace/patch/scene_chart.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;

namespace {

/// Elements along x, and along y over what overlaps.
constexpr int elements_of_law = 50;
/// Elements along y at most, in times of that: gaps between patches have as many as patches.
constexpr double most_gaps = 24.0;
/// Of the point loads that stand for a pressure.
constexpr int blocks_along = 5, blocks_across = 10;

ContactGrid grid_over(const Overlap& overlap, const contact::ChartedGeometry& geometry) {
  const Box& box = overlap.box;
  double steepest = 0.0;
  for (const RidgeRegion& region : overlap.regions)
    for (const double y : {region.y_lower, region.y_upper})
      steepest = std::max(steepest, std::abs(geometry.climb(y)));
  // On a curved surface y is the arc length, longer than its projection.
  const double stretch = contact::stretch_of(steepest);
  const auto on_surface = [&](double y, bool outward) {
    return outward == (y > 0.0) ? stretch * y : y;
  };
  const double y_lower = on_surface(box.y_lower, false);
  const double y_upper = on_surface(box.y_upper, true);
  const double times = std::clamp((y_upper - y_lower) / overlap.covered(), 1.0, most_gaps);
  const int ny =
      contact::count_of(std::ceil(elements_of_law * times - 1e-9), "elements of a force law");
  const double dx = (box.x_upper - box.x_lower) / elements_of_law, dy = (y_upper - y_lower) / ny;
  return {elements_of_law, ny, dx, dy, box.x_lower + 0.5 * dx, y_lower + 0.5 * dy};
}

}  // namespace

ForceLaw::ForceLaw(const contact::Scene& scene, const std::array<double, 2>& direction,
                   double largest_approach)
    : material_(scene.material.uncoupled()) {
  const Overlap overlap = Ridge(*scene.geometry.surface.profiles).overlap(largest_approach);
  if (overlap.regions.empty()) return;
  const contact::ChartedGeometry geometry = halfspace_geometry(scene);
  const ContactGrid grid = grid_over(overlap, geometry);
  compliance_ = std::make_unique<HalfspaceCompliance>(grid, material_);
  distance_ = geometry.undeformed_distance(grid);
  problem_.shape = geometry.shape(grid);
  problem_.frame = contact::vertical_frame(problem_.shape, direction);
  problem_.load.direction = direction;
}

void ForceLaw::press(double approach, const std::vector<contact::LoadBeside>& beside) {
  force_ = {};
  if (!compliance_) return;
  const ContactGrid& grid = compliance_->grid();
  problem_.undeformed_distance = distance_;
  if (!beside.empty()) problem_.undeformed_distance += displacement_beside(beside, material_, grid);
  problem_.load.approach = approach;
  const double along_z = problem_.load.direction[1];
  const double opening =
      problem_.frame.plane()
          ? problem_.undeformed_distance.minCoeff()
          : along_z *
                problem_.undeformed_distance.cwiseProduct(problem_.frame.to_vertical).minCoeff();
  if (!(approach > opening)) return;
  pressure_ = contact::press_standin(compliance_->normal(), problem_, pressure_).pressure;
  const Field none = Field::Zero(grid.size());
  const auto force = contact::transmitted_force(grid, {none, none, pressure_}, problem_.shape);
  force_ = {force[1], force[2]};
}

std::vector<contact::LoadBeside> ForceLaw::point_loads() const {
  std::vector<contact::LoadBeside> loads;
  if (!(force_[1] > 0.0)) return loads;
  const ContactGrid& grid = compliance_->grid();
  const auto step = [](int count, int blocks) { return (count + blocks - 1) / blocks; };
  const int di = step(grid.nx, blocks_along), dj = step(grid.ny, blocks_across);
  for (int j0 = 0; j0 < grid.ny; j0 += dj)
    for (int i0 = 0; i0 < grid.nx; i0 += di) {
      contact::LoadBeside load;
      for (int j = j0; j < std::min(j0 + dj, grid.ny); ++j)
        for (int i = i0; i < std::min(i0 + di, grid.nx); ++i) {
          const double force = pressure_[grid.index(i, j)] * grid.element_area();
          load.normal += force;
          load.x += force * grid.x(i);
          load.y += force * grid.y(j);
        }
      if (!(load.normal > 0.0)) continue;
      load.x /= load.normal;
      load.y /= load.normal;
      loads.push_back(load);
    }
  return loads;
}

}  // namespace rollfem::halfspace
