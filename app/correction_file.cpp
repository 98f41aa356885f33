#include "app/correction_file.hpp"

#include "contact/result/record.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rollfem::app {

using halfspace::SmoothBox;
using halfspace::SmoothMap;
using halfspace::SmoothParts;
using postprocess::NamedValues;

namespace {

void put(NamedValues& values, const std::string& name, const SmoothBox& box) {
  values.numbers[name + "_half_length"] = box.half_length;
  values.numbers[name + "_half_width"] = box.half_width;
  values.numbers[name + "_middle"] = box.middle;
}

void put(NamedValues& values, const std::string& name, const SmoothMap& map) {
  if (map.empty()) return;
  put(values, name + "_loads", map.loads);
  put(values, name + "_fields", map.fields);
  values.numbers[name + "_load_degree"] = map.load_degree;
  values.numbers[name + "_field_degree"] = map.field_degree;
  values.matrices[name + "_coefficients"] = map.coefficients;
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

SmoothMap map_of(const NamedValues& values, const std::string& name) {
  const auto found = values.matrices.find(name + "_coefficients");
  if (found == values.matrices.end()) return {};
  SmoothMap map{box_of(values, name + "_loads"), box_of(values, name + "_fields"),
                static_cast<int>(number(values, name + "_load_degree")),
                static_cast<int>(number(values, name + "_field_degree")), found->second};
  const auto terms = [](int degree) {
    return static_cast<Eigen::Index>(halfspace::polynomial_powers(degree).size());
  };
  if (map.coefficients.rows() != 3 * terms(map.field_degree) ||
      map.coefficients.cols() != 3 * terms(map.load_degree))
    throw std::runtime_error("the coefficients of " + name + " have another shape");
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
  put(values, "wheel", parts.wheel);
  put(values, "rail", parts.rail);
  values.numbers["unknowns"] = static_cast<double>(parts.unknowns);
  std::string& notes = values.texts["notes"];
  for (const std::string& note : parts.notes) notes += note + '\n';
  return values;
}

SmoothParts parts_of(const NamedValues& values) {
  SmoothParts parts;
  parts.wheel = map_of(values, "wheel");
  parts.rail = map_of(values, "rail");
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

}  // namespace rollfem::app
