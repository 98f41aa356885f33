// SPDX-License-Identifier: LGPL-2.1-or-later
// The mesh of a true section: a block of equal cells under the patch, and the polygon around it.
#include "contact/base/count.hpp"
#include "contact/base/errors.hpp"
#include "contact/base/pi.hpp"
#include "meshes/block_mesh.hpp"
#include "meshes/true_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::meshes {

namespace {

/// Lines of the polygon grow by this fraction of their distance from the block, up to `longest`; a
/// web of 16.5 mm then has two cells.
constexpr double growth = 0.5;
constexpr double longest = 16.0;  // mm
/// Largest turn of a line, rad.
constexpr double largest_turn = 0.6;

double distance(const SectionPoint& a, const SectionPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Points along a path at about the requested spacing: both ends, and between them as many as the
/// sum of ds / length plus the turning requires.
std::vector<SectionPoint> spaced(const std::vector<SectionPoint>& way,
                                 const std::function<double(const SectionPoint&)>& length) {
  std::vector<SectionPoint> fine{way.front()};
  for (std::size_t k = 1; k < way.size(); ++k) {
    const double size = distance(way[k - 1], way[k]);
    const int parts =
        std::max(1, contact::count_of(std::ceil(size / 0.25), "points around a section"));
    for (int p = 1; p <= parts; ++p)
      fine.push_back({way[k - 1][0] + p * (way[k][0] - way[k - 1][0]) / parts,
                      way[k - 1][1] + p * (way[k][1] - way[k - 1][1]) / parts});
  }
  std::vector<double> measure{0.0};
  double last = std::atan2(fine[1][1] - fine[0][1], fine[1][0] - fine[0][0]);
  for (std::size_t k = 1; k < fine.size(); ++k) {
    const double angle = std::atan2(fine[k][1] - fine[k - 1][1], fine[k][0] - fine[k - 1][0]);
    const double turn = std::abs(std::remainder(angle - last, 2.0 * contact::pi));
    last = angle;
    measure.push_back(measure.back() + std::max(distance(fine[k - 1], fine[k]) / length(fine[k]),
                                                turn / largest_turn));
  }
  const int count = std::max(
      1, contact::count_of(std::round(measure.back()), "points around a section (fem.cell_size)"));
  std::vector<SectionPoint> places{fine.front()};
  std::size_t at = 0;
  for (int k = 1; k < count; ++k) {
    while (measure[at] < k * measure.back() / count) ++at;
    places.push_back(fine[at]);
  }
  places.push_back(fine.back());
  return places;
}

/// Left of the block, right of it: the profile between its ends and the corners of the block.
std::vector<SectionPoint> profile_part(const TrueSection& outline, const BlockMesh& block,
                                       bool left) {
  const SectionPoint corner = block.point(left ? 0 : block.last_column(), 0);
  // The nearest point of the profile, which may be undercut at a flange.
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < outline.profile.size(); ++k)
    if (distance(outline.profile[k], corner) < distance(outline.profile[nearest], corner))
      nearest = k;
  std::vector<SectionPoint> part;
  if (left) {
    part.assign(outline.profile.begin(),
                outline.profile.begin() + static_cast<std::ptrdiff_t>(nearest));
    part.push_back(corner);
  } else {
    part.push_back(corner);
    part.insert(part.end(), outline.profile.begin() + static_cast<std::ptrdiff_t>(nearest) + 1,
                outline.profile.end());
  }
  if (part.size() < 2)
    throw contact::InputError(
        fmt::format("the finely meshed region from y = {:.4g} to {:.4g} mm extends beyond the "
                    "profile: use a smaller [fem] fine_extent or cell_size",
                    block.columns.front(), block.columns.back()));
  return part;
}

}  // namespace

BlockedSection mesh_true_section(const TrueSection& outline, const SectionBlock& given) {
  BlockMesh block{given.height, {}, given.rows, outline.inwards * given.cell_size};
  for (int column = -given.half_columns; column <= given.half_columns; ++column)
    block.columns.push_back(given.middle + column * given.cell_size);
  std::vector<SectionPoint> around_block;
  for (int row = 0; row <= block.rows; ++row)
    for (int column = 0; column <= block.last_column(); ++column)
      if (row == block.rows || column == 0 || column == block.last_column())
        around_block.push_back(block.point(column, row));
  const auto length = [&](const SectionPoint& p) {
    double nearest = HUGE_VAL;
    for (const SectionPoint& node : around_block) nearest = std::min(nearest, distance(p, node));
    return std::min(std::max(longest, 2.0 * given.cell_size),
                    2.0 * given.cell_size + growth * nearest);
  };
  // The closed polygon: profile, block, profile, lower outline.
  std::vector<BlockedLine> polygon;
  const auto add = [&](const std::vector<SectionPoint>& way, std::optional<Side> side = {}) {
    const auto places = spaced(way, length);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) polygon.push_back({places[k], side});
  };
  add(profile_part(outline, block, true));
  const std::vector<BlockedLine> of_block = lines_of(block);
  polygon.insert(polygon.end(), of_block.begin(), of_block.end());
  add(profile_part(outline, block, false));
  for (std::size_t k = 0; k + 1 < outline.around.size(); ++k)
    add({outline.around[k], outline.around[k + 1]},
        k == outline.held ? std::optional(Side::fixed) : std::nullopt);
  return mesh_around(block, polygon, "the depth");
}

}  // namespace rollfem::meshes
