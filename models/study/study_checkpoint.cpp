// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/study/study_checkpoint.hpp"

#include "contact/result/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace rollfem::modelling {

namespace {

using postprocess::StudyLevel;

std::string bytes_of(const StudyLevel& level) {
  contact::Record record;
  StudyLevel copy = level;
  record.values(copy.label, copy.parameter, copy.unknowns, copy.contact_elements);
  record.values(copy.seconds, copy.values, copy.bars, copy.noise);
  return record.bytes();
}

StudyLevel level_of(const std::string& bytes) {
  contact::Record record(bytes);
  StudyLevel level;
  record.values(level.label, level.parameter, level.unknowns, level.contact_elements);
  record.values(level.seconds, level.values, level.bars, level.noise);
  return level;
}

}  // namespace

LevelPoints::LevelPoints(postprocess::CheckpointFolder* folder, std::string level)
    : folder_(folder), prefix_(std::move(level) + "-of-") {}

std::optional<std::string> LevelPoints::find(const std::string& name) {
  if (folder_ == nullptr) return {};
  std::optional<std::string> bytes = folder_->find(prefix_ + name);
  if (!bytes) return {};
  contact::Record record(*bytes);
  double seconds = 0.0;
  std::string content;
  record.values(seconds, content);
  before_ = std::max(before_, seconds);
  return content;
}

void LevelPoints::keep(const std::string& name, const std::string& content) {
  if (folder_ == nullptr) return;
  contact::Record record;
  double seconds = before_ + std::chrono::duration<double>(Clock::now() - begin_).count();
  std::string copy = content;
  record.values(seconds, copy);
  folder_->keep(prefix_ + name, record.bytes());
}

void LevelPoints::drop() {
  if (folder_ != nullptr) folder_->drop(prefix_);
}

std::string level_record_name(const std::string& place_key, const postprocess::StudySeries& series,
                              const StudyLevel& level) {
  // The exact parameter is part of the name, because labels are rounded; it belongs to the last
  // refined quantity.
  std::string name = fmt::format("level-{}-{}-{}-{}-{:.12g}", place_key, series.model, series.vary,
                                 level.label, level.parameter);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '-'; }, '-');
  return name;
}

std::optional<StudyLevel> find_level(postprocess::CheckpointFolder* folder, const std::string& name,
                                     const ParallelSession* everywhere) {
  std::string bytes;
  if (folder != nullptr) bytes = folder->find(name).value_or("");
  if (everywhere != nullptr) bytes = everywhere->from_first(bytes);
  if (bytes.empty()) return {};
  return level_of(bytes);
}

void keep_level(postprocess::CheckpointFolder* folder, const std::string& name,
                const StudyLevel& level) {
  if (folder != nullptr) folder->keep(name, bytes_of(level));
}

}  // namespace rollfem::modelling
