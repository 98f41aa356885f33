// One patch on one grid, in milliseconds: without the coarser grids needed for
// error bars, and with the patch located on few elements.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"
#include "track/search/contact_search.hpp"

namespace rollfem::capi {

/// No row without pressure lies between others.
bool is_one_region(const contact::ContactGrid& grid, const contact::Field& pressure);

/// The first load point of a scene on a grid of `across` elements over the patch each way. Throws
/// contact::SolveError and contact::InputError as the model halfspace does.
contact::PointResult solve_patch(const contact::Scene& scene,
                                 const track::WheelRailContact& contact, int across);

}  // namespace rollfem::capi
