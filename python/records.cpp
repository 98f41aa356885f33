#include "python/records.hpp"

#include "contact/result/quantities.hpp"
#include "postprocess/write/point_table.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace rollfem::python {

namespace py = pybind11;

namespace {

/// An array on memory of the result, which cannot be written to.
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
  static const char* const kinds[] = {"point", "line", "plane", "surface"};
  py::list found;
  for (const contact::SubsurfaceField& field : point.subsurface) {
    py::dict one;
    one["kind"] = kinds[static_cast<int>(field.request.kind)];
    one["body"] = field.request.wheel ? "wheel" : "rail";
    one["points"] = rows(field.points, owner);
    one["displacement"] = rows(field.displacement, owner);
    one["stress"] = rows(field.stress, owner);
    found.append(one);
  }
  return found;
}

py::list maxima_of(const PointResult& point) {
  py::list found;
  for (const contact::StressMaximum& maximum : point.stress_maxima) {
    py::dict one;
    one["body"] = maximum.body;
    one["measure"] = maximum.measure;
    one["value"] = maximum.value;
    one["place"] = maximum.place;
    found.append(one);
  }
  return found;
}

py::dict bodies_of(const ModelResult& model, const PointResult& point, const Shared& owner) {
  py::dict found;
  for (std::size_t b = 0; b < point.bodies.size() && b < model.bodies.size(); ++b) {
    py::dict one;
    one["points"] = rows(model.bodies[b].points, owner);
    one["cells"] = rows(model.bodies[b].cells, owner);
    one["displacement"] = rows(point.bodies[b].displacement, owner);
    one["stress"] = rows(point.bodies[b].stress, owner);
    found[model.bodies[b].name.c_str()] = one;
  }
  return found;
}

py::dict point_of(const ModelResult& model, const PointResult& point, const Shared& owner) {
  py::dict found;
  found["scalars"] = scalars_of(point);
  found["fields"] = fields_of(model.grid, point, owner);
  found["error_estimate"] = point.error_estimate;
  found["no_bar"] = point.no_bar;
  found["model_error"] = point.model_error;
  found["richardson"] = point.richardson;
  found["subsurface"] = subsurface_of(point, owner);
  found["stress_maxima"] = maxima_of(point);
  found["bodies"] = bodies_of(model, point, owner);
  return found;
}

py::object place_of(const ModelResult& model) {
  if (!model.place) return py::none();
  py::dict found;
  found["wheel"] = model.place->left ? "left" : "right";
  for (const postprocess::PlaceScalar& one : postprocess::place_scalars())
    found[one.name] = one.value(*model.place);
  for (const char* count : {"position", "patch", "patches"})
    found[count] = py::int_(static_cast<int>(found[count].cast<double>()));
  return std::move(found);
}

py::dict model_of(const ModelResult& model, const Shared& owner) {
  py::dict found;
  found["name"] = model.name;
  found["label"] = model.label;
  found["key"] = model.key();
  found["seconds"] = model.seconds;
  found["unknowns"] = model.unknowns;
  found["contact_elements"] = model.contact_elements;
  found["notes"] = model.notes;
  found["choice"] = model.choice;
  found["shortfall"] = model.shortfall;
  found["model_error_source"] = model.model_error_source;
  found["dx"] = model.grid.dx;
  found["dy"] = model.grid.dy;
  py::array_t<double> x(model.grid.nx), y(model.grid.ny);
  for (int i = 0; i < model.grid.nx; ++i) x.mutable_at(i) = model.grid.x(i);
  for (int j = 0; j < model.grid.ny; ++j) y.mutable_at(j) = model.grid.y(j);
  found["x"] = x;
  found["y"] = y;
  found["place"] = place_of(model);
  py::list points;
  for (const PointResult& point : model.points) points.append(point_of(model, point, owner));
  found["points"] = points;
  return found;
}

}  // namespace

py::list models_of(const Shared& result) {
  py::list found;
  for (const ModelResult& model : result->models) found.append(model_of(model, result));
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
  found["state"] = py::make_tuple("-", "state of the element", "0 exterior, 1 adhesion, 2 slip");
  return found;
}

}  // namespace rollfem::python
