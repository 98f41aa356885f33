#include "python/tables.hpp"

#include "postprocess/table/table_files.hpp"

#include <map>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace rollfem::python {

namespace py = pybind11;

namespace {

using postprocess::CreepTableReader;
using postprocess::TableForces;
using Column = std::vector<double>;

/// F_x, F_y, M_z, both bars and the force along the normal, a column each.
template <class Ask>
std::vector<Column> columns_of(std::size_t count, const Ask& ask) {
  std::vector<Column> found(6, Column(count));
  const py::gil_scoped_release free;
  for (std::size_t k = 0; k < count; ++k) {
    const TableForces forces = ask(k);
    for (std::size_t q = 0; q < 3; ++q) found[q][k] = forces.forces[q];
    found[3][k] = forces.force_bar;
    found[4][k] = forces.moment_bar;
    found[5][k] = forces.along_normal;
  }
  return found;
}

std::map<std::string, double> interpolation_of(const CreepTableReader& reader) {
  const postprocess::InterpolationError& error = reader.table().interpolation;
  std::map<std::string, double> found{{"points", error.points}, {"seed", error.seed}};
  for (const auto& [name, member] : postprocess::interpolation_errors) found[name] = error.*member;
  return found;
}

std::vector<Column> axes_of(const CreepTableReader& reader) {
  const postprocess::CreepTable& table = reader.table();
  return {table.places(), table.creepage[0], table.creepage[1], table.creepage[2]};
}

/// Of every shift.
std::map<std::string, Column> wheels_of(const CreepTableReader& reader) {
  std::map<std::string, Column> found;
  if (!reader.table().over_shifts()) return found;
  for (const postprocess::WheelColumn& column : postprocess::wheel_columns())
    for (const postprocess::TableWheel& wheel : reader.table().wheels)
      found[column.name].push_back(wheel.*column.member);
  return found;
}

/// At any shifts.
std::map<std::string, Column> wheels_at(const CreepTableReader& reader, const Column& shifts) {
  std::map<std::string, Column> found;
  for (const double shift : shifts) {
    const postprocess::TableWheel wheel = reader.wheel_at(shift);
    for (const postprocess::WheelColumn& column : postprocess::wheel_columns())
      found[column.name].push_back(wheel.*column.member);
  }
  return found;
}

}  // namespace

void define_tables(py::module_& module) {
  py::class_<CreepTableReader>(module, "CreepTable")
      .def(py::init(
          [](const std::string& path) { return CreepTableReader(postprocess::read_table(path)); }))
      .def_property_readonly("title", [](const CreepTableReader& r) { return r.table().title; })
      .def_property_readonly("case_text",
                             [](const CreepTableReader& r) { return r.table().case_text; })
      .def_property_readonly("poisson_ratio",
                             [](const CreepTableReader& r) { return r.table().poisson_ratio; })
      .def_property_readonly("over_shifts",
                             [](const CreepTableReader& r) { return r.table().over_shifts(); })
      .def_property_readonly("shear_modulus",
                             [](const CreepTableReader& r) { return r.table().shear_modulus; })
      .def_property_readonly(
          "friction_coefficient",
          [](const CreepTableReader& r) { return r.table().friction_coefficient; })
      .def_property_readonly("wheels", &wheels_of)
      .def_property_readonly("along_normal",
                             [](const CreepTableReader& r) { return r.table().along_normal; })
      .def_property_readonly("axes", &axes_of)
      .def_property_readonly("interpolation", &interpolation_of)
      .def_property_readonly("forces", [](const CreepTableReader& r) { return r.table().forces; })
      .def_property_readonly("bars", [](const CreepTableReader& r) { return r.table().bars; })
      .def("scaled",
           [](const CreepTableReader& reader, const Column& ratio, const Column& xi,
              const Column& eta, const Column& phi) {
             return columns_of(ratio.size(), [&](std::size_t k) {
               return reader.at(ratio[k], {xi[k], eta[k], phi[k]});
             });
           })
      .def("wheels_at", &wheels_at)
      .def("of_wheel",
           [](const CreepTableReader& reader, const Column& shift, const Column& bound,
              const Column& xi, const Column& eta, const Column& phi) {
             return columns_of(shift.size(), [&](std::size_t k) {
               return reader.of_wheel(shift[k], bound[k], {xi[k], eta[k], phi[k]});
             });
           })
      .def("physical", [](const CreepTableReader& reader, const Column& a, const Column& b,
                          const Column& modulus, const Column& bound, const Column& xi,
                          const Column& eta, const Column& phi) {
        return columns_of(a.size(), [&](std::size_t k) {
          return reader.physical(a[k], b[k], modulus[k], bound[k], {xi[k], eta[k], phi[k]});
        });
      });
}

}  // namespace rollfem::python
