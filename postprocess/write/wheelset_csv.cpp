#include "contact/result/quantities.hpp"
#include "postprocess/write/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::postprocess {

namespace {

using contact::ModelResult;
using contact::PointResult;

/// What the patches of one wheel come to.
struct Wheel {
  const ModelResult* main = nullptr;  ///< the most loaded patch
  int patches = 0;
  double vertical_force = 0.0;      ///< N
  double longitudinal_force = 0.0;  ///< N
  double lateral_force = 0.0;       ///< N, on the wheel along y of the track: to the right
  double area = 0.0;                ///< mm^2
  double max_pressure = 0.0;        ///< MPa
};

/// Of the wheel along y of the track, with the patch's y and normal tilted by the contact angle
/// (docs/track.md: y of a left patch points to the field, of a right one to the middle).
double force_to_the_right(const contact::ContactPlace& place, const PointResult& point) {
  const double sine = std::sin(place.contact_angle);
  const double cosine = std::cos(place.contact_angle);
  const double tilt = place.left ? 1.0 : -1.0;
  return -point.lateral_force * cosine + tilt * point.normal_force * sine;
}

Wheel wheel_at(const RunRecord& run, const std::string& model, bool left, int position,
               std::size_t k) {
  Wheel wheel;
  for (const ModelResult& patch : run.models) {
    if (!patch.place || patch.name != model || patch.place->left != left ||
        patch.place->position != position || k >= patch.points.size())
      continue;
    const PointResult& point = patch.points[k];
    ++wheel.patches;
    wheel.vertical_force += contact::quantity_named("vertical_force").value(point).value_or(0.0);
    wheel.longitudinal_force += point.longitudinal_force;
    wheel.lateral_force += force_to_the_right(*patch.place, point);
    wheel.area += point.contact_area;
    wheel.max_pressure = std::max(wheel.max_pressure, point.max_pressure);
    if (!wheel.main || point.normal_force > wheel.main->points[k].normal_force) wheel.main = &patch;
  }
  return wheel;
}

std::string wheel_cells(const Wheel& wheel, std::size_t k) {
  if (!wheel.main) return ",,,,,,,,,,";
  const PointResult& point = wheel.main->points[k];
  return fmt::format(",{},{},{},{},{},{},{},{},{},{}", wheel.patches,
                     wheel.main->place->rolling_radius, wheel.main->place->contact_angle,
                     point.contact_length, point.contact_width, wheel.area, wheel.max_pressure,
                     wheel.vertical_force, wheel.longitudinal_force, wheel.lateral_force);
}

std::string head() {
  std::string text = "position [-],lateral_shift [mm],yaw [rad],model,point";
  for (const char* wheel : {"left", "right"})
    for (const char* what :
         {"patches [-]", "rolling_radius [mm]", "contact_angle [rad]", "contact_length [mm]",
          "contact_width [mm]", "contact_area [mm2]", "max_pressure [MPa]", "vertical_force [N]",
          "longitudinal_force [N]", "lateral_force [N]"})
      text += fmt::format(",{} {}", wheel, what);
  return text +
         ",radius_difference [mm],rigid_radius_difference [mm],conicity_harmonic [-],conicity_wave "
         "[-]\n";
}

std::string number_or_nothing(const std::optional<double>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

}  // namespace

std::string wheelset_csv(const RunRecord& run) {
  if (run.wheelset.empty()) return {};
  std::vector<std::string> models;
  for (const ModelResult& model : run.models)
    if (std::find(models.begin(), models.end(), model.name) == models.end())
      models.push_back(model.name);
  std::string text = head();
  for (std::size_t p = 0; p < run.wheelset.size(); ++p)
    for (const std::string& model : models)
      for (std::size_t k = 0;; ++k) {
        const int position = static_cast<int>(p) + 1;
        const Wheel left = wheel_at(run, model, true, position, k);
        const Wheel right = wheel_at(run, model, false, position, k);
        if (!left.main && !right.main) break;
        const auto radius = [](const Wheel& wheel) {
          return wheel.main ? wheel.main->place->rolling_radius : NAN;
        };
        const double difference = radius(right) - radius(left);
        text += fmt::format("{},{},{},{},{}{}{},{}", position, run.input.wheelset.lateral_shift[p],
                            run.input.wheelset.yaw[p], model, k, wheel_cells(left, k),
                            wheel_cells(right, k),
                            std::isfinite(difference) ? fmt::format("{}", difference) : "");
        const WheelsetGeometry& geometry = run.wheelset[p];
        text += fmt::format(",{}{}{}\n", geometry.radius_difference,
                            number_or_nothing(geometry.conicity_harmonic),
                            number_or_nothing(geometry.conicity_wave));
      }
  return text;
}

}  // namespace rollfem::postprocess
