// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/heat/temperature.hpp"

#include "base/pi.hpp"
#include "result/note.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace rollfem::contact {

namespace {

/// The step in which material has passed the element so many elements ahead; null: before all of
/// them.
std::vector<const HeatStep*> steps_met(const ContactGrid& grid, const HeatStep& now,
                                       const HeatPast& past) {
  constexpr double rounding = 1e-9;
  std::vector<const HeatStep*> met;
  const HeatStep* step = &now;
  double until = now.length;
  auto next = past.begin();
  for (int ahead = 0; ahead < grid.nx; ++ahead) {
    while (step != nullptr && ahead * grid.dx >= (1.0 - rounding) * until) {
      step = next == past.end() ? nullptr : &*next++;
      if (step != nullptr) until += step->length;
    }
    met.push_back(step);
  }
  return met;
}

/// Warming (SurfaceHeat::warming) of an element by the flows into one body through those ahead.
double warmed(const Field& warming, const std::vector<const HeatStep*>& met, Field HeatStep::*flows,
              Eigen::Index element) {
  double sum = 0.0;
  const auto row = static_cast<Eigen::Index>(met.size());
  for (Eigen::Index ahead = 1; ahead < row - element % row; ++ahead)
    if (const HeatStep* step = met[static_cast<std::size_t>(ahead)])
      sum += warming[ahead] * (step->*flows)[element + ahead];
  return sum;
}

/// Sets temperatures and flows (`now`) from the leading end of each row. `flow`: of friction. Where
/// the surfaces touch, what each takes follows from their equal temperatures: the heat of friction,
/// and what unlike bodies exchange.
void heat_rows(const ContactGrid& grid, const SurfaceHeat& heat, const Field& flow,
               const HeatPast& past, HeatStep& now, ContactFields& fields) {
  const Field warming = heat.warming(grid.dx, grid.nx);
  const double own = warming[0];
  const std::vector<const HeatStep*> met = steps_met(grid, now, past);
  for (Field* field : {&fields.temperature_wheel, &fields.temperature_rail})
    field->resize(grid.size());
  for (Field* flows : {&now.wheel, &now.rail}) flows->setZero(grid.size());
  const auto& [wheel, rail, speed] = heat;
  for (Eigen::Index k = grid.size(); k-- > 0;) {
    double& of_wheel = fields.temperature_wheel[k];
    double& of_rail = fields.temperature_rail[k];
    of_wheel = wheel.temperature + warmed(warming, met, &HeatStep::wheel, k) / wheel.effusivity;
    of_rail = rail.temperature + warmed(warming, met, &HeatStep::rail, k) / rail.effusivity;
    if (!(fields.traction.n[k] > 0.0)) continue;
    now.wheel[k] = (of_rail + own * flow[k] / rail.effusivity - of_wheel) /
                   (own / wheel.effusivity + own / rail.effusivity);
    now.rail[k] = flow[k] - now.wheel[k];
    of_wheel += own * now.wheel[k] / wheel.effusivity;
    of_rail = of_wheel;
  }
}

HeatStep heated(const ContactGrid& grid, const SurfaceHeat& heat, const Field& flow, double length,
                const HeatPast& past, PointResult& point) {
  HeatStep now{length, {}, {}};
  const ContactFields& fields = point.fields;
  heat_rows(grid, heat, flow, past, now, point.fields);
  const double per_length = grid.element_area() / heat.speed;
  point.heat_wheel = now.wheel.sum() * per_length;
  point.heat_rail = now.rail.sum() * per_length;
  Eigen::Index hottest = 0;
  const double highest = (fields.traction.n.array() > 0.0)
                             .select(fields.temperature_rail.array(), -HUGE_VAL)
                             .maxCoeff(&hottest);
  if (std::isinf(highest)) return now;
  point.max_temperature = highest;
  const auto k = static_cast<int>(hottest);
  point.max_temperature_x = grid.x(k % grid.nx);
  point.max_temperature_y = grid.y(k / grid.nx);
  return now;
}

}  // namespace

void set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, PointResult& point) {
  if (point.fields.work.size() == grid.size())
    heated(grid, heat, heat.speed * point.fields.work, HUGE_VAL, {}, point);
}

HeatStep set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, double length,
                          const HeatPast& past, PointResult& point) {
  const SurfaceField& traction = point.fields.traction;
  const TangentialField& slip = point.fields.slip;
  const Field work = -(traction.x.cwiseProduct(slip.x) + traction.y.cwiseProduct(slip.y));
  return heated(grid, heat, heat.speed * work.cwiseMax(0.0), length, past, point);
}

Field left_temperature(const ContactGrid& grid, const SurfaceHeat& heat, double length,
                       const HeatPast& past) {
  const Field warming = heat.warming(grid.dx, grid.nx), none = Field::Zero(grid.size());
  const HeatStep now{length, none, none};
  const std::vector<const HeatStep*> met = steps_met(grid, now, past);
  return Field::NullaryExpr(grid.size(), [&](Eigen::Index k) {
    return heat.contact_temperature() +
           (warmed(warming, met, &HeatStep::wheel, k) + warmed(warming, met, &HeatStep::rail, k)) /
               heat.effusivity();
  });
}

