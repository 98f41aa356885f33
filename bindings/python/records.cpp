// SPDX-License-Identifier: LGPL-2.1-or-later
// Results as Python sees them; and as bytes and back, for the processes of a pool: bit for bit, by
// the records of checkpoints.
#include "base/errors.hpp"
#include "bindings/python/bindings.hpp"
#include "modelling/program/provenance.hpp"
#include "result/quantities.hpp"
#include "result/record.hpp"
#include "result/write/contents.hpp"

#include <array>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace rollfem::python {

using namespace py::literals;

namespace {

using result::Array;
using result::Tree;
using Owner = std::shared_ptr<const void>;

/// A read-only array on the memory of the result.
py::array view(const Array& array, const Owner& result) {
  const std::array types{py::dtype::of<double>(), py::dtype::of<float>(), py::dtype::of<int>(),
                         py::dtype::of<unsigned char>()};
  const py::capsule keeper(new Owner(array.own ? array.own : result),
                           [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array found(types[static_cast<std::size_t>(array.type)],
                  std::vector<py::ssize_t>(array.shape.begin(), array.shape.end()), array.first,
                  keeper);
  found.attr("flags").attr("writeable") = false;
  return found;
}

py::dict attributes_of(const Tree& tree) {
  py::dict found;
  for (const auto& [name, value] : tree.attributes) found[name.c_str()] = py::cast(value);
  return found;
}

py::dict entries_of(const Tree& tree, const Owner& result) {
  py::dict found;
  for (const result::Entry& entry : tree.entries)
    if (const auto* array = std::get_if<Array>(&entry.values))
      found[entry.name.c_str()] = view(*array, result);
    else if (const auto* text = std::get_if<std::string>(&entry.values))
      found[entry.name.c_str()] = *text;
    else
      found[entry.name.c_str()] = std::get<std::vector<std::string>>(entry.values);
  return found;
}

/// (attributes, entries, parts)
py::tuple tuple_of(const Tree& tree, const Owner& result) {
  py::dict parts;
  for (const Tree& part : tree.parts) parts[part.name.c_str()] = tuple_of(part, result);
  return py::make_tuple(attributes_of(tree), entries_of(tree, result), parts);
}

/// All but the case.
void exchange(contact::Record& record, Result& result) {
  record.values(result.provenance, result.verdict, result.models, result.pairs, result.wheelset,
                result.rigid_row);
}

std::string program() {
  return modelling::version() + ' ' + modelling::commit();
}

/// A result as results.h5 holds it, (attributes, entries, parts) with dictionaries by name, parts
/// being such tuples. Arrays are views of the result without copies; each keeps the whole result
/// alive.
py::tuple contents_of(const Shared& result) {
  py::tuple whole = tuple_of(result::head_tree(*result), result);
  py::dict models;
  for (const ModelResult& model : result->models) {
    py::tuple one = tuple_of(result::model_tree(model, result->input), result);
    one[0]["model"] = model.name;
    one[0]["order"] = models.size();
    py::dict points;
    for (std::size_t k = 0; k < model.points.size(); ++k) {
      const Tree point = result::point_tree(model, k, true);
      points[point.name.c_str()] = tuple_of(point, result);
    }
    one[2]["points"] = py::make_tuple(py::dict(), py::dict(), points);
    models[model.key().c_str()] = one;
  }
  whole[2]["models"] = py::make_tuple(py::dict(), py::dict(), models);
  return whole;
}

/// The state of a pickled result, and the result of a state.
py::tuple packed(const Result& result) {
  Result copy = result;
  contact::Record record;
  exchange(record, copy);
  return py::make_tuple(program(), copy.input.text, copy.input.file, copy.input.models,
                        py::bytes(record.bytes()));
}

Shared unpacked(const py::tuple& state) {
  if (state[0].cast<std::string>() != program())
    throw InputError("a pickled result belongs to another version of rollfem (" +
                     state[0].cast<std::string>() + "); do: unpickle it there, and write it");
  auto result = std::make_shared<Result>();
  result->input = parse_case(state[1].cast<std::string>(), state[2].cast<std::string>());
  result->input.models = state[3].cast<std::vector<std::string>>();
  contact::Record record(state[4].cast<std::string>());
  exchange(record, *result);
  return result;
}

/// {name: (title, symbol, unit, meaning, percent_of, whether models are compared by it)}, in the
/// order of the files.
py::dict quantities() {
  py::dict found;
  for (const contact::Quantity& quantity : contact::quantities())
    found[quantity.name] = py::make_tuple(quantity.title, quantity.symbol, quantity.unit,
                                          quantity.meaning, contact::text_of(quantity.scale),
                                          quantity.use >= contact::QuantityUse::compared);
  return found;
}

/// {name: (unit, description, sign)}
py::dict fields() {
  py::dict found;
  for (const contact::PointField& field : contact::point_fields())
    found[field.name] = py::make_tuple(field.unit, field.description, field.sign);
  found["state"] = py::make_tuple("-", contact::state_meaning, "");
  return found;
}

}  // namespace

void define_results(py::module_& module) {
  py::class_<Result, std::shared_ptr<Result>>(module, "Result")
      .def_readonly("verdict", &Result::verdict)
      .def(py::pickle(&packed, &unpacked));
  module.def("contents_of", &contents_of);
  module.def("quantities", &quantities);
  module.def("fields", &fields);
}

}  // namespace rollfem::python
