// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include "convert/equivalent.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::convert {

namespace {

constexpr std::size_t most_entries = 100;  // per case file

bool equally_spaced(const std::vector<double>& values) {
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (std::abs(values[k] - values[k - 1] - step) > 1e-6 * std::abs(step)) return false;
  return true;
}

std::string place(const std::array<double, 3>& p) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", p[0], p[1], p[2]);
}

using Axes = std::array<std::vector<double>, 3>;

/// The points of one block in mm, in our axes.
Axes axes_of(const StressBlock& given, const ElementPlaces& elements, double sign) {
  Axes along{given.x, given.y, given.z};
  if (given.by_element) {
    for (double& x : along[0]) x = elements.x + (x - 0.5) * elements.dx;
    for (double& y : along[1]) y = elements.y + (y - 0.5) * elements.dy;
  }
  for (std::size_t c = 0; c < 2; ++c)
    for (double& value : along[c]) value = in_mm(sign * value);
  for (auto& values : along) std::sort(values.begin(), values.end());
  return along;
}

/// The direction of the lines: the longest axis with equally spaced points in one body; 3 if there
/// is none.
std::size_t line_of(const Axes& along) {
  std::size_t line = 3;
  for (std::size_t c = 0; c < 3; ++c) {
    const bool one_body = c < 2 || along[2].front() * along[2].back() >= 0.0;
    if (along[c].size() > 1 && one_body && equally_spaced(along[c]) &&
        (line == 3 || along[c].size() > along[line].size()))
      line = c;
  }
  return line;
}

/// An entry for a line between two places, or for a point if both coincide.
std::string entry(const std::array<double, 3>& from, const std::array<double, 3>& to,
                  std::size_t points) {
  const char* const body = std::min(from[2], to[2]) < 0.0 ? "rail" : "wheel";
  if (points == 1)
    return fmt::format("[[subsurface.point]]\nbody = \"{}\"\nat = {}\n", body, place(from));
  return fmt::format("[[subsurface.line]]\nbody = \"{}\"\nfrom = {}\nto = {}\npoints = {}\n", body,
                     place(from), place(to), points);
}

/// All entries; empty if there are too many.
std::vector<std::string> entries_of(Axes along) {
  const std::size_t line = line_of(along);
  std::vector<double> whole{0.0};
  if (line < 3) std::swap(whole, along[line]);
  if (line < 3) along[line] = {0.0};
  std::vector<std::string> all;
  if (along[0].size() * along[1].size() * along[2].size() > most_entries) return all;
  for (const double x : along[0])
    for (const double y : along[1])
      for (const double z : along[2]) {
        std::array<double, 3> from{x, y, z}, to = from;
        if (line < 3) from[line] = whole.front(), to[line] = whole.back();
        all.push_back(entry(from, to, whole.size()));
      }
  return all;
}

}  // namespace

void fill_stresses(const ContactCase& given, const ElementPlaces& elements, double sign,
                   Equivalent& made) {
  if (given.digits.S == 0 || given.digits.M != 0) return;
  std::size_t entries = 0;
  for (const StressBlock& block : given.stress_blocks) {
    if (block.x.empty() || block.y.empty() || block.z.empty()) continue;
    const auto texts = entries_of(axes_of(block, elements, sign));
    entries += texts.size();
    if (texts.empty() || entries > most_entries)
      made.notes.push_back(
          fmt::format("a block of {} by {} by {} points below the surface is not converted: "
                      "rollfem stress evaluates planes and lines after the run",
                      block.x.size(), block.y.size(), block.z.size()));
    else
      for (const std::string& text : texts) made.stresses += "\n" + text;
  }
}

}  // namespace rollfem::convert
