// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that list the sections of a body: position, file and, if wanted, the arc lengths of
// features in a line, "-" of one that the section lacks; or CONTACT's slices (.slcs of a rail,
// .slcw of a wheel; user guide, "Variable profiles"), where -1 marks such a feature and a length
// beyond the end, e.g. 999, the end.
#include "profiles/section_list.hpp"

#include "base/errors.hpp"
#include "base/knots.hpp"
#include "base/pi.hpp"
#include "base/text_fields.hpp"
#include "profiles/profile_corners.hpp"
#include "profiles/profile_points.hpp"
#include "profiles/profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rollfem::profiles {

namespace {

using contact::InputError;

// Features of sections whose list gives none.

constexpr double level = contact::pi / 6.0, steep = contact::pi / 3.0;
/// Features this close to an end of their section (mm) are ignored, because a neighbouring section
/// may end just before them; a kink this close to a bend is part of it.
constexpr double least_from_end = 5.0, same_bend = 2.0;

/// `kind`: of a bend 3 times the stretch before it plus that behind it (-1 rises, 0 is level, 1
/// falls), of a kink 0.
struct Feature {
  double parameter = 0.0;
  int kind = 0;
  double y = 0.0, z = 0.0;
};

std::vector<Feature> bends_of(const ProfileCurve& curve) {
  const std::vector<double> at = dense_parameters(curve, 0.25, 1e-3);
  std::vector<double> angle;
  for (const double parameter : at) {
    const ProfilePoint place = curve.at(parameter);
    angle.push_back(std::atan2(place.tangent_z, place.tangent_y));
  }
  // Between k and its successor, on the side of a stretch that faces another one.
  const auto end_of = [&](std::size_t k, int stretch, int other) {
    const double bound = stretch == 0 ? other * level : stretch * steep;
    const double part = (bound - angle[k]) / (angle[k + 1] - angle[k]);
    return at[k] + std::clamp(part, 0.0, 1.0) * (at[k + 1] - at[k]);
  };
  std::vector<Feature> found;
  int before = 0;
  std::size_t last = at.size();
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double size = std::abs(angle[k]);
    if (size > level && size < steep) continue;
    const int here = size <= level ? 0 : (angle[k] > 0.0 ? 1 : -1);
    if (last < at.size() && here != before)
      found.push_back(
          {0.5 * (end_of(last, before, here) + end_of(k - 1, here, before)), 3 * before + here});
    before = here;
    last = k;
  }
  return found;
}

std::vector<Feature> features_of(const ProfileCurve& curve) {
  const std::vector<Feature> bends = bends_of(curve);
  std::vector<Feature> all = bends, inside;
  for (const double kink : kinks_of(curve))
    if (std::none_of(bends.begin(), bends.end(), [&](const Feature& bend) {
          return std::abs(bend.parameter - kink) < same_bend;
        }))
      all.push_back({kink});
  std::sort(all.begin(), all.end(),
            [](const Feature& a, const Feature& b) { return a.parameter < b.parameter; });
  for (const auto& [parameter, kind, y, z] : all) {
    const ProfilePoint place = curve.at(parameter);
    if (std::min(parameter - curve.first(), curve.last() - parameter) > least_from_end)
      inside.push_back({parameter, kind, place.y, place.z});
  }
  return inside;
}

/// Index in `all`, features with their places in the neighbouring section, to which the first
/// feature of a section corresponds, with the others following in order. Nothing if no
/// correspondence is clearly the best.
std::optional<std::size_t> first_of(const std::vector<Feature>& here,
                                    const std::vector<Feature>& all) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity(), second = least;
  for (std::size_t shift = 0; !here.empty() && shift + here.size() <= all.size(); ++shift) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < here.size(); ++k) {
      const Feature &a = here[k], &b = all[shift + k];
      farthest = std::max(farthest, a.kind == b.kind ? std::hypot(a.y - b.y, a.z - b.z)
                                                     : std::numeric_limits<double>::infinity());
    }
    second = std::min(second, std::max(farthest, least));
    if (farthest < least) least = farthest, best = shift;
  }
  return least < 0.5 * second ? best : std::nullopt;
}

/// A section as listed.
struct Listed {
  double position = 0.0;  ///< mm or rad
  std::string file;
  std::vector<double> features;  ///< mm of arc length from the start
  std::size_t line = 0;
};

struct SectionList {
  std::vector<Listed> sections;
  SectionSpline spline = SectionSpline::through;
};

