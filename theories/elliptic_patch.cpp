// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/elliptic_patch.hpp"

#include "base/pi.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/patch/patch_search.hpp"
#include "scene/geometry.hpp"
#include "theories/equivalent_ellipse.hpp"
#include "theories/theory.hpp"

#include <cmath>
#include <utility>

namespace rollfem::theories {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;

namespace {

void report_done(const contact::ModelResult& result, const char* stage, int points,
                 const contact::Progress& progress) {
  contact::ProgressEvent done;
  done.model = result.name;
  done.stage = stage;
  done.points = points;
  done.contact_elements = result.contact_elements;
  done.finished = true;
  contact::report(progress, done);
}

int pressed_elements(const PointResult& point) {
  return static_cast<int>((point.fields.traction.n.array() > 0.0).count());
}

}  // namespace

halfspace::CreepForces EllipticPatch::linear_forces(const contact::Creepage& creepage) const {
  return halfspace::linear_creep_forces(hertz.semi_axis_x, hertz.semi_axis_y,
                                        material.shear_modulus, material.poisson_ratio, creepage);
}

double EllipticPatch::friction_at(const contact::Creepage& creepage) const {
  return falling ? falling->at(std::hypot(creepage.longitudinal, creepage.lateral)).value
                 : friction;
}

EllipticPatch elliptic_patch(const contact::Scene& scene) {
  contact::ModelResult hertz = run_hertz(scene, {});
  const bool falls = scene.friction_law && scene.friction_law->feels_slip();
  EllipticPatch patch{halfspace::hertz_of_scene(scene),
                      scene.material,
                      contact::ChartedGeometry(scene.geometry, contact::Chart::plane),
                      scene.friction_coefficient(),
                      falls ? scene.friction_law : nullptr,
                      hertz.grid,
                      std::move(hertz.points.front())};
  // Theories give no tangential displacement, and the record holds either all components or none.
  patch.normal.fields.displacement = {};
  return patch;
}

contact::ContactFields resting_fields(const contact::ContactGrid& grid,
                                      const contact::Field& pressure, double friction) {
  const contact::Field zero = contact::Field::Zero(grid.size());
  contact::ContactFields fields;
  fields.traction = {zero, zero, pressure};
  fields.slip = {zero, zero};
  fields.traction_bound = friction * pressure;
  fields.state.assign(grid.size(), contact::ElementState::exterior);
  for (int k = 0; k < grid.size(); ++k)
    if (pressure[k] > 0.0) fields.state[k] = contact::ElementState::adhesion;
  return fields;
}

contact::ModelResult run_theory(const contact::Scene& scene, const contact::ContactGrid& grid,
                                const contact::PointResult& normal, const std::string& name,
                                const contact::Progress& progress, const FillTangential& fill) {
  const contact::Stopwatch watch;
  contact::ModelResult result;
  result.name = name;
  result.grid = grid;
  result.contact_elements = pressed_elements(normal);
  if (scene.material.difference != 0.0)
    result.notes.push_back(
        {"unlike_materials",
         "unlike materials: combined constants, without coupling of pressure and friction"});
  for (const contact::LoadPoint& load_point : scene.points) {
    const contact::Stopwatch watch_of_point;
    contact::PointResult point = normal;
    point.creepage = load_point.creepage;
    fill(point);
    point.converged = true;
    point.seconds = watch_of_point.seconds();
    result.points.push_back(std::move(point));
  }
  result.seconds["total"] = watch.seconds();
  report_done(result, "solved", static_cast<int>(result.points.size()), progress);
  return result;
}

contact::Scene with_creepages_of_forces(
    contact::Scene scene,
    const std::function<contact::TransmittedForce(const contact::Creepage&)>& transmitted,
    bool has_peak) {
  constexpr double small = 1e-9;  // creepage without slip
  for (contact::LoadPoint& point : scene.points) {
    if (!point.force.any()) continue;
    const contact::TransmittedForce at_rest = transmitted({});
    contact::ForceSearch search;
    search.has_peak = has_peak;
    search.stiffness = {at_rest.force.x() - transmitted({small, 0.0, 0.0}).force.x(),
                        at_rest.force.y() - transmitted({0.0, small, 0.0}).force.y()};
    search.stiffness /= small;
    contact::refuse_force_beyond_friction(point.force, at_rest.bound);
    search.start =
        contact::first_creepage(point.force, {point.creepage.longitudinal, point.creepage.lateral},
                                search.stiffness, at_rest.bound);
    const contact::ForceLaw law = [&](const Eigen::Vector2d& creepage) {
      return transmitted({creepage.x(), creepage.y(), point.creepage.spin});
    };
    const Eigen::Vector2d found = contact::find_creepage(law, point.force, search).creepage;
    point.creepage.longitudinal = found.x();
    point.creepage.lateral = found.y();
  }
  return scene;
}

void set_forces(const halfspace::CreepForces& forces, contact::PointResult& point) {
  // Adding 0 turns -0 into 0.
  point.longitudinal_force = forces.longitudinal + 0.0;
  point.lateral_force = forces.lateral + 0.0;
  point.spin_moment = forces.spin_moment + 0.0;
  point.traction_coefficient = 0.0 - forces.longitudinal / point.normal_force;
}

void set_largest_tractions(contact::PointResult& point) {
  const contact::SurfaceField& traction = point.fields.traction;
  point.max_traction_x = traction.x.cwiseAbs().maxCoeff();
  point.max_traction =
      (traction.x.array().square() + traction.y.array().square()).sqrt().maxCoeff();
}

namespace {

using contact::pi;

contact::ContactFields sampled_fields(const contact::Scene& scene,
                                      const halfspace::HertzContact& hertz,
                                      const ContactGrid& grid) {
  const double modulus = scene.material.contact_modulus;
  const contact::Curvatures curvatures = halfspace::curvatures_of_scene(scene);
  contact::ContactFields fields =
      resting_fields(grid, grid.sample([&](double x, double y) { return hertz.pressure(x, y); }),
                     scene.friction_coefficient());
  const halfspace::LineHertz line{hertz.semi_axis_x, hertz.max_pressure, hertz.approach};
  const Field displacement = grid.sample([&](double x, double y) {
    return grid.is_line() ? halfspace::line_displacement(line, modulus, x)
                          : halfspace::hertz_displacement(hertz, modulus, x, y);
  });
  const Field distance = grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  fields.gap = distance + displacement;
  fields.gap.array() -= hertz.approach;
  fields.displacement = {fields.slip.x, fields.slip.y, displacement};
  return fields;
}

}  // namespace

contact::ModelResult run_hertz(const contact::Scene& scene, const contact::Progress& progress) {
  const contact::Stopwatch watch;
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(scene);
  contact::ModelResult result;
  result.name = "hertz";
  result.grid = halfspace::PatchSearch(scene).grid();
  PointResult point;
  point.normal_force = hertz.normal_force;
  point.max_pressure = hertz.max_pressure;
  point.approach = hertz.approach;
  point.semi_axis_x = hertz.semi_axis_x;
  point.semi_axis_y = hertz.semi_axis_y;
  point.contact_length = 2.0 * hertz.semi_axis_x;
  point.contact_width = 2.0 * hertz.semi_axis_y;
  point.contact_area = (scene.geometry.line ? 4.0 : pi) * hertz.semi_axis_x * hertz.semi_axis_y;
  point.adhesion_area = point.contact_area;
  point.converged = true;
  point.fields = sampled_fields(scene, hertz, result.grid);
  result.contact_elements = pressed_elements(point);
  point.seconds = result.seconds["total"] = watch.seconds();
  result.points.push_back(std::move(point));
  result.notes = {
      {"friction",
       "Hertz has no friction: one load point at creepage 0, without tangential tractions"},
      {"patch",
       "patch, pressure, approach and area are exact; the fields are sampled at element centres"}};
  report_done(result, "normal", 0, progress);
  return result;
}

contact::ModelInfo hertz_model() {
  using contact::Demand;
  // Frictionless: accepts any problem and gives only the patch.
  contact::ModelInfo model =
      theory("hertz", "Hertz", "elliptic patch and pressure in closed form, without friction",
             {Demand::line_contact, Demand::history, Demand::tangential_force, Demand::profiles,
              Demand::sections, Demand::lateral_creepage, Demand::spin, Demand::extra_slip,
              Demand::extra_slip_on_profiles, Demand::falling_friction, Demand::heated_friction,
              Demand::varying_friction, Demand::layer, Demand::plastic_layer},
             [](const contact::Scene& scene, const contact::Progress& progress) {
               return scene.has_profiles() ? run_hertz_of_patch(scene, progress)
                                           : run_hertz(scene, progress);
             },
             {false, true, closed_form.bars});
  model.frictionless = model.in_compare = true;
  return model;
}

}  // namespace rollfem::theories
