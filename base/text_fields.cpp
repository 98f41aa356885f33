// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/text_fields.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fcntl.h>
#include <numeric>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace rollfem::contact {

namespace {

/// The whole field by from_chars, which accepts no plus sign.
template <class Number>
std::optional<Number> parsed(std::string_view field) {
  if (field.size() > 1 && field.front() == '+' && field[1] != '-') field.remove_prefix(1);
  Number value{};
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string_view without_comment(std::string_view line, std::string_view marks) {
  return line.substr(0, line.find_first_of(marks));
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = trimmed(rest_.substr(0, end));
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

std::vector<std::string_view> fields_of(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> fields;
  fields.reserve(8);
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return fields;
}

std::vector<std::string_view> parts_of(std::string_view line, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find_first_of(separators, begin);
    parts.push_back(line.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::optional<double> number_of(std::string_view field, bool decimal_comma) {
  std::string copy;
  if (decimal_comma && field.find(',') != std::string_view::npos) {
    copy = field;
    std::replace(copy.begin(), copy.end(), ',', '.');
    field = copy;
  }
  const std::optional<double> value = parsed<double>(field);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> whole_number_of(std::string_view field) {
  return parsed<int>(field);
}

namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

bool looks_like_table(std::string_view text, std::string_view marks) {
  std::size_t numbers = 0, others = 0;
  for (TextLines lines(text); lines.next();) {
    const std::string_view line = without_comment(lines.line(), marks);
    const auto fields = fields_of(line, " ,;\t");
    if (fields.empty() || line.find('=') != std::string_view::npos) continue;
    if (fields.size() == 1 && (ends_with(fields[0], ".begin") || ends_with(fields[0], ".end")))
      continue;
    ++(number_of(fields.front()) ? numbers : others);
  }
  return numbers >= others && numbers > 0;
}

OpenedFile::OpenedFile(const std::string& path, const std::string& name, const std::string& action)
    : name_(name), action_(action) {
  file_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file_ < 0 && (errno == ENOENT || errno == ENOTDIR)) fail("there is no such file");
  struct stat status {};
  if (file_ < 0 || ::fstat(file_, &status) != 0) fail("cannot be read");
  if (S_ISDIR(status.st_mode)) fail("is a folder, not a file");
  if (!S_ISREG(status.st_mode)) fail("is not a regular file");
  size_ = static_cast<std::size_t>(status.st_size);
}

OpenedFile::~OpenedFile() {
  if (file_ >= 0) ::close(file_);
}

void OpenedFile::fail(const std::string& wrong) {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  throw FileError(fmt::format("{}: {}; do: {}", name_, wrong, action_));
}

std::size_t OpenedFile::read(char* data, std::size_t size) {
  std::size_t count = 0;
  while (count < size) {
    const ssize_t got = ::read(file_, data + count, size - count);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("cannot be read");
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  return count;
}

std::string text_of_file(const std::string& path, const std::string& name, std::size_t largest,
                         const std::string& action) {
  OpenedFile file(path, name, action);
  std::string text;
  // The size is only a first guess: files grow, and those of /proc have none.
  std::size_t wanted = std::min(file.size(), largest) + 1;
  for (std::size_t got = wanted; got == wanted; wanted = 1U << 16U) {
    const std::size_t before = text.size();
    text.resize(before + wanted);
    got = file.read(text.data() + before, wanted);
    text.resize(before + got);
    if (std::max(file.size(), text.size()) > largest)
      file.fail(
          fmt::format("is larger than {:.3g} MB", static_cast<double>(largest) / (1U << 20U)));
  }
  return text;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result(text);
  if (text.size() > longest) result.replace(longest - 3, std::string::npos, "...");
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return result;
}

namespace {

/// Number of insertions, deletions and replacements that make one word the other (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates) {
  std::string nearest;
  // At most half of the letters may differ; a more distant guess would only confuse.
  std::size_t smallest = (std::min<std::size_t>(name.size(), 40) + 1) / 2 + 1;
  if (name.size() > 80) return nearest;
  for (const std::string& candidate : candidates) {
    const bool part = name.size() > 2 && candidate.find(name) != std::string::npos;
    const std::size_t distance = part ? 1 : edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
  const std::string near = nearest_name(name, candidates);
  return near.empty() ? "" : fmt::format("did you mean {}? ", near);
}

}  // namespace rollfem::contact