[[noreturn]] void fail(const std::string& name, std::size_t line, const std::string& wrong,
                       const std::string& allowed, const std::string& remedy) {
  throw InputError(
      fmt::format("{}:{}: {}; allowed: {}; do: {}", name, line, wrong, allowed, remedy));
}

/// Lines without comments that are not empty, each divided into fields; quotes are dropped.
class Rows {
 public:
  Rows(std::string_view text, std::string_view marks, const std::string& name) : name_(name) {
    for (contact::TextLines lines(text); lines.next();) {
      const auto content = contact::without_comment(lines.line(), marks);
      std::vector<std::string> fields;
      for (const std::string_view field : contact::fields_of(content, " \t,'\""))
        fields.emplace_back(field);
      if (!fields.empty()) rows_.push_back({std::move(fields), lines.number()});
    }
  }
  bool more() const { return next_ < rows_.size(); }
  std::size_t line() const { return rows_.empty() ? 1 : rows_[std::min(next_, last())].line; }
  const std::vector<std::string>& take(std::size_t least, const std::string& what) {
    if (!more() || rows_[next_].fields.size() < least)
      fail(name_, line(), fmt::format("{} missing", what), fmt::format("{} fields", least),
           "complete the line (docs/profiles.md)");
    return rows_[next_++].fields;
  }
  double number(const std::string& field) const {
    const auto value = contact::number_of(field);
    if (!value)
      fail(name_, rows_[next_ - 1].line, fmt::format("\"{}\"", contact::printable(field)),
           "a number", "correct it");
    return *value;
  }
  /// An arc length, NaN of a feature that is missing.
  double feature(const std::string& field, bool slices) const {
    const bool missing = field == "-" || (slices && contact::number_of(field) == -1.0);
    return missing ? std::numeric_limits<double>::quiet_NaN() : number(field);
  }
  int count(const std::string& field) const {
    constexpr double most = 1e4;
    const double value = number(field);
    if (!(value >= 0.0 && value <= most))
      fail(name_, rows_[next_ - 1].line, field, fmt::format("a count up to {}", most),
           "correct it");
    return static_cast<int>(value);
  }

 private:
  struct Row {
    std::vector<std::string> fields;
    std::size_t line;
  };
  std::size_t last() const { return rows_.size() - 1; }
  const std::string& name_;
  std::vector<Row> rows_;
  std::size_t next_ = 0;
};

SectionList read_rows(std::string_view text, const std::string& name) {
  SectionList list;
  Rows rows(text, "#", name);
  while (rows.more()) {
    const std::size_t line = rows.line();
    const auto& fields = rows.take(2, "position and file");
    Listed section{rows.number(fields[0]), fields[1], {}, line};
    for (std::size_t k = 2; k < fields.size(); ++k)
      section.features.push_back(rows.feature(fields[k], false));
    list.sections.push_back(std::move(section));
  }
  return list;
}

SectionList read_slices(std::string_view text, const std::string& name) {
  SectionList list;
  Rows rows(text, "%!", name);
  const auto head = rows.take(2, "offset and scale of the positions");
  const double offset = rows.number(head[0]), scale = rows.number(head[1]);
  const int count = rows.count(rows.take(1, "number of slices")[0]);
  const auto counts = rows.take(3, "numbers of features, kinks and accelerations");
  const int features = rows.count(counts[0]);
  if (rows.count(counts[1]) > 0 || rows.count(counts[2]) > 0)
    fail(name, rows.line(), "kinks and accelerations between parts", "none of them (0 0)",
         "leave them out: sections are joined smoothly along the way");
  list.spline = rows.count(rows.take(1, "kind of spline")[0]) == 2 ? SectionSpline::smooth
                                                                   : SectionSpline::through;
  for (int k = 0; k < count; ++k) {
    const std::size_t line = rows.line();
    const auto& fields = rows.take(2, "position and file of a slice");
    list.sections.push_back({scale * (rows.number(fields[0]) + offset), fields[1], {}, line});
  }
  for (int k = 0; features > 0 && k < count; ++k) {
    const std::size_t line = rows.line();
    const auto& fields = rows.take(static_cast<std::size_t>(features) + 1, "features of a slice");
    Listed& section = list.sections[static_cast<std::size_t>(k)];
    section.line = line;
    // The first and the last are the ends of the section.
    for (int f = 2; f < features; ++f)
      section.features.push_back(rows.feature(fields[static_cast<std::size_t>(f)], true));
  }
  return list;
}

