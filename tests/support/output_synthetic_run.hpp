// SPDX-License-Identifier: LGPL-2.1-or-later
// A run with realistic fields that needs no solver: Hertz's pressure of thesis case a, and strip by
// strip Carter's traction, for the tests of output, figures and report.
#pragma once

#include "result/write/output.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

using contact::ContactGrid;
using contact::Field;
using contact::ModelResult;
using contact::PointResult;

struct SyntheticPatch {
  double a = 3.79236;
  double b = 10.87295;
  double p0 = 578.967;
  double friction = 0.55;
  double slip_per_creepage = 1263.0;  ///< mm of slip zone per unit of creepage: all slips at 0.6 %
};

/// Elliptic pressure, and Carter's traction in every strip: adhesion next to the leading edge.
inline void fill_fields(const SyntheticPatch& patch, const ContactGrid& grid, PointResult& point) {
  contact::ContactFields& f = point.fields;
  for (Field* field :
       {&f.traction.x, &f.traction.y, &f.traction.n, &f.slip.x, &f.slip.y, &f.traction_bound,
        &f.gap, &f.displacement.x, &f.displacement.y, &f.displacement.n})
    *field = Field::Zero(grid.size());
  f.state.assign(static_cast<std::size_t>(grid.size()), contact::ElementState::exterior);
  const double xi = point.creepage.longitudinal;
  const double scale = patch.p0 / patch.a;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i);
      const double y = grid.y(j);
      const int k = grid.index(i, j);
      const double edge = patch.a * std::sqrt(std::max(0.0, 1.0 - y * y / (patch.b * patch.b)));
      if (std::abs(x) >= edge) {
        f.gap[k] = 1e-3 * (std::abs(x) - edge);
        continue;
      }
      const double adhesion = std::max(0.0, edge - patch.slip_per_creepage * std::abs(xi));
      const double from_middle = x - (edge - adhesion);
      const bool sticks = std::abs(from_middle) < adhesion;
      f.traction.n[k] = scale * std::sqrt(edge * edge - x * x);
      f.traction_bound[k] = patch.friction * f.traction.n[k];
      const double relief =
          sticks ? scale * std::sqrt(adhesion * adhesion - from_middle * from_middle) : 0.0;
      f.traction.x[k] = std::copysign(patch.friction, -xi) * (f.traction.n[k] - relief);
      f.slip.x[k] = sticks ? 0.0 : 0.5 * xi * (1.0 - x / patch.a);
      f.displacement.x[k] = 1e-4 * (patch.a - x);
      f.state[static_cast<std::size_t>(k)] =
          sticks ? contact::ElementState::adhesion : contact::ElementState::slip;
    }
}

inline void fill_scalars(const SyntheticPatch& patch, const ContactGrid& grid, PointResult& point) {
  const double area = grid.element_area();
  const contact::ContactFields& f = point.fields;
  point.normal_force = area * f.traction.n.sum();
  point.longitudinal_force = area * f.traction.x.sum();
  point.lateral_force = area * f.traction.y.sum();
  point.traction_coefficient = -point.longitudinal_force / point.normal_force;
  point.max_pressure = f.traction.n.maxCoeff();
  point.max_traction_x = f.traction.x.cwiseAbs().maxCoeff();
  point.max_traction = point.max_traction_x;
  point.approach = 0.0473108;
  point.semi_axis_x = patch.a;
  point.semi_axis_y = patch.b;
  point.contact_length = 2 * patch.a;
  point.contact_width = 2 * patch.b;
  point.contact_area = M_PI * patch.a * patch.b;
  point.adhesion_area = area * static_cast<double>(std::count(f.state.begin(), f.state.end(),
                                                              contact::ElementState::adhesion));
  point.iterations = 5;
  point.residual = 1.0 / 3.0 * 1e-6;
  point.seconds = 0.25;
  point.converged = true;
}

/// How figures call them.
inline const std::map<std::string, std::string> labels{
    {"hertz", "Hertz"}, {"halfspace", "half-space"}, {"fem", "FEM"}};

inline ModelResult synthetic_model(const std::string& name, const SyntheticPatch& patch, int nx,
                                   int ny, const std::vector<double>& creepages) {
  ModelResult model;
  model.name = name;
  model.label = labels.at(name);
  model.grid = ContactGrid::centred(nx, ny, 2.3 * patch.a / nx, 2.3 * patch.b / ny);
  for (const double xi : creepages) {
    PointResult point;
    point.creepage.longitudinal = xi;
    fill_fields(patch, model.grid, point);
    fill_scalars(patch, model.grid, point);
    model.points.push_back(point);
  }
  model.contact_elements =
      static_cast<int>((model.points[0].fields.traction.n.array() > 0).count());
  model.unknowns = 3L * model.contact_elements;
  model.seconds = {{"total", 1.75}, {"setup", 0.1}, {"normal", 0.3}, {"tangential", 1.35}};
  return model;
}

