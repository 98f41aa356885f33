// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/python/caller.hpp"
#include "modelling/program/provenance.hpp"
#include "tables/files/table_files.hpp"
#include "tables/files/table_reader.hpp"
#include "tables/filling/table_filling.hpp"
#include "tables/filling/table_grid.hpp"

#include <algorithm>
#include <map>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::python {

using namespace py::literals;

namespace {

using tables::CreepTableReader;
using tables::TableForces;
using Column = std::vector<double>;

/// The table's answers to every row of columns of numbers, as columns F_x, F_y, M_z, both bars, the
/// force along the normal and the rise of the temperature.
template <class... Number>
auto over_rows(TableForces (*ask)(const CreepTableReader&, Number...)) {
  return [ask](const CreepTableReader& reader, const std::vector<Number>&... columns) {
    const std::size_t count = std::min({columns.size()...});
    std::vector<Column> found(7, Column(count));
    const FreeGil free;
    for (std::size_t k = 0; k < count; ++k) {
      const TableForces forces = ask(reader, columns[k]...);
      for (std::size_t q = 0; q < 3; ++q) found[q][k] = forces.forces[q];
      found[3][k] = forces.force_bar;
      found[4][k] = forces.moment_bar;
      found[5][k] = forces.along_normal;
      found[6][k] = forces.rise;
    }
    return found;
  };
}

std::map<std::string, Column> columns_of(const std::vector<tables::TableWheel>& wheels) {
  std::map<std::string, Column> found;
  for (const tables::WheelColumn& column : tables::wheel_columns())
    for (const tables::TableWheel& wheel : wheels)
      found[column.name].push_back(wheel.*column.member);
  return found;
}

/// Values of the wheel at arbitrary shifts and loads.
std::map<std::string, Column> wheels_at(const CreepTableReader& reader, const Column& shifts,
                                        const Column& loads) {
  std::vector<tables::TableWheel> wheels;
  for (std::size_t k = 0; k < shifts.size(); ++k)
    wheels.push_back(reader.wheel_at({shifts[k], loads[k]}));
  return columns_of(wheels);
}

CreepTableReader filled(const Case& input, py::object callback) {
  const std::string ignored = tables::ignored_keys(input);
  if (!ignored.empty() && PyErr_WarnEx(PyExc_UserWarning, ignored.c_str(), 2) < 0)
    throw py::error_already_set();
  return without_gil(std::move(callback), [&](const Progress& progress) {
    tables::CreepTable made = tables::empty_table(input);
    made.program = "rollfem " + modelling::version() + " (" + modelling::commit() + ")";
    made.command = "rollfem.table";
    tables::fill_table(made, input, progress, nullptr);
    return CreepTableReader(std::move(made));
  });
}

/// What `rollfem table` writes. h5py in another thread may hold the lock of HDF5 and wait for the
/// GIL, so HDF5 is used without it.
std::map<std::string, py::bytes> files_of(const CreepTableReader& reader) {
  const tables::CreepTable& table = reader.table();
  std::map<std::string, std::string> files;
  {
    const FreeGil free;
    files = {{"table.h5", tables::table_hdf5(table)},
             {"table.csv", tables::table_csv(table)},
             {"interpolation.csv", tables::interpolation_csv(table)}};
    if (table.over_shifts()) files.emplace("shifts.csv", tables::shifts_csv(table));
  }
  return {files.begin(), files.end()};
}

CreepTableReader read(const std::string& path) {
  const FreeGil free;
  return CreepTableReader(tables::read_table(path));
}

}  // namespace

void define_tables(py::module_& module) {
  py::class_<CreepTableReader>(module, "CreepTable")
      .def(py::init(&read))
      .def("files", &files_of)
      .def("wheels_at", &wheels_at)
      .def("scaled", over_rows(+[](const CreepTableReader& reader, double place, double load,
                                   double speed, double xi, double eta, double phi) {
             return reader.at({place, load, speed}, {xi, eta, phi});
           }))
      .def("of_wheel",
           over_rows(+[](const CreepTableReader& reader, double shift, double load, double speed,
                         double bound, double xi, double eta, double phi) {
             return reader.of_wheel({shift, load, speed}, bound, {xi, eta, phi});
           }))
      .def("physical",
           over_rows(+[](const CreepTableReader& reader, double a, double b, double modulus,
                         double bound, double speed, double xi, double eta, double phi) {
             return reader.physical(a, b, modulus, bound, {xi, eta, phi}, speed);
           }));
  module.def("fill_table", &filled);
}

}  // namespace rollfem::python
