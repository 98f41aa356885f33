// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction/flat_twin.hpp"

#include <cmath>
#include <memory>

namespace rollfem::hybrid {

namespace {

/// Points of the table from the middle to either end, with cubics between them.
constexpr int knots_per_side = 800;

}  // namespace

ArcLength::ArcLength(const contact::ContactSurface& surface, double reach) {
  // Three Gauss points for each piece.
  const double offset = std::sqrt(0.6);
  const double step = reach / knots_per_side;
  const auto density = [&](double y) { return contact::stretch_of(surface.climb(y)); };
  const auto piece = [&](double middle) {
    return step / 18.0 *
           (5.0 * density(middle - 0.5 * offset * step) + 8.0 * density(middle) +
            5.0 * density(middle + 0.5 * offset * step));
  };
  std::vector<contact::HeightKnot> arc(2 * knots_per_side + 1);
  for (int k = 0; k <= 2 * knots_per_side; ++k) {
    arc[k].y = (k - knots_per_side) * step;
    arc[k].slope = density(arc[k].y);
  }
  for (int k = knots_per_side; k < 2 * knots_per_side; ++k)
    arc[k + 1].z = arc[k].z + piece(arc[k].y + 0.5 * step);
  for (int k = knots_per_side; k > 0; --k) arc[k - 1].z = arc[k].z - piece(arc[k].y - 0.5 * step);
  arc_ = contact::HeightCurve(std::move(arc));
}

double ArcLength::at(double y) const {
  return arc_.at(y).value;
}

double ArcLength::place(double arc) const {
  double y = arc;
  for (int step = 0; step < 50; ++step) {
    const auto value = arc_.at(y);
    const double change = (value.value - arc) / value.slope;
    y -= change;
    if (std::abs(change) < 1e-13 * (1.0 + std::abs(y))) break;
  }
  return y;
}

fem::SurfaceShape flat_twin(const fem::SurfaceShape& shape, const contact::ContactSurface& surface,
                            double reach) {
  const auto arc = std::make_shared<ArcLength>(surface, reach);
  const double inwards = shape.is_wheel ? 1.0 : -1.0;
  auto chart = std::make_shared<fem::ChartFunctions>();
  chart->place = [arc, inwards](const dealii::Point<3>& at) {
    return dealii::Point<3>(at[0], arc->at(at[1]), inwards * at[2]);
  };
  chart->coordinates = [arc, inwards](const dealii::Point<3>& at) {
    return dealii::Point<3>(at[0], arc->place(at[1]), inwards * at[2]);
  };
  chart->frame = [](double, double) {
    std::array<dealii::Tensor<1, 3>, 3> axes;
    for (unsigned int k = 0; k < 3; ++k) axes[k][k] = 1.0;
    return axes;
  };
  fem::SurfaceShape twin;
  twin.is_wheel = shape.is_wheel;
  twin.functions = chart;
  return twin;
}

bool has_boxes(const contact::Scene& scene) {
  return scene.wheel.mesh.empty() && scene.rail.mesh.empty() &&
         fem::options_of(scene).mesh != fem::MeshFamily::gmsh;
}

contact::Scene with_boxes(const contact::Scene& scene) {
  contact::Scene boxes = scene;
  if (has_boxes(scene)) return boxes;
  boxes.wheel.mesh.clear();
  boxes.rail.mesh.clear();
  auto& options = boxes.options.set<fem::FemOptions>();
  options.mesh = fem::MeshFamily::structured;
  options.depth.reset();
  options.far_boundary.reset();
  return boxes;
}

}  // namespace rollfem::hybrid
