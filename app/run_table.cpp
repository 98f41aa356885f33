#include "app/run_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rollfem::app {

namespace {

using contact::ModelResult;
using contact::PointResult;

/// Hertz and other theories of the normal problem alone have no creep curve.
bool has_friction(const ModelResult& model) {
  return std::any_of(model.points.begin(), model.points.end(),
                     [](const PointResult& point) { return point.max_traction > 0.0; });
}

bool any_creepage(const std::vector<PointResult>& points, double contact::Creepage::*member) {
  return std::any_of(points.begin(), points.end(),
                     [&](const PointResult& point) { return point.creepage.*member != 0.0; });
}

/// At the largest load, which is that of all points but in a history.
std::string patch_table(const std::vector<ModelResult>& models) {
  std::string text =
      fmt::format("{:<19}{:>12}{:>10}{:>10}{:>15}{:>10}{:>10}\n", "model", "p0 in MPa", "a in mm",
                  "b in mm", "approach in mm", "F_z in N", "seconds");
  for (const ModelResult& model : models) {
    if (model.points.empty()) continue;
    const PointResult& point = *std::max_element(
        model.points.begin(), model.points.end(), [](const PointResult& a, const PointResult& b) {
          return a.normal_force < b.normal_force * (1.0 - 1e-9);
        });
    const auto seconds = model.seconds.find("total");
    text +=
        fmt::format("{:<19}{:>12.3f}{:>10.4f}{:>10.4f}{:>15.7f}{:>10.6g}{:>10.2f}\n", model.name,
                    point.max_pressure, point.semi_axis_x, point.semi_axis_y, point.approach,
                    point.normal_force, seconds == model.seconds.end() ? 0.0 : seconds->second);
  }
  return text;
}

/// Columns are wide enough for the name over them.
std::size_t width_of(const ModelResult& model) {
  return std::max<std::size_t>(12, model.name.size() + 2);
}

/// One row a load point, one column a model.
template <class Quantity>
std::string curve_table(const std::vector<const ModelResult*>& models, const std::string& heading,
                        const Quantity& quantity) {
  const auto& points = models.front()->points;
  const bool steps = points.front().step > 0;
  const bool lateral = any_creepage(points, &contact::Creepage::lateral);
  const bool spin = any_creepage(points, &contact::Creepage::spin);
  std::string text = fmt::format("\n{}\n{:<12}", heading, steps ? "step" : "xi");
  if (lateral) text += fmt::format("{:<12}", "eta");
  if (spin) text += fmt::format("{:<12}", "phi");
  for (const ModelResult* model : models)
    text += fmt::format("{:>{}}", model->name, width_of(*model));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const contact::Creepage& creepage = points[k].creepage;
    text += fmt::format("\n{:<12g}", steps ? points[k].step : creepage.longitudinal);
    if (lateral) text += fmt::format("{:<12g}", creepage.lateral);
    if (spin) text += fmt::format("{:<12g}", creepage.spin);
    for (const ModelResult* model : models) {
      if (k >= model->points.size()) {
        text += fmt::format("{:>{}}", "-", width_of(*model));
        continue;
      }
      // Rounding must not print as -0.00000.
      const double value = quantity(model->points[k]);
      text += fmt::format("{:>{}.5f}", std::abs(value) < 5e-6 ? 0.0 : value, width_of(*model));
    }
  }
  return text + "\n";
}

}  // namespace

std::string run_table(const std::vector<ModelResult>& models) {
  std::string text = patch_table(models);
  std::vector<const ModelResult*> with_friction;
  for (const ModelResult& model : models)
    if (has_friction(model)) with_friction.push_back(&model);
  if (with_friction.empty()) return text;
  text += curve_table(with_friction, "traction coefficient -F_x/F_z (forces on the wheel)",
                      [](const PointResult& point) { return point.traction_coefficient; });
  const auto& points = with_friction.front()->points;
  if (any_creepage(points, &contact::Creepage::lateral) ||
      any_creepage(points, &contact::Creepage::spin))
    text += curve_table(
        with_friction, "lateral coefficient -F_y/F_z (forces on the wheel)",
        [](const PointResult& point) { return -point.lateral_force / point.normal_force; });
  return text;
}

}  // namespace rollfem::app
