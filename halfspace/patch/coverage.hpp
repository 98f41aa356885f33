// Checks that a solved grid holds all of a contact: wheel and rail must not overlap beyond it, nor
// press on each other up to where another contact of the wheel begins.
#pragma once

#include "contact/result/result.hpp"

#include <array>
#include <optional>

namespace rollfem::halfspace {

/// Of a grid's lateral coordinate, mm: from the first to the last place beyond the grid where the
/// bodies would overlap under this load point, each element of the patch taken as a point load on
/// the half-space. Nothing for bodies without profiles. Where the undeformed bodies are farther
/// apart than the approach nothing touches, for displacement only ever opens the gap.
std::optional<std::array<double, 2>> touched_beyond(const contact::Scene& scene,
                                                    const contact::ChartedGeometry& geometry,
                                                    const contact::ContactGrid& grid,
                                                    const contact::PointResult& point,
                                                    const contact::NormalLoad& load);

/// Throws contact::SolveError where pressure reaches a limit of the contact
/// (PatchGeometry::limits).
void check_limits(const contact::Scene& scene, const contact::ChartedGeometry& geometry,
                  const contact::ContactGrid& grid, const contact::Field& pressure);

}  // namespace rollfem::halfspace
