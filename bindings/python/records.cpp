// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/python/bindings.hpp"
#include "contact/result/derived.hpp"
#include "contact/result/quantities.hpp"
#include "postprocess/write/point_table.hpp"

#include <algorithm>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace rollfem::python {

using namespace py::literals;

namespace {

/// A read-only array on the memory of the result.
template <class Number>
py::array view(const Number* data, std::vector<py::ssize_t> shape, const Shared& owner) {
  const py::capsule keeper(new Shared(owner),
                           [](void* kept) { delete static_cast<Shared*>(kept); });
  py::array_t<Number> array(std::move(shape), data, keeper);
  array.attr("flags").attr("writeable") = false;
  return std::move(array);
}

template <class Number, std::size_t width>
py::array rows(const std::vector<std::array<Number, width>>& values, const Shared& owner) {
  const auto count = static_cast<py::ssize_t>(values.size());
  return view(count > 0 ? values.front().data() : nullptr, {count, static_cast<py::ssize_t>(width)},
              owner);
}

/// None for an empty one.
py::object column(const contact::Field& values) {
  if (values.size() == 0) return py::none();
  return py::array_t<double>(values.size(), values.data());
}

py::object scalar(const contact::Quantity& quantity, double value) {
  switch (quantity.member.kind) {
    case contact::QuantityKind::count:
      return py::int_(static_cast<long>(value));
    case contact::QuantityKind::truth:
      return py::bool_(value != 0.0);
    default:
      return py::float_(value);
  }
}

py::dict scalars_of(const PointResult& point) {
  py::dict found;
  for (const contact::Quantity& quantity : contact::quantities())
    if (const auto value = quantity.value(point)) found[quantity.name] = scalar(quantity, *value);
  return found;
}

py::dict fields_of(const contact::ContactGrid& grid, const PointResult& point,
                   const Shared& owner) {
  const std::vector<py::ssize_t> shape{grid.ny, grid.nx};
  py::dict found;
  for (const postprocess::PointField& field : postprocess::point_fields()) {
    const contact::Field& values = field.value(point.fields);
    if (values.size() > 0) found[field.name] = view(values.data(), shape, owner);
  }
  const auto& state = point.fields.state;
  if (!state.empty())
    found["state"] = view(reinterpret_cast<const unsigned char*>(state.data()), shape, owner);
  return found;
}

py::list subsurface_of(const PointResult& point, const Shared& owner) {
  py::list found;
  for (const contact::SubsurfaceField& field : point.subsurface)
    found.append(py::dict(
        "kind"_a = word_of(field.request.kind), "body"_a = field.request.wheel ? "wheel" : "rail",
        "points"_a = rows(field.points, owner), "displacement"_a = rows(field.displacement, owner),
        "stress"_a = rows(field.stress, owner)));
  return found;
}

py::list maxima_of(const PointResult& point) {
  py::list found;
  for (const contact::StressMaximum& maximum : point.stress_maxima)
    found.append(py::dict("body"_a = maximum.body, "measure"_a = maximum.measure,
                          "value"_a = maximum.value, "place"_a = maximum.place));
  return found;
}

/// Numbers one after another as an array of this shape.
template <class Number>
py::array_t<double> shaped(const Number* values, const std::vector<py::ssize_t>& shape) {
  py::array_t<double> array(shape);
  std::copy(values, values + array.size(), array.mutable_data());
  return array;
}

/// Bodies that yield, their streamlines as [down, across].
py::dict yielded_of(const PointResult& point) {
  py::dict found;
  for (const contact::YieldedSection& body : point.yielded) {
    const std::vector<py::ssize_t> section{body.down, body.across},
        tensors{body.down, body.across, 6};
    const std::vector<py::ssize_t> surface{static_cast<py::ssize_t>(body.surface_y.size())};
    py::dict values("verdict"_a = body.verdict, "from_pass"_a = body.from_pass,
                    "iterations"_a = body.iterations, "y"_a = shaped(body.y.data(), section),
                    "depth"_a = shaped(body.depth.data(), section),
                    "accumulated"_a = shaped(body.accumulated.data(), section),
                    "strain"_a = shaped(body.strain.front().data(), tensors),
                    "stress"_a = shaped(body.stress.front().data(), tensors),
                    "surface_y"_a = shaped(body.surface_y.data(), surface),
                    "groove"_a = shaped(body.groove.data(), surface),
                    "forward_flow"_a = shaped(body.forward_flow.data(), surface));
    for (const auto& [name, value] : contact::scalars_of(body)) values[name] = value;
    found[body.body.c_str()] = values;
  }
  return found;
}

py::dict bodies_of(const ModelResult& model, const PointResult& point, const Shared& owner) {
  py::dict found;
  for (std::size_t b = 0; b < point.bodies.size() && b < model.bodies.size(); ++b)
    found[model.bodies[b].name.c_str()] =
        py::dict("points"_a = rows(model.bodies[b].points, owner),
                 "cells"_a = rows(model.bodies[b].cells, owner),
                 "displacement"_a = rows(point.bodies[b].displacement, owner),
                 "stress"_a = rows(point.bodies[b].stress, owner));
  return found;
}

py::dict point_of(const ModelResult& model, const PointResult& point, const Shared& owner) {
  return py::dict("scalars"_a = scalars_of(point), "fields"_a = fields_of(model.grid, point, owner),
                  "error_estimate"_a = point.error_estimate, "no_bar"_a = point.no_bar,
                  "model_error"_a = point.model_error, "richardson"_a = point.richardson,
                  "subsurface"_a = subsurface_of(point, owner),
                  "stress_maxima"_a = maxima_of(point),
                  "pass_work"_a = column(contact::pass_work(model.grid, point)),
                  "yielded"_a = yielded_of(point), "bodies"_a = bodies_of(model, point, owner));
}

py::dict model_of(const ModelResult& model, const Shared& owner) {
  py::array_t<double> x(model.grid.nx), y(model.grid.ny);
  for (int i = 0; i < model.grid.nx; ++i) x.mutable_at(i) = model.grid.x(i);
  for (int j = 0; j < model.grid.ny; ++j) y.mutable_at(j) = model.grid.y(j);
  py::list points;
  for (const PointResult& point : model.points) points.append(point_of(model, point, owner));
  return py::dict("name"_a = model.name, "label"_a = model.label, "key"_a = model.key(),
                  "seconds"_a = model.seconds, "unknowns"_a = model.unknowns,
                  "contact_elements"_a = model.contact_elements, "notes"_a = model.notes,
                  "choice"_a = model.choice, "shortfall"_a = model.shortfall,
                  "model_error_source"_a = model.model_error_source, "dx"_a = model.grid.dx,
                  "dy"_a = model.grid.dy, "x"_a = x, "y"_a = y,
                  "y_wheel"_a = column(model.rows.y_wheel), "y_rail"_a = column(model.rows.y_rail),
                  "width"_a = column(model.rows.width), "place"_a = place_of(model.place),
                  "points"_a = points);
}

}  // namespace

py::list models_of(const Shared& result) {
  py::list found;
  for (const ModelResult& model : result->models) found.append(model_of(model, result));
  return found;
}

py::object place_of(const std::optional<contact::ContactPlace>& place) {
  if (!place) return py::none();
  py::dict found;
  found["wheel"] = place->side();
  for (const postprocess::PlaceScalar& one : postprocess::place_scalars())
    found[one.name] = one.value(*place);
  for (const char* count : {"position", "patch", "patches"})
    found[count] = py::int_(static_cast<int>(found[count].cast<double>()));
  return found;
}

py::dict quantities() {
  py::dict found;
  for (const contact::Quantity& quantity : contact::quantities())
    found[quantity.name] = py::make_tuple(quantity.title, quantity.symbol, quantity.unit,
                                          quantity.meaning, contact::text_of(quantity.scale));
  return found;
}

py::dict fields() {
  py::dict found;
  for (const postprocess::PointField& field : postprocess::point_fields())
    found[field.name] = py::make_tuple(field.unit, field.description, field.sign);
  found["state"] =
      py::make_tuple("-", "state of the element", "0 exterior, 1 adhesion, 2 slip, 3 plastic");
  return found;
}

}  // namespace rollfem::python
