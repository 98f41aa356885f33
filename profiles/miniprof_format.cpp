// SPDX-License-Identifier: LGPL-2.1-or-later
// Profiles of the instrument MiniProf, old and new.
#include "base/errors.hpp"
#include "profiles/profile_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rollfem::profiles {

namespace {

using contact::TextLines;
using contact::trimmed;

/// The points under one `[SECTION]` of a MiniProf file, or before any.
struct MiniprofPart {
  std::string section;
  ProfilePoints points;
};

/// The part that `source` names, or the only one.
ProfilePoints chosen(const std::vector<MiniprofPart>& parts, const contact::ProfileSource& source,
                     bool wheel) {
  std::string found;
  const MiniprofPart* last = nullptr;
  std::size_t count = 0;
  for (const MiniprofPart& part : parts) {
    if (part.points.list.empty()) continue;
    if (!source.section.empty() && part.section == source.section) return part.points;
    found += fmt::format("{}{} ({} points)", found.empty() ? "" : ", ",
                         part.section.empty() ? "points of no section" : part.section,
                         part.points.list.size());
    last = &part;
    ++count;
  }
  if (count == 0) return {};
  if (count == 1 && source.section.empty()) return last->points;
  refuse_section(source, wheel, fmt::format("holds {} profiles", count), found, last->section);
}

/// Old headers are plain words, rows of numbers with words among them, and up to an empty line.
ProfilePoints read_miniprof(std::string_view text, const contact::ProfileSource& source,
                            bool wheel) {
  std::vector<MiniprofPart> parts(1);
  std::array<std::size_t, 2> columns{0, 1};
  bool in_words = false;
  for (TextLines lines(text); lines.next();) {
    std::vector<ListedPoint>& list = parts.back().points.list;
    const std::string_view line = before_comment(lines.line());
    if (line.empty()) {
      if (!lines.line().empty()) continue;
      if (in_words && list.size() == 1) list.clear();
      in_words = false;
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      parts.push_back({contact::printable(trimmed(line.substr(1, line.size() - 2))), {}});
      continue;
    }
    std::string key, value;
    if (key_and_value(line, key, value)) {
      if (key != "ColumnDef") continue;
      const auto names = contact::parts_of(value, ",");
      for (std::size_t column = 0; column < names.size(); ++column) {
        if (trimmed(names[column]) == "X") columns[0] = column;
        if (trimmed(names[column]) == "Y") columns[1] = column;
      }
      continue;
    }
    const NumberRow row = numbers_of(line);
    const bool complete = std::max(columns[0], columns[1]) < row.count;
    if (!row.wrong.empty()) {
      const bool header = list.empty() || (list.size() == 1 && in_words);
      if (!row.is_heading() || (!header && !complete)) not_numbers(source.name, lines, row.wrong);
      if (header && (in_words || !complete)) {
        list.clear();
        in_words = true;
        continue;
      }
    }
    if (!complete) too_few_numbers(source.name, lines);
    list.push_back(
        {row.values[columns[0]], row.values[columns[1]], static_cast<unsigned>(lines.number())});
  }
  return chosen(parts, source, wheel);
}

const KnownFormat miniprof(
    {"MiniProf", {{".whl", true}, {".ban", false}, {".mpt", {}}}, read_miniprof, true, "", true});

}  // namespace

}  // namespace rollfem::profiles
