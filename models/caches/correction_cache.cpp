// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/caches/correction_cache.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/record.hpp"
#include "halfspace/patch/correction_scene.hpp"
#include "models/caches/correction_file.hpp"
#include "models/program/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <tuple>
#include <utility>

namespace fs = std::filesystem;

namespace rollfem::modelling {

namespace {

/// Version of the files and of the way corrections are computed: raise it when the same scene gets
/// another correction.
constexpr int format = 3;

constexpr const char* suffix = ".correction.h5";
constexpr const char* part_suffix = ".part";

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.npos, end) == 0;
}

bool is_entry(const fs::path& file) {
  return ends_with(file.filename().string(), suffix);
}

bool is_ours(const fs::path& file) {
  const std::string name = file.filename().string();
  return is_entry(file) || (ends_with(name, part_suffix) && name.find(suffix) != std::string::npos);
}

fs::path folder_from_environment() {
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
                     symmetric ? "half" : "whole", halfspace::correction_key(correction));
}

fs::path file_of(const fs::path& folder, const std::string& key) {
  return folder / fmt::format("{:016x}{}", contact::checksum(key), suffix);
}

template <class Visit>
void each_file(const fs::path& folder, const Visit& visit) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    visit(entry->path());
}

}  // namespace

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
      const auto values = postprocess::read_named_values(file);
      if (values && values->texts.at("key") == key) {
        halfspace::SmoothParts parts = parts_of(*values);
        if (with_stresses && !parts.stresses) continue;
        found.parts = std::move(parts);
        found.parts->notes.push_back(
            fmt::format("the correction comes from the cache ({}); computing it took {:.1f} s",
                        folder_.string(), values->numbers.at("seconds")));
        return found;
      }
    } catch (const std::exception&) {
      // Reported as damaged below.
    }
    found.note = fmt::format("{} is damaged; the correction was recomputed", file.string());
  }
  return found;
}

std::string CorrectionCache::keep(const contact::Scene& correction,
                                  const halfspace::SmoothParts& parts, double seconds) const {
  if (off()) return {};
  const std::string key = key_of(correction, correction.is_symmetric());
  postprocess::NamedValues values = values_of(parts);
  values.numbers["seconds"] = seconds;
  values.texts["key"] = key;
  values.texts["words"] = halfspace::correction_words(correction);
  values.texts["made"] = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
  try {
    postprocess::write_named_values(file_of(folder_, key), values);
  } catch (const std::exception& error) {
    return fmt::format("the correction could not be stored for other runs: {}", error.what());
  }
  return {};
}

std::vector<CorrectionCache::Entry> CorrectionCache::entries() const {
  std::vector<Entry> entries;
  each_file(folder_, [&](const fs::path& file) {
    if (!is_entry(file)) return;
    Entry entry;
    entry.file = file;
    std::error_code error;
    entry.bytes = fs::file_size(file, error);
    if (const auto values = postprocess::read_named_values(file)) {
      const auto text = [&](const char* name) {
        const auto found = values->texts.find(name);
        return found == values->texts.end() ? std::string() : found->second;
      };
      const auto number = [&](const char* name) {
        const auto found = values->numbers.find(name);
        return found == values->numbers.end() ? 0.0 : found->second;
      };
      entry.words = text("words");
      entry.made = text("made");
      entry.unknowns = std::lround(number("unknowns"));
      entry.seconds = number("seconds");
    }
    entries.push_back(std::move(entry));
  });
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.made, a.file) < std::tie(b.made, b.file);
  });
  return entries;
}

std::vector<std::string> CorrectionCache::clear() const {
  std::vector<fs::path> files;
  each_file(folder_, [&](const fs::path& file) {
    if (is_ours(file)) files.push_back(file);
  });
  std::vector<std::string> left;
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) left.push_back(fmt::format("{}: {}", file.string(), error.message()));
  }
  return left;
}

}  // namespace rollfem::modelling
