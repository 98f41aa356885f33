// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/input/section_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rollfem::app {

using profiles::ListedSections;
using profiles::PlacedSection;

namespace {

std::string steps_of(const std::vector<PlacedSection>& sections) {
  double least = std::abs(sections[1].position - sections[0].position), largest = least;
  for (std::size_t k = 2; k < sections.size(); ++k) {
    const double step = sections[k].position - sections[k - 1].position;
    least = std::min(least, step);
    largest = std::max(largest, step);
  }
  return largest - least < 1e-6 * largest ? fmt::format("{:.4g}", largest)
                                          : fmt::format("{:.4g} to {:.4g}", least, largest);
}

}  // namespace

std::string sections_text(const ListedSections& family, const std::string& title, bool wheel) {
  const std::vector<PlacedSection>& sections = family.sections;
  const PlacedSection &first = sections.front(), &last = sections.back();
  std::string text = fmt::format("{}\n", title);
  const auto line = [&](const std::string& what, const std::string& value) {
    text += fmt::format("  {:<36}{}\n", what, value);
  };
  line("sections", fmt::format("{}", sections.size()));
  line(wheel ? "angles about the axle, rad" : "positions along the track, mm",
       fmt::format("{:g} to {:g}, {} apart{}", first.position, last.position, steps_of(sections),
                   family.around ? "; a full turn, which repeats"
                   : wheel       ? "; beyond these angles the wheel is round"
                                 : ""));
  line("between sections", family.spline == profiles::SectionSpline::through
                               ? "every point follows a cubic spline through them"
                               : "every point follows a spline that rounds kinks");
  const std::size_t count = first.features.size();
  line("features",
       count == 0 ? "none: points correspond by the fraction of the whole arc length" +
                        (family.without_features.empty() ? "" : "; " + family.without_features)
                  : fmt::format("{} {}; their ways, y, z in mm:", count,
                                family.found ? "found, bends and kinks" : "given in the list"));
  for (std::size_t k = 0; k < count; ++k) {
    const auto has = [&](const PlacedSection& section) { return !std::isnan(section.features[k]); };
    const auto from = std::find_if(sections.begin(), sections.end(), has);
    if (from == sections.end()) continue;
    const PlacedSection &start = *from,
                        &end = *std::find_if(sections.rbegin(), sections.rend(), has);
    const auto at = [&](const PlacedSection& section) {
      const profiles::ProfilePoint place = section.curve.at(section.features[k]);
      return fmt::format("{:9.3f},{:8.3f}", place.y, place.z);
    };
    text += fmt::format("    {:<34}{}  -> {}{}\n", k + 1, at(start), at(end),
                        has(first) && has(last)
                            ? ""
                            : fmt::format("  from {:g} to {:g}", start.position, end.position));
  }
  return text;
}

std::string sections_table(const ListedSections& family, const std::string& title, bool wheel) {
  constexpr double spacing = 0.5;  // mm
  std::vector<int> steps(family.sections.front().features.size() + 1, 1);
  for (const PlacedSection& section : family.sections) {
    const std::vector<double> ends = ends_of_parts(section);
    for (std::size_t part = 0; part < steps.size(); ++part)
      if (const double length = ends[part + 1] - ends[part]; length > 0.0)
        steps[part] = std::max(steps[part], static_cast<int>(std::ceil(length / spacing)));
  }
  std::string text =
      fmt::format("# {}\nposition [{}],part [-],y [mm],z [mm]\n", title, wheel ? "rad" : "mm");
  for (const PlacedSection& section : family.sections) {
    const std::vector<double> ends = ends_of_parts(section);
    for (std::size_t part = 0; part < steps.size(); ++part)
      for (int k = 0; k <= steps[part]; ++k) {
        const double at = ends[part] + (ends[part + 1] - ends[part]) * k / steps[part];
        text += fmt::format("{:g},{},", section.position, part + 1);
        if (std::isnan(at)) {
          text += ",\n";
          continue;
        }
        const profiles::ProfilePoint place = section.curve.at(at);
        text += fmt::format("{:.6f},{:.6f}\n", place.y, place.z);
      }
  }
  return text;
}

}  // namespace rollfem::app
