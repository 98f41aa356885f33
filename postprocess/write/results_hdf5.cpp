// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/derived.hpp"
#include "contact/result/quantities.hpp"
#include "contact/result/stress_measures.hpp"
#include "contact/scene/friction_law.hpp"
#include "postprocess/hdf5/hdf5_objects.hpp"
#include "postprocess/write/output.hpp"
#include "postprocess/write/point_table.hpp"
#include "postprocess/write/yielded_hdf5.hpp"

#include <fmt/core.h>

#include <cmath>

namespace rollfem::postprocess {
namespace {

using contact::ContactGrid;
using contact::ModelResult;
using contact::PointResult;
using namespace hdf5;

const char* const conventions =
    "mm, N, MPa, s, rad. x: rolling direction, material enters at large x; y: lateral; z: normal, "
    "into the wheel. Tractions and forces act on the wheel. Displacement difference and slip: "
    "wheel "
    "minus rail. traction_coefficient = -F_x / F_z.";

/// Directions in which a force is prescribed: "", "x", "y" or "xy".
std::string prescribed_forces(const contact::Case& input) {
  const auto any = [&](std::optional<double> contact::PrescribedForce::*direction) {
    return std::any_of(input.rolling.forces.begin(), input.rolling.forces.end(),
                       [&](const contact::PrescribedForce& force) { return force.*direction; });
  };
  return std::string(any(&contact::PrescribedForce::longitudinal) ? "x" : "") +
         (any(&contact::PrescribedForce::lateral) ? "y" : "");
}

/// A law that falls with the slip velocity, tabulated for figures and reports.
void write_friction_law(hid_t group, const contact::Case& input) {
  const contact::Friction law = contact::friction_of(input);
  if (!law || !law->feels_slip()) return;
  using contact::FallShape;
  const FallShape& shape = input.friction_fall.shape;
  const double speed = input.rolling.slip_speed();
  write_attribute(group, "law", std::string(word_of(shape)));
  for (std::size_t k = 0; k < FallShape::most_constants; ++k)
    if (const FallShape::Constant& own = shape.constants[k]; own.name != nullptr)
      write_attribute(group, own.name, input.friction_fall.constants[k].value_or(own.otherwise));
  write_attribute(group, "speed", speed);
  write_attribute(group, "memory_distance", input.friction_fall.memory_distance);
  constexpr int per_decade = 30;
  std::vector<double> rows{0.0, law->coefficient()};
  for (int k = -3 * per_decade; k <= 9 * per_decade; ++k) {
    const double velocity = std::pow(10.0, static_cast<double>(k) / per_decade);
    rows.insert(rows.end(), {velocity, law->at(velocity / speed).value});
  }
  const Handle table =
      write_dataset(group, "friction_law", {rows.size() / 2, 2}, H5T_NATIVE_DOUBLE, rows.data());
  write_comment(table, "Slip velocity, mm/s (in a shift: slip in mm), and coefficient of friction");
}

void write_case(hid_t file, const contact::Case& input) {
  const Handle group =
      create_group(file, "case", "The whole file (text); main numbers as attributes in mm, N, MPa");
  write_attribute(group, "title", input.title);
  write_attribute(group, "file", input.file);
  write_attribute(group, "friction_coefficient", input.friction_coefficient);
  if (!input.friction_variation.points.empty())
    write_attribute(group, "friction_varies",
                    std::string(!input.friction_variation.track_position.empty() ? "along the track"
                                : !input.friction_variation.inclination.empty()
                                    ? "over the inclination of the rail"
                                    : "over the lateral position"));
  write_friction_law(group, input);
  write_stress_before(group, input);
  const contact::Layer layer = input.layer.value_or(contact::Layer{});
  for (const auto& [name, value] : {std::pair{"layer_thickness", layer.thickness},
                                    {"layer_shear_modulus", layer.shear_modulus},
                                    {"layer_yield_stress", layer.yield_stress},
                                    {"layer_hardening", layer.hardening},
                                    {"normal_force", input.load.normal_force},
                                    {"vertical_force", input.load.vertical_force},
                                    {"approach", input.load.approach},
                                    {"max_pressure", input.load.max_pressure}})
    if (value) write_attribute(group, name, *value);
  write_attribute(group, "problem", std::string(word_of(input.rolling.problem)));
  write_attribute(group, "prescribed_forces", prescribed_forces(input));
  if (input.given_pressure) {
    write_attribute(group, "given_semi_axis_x", input.given_pressure->semi_axis_x);
    write_attribute(group, "given_semi_axis_y", input.given_pressure->semi_axis_y);
    write_attribute(group, "given_max_pressure", input.given_pressure->max_pressure);
  }
  if (input.undeformed_distance.quadratic) {
    write_attribute(group, "distance_A", (*input.undeformed_distance.quadratic)[0]);
    write_attribute(group, "distance_B", (*input.undeformed_distance.quadratic)[1]);
  }
  if (input.undeformed_distance.values)
    write_attribute(group, "distance_file", input.undeformed_distance.values->file);
  write_attribute(group, "wheel_rolling_radius", input.wheel.rolling_radius);
  write_attribute(group, "wheel_transverse_radius", input.wheel.transverse_radius);
  if (std::isfinite(input.rail.rolling_radius))
    write_attribute(group, "rail_rolling_radius", input.rail.rolling_radius);
  if (!input.wheel.profile.name.empty())
    write_attribute(group, "wheel_profile", input.wheel.profile.name);
  if (!input.rail.profile.name.empty())
    write_attribute(group, "rail_profile", input.rail.profile.name);
  write_attribute(group, "wheel_young_modulus", input.wheel.material.young_modulus);
  write_attribute(group, "wheel_poisson_ratio", input.wheel.material.poisson_ratio);
  write_attribute(group, "rail_transverse_radius", input.rail.transverse_radius);
  write_attribute(group, "rail_young_modulus", input.rail.material.young_modulus);
  write_attribute(group, "rail_poisson_ratio", input.rail.material.poisson_ratio);
  const Handle text = write_dataset(group, "text", input.text);
  write_comment(text, "The case file as read (TOML)");
}

void write_provenance(hid_t file, const Provenance& provenance) {
  const Handle group =
      create_group(file, "provenance", "Program, version, machine and time of this result");
  write_attribute(group, "version", provenance.version);
  write_attribute(group, "commit", provenance.commit);
  write_attribute(group, "host", provenance.host);
  write_attribute(group, "started", provenance.started);
  write_attribute(group, "command", provenance.command);
  write_attribute(group, "processes", static_cast<long>(provenance.processes));
}

/// Explains the attributes of a load point for programs that do not show comments.
void write_documentation(hid_t file) {
  std::vector<std::string> lines;
  for (const contact::Quantity& quantity : contact::quantities())
    lines.push_back(fmt::format("{} [{}]: {}", quantity.name, quantity.unit, quantity.meaning));
  for (const PlaceScalar& scalar : place_scalars())
    lines.push_back(fmt::format("place/{} [{}]: {}", scalar.name, scalar.unit, scalar.description));
  const Handle dataset = write_dataset(file, "documentation", lines);
  write_comment(dataset, "Unit and meaning of the attributes of /models/NAME/points/NUMBER");
}

/// The same for the scalars only, in columns for programs.
void write_quantities(hid_t file) {
  const Handle group = create_group(
      file, "quantities", "Scalars of a load point: entry k of each dataset describes one");
  const auto write_column = [&](const char* name, const char* comment, const auto& text) {
    std::vector<std::string> lines;
    for (const contact::Quantity& quantity : contact::quantities())
      lines.emplace_back(text(quantity));
    write_comment(write_dataset(group, name, lines), comment);
  };
  const auto column = [&](const char* name, const char* comment,
                          const char* const contact::Quantity::*member) {
    write_column(name, comment,
                 [&](const contact::Quantity& quantity) { return quantity.*member; });
  };
  column("name", "Attribute of /models/NAME/points/NUMBER", &contact::Quantity::name);
  column("title", "For headings", &contact::Quantity::title);
  column("symbol", "F_x, xi, ...; empty if there is none", &contact::Quantity::symbol);
  column("unit", "- if there is none", &contact::Quantity::unit);
  column("meaning", "Meaning, with sign", &contact::Quantity::meaning);
  write_column("percent_of", "Reference of percentages of errors and differences; empty: none",
               [](const contact::Quantity& quantity) { return contact::text_of(quantity.scale); });
}

std::vector<double> list_of(const contact::Field& field) {
  return {field.begin(), field.end()};
}

void write_grid(hid_t model, const ContactGrid& grid, const contact::ProfileRows& rows) {
  const Handle group =
      create_group(model, "grid",
                   "Contact grid: centres of the elements (x, y) and their size (attributes dx, "
                   "dy, in mm); fields are [ny, nx], x runs fastest");
  write_attribute(group, "dx", grid.dx);
  write_attribute(group, "dy", grid.dy);
  write_attribute(group, "unit", std::string("mm"));
  std::vector<double> x, y;
  for (int i = 0; i < grid.nx; ++i) x.push_back(grid.x(i));
  for (int j = 0; j < grid.ny; ++j) y.push_back(grid.y(j));
  write_values(group, "x", x, "mm", "element centres along rolling", "material enters at large x");
  write_values(group, "y", y, "mm", "element centres across rolling");
  if (rows.width.size() == 0) return;
  write_values(group, "y_wheel", list_of(rows.y_wheel), "mm",
               "of the rows, on the wheel's profile");
  write_values(group, "y_rail", list_of(rows.y_rail), "mm", "of the rows, on the rail's profile");
  write_values(group, "width", list_of(rows.width), "mm", "of the rows, along the surface");
}

void write_point_fields(hid_t group, const ContactGrid& grid, const PointResult& point) {
  const Shape shape{static_cast<hsize_t>(grid.ny), static_cast<hsize_t>(grid.nx)};
  for (const PointField& field : point_fields()) {
    const contact::Field& values = field.value(point.fields);
    if (values.size() == 0) continue;
    describe(write_dataset(group, field.name, shape, H5T_NATIVE_DOUBLE, values.data()), field.unit,
             field.description, field.sign);
  }
  if (point.fields.state.empty()) return;
  describe(write_dataset(group, "state", shape, H5T_NATIVE_UCHAR, point.fields.state.data()), "-",
           "state of the element: 0 exterior, 1 adhesion, 2 slip, 3 plastic");
}

void write_subsurface(hid_t point, const std::vector<contact::SubsurfaceField>& fields) {
  if (fields.empty()) return;
  const Handle all = create_group(point, "subsurface", "Points below the surface, as requested");
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const contact::SubsurfaceField& field = fields[k];
    const Handle group = create_group(all, fmt::format("{:04}", k), "Points, first side fastest");
    write_attribute(group, "kind", std::string(word_of(field.request.kind)));
    write_attribute(group, "body", std::string(field.request.wheel ? "wheel" : "rail"));
    write_attribute(group, "points_along", static_cast<long>(field.request.points[0]));
    write_attribute(group, "points_across", static_cast<long>(field.request.points[1]));
    write_rows(group, "points", field.points, "mm",
               "x, y, z in the global frame, z into the wheel");
    write_rows(group, "displacement", field.displacement, "mm",
               "displacement of the material, x, y, z");
    write_rows(group, "stress", field.stress, "MPa",
               "stress: xx, yy, zz, xy, yz, xz; tension positive");
    std::vector<double> equivalent;
    for (const auto& stress : field.stress)
      equivalent.push_back(contact::von_mises(contact::Stress::from_array(stress)));
    write_values(group, "von_mises", equivalent, "MPa", "von Mises stress");
  }
}

void write_stress_maxima(hid_t point, const std::vector<contact::StressMaximum>& maxima) {
  if (maxima.empty()) return;
  const Handle group =
      create_group(point, "stress_maxima", "Largest stresses of wheel and rail, with their places");
  std::vector<std::string> body, measure;
  std::vector<double> value;
  std::vector<std::array<double, 3>> place;
  for (const contact::StressMaximum& maximum : maxima) {
    body.push_back(maximum.body);
    measure.push_back(maximum.measure);
    value.push_back(maximum.value);
    place.push_back(maximum.place);
  }
  write_comment(write_dataset(group, "body", body), "wheel or rail");
  write_comment(write_dataset(group, "measure", measure), "stress measure");
  write_values(group, "value", value, "MPa", "largest value");
  write_rows(group, "place", place, "mm", "x, y, z in the global frame, z into the wheel");
}

/// Wheel and rail at a load point that stores them; nodes and cells stand once in the model.
void write_body_values(hid_t point, const std::vector<contact::BodyField>& bodies,
                       const contact::PointResult& result) {
  if (result.bodies.empty()) return;
  const Handle all = create_group(point, "bodies",
                                  "Wheel and rail under this load: values at the nodes of "
                                  "../../bodies; between them trilinear");
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Handle group = create_group(all, bodies[k].name, "The whole segment, both halves");
    write_rows(group, "displacement", result.bodies.at(k).displacement, "mm",
               "displacement of the nodes, x, y, z");
    write_rows(group, "stress", result.bodies.at(k).stress, "MPa",
               "stress: xx, yy, zz, xy, yz, xz; tension positive");
  }
}

