// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/caches/correction_file.hpp"

#include "contact/result/record.hpp"
#include "halfspace/stress/smooth_stress.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rollfem::modelling {

using halfspace::SmoothBox;
using halfspace::SmoothDepthMap;
using halfspace::SmoothMap;
using halfspace::SmoothParts;
using postprocess::NamedValues;

namespace {

void put(NamedValues& values, const std::string& name, const SmoothBox& box) {
  values.numbers[name + "_half_length"] = box.half_length;
  values.numbers[name + "_half_width"] = box.half_width;
  values.numbers[name + "_middle"] = box.middle;
}

/// Common part of the maps on and below the surface.
template <class Map>
void put_map(NamedValues& values, const std::string& name, const Map& map) {
  if (map.empty()) return;
  put(values, name + "_loads", map.loads);
  put(values, name + "_fields", map.fields);
  values.numbers[name + "_load_degree"] = map.load_degree;
  values.numbers[name + "_field_degree"] = map.field_degree;
  values.matrices[name + "_coefficients"] = map.coefficients;
}

void put(NamedValues& values, const std::string& name, const SmoothDepthMap& map) {
  put_map(values, name, map);
  if (!map.empty()) values.numbers[name + "_depth"] = map.depth;
}

double number(const NamedValues& values, const std::string& name) {
  const auto found = values.numbers.find(name);
  if (found == values.numbers.end()) throw std::runtime_error("there is no number " + name);
  return found->second;
}

SmoothBox box_of(const NamedValues& values, const std::string& name) {
  return {number(values, name + "_half_length"), number(values, name + "_half_width"),
          number(values, name + "_middle")};
}

Eigen::Index surface_terms(int degree) {
  return static_cast<Eigen::Index>(halfspace::polynomial_powers(degree).size());
}

/// `terms`: number of coefficients for a degree of the fields.
template <class Map, class Terms>
Map map_of(const NamedValues& values, const std::string& name, const Terms& terms) {
  Map map;
  const auto found = values.matrices.find(name + "_coefficients");
  if (found == values.matrices.end()) return map;
  map.loads = box_of(values, name + "_loads");
  map.fields = box_of(values, name + "_fields");
  map.load_degree = static_cast<int>(number(values, name + "_load_degree"));
  map.field_degree = static_cast<int>(number(values, name + "_field_degree"));
  map.coefficients = found->second;
  if (map.coefficients.rows() != terms(map.field_degree) ||
      map.coefficients.cols() != 3 * surface_terms(map.load_degree))
    throw std::runtime_error("the coefficients of " + name + " have the wrong shape");
  return map;
}

SmoothMap surface_map(const NamedValues& values, const std::string& name) {
  return map_of<SmoothMap>(values, name, [](int degree) { return 3 * surface_terms(degree); });
}

SmoothDepthMap depth_map(const NamedValues& values, const std::string& name) {
  auto map = map_of<SmoothDepthMap>(values, name, [](int degree) {
    return halfspace::smooth_components * halfspace::depth_polynomial_count(degree);
  });
  if (!map.empty()) map.depth = number(values, name + "_depth");
  return map;
}

void exchange(contact::Record& record, Eigen::MatrixXd& matrix) {
  Eigen::Index rows = matrix.rows(), columns = matrix.cols();
  contact::Field entries = Eigen::Map<contact::Field>(matrix.data(), matrix.size());
  record.values(rows, columns, entries);
  matrix = Eigen::Map<Eigen::MatrixXd>(entries.data(), rows, columns);
}

void exchange(contact::Record& record, NamedValues& values) {
  record.values(values.texts, values.numbers);
  std::size_t count = values.matrices.size();
  record.value(count);
  if (!record.reading()) {
    for (auto& [name, matrix] : values.matrices) {
      std::string label = name;
      record.value(label);
      exchange(record, matrix);
    }
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::string name;
    record.value(name);
    exchange(record, values.matrices[name]);
  }
}

}  // namespace

NamedValues values_of(const SmoothParts& parts) {
  NamedValues values;
  put_map(values, "wheel", parts.wheel);
  put_map(values, "rail", parts.rail);
  put(values, "wheel_below", parts.wheel_below);
  put(values, "rail_below", parts.rail_below);
  values.numbers["stresses"] = parts.stresses ? 1.0 : 0.0;
  values.numbers["unknowns"] = static_cast<double>(parts.unknowns);
  std::string& notes = values.texts["notes"];
  for (const std::string& note : parts.notes) notes += note + '\n';
  return values;
}

SmoothParts parts_of(const NamedValues& values) {
  SmoothParts parts;
  parts.wheel = surface_map(values, "wheel");
  parts.rail = surface_map(values, "rail");
  parts.wheel_below = depth_map(values, "wheel_below");
  parts.rail_below = depth_map(values, "rail_below");
  parts.stresses = number(values, "stresses") > 0.0;
  parts.unknowns = std::lround(number(values, "unknowns"));
  std::istringstream notes(values.texts.at("notes"));
  for (std::string note; std::getline(notes, note);) parts.notes.push_back(note);
  return parts;
}

std::string packed(NamedValues values) {
  contact::Record record;
  exchange(record, values);
  return record.bytes();
}

NamedValues unpacked(const std::string& bytes) {
  contact::Record record(bytes);
  NamedValues values;
  exchange(record, values);
  return values;
}

}  // namespace rollfem::modelling
