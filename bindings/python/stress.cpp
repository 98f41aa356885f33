// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress and displacement below the surface of stored load points: sums over the tractions of a
// contact, and interpolation in bodies of finite elements. Where, and what follows from it, is
// Python's (postprocess/rollfem/commands/subsurface.py).
#include "bindings/python/caller.hpp"
#include "case/reading/case_reader.hpp"
#include "halfspace/stress/stress_maxima.hpp"
#include "modelling/stress/body_sampler.hpp"
#include "modelling/stress/corrected_stress.hpp"
#include "result/heat/temperature.hpp"
#include "result/stress_extremes.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace rollfem::python {

using namespace py::literals;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
template <std::size_t width, class Number = double>
using Rows = std::vector<std::array<Number, width>>;

template <std::size_t width, class Number = double>
Rows<width, Number> rows_of(
    const py::array_t<Number, py::array::c_style | py::array::forcecast>& array) {
  Rows<width, Number> rows(static_cast<std::size_t>(array.size()) / width);
  if (!rows.empty()) std::copy_n(array.data(), rows.size() * width, rows.front().data());
  return rows;
}

template <std::size_t width>
py::array_t<double> array_of(const Rows<width>& rows) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(width)});
  if (!rows.empty()) std::copy_n(rows.front().data(), rows.size() * width, array.mutable_data());
  return array;
}

contact::Field field_of(const Array& array) {
  return Eigen::Map<const contact::Field>(array.data(), array.size());
}

/// Tractions of a load point on its grid.
struct Loaded {
  contact::ContactGrid grid;
  contact::SurfaceField traction;

  halfspace::LoadedBody body(bool wheel, const contact::Material& material) const {
    return {wheel ? halfspace::Body::wheel : halfspace::Body::rail, material, grid, traction};
  }
  /// With what else largest stresses need.
  PointResult point(double semi_axis_x, double semi_axis_y) const {
    PointResult made;
    made.fields.traction = traction;
    made.semi_axis_x = semi_axis_x;
    made.semi_axis_y = semi_axis_y;
    return made;
  }
};

Loaded loaded(const Array& x, const Array& y, double dx, double dy, double line_reference,
              const Array& pressure, const Array& along, const Array& across) {
  return {{static_cast<int>(x.size()), static_cast<int>(y.size()), dx, dy, x.at(0), y.at(0),
           line_reference},
          {field_of(along), field_of(across), field_of(pressure)}};
}

/// (displacement [n, 3], stress [n, 6]) of a body as half-space at places [n, 3].
py::tuple below(const Loaded& load, bool wheel, double young, double poisson, const Array& places) {
  std::vector<halfspace::SubsurfacePoint> points;
  for (const auto& place : rows_of<3>(places))
    points.push_back({place[0], place[1], wheel ? place[2] : 0.0 - place[2]});
  Rows<3> displacement;
  Rows<6> stress;
  for (const halfspace::SubsurfaceState& state : without_gil(py::none(), [&](const Progress&) {
         return halfspace::smooth_subsurface_at(load.body(wheel, {young, poisson}), points);
       })) {
    displacement.push_back(state.displacement);
    stress.push_back(state.stress);
  }
  return py::make_tuple(array_of(displacement), array_of(stress));
}

/// Dictionaries body, measure, value, place.
py::list maxima_of(const std::vector<contact::StressMaximum>& maxima) {
  py::list found;
  for (const contact::StressMaximum& maximum : maxima) found.append(dict_of(maximum));
  return found;
}

/// The largest stresses of wheel and rail as half-spaces; `materials`: (E, nu) of both.
py::list maxima(const Loaded& load, const std::array<std::array<double, 2>, 2>& materials,
                double semi_axis_x, double semi_axis_y) {
  Case input;
  input.wheel.material = {materials[0][0], materials[0][1]};
  input.rail.material = {materials[1][0], materials[1][1]};
  return maxima_of(without_gil(py::none(), [&](const Progress&) {
    return halfspace::stress_maxima(input, load.grid, load.point(semi_axis_x, semi_axis_y));
  }));
}

contact::SubsurfaceRequest request_of(const py::dict& places) {
  using Kind = contact::SubsurfaceRequest::Kind;
  contact::SubsurfaceRequest request;
  for (const Kind kind : {Kind::point, Kind::line, Kind::plane, Kind::surface})
    if (places["kind"].cast<std::string>() == word_of(kind)) request.kind = kind;
  request.wheel = places["body"].cast<std::string>() == "wheel";
  request.from = places["from"].cast<std::array<double, 3>>();
  request.to = places["to"].cast<std::array<double, 3>>();
  request.across = places["across"].cast<std::array<double, 3>>();
  request.depth = places["depth"].cast<double>();
  request.points = places["points"].cast<std::array<int, 2>>();
  return request;
}

py::list read_places(const std::string& path) {
  py::list found;
  for (const contact::SubsurfaceRequest& request : contact::read_places(path))
    found.append(py::dict("kind"_a = word_of(request.kind),
                          "body"_a = request.wheel ? "wheel" : "rail", "from"_a = request.from,
                          "to"_a = request.to, "across"_a = request.across,
                          "depth"_a = request.depth, "points"_a = request.points));
  return found;
}