/// Writes a quantity; counts and booleans (1 or 0) as integers, nothing if the model does not give
/// it, NaN if the load point has no solution.
void write_quantity(hid_t group, const contact::Quantity& quantity, const PointResult& point) {
  std::optional<double> value = quantity.value(point);
  if (!value && !quantity.member.may_be_absent) value = std::nan("");
  if (!value) return;
  if (quantity.member.kind == contact::QuantityKind::number)
    write_attribute(group, quantity.name, *value);
  else
    write_attribute(group, quantity.name, static_cast<long>(*value));
}

/// A group of numbers by quantity.
void write_by_quantity(hid_t parent, const char* name, const char* comment,
                       const std::map<std::string, double>& numbers) {
  const Handle group = create_group(parent, name, comment);
  for (const auto& [quantity, value] : numbers) write_attribute(group, quantity, value);
}

void write_point(hid_t points, std::size_t number, const ModelResult& model, bool with_fields) {
  const PointResult& point = model.points[number];
  const Handle group = create_group(
      points, fmt::format("{:04}", number),
      fmt::format("Creepage xi = {}, eta = {}, spin = {} rad/mm; attributes: see /documentation",
                  point.creepage.longitudinal, point.creepage.lateral, point.creepage.spin));
  for (const contact::Quantity& quantity : contact::quantities())
    write_quantity(group, quantity, point);
  write_by_quantity(group, "error_estimate", "Attributes: estimated error by quantity, in its unit",
                    point.error_estimate);
  const Handle words = create_group(
      group, "no_bar", "Attributes: why a quantity has no error estimate, docs/results.md");
  for (const auto& [quantity, word] : point.no_bar) write_attribute(words, quantity, word);
  if (!point.model_error.empty())
    write_by_quantity(group, "model_error", "Attributes: model error by quantity, in its unit",
                      point.model_error);
  if (!point.richardson.empty())
    write_by_quantity(group, "richardson", "Attributes: values extrapolated to cells of size 0",
                      point.richardson);
  if (with_fields) write_point_fields(group, model.grid, point);
  if (const contact::Field work = contact::pass_work(model.grid, point); work.size() > 0)
    write_values(group, "pass_work", list_of(work), "N/mm", "frictional work per pass and area");
  write_subsurface(group, point.subsurface);
  write_stress_maxima(group, point.stress_maxima);
  write_yielded(group, point.yielded);
  write_body_values(group, model.bodies, point);
}

