// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/balance_record.hpp"

#include "contact/result/record.hpp"

#include <stdexcept>

namespace rollfem::track {

namespace {

using contact::Record;

void exchange(Record& record, contact::Creepage& creepage) {
  record.values(creepage.longitudinal, creepage.lateral, creepage.spin);
}

void exchange(Record& record, contact::LoadPoint& point) {
  record.values(point.load.force, point.load.approach, point.load.direction[0],
                point.load.direction[1]);
  exchange(record, point.creepage);
  bool has_error = point.creepage_error.has_value();
  record.value(has_error);
  if (!has_error) return;
  if (!point.creepage_error) point.creepage_error.emplace();
  exchange(record, *point.creepage_error);
}

/// All values of a placed scene that the balance changes.
void exchange(Record& record, contact::Scene& scene) {
  record.values(scene.place->patch, scene.place->patches, scene.turns_freely);
  std::size_t neighbours = scene.neighbour_loads.size();
  record.value(neighbours);
  if (record.reading()) scene.neighbour_loads.assign(neighbours, {});
  for (contact::NeighbourLoad& load : scene.neighbour_loads)
    record.values(load.x, load.y, load.longitudinal, load.lateral, load.normal, load.turn);
  for (contact::LoadPoint& point : scene.points) exchange(record, point);
}

/// Index of the placed patch from which a scene was made: its position on the track stays the same.
std::size_t source_of(const std::vector<PlacedScene>& placed, const contact::Scene& scene) {
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const contact::ContactPlace& place = *placed[i].scene.place;
    if (place.left == scene.place->left && place.y_track == scene.place->y_track) return i;
  }
  throw std::runtime_error("a balanced patch was not placed");
}

}  // namespace

std::string record_of_balance(const std::vector<PlacedScene>& placed,
                              std::vector<contact::Scene> balanced) {
  Record record;
  std::size_t count = balanced.size();
  record.value(count);
  for (contact::Scene& scene : balanced) {
    std::size_t source = source_of(placed, scene);
    record.value(source);
    exchange(record, scene);
  }
  return record.bytes();
}

std::vector<contact::Scene> balance_of_record(const std::vector<PlacedScene>& placed,
                                              const std::string& bytes) {
  Record record(bytes);
  std::size_t count = 0;
  record.value(count);
  std::vector<contact::Scene> balanced;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t source = 0;
    record.value(source);
    balanced.push_back(placed.at(source).scene);
    exchange(record, balanced.back());
  }
  if (!record.exhausted()) throw std::runtime_error("a record of another balance");
  return balanced;
}

}  // namespace rollfem::track
