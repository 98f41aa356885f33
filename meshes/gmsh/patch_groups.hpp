// Which minima of the gap are one patch under a load, and where its reference point is.
#pragma once

#include "meshes/track/load_estimate.hpp"

#include <array>
#include <functional>
#include <vector>

namespace rollfem::meshes {

/// A stretch and the minima that went into it.
struct PatchGroup {
  Stretch stretch;
  std::vector<GapMinimum> minima;
};

/// Sinking under the load when these stretches carry it, measured from gap 0, mm.
using SinkingOf = std::function<double(const std::vector<Stretch>&)>;

/// Every minimum with the stretch between the ridges beside it; humps with next to no valley
/// between them are one.
std::vector<PatchGroup> separate_groups(const VerticalGap& gap);

/// Joins neighbours that meet under the load and whose normals differ by less than `merge_angle`
/// (rad), until none are left; the sinking falls with every joint. Returns the last sinking.
double merge_groups(const VerticalGap& gap, std::vector<PatchGroup>& groups, double merge_angle,
                    const SinkingOf& sinking_of);

/// Where the bodies overlap at a sinking: y of the side frame.
std::array<double, 2> reach_of(const VerticalGap& gap, const Stretch& stretch, double sinking);

/// Mean place of the overlap at a sinking, weighted by the square of its depth over the area; the
/// lowest point where nothing overlaps. y of the side frame.
double reference_place(const VerticalGap& gap, const Stretch& stretch, double sinking);

}  // namespace rollfem::meshes
