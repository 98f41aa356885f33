// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/elasticity/level_checkpoint.hpp"

#include "contact/solve/state_record.hpp"

#include <fmt/format.h>

namespace rollfem::fem {

namespace {

using contact::Record;

void exchange(Record& record, LevelStart& start) {
  record.values(start.defect, start.contact_elements, start.unknowns, start.solver);
  record.values(start.reach, start.half, start.notes, start.bodies);
}

}  // namespace

LevelCheckpoint::LevelCheckpoint(contact::Checkpoint* store, double cell_size)
    : store_(store), cell_size_(cell_size) {}

std::string LevelCheckpoint::name_of(const std::string& part) const {
  return fmt::format("fem-{:.9g}mm-{}", cell_size_, part);
}

std::string LevelCheckpoint::kept(const std::string& part) const {
  return store_ == nullptr ? "" : store_->find(name_of(part)).value_or("");
}

bool LevelCheckpoint::find(LevelStart& start) const {
  const std::string bytes = kept("normal");
  if (bytes.empty()) return false;
  Record record(bytes);
  exchange(record, start);
  return true;
}

void LevelCheckpoint::keep(const LevelStart& start) const {
  if (store_ == nullptr) return;
  Record record;
  LevelStart copy = start;
  exchange(record, copy);
  store_->keep(name_of("normal"), record.bytes());
}

bool LevelCheckpoint::find(std::size_t k, contact::PointResult& point,
                           contact::ContactState& state) const {
  const std::string bytes = kept(fmt::format("{:04}", k + 1));
  if (bytes.empty()) return false;
  contact::read_point(bytes, point, state);
  return true;
}

void LevelCheckpoint::keep(std::size_t k, const contact::PointResult& point,
                           const contact::ContactState& state) const {
  if (store_ == nullptr) return;
  store_->keep(name_of(fmt::format("{:04}", k + 1)), contact::point_record(point, state));
}

}  // namespace rollfem::fem