/// ([(places, displacement, stress)] of the requests, largest stresses) of the model that corrects
/// half-spaces. `place`: of the patch or None; `requests`: (request, whether along the normal).
py::tuple corrected(const Loaded& load, const Case& input, const py::object& place,
                    double semi_axis_x, double semi_axis_y,
                    const std::vector<std::pair<py::dict, bool>>& requests) {
  std::optional<contact::ContactPlace> patch;
  if (!place.is_none()) {
    patch.emplace();
    patch->left = place["wheel"].cast<std::string>() == "left";
    patch->position = place["position"].cast<int>();
    patch->patch = place["patch"].cast<int>();
    patch->patches = place["patches"].cast<int>();
  }
  std::vector<modelling::StoredRequest> asked;
  for (const auto& [request, along_normal] : requests)
    asked.push_back({request_of(request), along_normal});
  PointResult point = load.point(semi_axis_x, semi_axis_y);
  without_gil(py::none(), [&](const Progress&) {
    modelling::add_corrected_stress(input, patch, load.grid, asked, point);
    return 0;
  });
  py::list fields;
  for (const contact::SubsurfaceField& field : point.subsurface)
    fields.append(py::make_tuple(array_of(field.points), array_of(field.displacement),
                                 array_of(field.stress)));
  return py::make_tuple(fields, maxima_of(point.stress_maxima));
}

/// A stored body of finite elements.
class StoredBody {
 public:
  StoredBody(const std::string& name, const Array& points,
             const py::array_t<int, py::array::c_style | py::array::forcecast>& cells,
             const Array& displacement, const Array& stress)
      : body_{name, rows_of<3>(points), rows_of<8, int>(cells), rows_of<3>(displacement),
              rows_of<6>(stress)},
        sampler_(body_) {}
  StoredBody(const StoredBody&) = delete;
  StoredBody& operator=(const StoredBody&) = delete;

  /// (places [n, 3], displacement, stress, distance [n] by which a place was moved).
  py::tuple at(const Array& places) const {
    Rows<3> found, displacement;
    Rows<6> stress;
    Rows<1> moved;
    for (const auto& place : rows_of<3>(places)) {
      const modelling::BodySample sample = sampler_.at(place);
      found.push_back(sample.place);
      displacement.push_back(sample.displacement);
      stress.push_back(sample.stress);
      moved.push_back({sample.moved});
    }
    return py::make_tuple(array_of(found), array_of(displacement), array_of(stress),
                          array_of(moved));
  }
  double surface(double x, double y, double inner, double outer) const {
    return sampler_.surface(x, y, inner, outer);
  }
  /// The largest range of xz below a patch with these semi-axes and this middle.
  py::list xz_range(double semi_axis_x, double semi_axis_y, double x, double y) const {
    PointResult point;
    point.semi_axis_x = semi_axis_x;
    point.semi_axis_y = semi_axis_y;
    point.patch_x_middle = x;
    point.patch_y_middle = y;
    const double sign = body_.name == "wheel" ? 1.0 : -1.0;
    const auto within = [&](double value, std::size_t c) {
      return std::clamp(value, sampler_.lower()[c], sampler_.upper()[c]);
    };
    const contact::RollingLines lines = contact::rolling_lines(
        point, contact::rolling_step(point), contact::rolling_layers,
        [&](double along, double across, double depth) {
          return modelling::Place{within(along, 0), within(across, 1), within(sign * depth, 2)};
        });
    std::vector<double> xz;
    for (const modelling::Place& place : lines.places) xz.push_back(sampler_.at(place).stress[5]);
    return maxima_of({contact::largest_xz_range(body_.name, lines, xz)});
  }

 private:
  contact::BodyField body_;
  modelling::BodySampler sampler_;
};

/// {model with stress: where its stress comes from}, the reference of the models first.
std::vector<std::pair<std::string, std::string>> models_with_stress() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const std::string& name : known_models().names(&contact::ModelInfo::has_stress)) {
    const contact::ModelInfo& model = known_models().at(name);
    found.emplace_back(name, model.keeps_bodies      ? "bodies"
                             : model.corrects_stress ? "corrected"
                                                     : "tractions");
  }
  return found;
}

}  // namespace

void define_stress(py::module_& module) {
  module.def("read_places", &read_places);
  module.def("models_with_stress", &models_with_stress);
  module.def("line_reference", [](const Case& input) {
    const contact::Geometry geometry(input);
    return geometry.line ? geometry.line->reference : 0.0;
  });
  // Effusivity, diffusivity, temperature before contact and expansion of a body, and the speed.
  module.def("heated_body", [](const Case& input, bool wheel) -> py::object {
    const auto heat = contact::surface_heat(input);
    if (!heat) return py::none();
    const contact::HeatedBody& body = wheel ? heat->wheel : heat->rail;
    return py::make_tuple(body.effusivity, body.diffusivity, body.temperature, body.expansion,
                          heat->speed);
  });
  // K at places (x, y, depth) below a row of elements [ny, nx] of a body (as heated_body).
  module.def("rise_below", [](const std::array<double, 5>& body, const Array& x, const Array& y,
                              double dx, double dy, const Array& surface, const Array& places) {
    const contact::ContactGrid grid{
        static_cast<int>(x.size()), static_cast<int>(y.size()), dx, dy, x.at(0), y.at(0)};
    return contact::rise_below(grid, {body[0], body[1], body[3], body[2]}, body[4],
                               field_of(surface), rows_of<3>(places));
  });
  py::class_<Loaded>(module, "Loaded")
      .def(py::init(&loaded))
      .def("below", &below)
      .def("maxima", &maxima)
      .def("corrected", &corrected);
  py::class_<StoredBody>(module, "StoredBody")
      .def(py::init<const std::string&, const Array&,
                    const py::array_t<int, py::array::c_style | py::array::forcecast>&,
                    const Array&, const Array&>())
      .def("at", &StoredBody::at)
      .def("surface", &StoredBody::surface)
      .def("xz_range", &StoredBody::xz_range);
}

}  // namespace rollfem::python