/// A feature this close to an end of its section (mm) is that end.
constexpr double at_end = 0.01;

/// Parameters of a curve at arc lengths from its start; NaN for missing features and for those at
/// an end of the section, which takes the place of missing ones anyway. With `ends`, lengths beyond
/// the end count as the end; otherwise the list stops there.
std::vector<double> at_lengths(const ProfileCurve& curve, const std::vector<double>& lengths,
                               bool ends) {
  const std::vector<double> places = dense_parameters(curve, 0.05);
  std::vector<double> way{0.0}, result;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const ProfilePoint a = curve.at(places[k - 1]), b = curve.at(places[k]);
    way.push_back(way.back() + std::hypot(b.y - a.y, b.z - a.z));
  }
  for (const double length : lengths) {
    if (!ends && length > way.back() + at_end) break;
    if (std::isnan(length) || std::abs(length) < at_end || length > way.back() - at_end) {
      result.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const auto [k, piece, part] = contact::piece_of(way, length);
    result.push_back(places[k] + part * (places[k + 1] - places[k]));
  }
  return result;
}

void check_list(const SectionList& list, const std::string& name) {
  constexpr std::size_t most_sections = 10'000, most_features = 1000;
  constexpr double farthest = 1e9;
  if (list.sections.size() < 2 || list.sections.size() > most_sections)
    fail(name, 1, fmt::format("{} sections", list.sections.size()),
         fmt::format("at least two, at most {}", most_sections),
         "list position and file of each, a line for each");
  for (std::size_t k = 0; k < list.sections.size(); ++k) {
    const Listed& here = list.sections[k];
    const Listed& before = list.sections[k > 0 ? k - 1 : 0];
    if (contact::is_list_of_sections(here.file))
      fail(name, here.line, fmt::format("{} is a list of sections", contact::printable(here.file)),
           "files with one profile", "list its sections here");
    if (here.features.size() > most_features)
      fail(name, here.line, fmt::format("{} features", here.features.size()),
           fmt::format("up to {}", most_features), "give fewer");
    if (std::abs(here.position) > farthest)
      fail(name, here.line, fmt::format("position {:g}", here.position),
           fmt::format("up to {:g} of either sign, mm or rad", farthest), "correct it");
    if (k > 0 && !(here.position > before.position))
      fail(name, here.line, fmt::format("position {:g} after {:g}", here.position, before.position),
           "increasing positions", "sort the sections");
    if (here.features.size() != before.features.size())
      fail(name, here.line, fmt::format("{} features", here.features.size()),
           fmt::format("{}, as many for each section", before.features.size()),
           "give the same features for each section, - for one that it lacks");
  }
}

/// Whether a wheel's list describes a full turn, after which it repeats. If less than about a step
/// is missing, the first section comes again at the end.
bool close_turn(SectionList& list, const std::string& name) {
  constexpr double turn = 2.0 * contact::pi, largest_rounding = 5e-3;  // rad
  std::vector<Listed>& all = list.sections;
  const double way = all.back().position - all.front().position, rest = turn - way;
  const double step = std::max(all[1].position - all[0].position,
                               all.back().position - all[all.size() - 2].position);
  const double rounding = std::min(largest_rounding, 0.25 * step);
  if (rest < -rounding)
    fail(name, all.back().line, fmt::format("angles over {:g} rad", way),
         "at most a turn, 2 pi = 6.283185",
         "give angles in rad, and every place of the wheel once");
  if (rest > 1.5 * step) return false;
  if (rest > rounding) all.push_back(all.front());
  all.back().position = all.front().position + turn;
  return true;
}

/// Whether both have the same points, to the digits of a file.
bool alike(const PlacedSection& a, const PlacedSection& b) {
  constexpr double digits = 1e-6;  // mm
  const auto same = [](const auto& x, const auto& y, const auto& near) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), near);
  };
  const auto near = [](double p, double q) { return std::abs(p - q) < digits; };
  const auto at_one_place = [&](const ProfileKnot& p, const ProfileKnot& q) {
    return near(p.y, q.y) && near(p.z, q.z);
  };
  return same(a.curve.knots(), b.curve.knots(), at_one_place) && same(a.features, b.features, near);
}

}  // namespace

