// Stresses of half-spaces at the [[subsurface.*]] points of a case.
#pragma once

#include "contact/result/result.hpp"

#include <vector>

namespace rollfem::halfspace {

/// Points of a request, mm in the global frame, the first side fastest; those that follow the
/// surface on the plane z = 0 or as far below it as asked.
std::vector<std::array<double, 3>> subsurface_points(const contact::SubsurfaceRequest& request);

/// Displacement and stress at the points of every request of the case, from tractions on the wheel.
/// Each body has its own material and, on the rail, the opposite tractions. Without displacement in
/// a rigid body.
std::vector<contact::SubsurfaceField> subsurface_fields(const contact::Scene& scene,
                                                        const contact::ContactGrid& grid,
                                                        const contact::SurfaceField& traction);

}  // namespace rollfem::halfspace
