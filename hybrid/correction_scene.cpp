// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hybrid/correction_scene.hpp"

#include "base/errors.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/patch/patch_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace rollfem::hybrid {

using contact::NormalLoad;
using contact::Scene;
using halfspace::PatchBox;
using halfspace::PatchSearch;

/// Semi-axes of the boxes then differ by 6.3 % at most. Where they differ by 9.4 % the pressure of
/// case f changes by 0.022 % and its traction coefficients by 1e-4.
const double correction_load_ratio = 1.2;

namespace {

/// The box of the rounded load is at most this many times that of the load itself; otherwise it
/// contains another contact of the profiles.
constexpr double largest_growth = 1.5;

double rounded_up(double value) {
  // Values already on a step stay there.
  const double steps = std::log(value) / std::log(correction_load_ratio);
  return std::pow(correction_load_ratio, std::ceil(steps - 1e-6));
}

NormalLoad rounded_up(NormalLoad load) {
  for (std::optional<double>* part : {&load.force, &load.approach})
    if (*part) *part = rounded_up(**part);
  return load;
}

bool is_alike(const PatchBox& larger, const PatchBox& box) {
  return larger.half_length <= largest_growth * box.half_length &&
         larger.half_width <= largest_growth * box.half_width &&
         std::abs(larger.middle - box.middle) <= 0.5 * box.half_width;
}

/// Segments of a given size must hold the finest cells around the box with some margin.
bool fits(const PatchBox& box, const Scene& bodies) {
  constexpr double half_sizes = 4.0;
  const auto holds = [&](const std::optional<double>& reach) {
    return !reach || *reach >= half_sizes * box.larger();
  };
  const auto half = [](std::optional<double> size) {
    if (size) *size *= 0.5;
    return size;
  };
  const fem::FemOptions& given = fem::options_of(bodies);
  return holds(bodies.body_extent) && holds(given.depth) && holds(half(given.width)) &&
         holds(half(given.length));
}

/// A line "name value value ...".
template <class... Values>
void add(std::string& text, const char* name, Values... values) {
  text += name;
  ((text += fmt::format(" {:.10g}", values)), ...);
  text += '\n';
}

void add(std::string& text, const char* name, const contact::HeightCurve& curve) {
  text += name;
  for (const contact::HeightKnot& knot : curve.knots()) {
    const contact::CurveValue at = curve.at(knot.y);
    // Heights are computed at positions found as roots, whose error affects the last digits.
    fmt::format_to(std::back_inserter(text), " {:.8f} {:.8f} {:.8f}", knot.y, at.value, at.slope);
  }
  text += '\n';
}

void add_surface(std::string& text, const contact::ContactSurface& surface) {
  add(text, "radii", surface.rolling_radius, surface.wheel_transverse_radius,
      surface.rail_transverse_radius, surface.follows, surface.wheel_round_to,
      surface.rail_round_to);
  if (surface.rail_is_roller()) add(text, "roller", surface.rail_rolling_radius);
  if (!surface.profiles) return;
  const contact::PatchGeometry& profiles = *surface.profiles;
  add(text, "rail", profiles.rail());
  add(text, "wheel", profiles.wheel_radius());
  const auto add_axle = [&](const contact::Axle& axle) {
    for (const auto& vector : {axle.point, axle.direction})
      text += fmt::format("axle {:.8f} {:.8f} {:.8f}\n", vector[0], vector[1], vector[2]);
  };
  add_axle(profiles.axle());
  if (profiles.is_roller()) add_axle(profiles.rail_axle());
}

/// Parameters of bodies that are not boxes under their surface.
void add_given_bodies(std::string& text, const Scene& scene) {
  const fem::FemOptions& options = fem::options_of(scene);
  if (options.mesh == fem::MeshFamily::gmsh)
    add(text, "sections", options.rim_thickness.value_or(0.0), scene.rail_inclination,
        scene.place && !scene.place->left ? 1.0 : 0.0);
  for (const std::string& mesh : {scene.wheel.mesh, scene.rail.mesh}) {
    if (mesh.empty()) continue;
    const auto path = std::filesystem::path(scene.file).parent_path() / mesh;
    std::error_code missing;  // reported by the reader of the mesh
    text += fmt::format("mesh {} {} {}\n", std::filesystem::absolute(path).string(),
                        std::filesystem::file_size(path, missing),
                        std::filesystem::last_write_time(path, missing).time_since_epoch().count());
  }
}

}  // namespace

Scene correction_scene(const Scene& scene) {
  Scene bodies;
  bodies.file = scene.file;
  bodies.geometry = scene.geometry;
  bodies.place = scene.place;
  bodies.rail_inclination = scene.rail_inclination;
  bodies.wheel = scene.wheel;
  bodies.rail = scene.rail;
  bodies.material = scene.material;
  bodies.material.layer = 0.0;
  bodies.follows_surface = scene.follows_surface;
  bodies.inertia = scene.inertia;
  bodies.body_extent = scene.body_extent;
  bodies.options.set<fem::FemOptions>() = fem::options_of(scene);
  bodies.speed = scene.feels_inertia() ? scene.speed : 0.0;
  const NormalLoad largest = contact::largest_load(scene);
  contact::LoadPoint point;
  point.creepage.lateral = scene.is_symmetric() ? 0.0 : 1.0;
  point.load = rounded_up(largest);
  bodies.points = {point};
  try {
    const PatchBox box = PatchSearch(bodies).box();
    if (is_alike(box, PatchSearch(scene).box()) && fits(box, bodies)) return bodies;
  } catch (const contact::Failure&) {
    // The profiles end before, or no patch is found.
  }
  bodies.points.front().load = largest;
  return bodies;
}

std::string correction_key(const Scene& correction) {
  std::string text;
  const PatchBox box = PatchSearch(correction).box();
  add(text, "patch", box.half_length, box.half_width, box.middle, box.half_loaded);
  add_surface(text, correction.geometry.surface);
  for (const auto* material : {&correction.wheel.material, &correction.rail.material})
    add(text, "material", material->young_modulus, material->poisson_ratio);
  const fem::FemOptions& given = fem::options_of(correction);
  add(text, "bodies", correction.body_extent.value_or(0.0), given.width.value_or(0.0),
      given.depth.value_or(0.0), given.length.value_or(0.0), given.fine_extent.value_or(0.0));
  text += fmt::format("degree {} far {}\n", given.degree,
                      given.far_boundary ? static_cast<int>(*given.far_boundary) : -1);
  add_given_bodies(text, correction);
  return text;
}

std::string correction_words(const Scene& correction) {
  const contact::ContactSurface& surface = correction.geometry.surface;
  const PatchBox box = PatchSearch(correction).box();
  const std::string bodies =
      correction.place
          ? fmt::format("{}, {}", std::filesystem::path(correction.file).stem().string(),
                        correction.place->label())
          : fmt::format("wheel {:.5g}, across {:.5g}; rail across {:.5g}", surface.rolling_radius,
                        surface.wheel_transverse_radius, surface.rail_transverse_radius);
  return fmt::format("{}; patch {:.3g} by {:.3g} mm", bodies, 2.0 * box.half_length,
                     2.0 * box.half_width);
}

}  // namespace rollfem::hybrid
