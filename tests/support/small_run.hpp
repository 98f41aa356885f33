// SPDX-License-Identifier: LGPL-2.1-or-later
// A run of two models with a few made-up numbers, for tests of what is stored of a result.
#pragma once

#include "result/write/output.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

/// A load point on this grid with all fields.
inline contact::PointResult small_point(const contact::ContactGrid& grid, double creepage) {
  contact::PointResult point;
  contact::ContactFields& f = point.fields;
  double number = creepage;
  for (contact::Field* field :
       {&f.traction.x, &f.traction.y, &f.traction.n, &f.slip.x, &f.slip.y, &f.traction_bound,
        &f.gap, &f.displacement.x, &f.displacement.y, &f.displacement.n})
    *field = contact::Field::Constant(grid.size(), number += 1.0 / 3.0);
  f.state.assign(static_cast<std::size_t>(grid.size()), contact::ElementState::slip);
  point.creepage.longitudinal = creepage;
  point.max_pressure = 600.0;
  point.error_estimate = {{"max_pressure", 1.25}};
  point.no_bar = {{"approach", contact::NoBar::given}};
  point.model_error = {{"semi_axis_x", 0.5}};
  point.converged = true;
  return point;
}

/// A hexahedron, and its stress and displacement.
inline contact::BodyField small_body(const std::string& name) {
  contact::BodyField body;
  body.name = name;
  body.cells = {{0, 1, 2, 3, 4, 5, 6, 7}};
  for (const double z : {-1.0, 0.0})
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      body.points.push_back({x, y, z});
  return body;
}

/// Half-space and finite elements, with two load points each; the second model stores its bodies.
inline result::RunRecord small_run() {
  result::RunRecord run;
  run.input.title = "small";
  run.input.text = "title = \"small\"\n";
  run.input.load.normal_force = 50e3;
  run.provenance = {"0.1.0", "abc1234", "host", "2026-01-31T12:00:00Z", "rollfem run a.toml", 1};
  for (const char* name : {"halfspace", "fem"}) {
    contact::ModelResult& model = run.models.emplace_back();
    model.name = model.label = name;
    model.grid = contact::ContactGrid::centred(3, 2, 0.5, 0.25);
    model.points = {small_point(model.grid, 0.0), small_point(model.grid, 0.001)};
    model.seconds = {{"total", 1.75}};
    model.notes = {{"mesh", "coarse"}};
  }
  contact::ModelResult& fem = run.models.back();
  fem.bodies = {small_body("wheel"), small_body("rail")};
  contact::BodyValues values;
  values.displacement.assign(8, {0.0F, 0.0F, 0.0078125F});
  values.stress.assign(8, {0.0F, 0.0F, -100.0F, 0.0F, 0.0F, 30.0F});
  for (contact::PointResult& point : fem.points) point.bodies = {values, values};
  return run;
}

}  // namespace rollfem::testing
