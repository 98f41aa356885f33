#include "theories/elliptic_patch.hpp"

#include "theories/hertz_model.hpp"
#include "theories/registry.hpp"

#include <chrono>
#include <utility>

namespace rollfem::theories {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EllipticPatch elliptic_patch(const contact::Scene& scene) {
  contact::ModelResult hertz = run_hertz(scene, {});
  EllipticPatch patch{halfspace::hertz_of_scene(scene),
                      scene.material,
                      contact::ChartedGeometry(scene.geometry, contact::Chart::plane),
                      0.0,
                      {},
                      {}};
  patch.friction = scene.friction_coefficient();
  patch.grid = hertz.grid;
  patch.normal = std::move(hertz.points.front());
  // Theories give no tangential displacement, and the record has all components or none.
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
  halfspace::models().check(scene, name);  // for callers other than the registry
  const auto start = std::chrono::steady_clock::now();
  contact::ModelResult result;
  result.name = name;
  result.grid = grid;
  result.contact_elements = static_cast<int>((normal.fields.traction.n.array() > 0.0).count());
  if (scene.material.difference != 0.0)
    result.notes.push_back(
        "unlike materials: combined constants, without coupling of pressure and friction");
  for (const contact::LoadPoint& load_point : scene.points) {
    const auto point_start = std::chrono::steady_clock::now();
    contact::PointResult point = normal;
    point.creepage = load_point.creepage;
    fill(point);
    point.converged = true;
    point.seconds = seconds_since(point_start);
    result.points.push_back(std::move(point));
  }
  result.seconds["total"] = seconds_since(start);
  contact::ProgressEvent done;
  done.model = name;
  done.stage = "solved";
  done.points = static_cast<int>(result.points.size());
  done.contact_elements = result.contact_elements;
  done.finished = true;
  contact::report(progress, done);
  return result;
}

void set_forces(const halfspace::CreepForces& forces, contact::PointResult& point) {
  // Adding 0 makes no -0 of a force that vanishes.
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

}  // namespace rollfem::theories
