// SPDX-License-Identifier: LGPL-2.1-or-later
// The folder in which corrections of the model hybrid are kept after a run, so that another load,
// creepage or friction on the same bodies needs no finite elements.
#pragma once

#include "contact/scene/scene.hpp"
#include "halfspace/elasticity/smooth_map.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::modelling {

class CorrectionCache {
 public:
  /// $ROLLFEM_CACHE, else rollfem in $XDG_CACHE_HOME, else in ~/.cache. No folder, and no cache,
  /// where ROLLFEM_CACHE is empty or there is no home.
  CorrectionCache();
  explicit CorrectionCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool off() const { return folder_.empty(); }
  const std::filesystem::path& folder() const { return folder_; }

  struct Found {
    std::optional<halfspace::SmoothParts> parts;  ///< with a note on where they come from
    std::string note;                             ///< of a file that is damaged; else empty
  };
  /// Of a correction scene (halfspace/patch/correction_scene.hpp). Parts for bodies without a plane
  /// of symmetry serve those with one as well, those without stresses nobody who asks for some.
  Found find(const contact::Scene& correction, bool with_stresses) const;
  /// Whole or not at all; `seconds`: that finding them took. Why it could not be stored; empty: it
  /// was.
  std::string keep(const contact::Scene& correction, const halfspace::SmoothParts& parts,
                   double seconds) const;

  struct Entry {
    std::filesystem::path file;
    std::string words;  ///< the bodies in a line; empty: damaged, or of another program
    std::string made;   ///< UTC, ISO 8601
    std::uintmax_t bytes = 0;
    long unknowns = 0;
    double seconds = 0.0;  ///< that it took
  };
  /// Sorted by date.
  std::vector<Entry> entries() const;
  /// Removes all of them, and what unfinished ones have left. Returns what could not be removed.
  std::vector<std::string> clear() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace rollfem::modelling
