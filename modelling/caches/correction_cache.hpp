// SPDX-License-Identifier: LGPL-2.1-or-later
// The cache of the model hybrid: keeps corrections after a run, so that another load, creepage or
// friction on the same bodies needs no finite elements.
#pragma once

#include "hybrid/smooth_map.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

/// The smooth parts as bytes in this machine's byte order, for files and other processes.
std::string packed(hybrid::SmoothParts parts);
/// Throws contact::FileError when the bytes are those of something else.
hybrid::SmoothParts unpacked(const std::string& bytes);

class CorrectionCache {
 public:
  /// Uses $ROLLFEM_CACHE, else $XDG_CACHE_HOME/rollfem, else ~/.cache/rollfem. The cache is off if
  /// ROLLFEM_CACHE is empty or there is no home folder.
  CorrectionCache();
  /// Switches the cache off in this process, whose measured times stored corrections would falsify.
  static void switch_off();
  explicit CorrectionCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool off() const { return folder_.empty(); }
  const std::filesystem::path& folder() const { return folder_; }

  struct Found {
    std::optional<hybrid::SmoothParts> parts;  ///< with a note on their origin
    std::string note;                          ///< names a damaged file; otherwise empty
  };
  /// Looks up a correction scene (hybrid/correction_scene.hpp). Parts for bodies without a
  /// plane of symmetry also serve bodies with one; parts without stresses do not serve a request
  /// with stresses.
  Found find(const contact::Scene& correction, bool with_stresses) const;
  /// Stores the parts completely or not at all; `seconds`: time taken to compute them. Returns why
  /// they could not be stored, or an empty text.
  std::string keep(const contact::Scene& correction, const hybrid::SmoothParts& parts,
                   double seconds) const;

  struct Entry {
    std::filesystem::path file;
    std::string words;  ///< the bodies in one line; empty: damaged, or written by another program
    std::string made;   ///< UTC, ISO 8601
    std::uintmax_t bytes = 0;
    long unknowns = 0;
    double seconds = 0.0;  ///< taken to compute it
  };
  /// Sorted by date.
  std::vector<Entry> entries() const;
  /// Removes all entries and the remains of unfinished ones. Returns what could not be removed.
  std::vector<std::string> clear() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace rollfem::modelling
