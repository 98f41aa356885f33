// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/caches/correction_cache.hpp"

#include "base/errors.hpp"
#include "hybrid/correction_scene.hpp"
#include "modelling/program/provenance.hpp"
#include "result/files/files_together.hpp"
#include "result/files/result_folder.hpp"
#include "result/files/seal.hpp"
#include "result/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace fs = std::filesystem;

namespace rollfem::modelling {

using hybrid::SmoothDepthMap;
using hybrid::SmoothParts;

namespace {

/// Version of the files and of the way corrections are computed: raise it when the same scene gets
/// another correction.
constexpr int format = 4;

constexpr const char* suffix = ".correction";
constexpr const char* part_suffix = ".part";

bool is_ours(const fs::path& file) {
  return file.filename().string().find(suffix) != std::string::npos;
}

bool is_entry(const fs::path& file) {
  return is_ours(file) && file.extension() != part_suffix;
}

std::atomic<bool> switched_off{false};

fs::path folder_from_environment() {
  if (switched_off) return {};
  const auto value = [](const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? std::string() : std::string(text);
  };
  if (std::getenv("ROLLFEM_CACHE") != nullptr) return value("ROLLFEM_CACHE");
  // The XDG standard ignores relative folders.
  if (const fs::path base = value("XDG_CACHE_HOME"); base.is_absolute()) return base / "rollfem";
  if (const fs::path home = value("HOME"); home.is_absolute()) return home / ".cache" / "rollfem";
  return {};
}

std::string key_of(const contact::Scene& correction, bool symmetric) {
  return fmt::format("format {} of rollfem {} ({})\n{} bodies\n{}", format, version(), commit(),
                     symmetric ? "half" : "whole", hybrid::correction_key(correction));
}

fs::path file_of(const fs::path& folder, const std::string& key) {
  return folder / fmt::format("{:016x}{}", contact::checksum(key), suffix);
}

/// Common part of the maps on and below the surface.
template <class Map>
void exchange(contact::Record& record, Map& map) {
  Eigen::Index rows = map.coefficients.rows(), columns = map.coefficients.cols();
  contact::Field entries = map.coefficients.reshaped();
  record.values(map.loads, map.fields, map.load_degree, map.field_degree, rows, columns, entries);
  if (entries.size() != rows * columns) throw contact::FileError("a map of another shape");
  map.coefficients = entries.reshaped(rows, columns);
}

void exchange(contact::Record& record, SmoothParts& parts) {
  exchange(record, parts.wheel);
  exchange(record, parts.rail);
  for (SmoothDepthMap* below : {&parts.wheel_below, &parts.rail_below}) {
    exchange(record, *below);
    record.value(below->depth);
  }
  record.values(parts.stresses, parts.unknowns, parts.notes);
}

/// What a file holds.
struct Stored {
  std::string key;
  CorrectionCache::Entry entry;
  std::string parts;
};

void exchange(contact::Record& record, Stored& stored) {
  CorrectionCache::Entry& entry = stored.entry;
  record.values(stored.key, entry.words, entry.made, entry.unknowns, entry.seconds, stored.parts);
}

/// Throws contact::FileError if the file is damaged or of another format.
Stored read(const fs::path& file) {
  const auto bytes = result::opened_record(suffix, result::contents_of(file));
  if (!bytes) throw contact::FileError("damaged");
  Stored stored;
  contact::Record(*bytes).value(stored);
  return stored;
}

}  // namespace

std::string packed(SmoothParts parts) {
  contact::Record record;
  exchange(record, parts);
  return record.bytes();
}

SmoothParts unpacked(const std::string& bytes) {
  contact::Record record(bytes);
  SmoothParts parts;
  exchange(record, parts);
  if (!record.exhausted()) throw contact::FileError("a correction of another program");
  return parts;
}

void CorrectionCache::switch_off() {
  switched_off = true;
}

CorrectionCache::CorrectionCache() : folder_(folder_from_environment()) {}

CorrectionCache::Found CorrectionCache::find(const contact::Scene& correction,
                                             bool with_stresses) const {
  Found found;
  if (off()) return found;
  for (const bool symmetric : {true, false}) {
    if (symmetric && !correction.is_symmetric()) continue;
    const std::string key = key_of(correction, symmetric);
    const fs::path file = file_of(folder_, key);
    std::error_code error;
    if (!fs::exists(file, error)) continue;
    try {
      const Stored stored = read(file);
      if (stored.key == key) {
        SmoothParts parts = unpacked(stored.parts);
        if (with_stresses && !parts.stresses) continue;
        found.parts = std::move(parts);
        contact::add_note(found.parts->notes, "cache",
                          "the correction comes from the cache ({}); computing it took {:.1f} s",
                          folder_.string(), stored.entry.seconds);
        return found;
      }
    } catch (const contact::FileError&) {
      // Reported as damaged below.
    }
    found.note = fmt::format("{} is damaged; the correction was recomputed", file.string());
  }
  return found;
}

std::string CorrectionCache::keep(const contact::Scene& correction, const SmoothParts& parts,
                                  double seconds) const {
  if (off()) return {};
  const std::string key = key_of(correction, correction.is_symmetric());
  Stored stored{key, {}, packed(parts)};
  stored.entry.words = hybrid::correction_words(correction);
  stored.entry.made = result::utc_now();
  stored.entry.unknowns = parts.unknowns;
  stored.entry.seconds = seconds;
  try {
    result::replace_file(file_of(folder_, key),
                         result::sealed_record(suffix, contact::record_of(stored)));
  } catch (const std::exception& error) {
    return fmt::format("the correction could not be stored for other runs: {}", error.what());
  }
  return {};
}

std::vector<CorrectionCache::Entry> CorrectionCache::entries() const {
  std::vector<Entry> entries;
  for (const fs::path& file : result::files_in(folder_)) {
    if (!is_entry(file)) continue;
    Entry& entry = entries.emplace_back();
    try {
      entry = read(file).entry;
    } catch (const contact::FileError&) {
      // Listed as damaged.
    }
    entry.file = file;
    std::error_code error;
    entry.bytes = fs::file_size(file, error);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.made, a.file) < std::tie(b.made, b.file);
  });
  return entries;
}

std::vector<std::string> CorrectionCache::clear() const {
  std::vector<std::string> left;
  for (const fs::path& file : result::files_in(folder_)) {
    if (!is_ours(file)) continue;
    std::error_code error;
    fs::remove(file, error);
    if (error) left.push_back(fmt::format("{}: {}", file.string(), error.message()));
  }
  return left;
}

}  // namespace rollfem::modelling
