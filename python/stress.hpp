// Stress measures for arrays of Python.
#pragma once

#include <pybind11/numpy.h>

namespace rollfem::python {

namespace py = pybind11;

/// {"hydrostatic", "von_mises", "tresca", "orthogonal_shear": [...], "principal": [..., 3]} of
/// stresses [..., 6], MPa: xx, yy, zz, xy, yz, xz (contact/result/stress_measures.hpp). Raises
/// ValueError where the last axis is not of six.
py::dict stress_measures(const py::object& components);

}  // namespace rollfem::python
