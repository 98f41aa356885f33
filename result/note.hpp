// SPDX-License-Identifier: LGPL-2.1-or-later
// What a reader of a result must know beside its numbers: notes, and why a value has no error bar.
#pragma once

#include "base/members.hpp"

#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace rollfem::contact {

struct Note {
  enum Severity { remark, warning };

  /// A word for the subject, unique to the kind of sentence: notes of one model about the same
  /// differ in their numbers only.
  std::string about;
  std::string text;
  Severity severity = remark;

  friend constexpr const char* word_of(Severity of) { return of == warning ? "warning" : "remark"; }

  static constexpr Listed listed = Listed::as_table;
  static constexpr auto members() {
    using S = Note;
    return std::tuple(
        member("severity", &S::severity, "", "remark or warning"),
        member("about", &S::about, "", "equal where notes of a model differ in their numbers only"),
        member("text", &S::text, "", "one sentence"));
  }

  bool operator==(const Note& other) const {
    return about == other.about && text == other.text && severity == other.severity;
  }
};

template <class... Values>
void add_note(std::vector<Note>& notes, const std::string& about,
              fmt::format_string<Values...> text, Values&&... values) {
  notes.push_back({about, fmt::format(text, std::forward<Values>(values)...)});
}

template <class... Values>
void add_warning(std::vector<Note>& notes, const std::string& about,
                 fmt::format_string<Values...> text, Values&&... values) {
  add_note(notes, about, text, std::forward<Values>(values)...);
  notes.back().severity = Note::warning;
}

/// Of the note that says where PointResult::model_error comes from, or why there is none: a warning
/// if the estimate failed.
inline constexpr const char* about_model_error = "model_error";

/// Why a value has no error bar.
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
  not_resolved,  ///< plastic flow whose strain depends on the mesh too much to tell how far
};

/// Words of the members, in their order, in files and tables.
inline constexpr std::array<const char*, 12> no_bar_words{
    "exact",   "given",    "counted",       "measured",     "theory",   "one grid",
    "balance", "relative", "not estimated", "near surface", "no limit", "not resolved"};

constexpr const char* word_of(NoBar reason) {
  return no_bar_words[static_cast<std::size_t>(reason)];
}

}  // namespace rollfem::contact
