// Displacements under a contact due to loads beside it: the other contacts of its
// wheel, as point loads on the half-space to which the surface of both is unrolled
// (Boussinesq, Cerruti; Johnson 1985, 3.2 and 3.6).
#pragma once

#include "contact/base/material.hpp"
#include "contact/scene/scene.hpp"

namespace rollfem::halfspace {

/// Normal displacement difference (wheel minus rail, mm) at (x, y): an extra distance.
double displacement_beside(const std::vector<contact::LoadBeside>& loads,
                           const contact::CombinedMaterial& material, double x, double y);

/// The same at the element centres; empty where nothing loads.
contact::Field displacement_beside(const std::vector<contact::LoadBeside>& loads,
                                   const contact::CombinedMaterial& material,
                                   const contact::ContactGrid& grid);

/// Slip of steady rolling by the tangential loads: -du/dx at the element centres; empty as well.
contact::TangentialField slip_beside(const std::vector<contact::LoadBeside>& loads,
                                     const contact::CombinedMaterial& material,
                                     const contact::ContactGrid& grid);

}  // namespace rollfem::halfspace
