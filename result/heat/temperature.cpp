// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/heat/temperature.hpp"

#include "result/note.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// Temperatures and heat flows of both surfaces in one row of elements, from its leading end.
struct HeatedRow {
  Field wheel, rail;            ///< degC
  Field wheel_flow, rail_flow;  ///< N/(mm s), into the bodies
};

/// `warming`: of every distance in elements. `flow`: of friction, N/(mm s). Where the surfaces
/// touch, what each takes follows from their equal temperatures: the heat of friction, and what
/// unlike bodies exchange.
HeatedRow heated_row(const SurfaceHeat& heat, const Field& warming, const Field& pressure,
                     const Field& flow) {
  const auto n = static_cast<int>(flow.size());
  const auto& [wheel, rail, speed] = heat;
  HeatedRow row{Field(n), Field(n), Field::Zero(n), Field::Zero(n)};
  for (int i = n; i-- > 0;) {
    const int ahead = n - 1 - i;
    const auto before = [&](const Field& flows) {
      return warming.segment(1, ahead).dot(flows.tail(ahead));
    };
    row.wheel[i] = wheel.temperature + before(row.wheel_flow) / wheel.effusivity;
    row.rail[i] = rail.temperature + before(row.rail_flow) / rail.effusivity;
    if (!(pressure[i] > 0.0)) continue;
    const double own = warming[0];
    row.wheel_flow[i] = (row.rail[i] + own * flow[i] / rail.effusivity - row.wheel[i]) /
                        (own / wheel.effusivity + own / rail.effusivity);
    row.rail_flow[i] = flow[i] - row.wheel_flow[i];
    row.wheel[i] += own * row.wheel_flow[i] / wheel.effusivity;
    row.rail[i] = row.wheel[i];
  }
  return row;
}

}  // namespace

void set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, PointResult& point) {
  ContactFields& fields = point.fields;
  if (fields.work.size() != grid.size()) return;
  const Field warming = Field::NullaryExpr(
      grid.nx, [&](Eigen::Index i) { return heat.warming(grid.dx, static_cast<int>(i)); });
  fields.temperature_wheel.resize(grid.size());
  fields.temperature_rail.resize(grid.size());
  double wheel_flow = 0.0, rail_flow = 0.0;
  for (int j = 0; j < grid.ny; ++j) {
    const int first = grid.index(0, j);
    const HeatedRow row = heated_row(heat, warming, fields.traction.n.segment(first, grid.nx),
                                     heat.speed * fields.work.segment(first, grid.nx));
    fields.temperature_wheel.segment(first, grid.nx) = row.wheel;
    fields.temperature_rail.segment(first, grid.nx) = row.rail;
    wheel_flow += row.wheel_flow.sum();
    rail_flow += row.rail_flow.sum();
  }
  const double per_length = grid.element_area() / heat.speed;
  point.heat_wheel = wheel_flow * per_length;
  point.heat_rail = rail_flow * per_length;
  Eigen::Index hottest = 0;
  const double highest = (fields.traction.n.array() > 0.0)
                             .select(fields.temperature_rail.array(), -HUGE_VAL)
                             .maxCoeff(&hottest);
  if (std::isinf(highest)) return;
  point.max_temperature = highest;
  const auto k = static_cast<int>(hottest);
  point.max_temperature_x = grid.x(k % grid.nx);
  point.max_temperature_y = grid.y(k / grid.nx);
}

void warn_of_temperature(const SurfaceHeat& heat, ModelResult& result) {
  const double limit = std::min(heat.wheel.limit, heat.rail.limit);
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