void write_place(hid_t model, const contact::ContactPlace& place, const contact::Case& input) {
  const Handle group = create_group(
      model, "place", "Attributes: place of the patch on the track and on the profiles");
  write_attribute(group, "wheel", std::string(place.side()));
  for (const PlaceScalar& scalar : place_scalars())
    write_attribute(group, scalar.name, scalar.value(place));
  for (const WayScalar& way : ways_of(input))
    write_attribute(group, way.name, way.at(input, place.position));
}

/// After all load points.
void write_bodies(hid_t model, const contact::ModelResult& result) {
  const std::vector<std::size_t> kept = result.points_with_bodies();
  if (kept.empty()) return;
  const Handle all =
      create_group(model, "bodies",
                   "Wheel and rail: nodes and hexahedra; displacement and stress are links to the "
                   "load point in the attribute load_point (from 0)");
  write_attribute(all, "load_point", static_cast<long>(kept.back()));
  for (const contact::BodyField& body : result.bodies) {
    const Handle group = create_group(all, body.name, "The whole segment, both halves");
    write_rows(group, "points", body.points, "mm",
               "x, y, z of the undeformed nodes in the global frame, z into the wheel");
    write_rows(group, "cells", body.cells, "-",
               "nodes of every hexahedron, from 0, in VTK's order");
    for (const char* name : {"displacement", "stress"})
      link(model, fmt::format("points/{:04}/bodies/{}/{}", kept.back(), body.name, name), group,
           name);
  }
}

