// SPDX-License-Identifier: LGPL-2.1-or-later
// The flash temperature of both surfaces, from the work of friction: Jaeger 1942; with unlike
// bodies as Ertz and Knothe 2002 (Wear 253).
#pragma once

#include "result/result.hpp"

namespace rollfem::contact {

/// Sets the temperatures of both surfaces and what follows from them at a load point in steady
/// rolling whose ContactFields::work is known. Friction heats the elements in contact, where both
/// surfaces have one temperature; between and behind patches none flows. No heat is lost: what
/// both bodies take is the frictional work.
void set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, PointResult& point);

/// Warns of load points with surfaces above the limits of the bodies.
void warn_of_temperature(const SurfaceHeat& heat, ModelResult& result);

}  // namespace rollfem::contact
