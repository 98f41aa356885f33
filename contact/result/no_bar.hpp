// SPDX-License-Identifier: LGPL-2.1-or-later
// Why a value has no error bar.
#pragma once

#include <array>
#include <stdexcept>
#include <string>

namespace rollfem::contact {

enum class NoBar {
  exact,     ///< a closed form, computed to rounding
  given,     ///< prescribed by the case
  counted,   ///< a count
  measured,  ///< a figure of the computation
  theory,    ///< a closed form of an approximate theory, without a grid; see model_error
  one_grid,  ///< no second solution to compare
  balance,   ///< found by the balance of a wheelset, which has no balance on a coarser grid
  relative,  ///< depends on geometry.reference_distance (line contact): no absolute meaning
  not_estimated,
  near_surface,  ///< the largest stress lies so near the surface that the coarser grid does not
                 ///< tell
  no_limit,      ///< grows without bound on finer grids: the pressure at a sharp end of a body
};

/// Words of the members, in their order, in files and tables.
inline constexpr std::array<const char*, 11> no_bar_words{
    "exact",   "given",    "counted",       "measured",     "theory",  "one grid",
    "balance", "relative", "not estimated", "near surface", "no limit"};

constexpr const char* word_of(NoBar reason) {
  return no_bar_words[static_cast<std::size_t>(reason)];
}

/// Throws std::runtime_error for another word.
inline NoBar no_bar_of(const std::string& word) {
  for (std::size_t k = 0; k < no_bar_words.size(); ++k)
    if (word == no_bar_words[k]) return static_cast<NoBar>(k);
  throw std::runtime_error("\"" + word + "\" is no reason for a missing error bar");
}

}  // namespace rollfem::contact
