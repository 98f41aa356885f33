#include "contact/scene/flanks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rollfem::contact {

std::string why_flanks_touch(const Geometry& geometry, double y) {
  const ContactSurface& surface = geometry.surface;
  const auto straight = [&](double radius, double round_to) {
    return std::isfinite(radius) && std::abs(y) > round_to * std::abs(radius);
  };
  if (!geometry.has_surfaces() || geometry.has_profiles() ||
      !straight(surface.wheel_transverse_radius, surface.wheel_round_to) ||
      !straight(surface.rail_transverse_radius, surface.rail_round_to))
    return "";
  return fmt::format(
      "the contact patch reaches past the circles of wheel and rail, which end at {} and {} of "
      "their radii across, onto straight flanks (the potential contact area ends at y = {:.4g} "
      "mm); equally steep flanks touch along their whole length, which no grid can contain; do: "
      "give [wheel] and [rail] a larger round_to (at most 0.9), a smaller load, or transverse "
      "radii that differ more (docs/meshes.md)",
      surface.wheel_round_to, surface.rail_round_to, y);
}

}  // namespace rollfem::contact
