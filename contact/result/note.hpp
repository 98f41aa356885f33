// SPDX-License-Identifier: LGPL-2.1-or-later
// What a reader of a result must know beside its numbers.
#pragma once

#include "contact/scene/members.hpp"

#include <fmt/core.h>

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

  std::string severity_word() const { return severity == warning ? "warning" : "remark"; }

  static constexpr Listed listed = Listed::as_table;
  static constexpr auto members() {
    using S = Note;
    return std::tuple(
        member("severity", &S::severity_word, "", "remark or warning"),
        member("about", &S::about, "", "equal where notes of a model differ in their numbers only"),
        member("text", &S::text, "", "one sentence"), member_within("severity", &S::severity));
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

}  // namespace rollfem::contact
