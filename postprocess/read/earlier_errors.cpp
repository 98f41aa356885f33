#include "postprocess/read/earlier_errors.hpp"

#include "contact/result/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::postprocess {
namespace {

constexpr double least_part = 0.01;

double size_in_version_1(const contact::PointResult& point, const std::string& name,
                         double friction) {
  if (name == "subsurface_stress") return point.max_pressure;
  for (const contact::StressMaximum& maximum : point.stress_maxima)
    if (name == "max_" + maximum.measure + "_" + maximum.body)
      return std::max(maximum.value, least_part * point.max_pressure);
  const contact::Quantity* quantity = contact::find_quantity(name);
  if (quantity == nullptr) return 1.0;  // the energy norm, which is relative to this day
  const double least = name == "longitudinal_creepage" || name == "lateral_creepage"
                           ? std::hypot(point.creepage.longitudinal, point.creepage.lateral)
                           : contact::full_sliding(*quantity, point, friction);
  return std::max(std::abs(quantity->value(point).value_or(0.0)), least_part * least);
}

}  // namespace

void make_errors_absolute(contact::PointResult& point, double friction_coefficient) {
  for (auto& [name, error] : point.error_estimate)
    error *= size_in_version_1(point, name, friction_coefficient);
  // Theories told that of the force alone.
  const auto force = point.error_estimate.find("longitudinal_force");
  if (force != point.error_estimate.end() && point.normal_force > 0.0)
    point.error_estimate.emplace("traction_coefficient", force->second / point.normal_force);
}

}  // namespace rollfem::postprocess
