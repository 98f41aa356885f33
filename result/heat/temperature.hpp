// SPDX-License-Identifier: LGPL-2.1-or-later
// The flash temperature of both surfaces, from the work of friction: Jaeger 1942; with unlike
// bodies as Ertz and Knothe 2002 (Wear 253).
#pragma once

#include "result/result.hpp"

#include <array>
#include <vector>

namespace rollfem::contact {

/// Heat flows into both bodies through the elements, N/(mm s), while the contact rolls on.
struct HeatStep {
  double length = 0.0;  ///< mm rolled; infinite: steady rolling
  Field wheel, rail;
};
/// The last step first.
using HeatPast = std::vector<HeatStep>;

/// Sets the temperatures of both surfaces and what follows from them at a load point in steady
/// rolling whose ContactFields::work is known. Friction heats the elements in contact, where both
/// surfaces have one temperature; between and behind patches none flows. No heat is lost: what
/// both bodies take is the frictional work.
void set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, PointResult& point);

/// The same at the end of a step of this length, from the tractions and the slip of its elements:
/// material has passed each element ahead in the step in which it was there, so that a state that
/// stays has the temperatures of steady rolling, however long its steps. Returns the flows.
HeatStep set_temperatures(const ContactGrid& grid, const SurfaceHeat& heat, double length,
                          const HeatPast& past, PointResult& point);

/// Temperature that surfaces in contact have by the heat of earlier steps alone, degC, at the end
/// of a step of this length.
Field left_temperature(const ContactGrid& grid, const SurfaceHeat& heat, double length,
                       const HeatPast& past);

/// K above the temperature before contact below the surface of a body, from that of the elements of
/// its surface (degC), at places (x, y, depth >= 0), linear between the middles of elements; 0
/// ahead of and beside the grid, and more than its length behind it.
std::vector<double> rise_below(const ContactGrid& grid, const HeatedBody& body, double speed,
                               const Field& surface,
                               const std::vector<std::array<double, 3>>& places);

/// Where bodies have heat: warns of load points with surfaces above their limits, and notes the
/// thermal stress that the stresses of the result leave out, and the yielding of wheel or rail
/// (`yields_cold`).
void tell_of_heat(const Scene& scene, ModelResult& result,
                  const std::array<bool, 2>& yields_cold = {});

}  // namespace rollfem::contact