namespace {

/// K at a depth by a heat flow of 1 N/(mm s) through an element so many elements ahead: after it
/// has begun that of erfc.
Field warming_at(double depth, const ContactGrid& grid, const HeatedBody& body, double speed) {
  const double conductivity = body.effusivity * std::sqrt(body.diffusivity);
  Field found(2 * grid.nx + 1);
  double last = 0.0;
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    const double passed = (static_cast<double>(k) + 0.5) * grid.dx;
    const double length = 2.0 * std::sqrt(body.diffusivity * passed / speed), u = depth / length;
    const double next =
        length * (std::exp(-u * u) / std::sqrt(pi) - u * std::erfc(u)) / conductivity;
    found[k] = next - last;
    last = next;
  }
  return found;
}

/// The largest thermal stress at a surface in contact that stresses of the result leave out: the
/// material around a thin layer holds it, E alpha (T - T_0)/(1 - nu) along and across.
void note_thermal_stress(const Scene& scene, const std::array<bool, 2>& yields_cold,
                         ModelResult& result) {
  double largest = 0.0, depth = 0.0;
  std::string body, what;
  for (const PointResult& point : result.points) {
    const bool stresses =
        !point.stress_maxima.empty() || !point.subsurface.empty() || !point.bodies.empty();
    for (const auto& [name, cold, heat, material] :
         {std::tuple("wheel", yields_cold[0], &scene.heat->wheel, &scene.wheel.material),
          {"rail", yields_cold[1], &scene.heat->rail, &scene.rail.material}}) {
      if (!stresses && !cold) continue;
      const double rise = point.max_temperature.value_or(heat->temperature) - heat->temperature;
      const double stress =
          material->young_modulus * heat->expansion * rise / (1.0 - material->poisson_ratio);
      if (material->rigid() || stress <= largest) continue;
      largest = stress;
      depth = scene.heat->layer(*heat, point.contact_length);
      body = name;
      what = !cold      ? "stresses leave"
             : stresses ? "stresses and yielding leave"
                        : "yielding leaves";
    }
  }
  if (largest > 0.0)
    add_note(
        result.notes, "thermal_stress",
        "{} out thermal strain: up to {:.0f} MPa of compression along and across the surface of "
        "the {}, in a layer of {:.2g} mm; rollfem stress adds it to stresses (docs/heat.md)",
        what, largest, body, depth);
}

}  // namespace

std::vector<double> rise_below(const ContactGrid& grid, const HeatedBody& body, double speed,
                               const Field& surface,
                               const std::vector<std::array<double, 3>>& places) {
  const int nx = grid.nx, ny = grid.ny;
  // Heat flows that lead to these temperatures, from the leading end of each row.
  Field flow = surface.array() - body.temperature;
  const Field own = warming_at(0.0, grid, body, speed);
  for (int i = nx - 1; i >= 0; --i)
    for (int j = 0; j < ny; ++j) {
      const int k = grid.index(i, j), ahead = nx - 1 - i;
      flow[k] = (flow[k] - own.segment(1, ahead).dot(flow.segment(k + 1, ahead))) / own[0];
    }
  Field warming;
  double of_depth = -1.0;
  // In the middle of a column, perhaps one behind the grid.
  const auto in_column = [&](int i, int j) {
    const int from = std::clamp(i, 0, nx);
    return warming.segment(from - i, nx - from).dot(flow.segment(grid.index(from, j), nx - from));
  };
  std::vector<double> found(places.size(), 0.0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [x, y, depth] = places[k];
    const double column = (x - grid.x_first) / grid.dx, row = (y - grid.y_first) / grid.dy;
    const bool beside = ny > 1 && (row < -0.5 || row > ny - 0.5);
    if (beside || !(column >= -nx && column < nx)) continue;
    if (depth != of_depth) warming = warming_at(of_depth = depth, grid, body, speed);
    const double inside = std::clamp(row, 0.0, ny - 1.0);
    const int i = static_cast<int>(std::floor(column)), j = static_cast<int>(inside);
    for (const auto& [across, there] : {std::pair(1.0 - (inside - j), j), {inside - j, j + 1}})
      for (const auto& [along, here] : {std::pair(1.0 - (column - i), i), {column - i, i + 1}})
        if (across * along > 0.0) found[k] += across * along * in_column(here, there);
  }
  return found;
}

void tell_of_heat(const Scene& scene, ModelResult& result, const std::array<bool, 2>& yields_cold) {
  if (!scene.heat) return;
  note_thermal_stress(scene, yields_cold, result);
  const double limit = std::min(scene.heat->wheel.limit, scene.heat->rail.limit);
  double hottest = 0.0;
  std::size_t above = 0;
  for (const PointResult& point : result.points) {
    hottest = std::max(hottest, point.max_temperature.value_or(0.0));
    above += point.max_temperature.value_or(0.0) > limit ? 1 : 0;
  }
  if (above > 0)
    add_warning(result.notes, "temperature",
                "surfaces reach {:.0f} degC, above the {:g} degC at which steel transforms, at {} "
                "of {} load points (docs/heat.md)",
                hottest, limit, above, result.points.size());
}

}  // namespace rollfem::contact
