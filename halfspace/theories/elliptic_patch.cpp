#include "halfspace/theories/elliptic_patch.hpp"

#include "contact/base/errors.hpp"
#include "contact/case/abilities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace rollfem::halfspace {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

[[noreturn]] void refuse(const std::string& file, const std::string& model, const std::string& what,
                         const std::string& others) {
  throw contact::InputError(fmt::format(
      "{0}: model {1}: {2}: it cannot take this; allowed: {3}; do: run with --model {4}", file,
      model, what, others, others.substr(others.rfind(' ') + 1)));
}

template <class Predicate>
bool any_load_point(const contact::Case& input, Predicate&& predicate) {
  const auto& creepages = input.rolling.creepages;
  return std::any_of(creepages.begin(), creepages.end(), predicate);
}

}  // namespace

EllipticPatch elliptic_patch(const contact::Case& input) {
  contact::ModelResult hertz = run_hertz(input, {});
  EllipticPatch patch;
  patch.hertz = hertz_of_case(input);
  patch.material = contact::combine(input.wheel.material, input.rail.material);
  patch.friction = input.friction_coefficient;
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
  fields.gap = zero;
  fields.state.assign(grid.size(), contact::ElementState::exterior);
  for (int k = 0; k < grid.size(); ++k)
    if (pressure[k] > 0.0) fields.state[k] = contact::ElementState::adhesion;
  return fields;
}

contact::ModelResult run_theory(const contact::Case& input, const contact::ContactGrid& grid,
                                const contact::PointResult& normal, const std::string& name,
                                const contact::Progress& progress, const FillTangential& fill) {
  contact::check_able(input, name);
  const auto start = std::chrono::steady_clock::now();
  contact::ModelResult result;
  result.name = name;
  result.grid = grid;
  result.contact_elements = static_cast<int>((normal.fields.traction.n.array() > 0.0).count());
  if (contact::combine(input.wheel.material, input.rail.material).difference != 0.0)
    result.notes.push_back(
        "unlike materials: combined constants, without the coupling of pressure and friction");
  for (const contact::Creepage& creepage : input.rolling.creepages) {
    const auto point_start = std::chrono::steady_clock::now();
    contact::PointResult point = normal;
    point.creepage = creepage;
    fill(point);
    point.converged = true;
    point.seconds = seconds_since(point_start);
    result.points.push_back(std::move(point));
  }
  result.seconds["total"] = seconds_since(start);
  contact::ProgressEvent done;
  done.model = name;
  done.stage = "rolling";
  done.points = static_cast<int>(result.points.size());
  done.contact_elements = result.contact_elements;
  done.finished = true;
  contact::report(progress, done);
  return result;
}

void set_forces(const CreepForces& forces, contact::PointResult& point) {
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

void refuse_extra_slip(const contact::Case& input, const std::string& model) {
  if (input.rolling.extra_slip != contact::ExtraSlip::none)
    refuse(input.file, model, "rolling.extra_slip", "carter, fastsim, strip, halfspace");
}

void refuse_spin(const contact::Case& input, const std::string& model) {
  if (any_load_point(input, [](const contact::Creepage& c) { return c.spin != 0.0; }))
    refuse(input.file, model, "rolling.spin", "linear, fastsim, strip, halfspace");
}

void refuse_lateral_creepage(const contact::Case& input, const std::string& model) {
  if (any_load_point(input, [](const contact::Creepage& c) { return c.lateral != 0.0; }))
    refuse(input.file, model, "rolling.lateral_creepage",
           "linear, vermeulen-johnson, fastsim, strip, halfspace");
}

}  // namespace rollfem::halfspace
