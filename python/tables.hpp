// Tables for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace rollfem::python {

/// The class CreepTable, on which rollfem.Table is made.
void define_tables(pybind11::module_& module);

}  // namespace rollfem::python
