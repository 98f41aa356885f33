// SPDX-License-Identifier: LGPL-2.1-or-later
// A format of profile files is one file of this folder, which reads it and makes it known by a
// constant KnownFormat, and an entry in docs/profiles.md. The ending of a file's name selects its
// format; files of no known ending have columns y and z.
#pragma once

#include "base/text_fields.hpp"
#include "profiles/profile_points.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rollfem::profiles {

/// An ending of file names in small letters, ".prw", and whether it is one of wheels; empty: of
/// both bodies.
struct ProfileEnding {
  std::string ending;
  std::optional<bool> wheel;
};

struct ProfileFormat {
  std::string name;  ///< "SIMPACK"
  std::vector<ProfileEnding> endings;
  /// Points in mm, or in ProfileSource::unit. Throws contact::InputError with line and value.
  ProfilePoints (*read)(std::string_view text, const contact::ProfileSource& source, bool wheel);
  bool any_direction = false;  ///< does not prescribe the direction of the list
  std::string unit_key = {};  ///< by which a file states its unit; empty: ProfileSource::unit holds
  bool has_sections = false;  ///< ProfileSource::section names one of several profiles
};

struct KnownFormat {
  explicit KnownFormat(ProfileFormat format);
};

/// Two columns (text, CSV), or a known format, by the ending of the name. `path`:
/// location; `source.name`: name used in messages. Throws contact::InputError with line and value.
ProfilePoints read_profile_points(const std::string& path, const contact::ProfileSource& source,
                                  bool wheel);

/// The same from the text of such a file; the extension of `source.name` selects the format.
ProfilePoints parse_profile_points(std::string_view text, const contact::ProfileSource& source,
                                   bool wheel);

/// Whether a built-in profile, or a file by its ending, is of a wheel; nothing if it may be of
/// either body.
std::optional<bool> body_of_profile(const std::string& name);

// Parts of readers.

std::string_view before_comment(std::string_view line);

/// Numbers read from a line; further columns are ignored.
constexpr std::size_t most_columns = 16;

struct NumberRow {
  std::array<double, most_columns> values{};
  std::size_t count = 0;
  std::string wrong;  ///< the first field that is no number
  /// Whether the words may be a heading: none of them looks like a misspelt number.
  bool is_heading() const {
    const bool spoilt =
        std::string_view("+-.0123456789").find(wrong[0]) != std::string_view::npos &&
        wrong.find_first_of("0123456789") != std::string::npos;
    return !spoilt;
  }
};

NumberRow numbers_of(std::string_view text);

/// "key = value", the line without its comment.
bool key_and_value(std::string_view line, std::string& key, std::string& value);

void add(ProfilePoints& points, double y, double z, const contact::TextLines& at);

[[noreturn]] void not_numbers(const std::string& file, const contact::TextLines& at,
                              const std::string& field);
/// `section` names no profile of the file, or is missing where `several` says why it is needed.
/// `allowed`: the sections; `one` of them.
[[noreturn]] void refuse_section(const contact::ProfileSource& source, bool wheel,
                                 const std::string& several, const std::string& allowed,
                                 const std::string& one);
[[noreturn]] void too_few_numbers(const std::string& file, const contact::TextLines& at);

}  // namespace rollfem::profiles
