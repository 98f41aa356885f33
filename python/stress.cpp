#include "python/stress.hpp"

#include "contact/result/stress_measures.hpp"

#include <stdexcept>

namespace rollfem::python {

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// For each of the stresses, `count` numbers.
template <class Measure>
py::array_t<double> measured(const Array& stress, py::ssize_t count, const Measure& measure) {
  std::vector<py::ssize_t> shape(stress.shape(), stress.shape() + stress.ndim() - 1);
  if (count > 1) shape.push_back(count);
  py::array_t<double> found(shape);
  const double* from = stress.data();
  double* to = found.mutable_data();
  for (py::ssize_t k = 0; k < stress.size() / 6; ++k, from += 6, to += count)
    measure(contact::Stress::from_array({from[0], from[1], from[2], from[3], from[4], from[5]}),
            to);
  return found;
}

}  // namespace

py::dict stress_measures(const py::object& components) {
  const Array stress = Array::ensure(components);
  if (!stress) throw py::error_already_set();
  if (stress.ndim() < 1 || stress.shape(stress.ndim() - 1) != 6)
    throw py::value_error(
        "stress_measures: the last axis of a stress has its six components xx, yy, zz, xy, yz, xz");
  using Value = double (*)(const contact::Stress&);
  py::dict found;
  for (const auto& [name, value] :
       {std::pair<const char*, Value>{"hydrostatic", contact::hydrostatic},
        {"von_mises", contact::von_mises},
        {"tresca", contact::tresca},
        {"orthogonal_shear", contact::orthogonal_shear}})
    found[name] = measured(
        stress, 1, [value = value](const contact::Stress& s, double* to) { *to = value(s); });
  found["principal"] = measured(stress, 3, [](const contact::Stress& s, double* to) {
    const std::array<double, 3> values = contact::principal(s);
    std::copy(values.begin(), values.end(), to);
  });
  return found;
}

}  // namespace rollfem::python