/// Uniaxial stress in the points of synthetic_body; `load` tells load points apart.
inline contact::BodyValues synthetic_values(int load = 0) {
  contact::BodyValues values;
  for (int level = 0; level < 3; ++level)
    for (int corner = 0; corner < 4; ++corner) {
      values.displacement.push_back({0.0F, 0.0F, 0.0078125F * static_cast<float>(level)});
      values.stress.push_back({0.0F, 0.0F, -100.0F - static_cast<float>(level), 0.0F, 0.0F,
                               30.0F * static_cast<float>(load + 1)});
    }
  return values;
}

/// Two elements on top of each other.
inline contact::BodyField synthetic_body(const std::string& name) {
  contact::BodyField body;
  body.name = name;
  for (int level = 0; level < 3; ++level)
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      body.points.push_back({x, y, -1.0 * level});
  body.cells = {{4, 5, 6, 7, 0, 1, 2, 3}, {8, 9, 10, 11, 4, 5, 6, 7}};
  return body;
}

/// Hertz (one frictionless point without traction fields), a half-space and a FE result.
inline result::RunRecord synthetic_run() {
  result::RunRecord run;
  run.input.title = "thesis case a: conforming plane";
  run.input.file = "cases/thesis_a.toml";
  run.input.text =
      "title = \"thesis case a: conforming plane\"\n[load]\nnormal_force = 50e3  # N\n";
  run.input.models = {"hertz", "halfspace", "fem"};
  run.input.load.normal_force = 50e3;
  run.input.friction_coefficient = 0.55;
  run.input.wheel.rolling_radius = 405.0;
  run.input.rail.transverse_radius = 2000.0;
  run.provenance = {
      "0.1.0", "abc1234", "testhost", "2026-01-31T12:00:00Z", "rollfem run cases/thesis_a.toml", 1};
  const std::vector<double> creepages{0.0, 0.0005, 0.001, 0.002, 0.003, 0.004, 0.006};

  ModelResult hertz = synthetic_model("hertz", {}, 46, 131, {0.0});
  contact::ContactFields& fields = hertz.points[0].fields;
  contact::ContactFields kept;
  kept.traction.n = fields.traction.n;
  kept.traction.x = kept.traction.y = fields.gap = Field();
  fields = kept;
  hertz.points[0].adhesion_area = 0.0;
  hertz.points[0].no_bar = {{"max_pressure", contact::NoBar::exact}};
  hertz.points[0].model_error = {{"max_pressure", 2.5}};
  hertz.seconds = {{"total", 0.001}};
  hertz.unknowns = 0;
  hertz.notes = {{"patch", "Exact for smooth, frictionless, elliptic contact."},
                 {contact::about_model_error, "a finer grid"}};

  ModelResult halfspace = synthetic_model("halfspace", {}, 46, 131, creepages);
  SyntheticPatch measured;
  measured.a *= 1.006;
  measured.b *= 0.997;
  measured.p0 *= 0.998;
  ModelResult fem = synthetic_model("fem", measured, 19, 53, creepages);
  fem.unknowns = 446000;
  fem.seconds = {{"total", 171.0}, {"setup", 62.0}, {"normal", 30.0}, {"tangential", 79.0}};
  fem.bodies = {synthetic_body("wheel"), synthetic_body("rail")};
  for (std::size_t k = 0; k < fem.points.size(); ++k)
    fem.points[k].bodies = {synthetic_values(static_cast<int>(k)),
                            synthetic_values(10 + static_cast<int>(k))};
  fem.notes = {
      {"mesh", "Segments reach 45 mm from the patch; symmetry plane y = 0 used."},
      {"far_boundary", "Far boundaries are clamped: the approach is the least certain number."}};
  for (ModelResult* model : {&halfspace, &fem})
    for (PointResult& point : model->points)
      point.error_estimate = {{"max_pressure", 1.25},
                              {"longitudinal_force", 50.0},
                              {"traction_coefficient", 50.0 / point.normal_force}};
  run.models = {hertz, halfspace, fem};
  return run;
}

}  // namespace rollfem::testing
