// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/caches/correction_file.hpp"

#include "contact/result/record.hpp"

#include <stdexcept>

namespace rollfem::modelling {

using contact::Record;
using halfspace::SmoothBox;
using halfspace::SmoothDepthMap;
using halfspace::SmoothParts;

namespace {

void exchange(Record& record, SmoothBox& box) {
  record.values(box.half_length, box.half_width, box.middle);
}

/// Common part of the maps on and below the surface.
template <class Map>
void exchange(Record& record, Map& map) {
  exchange(record, map.loads);
  exchange(record, map.fields);
  Eigen::Index rows = map.coefficients.rows(), columns = map.coefficients.cols();
  contact::Field entries = map.coefficients.reshaped();
  record.values(map.load_degree, map.field_degree, rows, columns, entries);
  if (entries.size() != rows * columns) throw std::runtime_error("a map of another shape");
  map.coefficients = entries.reshaped(rows, columns);
}

void exchange(Record& record, SmoothParts& parts) {
  exchange(record, parts.wheel);
  exchange(record, parts.rail);
  for (SmoothDepthMap* below : {&parts.wheel_below, &parts.rail_below}) {
    exchange(record, *below);
    record.value(below->depth);
  }
  std::size_t notes = parts.notes.size();
  record.values(parts.stresses, parts.unknowns, notes);
  if (record.reading()) parts.notes.clear();
  for (std::size_t k = 0; k < notes; ++k) {
    if (record.reading()) parts.notes.emplace_back();
    record.value(parts.notes[k]);
  }
}

}  // namespace

std::string packed(SmoothParts parts) {
  Record record;
  exchange(record, parts);
  return record.bytes();
}

SmoothParts unpacked(const std::string& bytes) {
  Record record(bytes);
  SmoothParts parts;
  exchange(record, parts);
  if (!record.exhausted()) throw std::runtime_error("a correction of another program");
  return parts;
}

}  // namespace rollfem::modelling
