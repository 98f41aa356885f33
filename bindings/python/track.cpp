// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/errors.hpp"
#include "bindings/python/bindings.hpp"
#include "profiles/profile_format.hpp"
#include "profiles/profiles.hpp"
#include "result/rigid_wheelset.hpp"
#include "track/balance/balance.hpp"
#include "track/motion/rigid_touch.hpp"

#include <cmath>
#include <limits>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace rollfem::python {

using namespace py::literals;

namespace {

/// A column of numbers, one for each row.
template <class Row, class Value>
py::array_t<double> column(const std::vector<Row>& rows, const Value& value) {
  py::array_t<double> found(static_cast<py::ssize_t>(rows.size()));
  double* to = found.mutable_data();
  for (const Row& row : rows) *to++ = value(row);
  return found;
}

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

void check_profiles(const Case& input, const char* what) {
  if (!input.has_profiles())
    throw InputError(input.file + ": " + what +
                     ": wheel and rail are given by radii, without a track; allowed: a case with "
                     "profiles; do: give wheel.profile, rail.profile and [wheelset]");
}

/// {name: (unit, meaning)} of what wheelset_of gives.
py::dict wheelset_columns() {
  py::dict found;
  contact::for_members<contact::RigidWheelset>([&](const auto& each) {
    if constexpr (std::decay_t<decltype(each)>::kept != contact::Kept::within)
      found[each.name] = py::make_tuple(each.unit, each.meaning);
  });
  return found;
}

/// The columns of wheelset.csv.
py::dict wheelset_of(const Case& input, double reach, double step) {
  check_profiles(input, "wheelset");
  std::vector<track::RigidWheelset> rows;
  {
    const py::gil_scoped_release free;
    rows = track::wheelset_rows(input, track::search_scene_of(input), reach, step);
  }
  py::dict found;
  contact::for_members<contact::RigidWheelset>([&](const auto& each) {
    if constexpr (std::decay_t<decltype(each)>::kept != contact::Kept::within)
      found[each.name] =
          column(rows, [&](const auto& row) { return or_nan(std::invoke(each.part, row)); });
  });
  return found;
}

py::list contact_points_of(const Case& input) {
  check_profiles(input, "contact_points");
  std::vector<track::WheelRailContact> contacts;
  {
    const py::gil_scoped_release free;
    contacts = track::place_wheels(input, track::search_scene_of(input));
  }
  py::list found;
  for (const track::WheelRailContact& contact : contacts) found.append(dict_of(contact.place));
  return found;
}

py::dict features_of(const profiles::ProfileCurve& curve, bool wheel) {
  const profiles::ProfileFeatures features = profiles::profile_features(curve, wheel);
  // The rail's inside is towards +z, the wheel's towards -z.
  const auto radius = [](const profiles::ProfilePoint& place) {
    constexpr double straight = 1e-6;  // 1/mm
    const double size = std::abs(place.curvature);
    return size > straight ? 1.0 / size : std::numeric_limits<double>::infinity();
  };
  const double up = radius(features.sharpest_up), down = radius(features.sharpest_down);
  std::vector<double> joints;
  for (const profiles::ProfileJoint& joint : features.joints) joints.push_back(joint.place.y);
  return py::dict("length"_a = features.length, "gauge_face"_a = features.gauge_face,
                  "flange_tip"_a = wheel ? profiles::flange_tip(curve) : std::nullopt,
                  "smallest_convex_radius"_a = wheel ? down : up,
                  "smallest_hollow_radius"_a = wheel ? up : down, "joints"_a = joints);
}

/// The profile of a body of the case, as it is mended.
py::dict profile_of(const Case& input, bool wheel) {
  profiles::ProfileReport report;
  std::vector<profiles::ProfileRow> rows;
  py::dict found;
  profiles::ProfileCurve curve;
  {
    const py::gil_scoped_release free;
    const contact::ProfileSource& source = wheel ? input.wheel.profile : input.rail.profile;
    // Where the flange must be is a matter of the wheelset.
    curve = source.name.empty() ? profiles::profile_of_case(input, wheel, &report)
                                : profiles::make_profile(source, wheel, input.file, &report);
    rows = profiles::profile_rows(curve, wheel);
  }
  using Row = profiles::ProfileRow;
  found = features_of(curve, wheel);
  found["kind"] = report.kind;
  found["points"] = report.points;
  const std::pair<const char*, double Row::*> columns[] = {{"s", &Row::s},
                                                           {"y", &Row::y},
                                                           {"z", &Row::z},
                                                           {"angle", &Row::angle},
                                                           {"curvature", &Row::curvature}};
  for (const auto& [name, member] : columns)
    found[name] = column(rows, [m = member](const Row& row) { return row.*m; });
  if (report.smoothing)
    found["smoothing"] =
        py::dict("scatter"_a = report.smoothing->scatter, "rms"_a = report.smoothing->rms,
                 "largest"_a = report.smoothing->largest);
  else
    found["smoothing"] = py::none();
  return found;
}

}  // namespace

void define_track(py::module_& module) {
  module.def("wheelset_columns", &wheelset_columns);
  module.def("wheelset", &wheelset_of);
  module.def("contact_points", &contact_points_of);
  module.def("profile", &profile_of);
  module.def("body_of_profile", [](const std::string& name) {
    const std::optional<bool> wheel = profiles::body_of_profile(name);
    return wheel ? std::optional<std::string>(*wheel ? "wheel" : "rail") : std::nullopt;
  });
}

}  // namespace rollfem::python
