// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/case_bodies.hpp"

#include "base/errors.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "fem/mesh/run_layout.hpp"
#include "meshes/true_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace rollfem::fem {

namespace {

/// Distance from the origin to the nearest clamped node.
double distance_to_fixed(const meshes::HexMesh& mesh) {
  double nearest = HUGE_VAL;
  for (const auto& quad : mesh.sides)
    if (quad.side == meshes::Side::fixed)
      for (const int corner : quad.corners) {
        const auto& p = mesh.points[corner];
        nearest = std::min(nearest, std::hypot(p[0], p[1], p[2]));
      }
  return nearest;
}

std::unique_ptr<Body> imported_body(const contact::Scene& scene, const std::string& key,
                                    const std::string& file, const SurfaceShape& shape,
                                    const contact::Material& material, BodyOptions options,
                                    MPI_Comm communicator) {
  const auto path = std::filesystem::path(scene.file).parent_path() / file;
  const std::string name = fmt::format("{}: {}.mesh = \"{}\"", scene.file, key, file);
  const bool case_is_symmetric = options.half;
  const CoarseBody coarse = on_all_processes(
      communicator, [&] { return user_mesh(path.string(), name, shape, options); });
  options.half = coarse.mesh.half();
  if (options.half && !case_is_symmetric)
    throw contact::InputError({name},
                              "half a body (it has a group `symmetry`) allows neither lateral "
                              "creepage nor spin; do: mesh the whole body, or set both to 0");
  options.extent = distance_to_fixed(coarse.mesh);
  return contact::at_place({name}, [&] {
    return std::make_unique<Body>(shape, material, options, coarse, communicator);
  });
}

constexpr double default_rim_thickness = 65.0;  // mm
constexpr double default_cut_depth = 172.0;     // mm, the whole rail

meshes::TrueSection section_of(const contact::Scene& scene, bool is_wheel) {
  const contact::PatchGeometry& profiles = *scene.geometry.surface.profiles;
  if (is_wheel || profiles.is_roller())
    return meshes::rim_section(profiles, is_wheel,
                               options_of(scene).rim_thickness.value_or(default_rim_thickness));
  meshes::RailStand stand;
  stand.inclination = scene.rail_inclination;
  stand.field_at_left = scene.place && !scene.place->left;
  stand.cut_depth = options_of(scene).depth.value_or(default_cut_depth);
  return meshes::rail_section(profiles, stand);
}

std::unique_ptr<Body> section_body(const contact::Scene& scene, const SurfaceShape& shape,
                                   const contact::Material& material, BodyOptions options,
                                   MPI_Comm communicator) {
  options.depth.reset();
  return contact::at_place(scene.where(), [&] {
    const meshes::TrueSection section = section_of(scene, shape.is_wheel);
    const CoarseBody coarse =
        on_all_processes(communicator, [&] { return true_section_mesh(section, shape, options); });
    options.extent = distance_to_fixed(coarse.mesh);
    return std::make_unique<Body>(shape, material, options, coarse, communicator);
  });
}

std::string section_note(const contact::Scene& scene) {
  std::string text = "bodies are true sections, fixed at their ends along rolling";
  const bool roller = scene.geometry.surface.profiles->is_roller();
  if (!scene.rail.material.rigid() && !roller)
    text += fmt::format(
        "; the rail with the underside of the head, web and foot of 60E1, cut and fixed {:.4g} mm "
        "below its top",
        std::min(default_cut_depth, options_of(scene).depth.value_or(default_cut_depth)));
  if (!scene.wheel.material.rigid() || (roller && !scene.rail.material.rigid()))
    text += fmt::format("; the rim{} fixed {:.4g} mm from the contact",
                        roller ? "s of wheel and roller are" : " is",
                        options_of(scene).rim_thickness.value_or(default_rim_thickness));
  return text;
}

void check_far_boundary(const contact::Scene& scene) {
  if (has_true_sections(scene) && options_of(scene).far_boundary == FarBoundary::point_load)
    throw contact::InputError(
        scene.where(),
        "fem.far_boundary = \"point_load\" moves the far boundary like that of a half-space, "
        "which does not suit true sections with free sides; allowed with profiles: \"clamped\"; "
        "do: remove it, or use boxes on the surface ([fem] mesh = \"structured\")");
}

SurfaceShape surface_shape(const contact::Scene& scene, bool is_wheel) {
  const contact::ContactSurface& surface = scene.geometry.surface;
  if (scene.has_profiles()) return profile_surface(surface.profiles, is_wheel);
  SurfaceShape shape;
  shape.is_wheel = is_wheel;
  shape.rolling_radius = is_wheel ? surface.rolling_radius : -surface.rail_rolling_radius;
  shape.transverse_radius =
      is_wheel ? surface.wheel_transverse_radius : surface.rail_transverse_radius;
  shape.round_to = is_wheel ? surface.wheel_round_to : surface.rail_round_to;
  return shape;
}

}  // namespace

CaseBodies make_bodies(const contact::Scene& scene, const BodyOptions& options,
                       MPI_Comm communicator, const MeshedBodies& wanted) {
  const SurfaceShape wheel = surface_shape(scene, true), rail = surface_shape(scene, false);
  check_far_boundary(scene);
  const bool sections = has_true_sections(scene);
  CaseBodies bodies;
  const auto make = [&](const std::string& key, const std::string& file, const SurfaceShape& shape,
                        const contact::Material& material) -> std::unique_ptr<Body> {
    const BodyOptions own = options_of(scene, shape.is_wheel, options);
    if (material.rigid()) {
      contact::add_note(bodies.notes, "rigid_" + key, "the {} is rigid and not meshed", key);
      return nullptr;
    }
    if (!own.rows.equal_rows())
      contact::add_note(bodies.notes, "surface_layer_" + key,
                        "the {} flows at the surface: its cells are {:.2g} mm high there, and grow "
                        "to {:.4g} mm at a depth of {:.2g} mm ([fem] surface_layer)",
                        key, own.rows.depth(own.cell_size), own.cell_size,
                        own.rows.depth(own.rows.reach()));
    if (file.empty() && sections) return section_body(scene, shape, material, own, communicator);
    if (file.empty()) return std::make_unique<Body>(shape, material, own, communicator);
    contact::add_note(bodies.notes, "mesh_" + key, "the {} has the mesh of {}", key, file);
    return imported_body(scene, key, file, shape, material, own, communicator);
  };
  if (wanted.wheel) bodies.wheel = make("wheel", scene.wheel.mesh, wheel, scene.wheel.material);
  if (wanted.rail) bodies.rail = make("rail", scene.rail.mesh, rail, scene.rail.material);
  const auto reach = [sections](const Body* body, bool imported) {
    if (body == nullptr) return contact::infinity;
    const BodyOptions& o = body->options();
    return imported || sections ? o.extent : std::min({o.reach_s(), o.reach_t(), o.reach_depth()});
  };
  bodies.reach = std::min(reach(bodies.wheel.get(), !scene.wheel.mesh.empty()),
                          reach(bodies.rail.get(), !scene.rail.mesh.empty()));
  if (sections)
    bodies.notes.push_back({"mesh", section_note(scene)});
  else if (options.family == MeshFamily::gmsh)
    bodies.notes.push_back({"mesh", "meshes by gmsh: swept cross-sections of quadrilaterals"});
  return bodies;
}

}  // namespace rollfem::fem
