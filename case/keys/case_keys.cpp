// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/keys/case_keys.hpp"

#include "case/keys/key_builder.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>

namespace rollfem::contact {

namespace {

struct Declarations {
  std::vector<Section> sections;
  std::vector<Key> keys;
};

Declarations gather(const Sections& of_models) {
  Declarations all;
  std::vector<std::size_t> counts;
  const auto add = [&](const Sections& sections) {
    for (const SectionWithKeys& declared : sections) {
      all.sections.push_back(declared.section);
      counts.push_back(declared.keys.size());
      all.keys.insert(all.keys.end(), declared.keys.begin(), declared.keys.end());
    }
  };
  for (auto* declare : {&load_sections, &friction_sections, &body_sections, &track_sections,
                        &rolling_sections, &contact_sections})
    add(declare());
  add(of_models);
  add(output_sections());
  const Key* next = all.keys.data();
  for (std::size_t k = 0; k < counts.size(); ++k) {
    all.sections[k].first = next;
    all.sections[k].last = next += counts[k];
  }
  return all;
}

struct Known {
  std::mutex one_at_a_time;
  Sections of_models;
  std::deque<Declarations> all;  ///< the last holds; someone may still point to keys of others
};

Known& known() {
  static Known one;
  return one;
}

const Declarations& declarations() {
  const std::lock_guard lock(known().one_at_a_time);
  if (known().all.empty()) known().all.push_back(gather(known().of_models));
  return known().all.back();
}

}  // namespace

bool Bounds::contains(double value) const {
  if ((infinite && value == infinity) || (zero && value == 0.0)) return true;
  if (none && std::isnan(value)) return true;
  if (!std::isfinite(value)) return false;
  const double bounded = magnitude ? std::abs(value) : value;
  return bounded >= lower && (upper_open ? bounded < upper : bounded <= upper);
}

KeyValue shortened(Numbers values) {
  if (std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
    return {};
  const bool same = std::all_of(values.begin(), values.end(),
                                [&](double value) { return value == values.front(); });
  if (same) values.resize(1);
  return values;
}

void grow_load_points(Case& input, std::size_t count) {
  auto& creepages = input.rolling.creepages;
  if (creepages.size() == 1) creepages.resize(count, creepages.front());
  const auto follow = [&](auto& entries) {
    if (!entries.empty()) entries.resize(creepages.size(), entries.front());
  };
  follow(input.rolling.forces);
  Wheelset& wheelset = input.wheelset;
  for (auto* list :
       {&wheelset.rotation_change, &wheelset.longitudinal_force, &wheelset.axle_torque})
    follow(*list);
  follow(input.history);
}

void add_section(SectionWithKeys added) {
  const std::lock_guard lock(known().one_at_a_time);
  Sections& sections = known().of_models;
  const Section& section = added.section;
  auto place = sections.begin();
  for (auto other = sections.begin(); other != sections.end(); ++other) {
    if (other->section.name == section.name) return;
    if (other->section.position <= section.position) place = other + 1;
  }
  sections.insert(place, std::move(added));
  if (!known().all.empty()) known().all.push_back(gather(sections));
}

const std::vector<Section>& case_sections() {
  return declarations().sections;
}

const std::vector<Key>& case_keys() {
  return declarations().keys;
}

const Key* find_key(const std::string& section, const std::string& name) {
  for (const Key& key : case_keys())
    if (key.section == section && key.name == name) return &key;
  return nullptr;
}

const Key* find_key(const std::string& path) {
  const std::size_t dot = path.rfind('.');  // names of sections may have one, names of keys not
  return dot == path.npos ? find_key("", path)
                          : find_key(path.substr(0, dot), path.substr(dot + 1));
}

}  // namespace rollfem::contact
