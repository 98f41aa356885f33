#include "theories/hertz_model.hpp"

#include "contact/base/pi.hpp"
#include "contact/scene/geometry.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "halfspace/closed_forms/line_hertz.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <chrono>
#include <cmath>

namespace rollfem::theories {

using contact::ContactGrid;
using contact::Field;
using contact::PointResult;

namespace {

using contact::pi;

contact::ContactFields sampled_fields(const contact::Scene& scene,
                                      const halfspace::HertzContact& hertz,
                                      const ContactGrid& grid) {
  const double modulus = scene.material.contact_modulus;
  const contact::Curvatures curvatures = halfspace::curvatures_of_scene(scene);
  const Field zero = Field::Zero(grid.size());
  contact::ContactFields fields;
  fields.traction = {zero, zero,
                     grid.sample([&](double x, double y) { return hertz.pressure(x, y); })};
  fields.slip = {zero, zero};
  fields.traction_bound = scene.friction_coefficient() * fields.traction.n;
  const halfspace::LineHertz line{hertz.semi_axis_x, hertz.max_pressure, hertz.approach};
  const Field displacement = grid.sample([&](double x, double y) {
    return grid.is_line() ? halfspace::line_displacement(line, modulus, x)
                          : halfspace::hertz_displacement(hertz, modulus, x, y);
  });
  const Field distance = grid.sample(
      [&](double x, double y) { return contact::undeformed_distance(curvatures, x, y); });
  const auto inside = fields.traction.n.array() > 0.0;
  fields.gap = distance + displacement;
  fields.gap.array() -= hertz.approach;
  fields.displacement = {zero, zero, displacement};
  for (Eigen::Index k = 0; k < grid.size(); ++k)
    fields.state.push_back(inside[k] ? contact::ElementState::adhesion
                                     : contact::ElementState::exterior);
  return fields;
}

}  // namespace

contact::ModelResult run_hertz(const contact::Scene& scene, const contact::Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
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
  result.contact_elements = static_cast<int>((point.fields.traction.n.array() > 0.0).count());
  result.seconds["total"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  point.seconds = result.seconds["total"];
  result.points.push_back(std::move(point));
  result.notes = {
      "Hertz has no friction: one load point at creepage 0, without tangential tractions",
      "patch, pressure, approach and area are exact; the fields are sampled at element centres"};
  contact::ProgressEvent event;
  event.model = "hertz";
  event.stage = "normal";
  event.contact_elements = result.contact_elements;
  event.finished = true;
  contact::report(progress, event);
  return result;
}

}  // namespace rollfem::theories
