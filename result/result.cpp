// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/result.hpp"

#include "result/patch_size.hpp"
#include "result/stress_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

/// An empty component counts as zero: frictionless results carry no tangential tractions.
Field filled(const Field& field, Eigen::Index size) {
  return field.size() == size ? field : Field(Field::Zero(size));
}

/// Tractions along x, y, z times the true area of the elements, per unit of area of the grid.
struct ProjectedTractions {
  Field along, across, upwards;
};

ProjectedTractions project(const SurfaceField& traction, const PatchShape& shape) {
  const Field& pressure = traction.n;
  const Field px = filled(traction.x, pressure.size());
  const Field py = filled(traction.y, pressure.size());
  const Field climb = filled(shape.climb, pressure.size());
  ProjectedTractions projected{
      shape.stretch.size() == 0 ? px : Field(px.cwiseProduct(shape.stretch)),
      py - climb.cwiseProduct(pressure), pressure + climb.cwiseProduct(py)};
  if (shape.y.size() != 0) {
    // An element along the surface covers less of the projection.
    const Field cosine = (1.0 + climb.array().square()).rsqrt();
    projected.across = projected.across.cwiseProduct(cosine);
    projected.upwards = projected.upwards.cwiseProduct(cosine);
  }
  return projected;
}

/// Across, along the surface: a grid may lie in the projection.
double width_along_surface(const ContactGrid& grid, const PatchShape& shape,
                           const PatchSize& patch) {
  double width = patch.width;
  if (shape.climb.size() == 0 || shape.y.size() != 0) return width;
  for (int j = 0; j < grid.ny; ++j) {
    const double y = grid.y(j), half = 0.5 * grid.dy;
    const double within = std::min(patch.y_upper, y + half) - std::max(patch.y_lower, y - half);
    const double climb = shape.climb[grid.index(grid.nx / 2, j)];
    width += std::max(0.0, within) * (std::hypot(1.0, climb) - 1.0);
  }
  return width;
}

/// True area over projected area of the elements in contact.
double mean_stretch(const PatchShape& shape, const Field& pressure) {
  if (shape.stretch.size() == 0) return 1.0;
  const Field mask = (pressure.array() > 0.0).cast<double>();
  return mask.sum() > 0.0 ? shape.stretch.dot(mask) / mask.sum() : 1.0;
}

}  // namespace

std::vector<double> SubsurfaceField::von_mises() const {
  std::vector<double> values;
  for (const auto& each : stress) values.push_back(contact::von_mises(each));
  return values;
}

std::optional<double> PointResult::bar_of(const std::string& quantity) const {
  const auto bar = error_estimate.find(quantity);
  return bar == error_estimate.end() ? std::nullopt : std::optional<double>(bar->second);
}

std::string ModelResult::key() const {
  return place ? name + '_' + place->key() : name;
}

BodyField ModelResult::body_at(std::size_t point, std::size_t body) const {
  BodyField field = bodies.at(body);
  const BodyValues& values = points.at(point).bodies.at(body);
  for (const auto& u : values.displacement) field.displacement.push_back({u[0], u[1], u[2]});
  for (const auto& s : values.stress) field.stress.push_back({s[0], s[1], s[2], s[3], s[4], s[5]});
  return field;
}

bool ModelResult::has_model_error() const {
  return std::any_of(points.begin(), points.end(),
                     [](const PointResult& point) { return !point.model_error.empty(); });
}

std::string StressMaximum::bar_name() const {
  return fmt::format("max_{}_{}", measure, body);
}

const Note* ModelResult::note_about(const std::string& subject) const {
  const auto found = std::find_if(notes.begin(), notes.end(),
                                  [&](const Note& note) { return note.about == subject; });
  return found == notes.end() ? nullptr : &*found;
}

void ModelResult::set_note(Note note) {
  if (const Note* known = note_about(note.about))
    notes[static_cast<std::size_t>(known - notes.data())] = std::move(note);
  else
    notes.push_back(std::move(note));
}

bool ModelResult::has_friction() const {
  return std::any_of(points.begin(), points.end(),
                     [](const PointResult& point) { return point.max_traction > 0.0; });
}

double ModelResult::total_seconds() const {
  const auto total = seconds.find("total");
  return total == seconds.end() ? 0.0 : total->second;
}

std::vector<std::size_t> ModelResult::points_with_bodies() const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!bodies.empty() && points[k].bodies.size() == bodies.size()) found.push_back(k);
  return found;
}

std::array<double, 3> transmitted_force(const ContactGrid& grid, const SurfaceField& traction,
                                        const PatchShape& shape) {
  const ProjectedTractions projected = project(traction, shape);
  const double area = grid.element_area();
  return {area * projected.along.sum(), area * projected.across.sum(),
          area * projected.upwards.sum()};
}

void integrate_tractions(const ContactGrid& grid, PointResult& point, const PatchShape& shape) {
  const Field& pressure = point.fields.traction.n;
  const Field px = filled(point.fields.traction.x, pressure.size());
  const Field py = filled(point.fields.traction.y, pressure.size());
  const double area = grid.element_area();
  const Field x = grid.sample([](double at, double) { return at; });
  const bool unrolled = shape.y.size() != 0;
  const Field y = unrolled ? shape.y : grid.sample([](double, double at) { return at; });
  const ProjectedTractions projected = project(point.fields.traction, shape);
  point.normal_force = area * projected.upwards.sum();
  point.longitudinal_force = area * projected.along.sum();
  point.lateral_force = area * projected.across.sum();
  if (shape.climb.size() != 0)
    point.lateral_pressure = area * project({{}, {}, pressure}, shape).across.sum();
  point.spin_moment = area * (x.dot(projected.across) - y.dot(projected.along));
  // 0.0 - avoids a coefficient of minus zero for zero force.
  point.traction_coefficient =
      point.normal_force > 0.0 ? 0.0 - point.longitudinal_force / point.normal_force : 0.0;
  point.max_pressure = pressure.maxCoeff();
  point.max_traction = std::sqrt((px.array().square() + py.array().square()).maxCoeff());
  point.max_traction_x = px.cwiseAbs().maxCoeff();

  const PatchSize patch = patch_size(grid, pressure);
  point.contact_length = patch.length;
  point.contact_width = width_along_surface(grid, shape, patch);
  point.semi_axis_x = 0.5 * patch.length;
  point.semi_axis_y = 0.5 * point.contact_width;
  point.contact_area = patch.area * mean_stretch(shape, pressure);
  point.patch_count = count_parts(grid, pressure);
  const auto count = [&](ElementState state) {
    return static_cast<double>(
        std::count(point.fields.state.begin(), point.fields.state.end(), state));
  };
  const double adhesion = count(ElementState::adhesion);
  const double contact = adhesion + count(ElementState::slip) + count(ElementState::plastic);
  point.adhesion_area = contact > 0.0 ? point.contact_area * adhesion / contact : 0.0;
}

}  // namespace rollfem::contact