std::string find_features(std::vector<PlacedSection>& sections) {
  std::vector<std::vector<Feature>> found;
  for (const PlacedSection& section : sections) found.push_back(features_of(section.curve));
  const auto fullest = std::max_element(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  if (fullest->empty()) return "";
  const auto count = static_cast<std::ptrdiff_t>(found.size());
  for (const std::ptrdiff_t step : {1, -1}) {
    std::vector<Feature> all = *fullest;
    for (std::ptrdiff_t k = fullest - found.begin(); k >= 0 && k < count; k += step) {
      const auto i = static_cast<std::size_t>(k);
      const auto first = first_of(found[i], all);
      if (!first) {
        for (PlacedSection& section : sections) section.features.clear();
        return fmt::format(
            "the {} bends and kinks of the section at {:g} do not correspond to the {} of the "
            "section at {:g}; give the arc lengths of features in every line to keep edges sharp",
            found[i].size(), sections[i].position, fullest->size(),
            sections[static_cast<std::size_t>(fullest - found.begin())].position);
      }
      sections[i].features.assign(all.size(), std::numeric_limits<double>::quiet_NaN());
      for (std::size_t f = 0; f < found[i].size(); ++f) {
        all[*first + f] = found[i][f];
        sections[i].features[*first + f] = found[i][f].parameter;
      }
    }
  }
  return "";
}

ListedSections read_sections(const contact::ProfileSource& source, bool wheel,
                             const std::string& case_file) {
  const std::filesystem::path path = std::filesystem::path(case_file).parent_path() / source.name;
  constexpr std::size_t largest = 10'000'000;
  const std::string text = contact::text_of_file(path.string(), source.name, largest);
  const bool plain = std::filesystem::path(source.name).extension() == ".sections";
  // Never quote the contents of other files.
  if (!contact::looks_like_table(text, plain ? "#" : "%!"))
    fail(source.name, 1, "is not a list of sections, most of its lines do not begin with a number",
         "lines of position and file", "check the path");
  SectionList list = plain ? read_rows(text, source.name) : read_slices(text, source.name);
  check_list(list, source.name);
  ListedSections read{{},
                      list.spline,
                      wheel && close_turn(list, source.name),
                      list.sections.front().features.empty(),
                      {}};
  std::map<std::string, ProfileCurve> curves;
  for (const Listed& listed : list.sections) {
    contact::ProfileSource one = source;
    one.name = (std::filesystem::path(source.name).parent_path() / listed.file).string();
    const auto [curve, first_time] = curves.try_emplace(one.name);
    if (first_time) curve->second = make_profile(one, wheel, case_file);
    PlacedSection section{listed.position, curve->second, {}};
    section.features = at_lengths(section.curve, listed.features, !plain);
    if (section.features.size() != listed.features.size())
      fail(source.name, listed.line, "a feature beyond the end of its section",
           "arc lengths from the start of the section, mm", "correct it");
    try {
      static_cast<void>(ends_of_parts(section));
    } catch (const std::invalid_argument& error) {
      fail(source.name, listed.line, error.what(), "increasing arc lengths from 0 on, mm",
           "correct them");
    }
    read.sections.push_back(std::move(section));
  }
  // Of a feature at an end of every section nothing is left.
  for (std::size_t f = list.sections.front().features.size(); f-- > 0;)
    if (std::all_of(read.sections.begin(), read.sections.end(),
                    [f](const auto& section) { return std::isnan(section.features[f]); }))
      for (PlacedSection& section : read.sections)
        section.features.erase(section.features.begin() + static_cast<std::ptrdiff_t>(f));
  if (read.around && !alike(read.sections.front(), read.sections.back()))
    fail(source.name, list.sections.back().line, "a full turn ends with another section",
         "the section of the first line, because the wheel repeats there",
         "leave this line out, or name the first section");
  if (read.found) read.without_features = find_features(read.sections);
  return read;
}

std::shared_ptr<const SectionSurface> make_sections(const contact::ProfileSource& source,
                                                    bool wheel, const std::string& case_file) {
  if (!source.lists_sections()) return {};
  ListedSections read = read_sections(source, wheel, case_file);
  try {
    return std::make_shared<const SectionSurface>(std::move(read.sections), read.spline,
                                                  wheel ? 2.0 * contact::pi : 0.0);
  } catch (const SectionsTooClose& error) {
    throw InputError({source.name}, std::string(error.what()));
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}; do: correct the list of sections (docs/profiles.md)",
                                 source.name, error.what()));
  }
}

}  // namespace rollfem::profiles
