#include "halfspace/patch/scene_chart.hpp"

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include <utility>

namespace rollfem::halfspace {

using contact::Scene;

namespace {

void check_curved(const Scene& scene) {
  const auto refuse = [&](bool asked, const char* what) {
    if (!asked) return;
    throw contact::InputError(
        fmt::format("{}: halfspace.surface = \"curved\": cannot be combined with {}; allowed: "
                    "wheel and rail with radii or profiles, and no stresses below the surface; do: "
                    "leave that out, or run with surface = \"planar\"",
                    scene.file, what));
  };
  refuse(!scene.geometry.has_surfaces(), "undeformed_distance");
  refuse(scene.given_pressure.has_value(), "given_pressure");
  refuse(scene.asks_for_stress(), "subsurface stresses, which need a plane half-space");
}

}  // namespace

contact::ChartedGeometry halfspace_geometry(const Scene& scene) {
  if (!(scene.follows_surface > 0.0)) return {scene.geometry, contact::Chart::plane};
  check_curved(scene);
  contact::Geometry geometry = scene.geometry;
  geometry.surface.follows = scene.follows_surface;
  return {std::move(geometry), contact::Chart::arc};
}

}  // namespace rollfem::halfspace