void write_model(hid_t models, const ModelResult& model, long order, const contact::Case& input) {
  const Handle group = create_group(models, model.key(), "Result of the model " + model.name);
  write_attribute(group, "model", model.name);
  if (!model.label.empty()) write_attribute(group, "label", model.label);
  if (model.place) write_place(group, *model.place, input);
  write_attribute(group, "order", order);
  write_attribute(group, "model_error_source", model.model_error_source);
  write_attribute(group, "unknowns", model.unknowns);
  write_attribute(group, "contact_elements", static_cast<long>(model.contact_elements));
  const Handle seconds = create_group(group, "seconds", "Attributes: seconds by stage");
  for (const auto& [stage, value] : model.seconds) write_attribute(seconds, stage, value);
  const Handle notes = write_dataset(group, "notes", model.notes);
  write_comment(notes, "Notes: domain, symmetry, limits");
  write_grid(group, model.grid, model.rows);
  const Handle points = create_group(group, "points", "Load points in the order of the case");
  for (std::size_t k = 0; k < model.points.size(); ++k)
    write_point(points, k, model, input.output.keeps_grid(k, model.points.size()));
  write_bodies(group, model);
}

void write_pairs(hid_t file, const std::vector<PlacedPair>& pairs) {
  if (pairs.empty()) return;
  const Handle all = create_group(file, "profiles", "Wheel and rail in position on the track");
  for (const PlacedPair& pair : pairs) {
    const std::string side = contact::side_word(pair.left);
    const Handle group = create_group(all, fmt::format("{}_{}", side, pair.position),
                                      "Sections at x = 0 of the track");
    write_attribute(group, "wheel", side);
    write_attribute(group, "position", static_cast<long>(pair.position));
    write_rows(group, "rail", pair.rail, "mm", "y to the right, z down");
    write_rows(group, "wheel", pair.wheel, "mm", "y to the right, z down");
  }
}

}  // namespace

std::string results_hdf5(const RunRecord& run) {
  const File file = create_file_in_memory();
  write_comment(file, std::string("rollfem result, layout: docs/results.md. ") + conventions);
  write_attribute(file, "format", std::string("rollfem results"));
  write_attribute(file, "format_version", static_cast<long>(hdf5_format_version));
  write_attribute(file, "format_minor", static_cast<long>(hdf5_format_minor));
  write_attribute(file, "conventions", std::string(conventions));
  write_documentation(file);
  write_quantities(file);
  write_case(file, run.input);
  write_attribute(file, "verdict", run.verdict);
  write_provenance(file, run.provenance);
  write_pairs(file, run.pairs);
  {
    const Handle models = create_group(
        file, "models",
        "One group per model; with profiles per model and patch, MODEL_SIDE_POSITION_PATCH");
    for (std::size_t k = 0; k < run.models.size(); ++k)
      write_model(models, run.models[k], static_cast<long>(k), run.input);
  }
  // Written last, so that a reader recognises incomplete files.
  write_attribute(file, "complete", 1L);
  return sealed_image(file);
}

}  // namespace rollfem::postprocess
