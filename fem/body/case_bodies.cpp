#include "fem/body/case_bodies.hpp"

#include "contact/base/errors.hpp"
#include "fem/body/coarse_mesh.hpp"
#include "fem/model/run_layout.hpp"
#include "meshes/gmsh/true_section.hpp"

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

std::unique_ptr<Body> imported_body(const contact::Case& input, const std::string& key,
                                    const std::string& file, const SurfaceShape& shape,
                                    const contact::Material& material, BodyOptions options,
                                    MPI_Comm communicator) {
  const auto path = std::filesystem::path(input.file).parent_path() / file;
  const std::string name = fmt::format("{}: {}.mesh = \"{}\"", input.file, key, file);
  const bool case_is_symmetric = options.half;
  const auto mesh = user_mesh(path.string(), name, shape, options, communicator);
  options.half = std::any_of(mesh.sides.begin(), mesh.sides.end(),
                             [](const auto& quad) { return quad.side == meshes::Side::symmetry; });
  if (options.half && !case_is_symmetric)
    throw contact::InputError(
        fmt::format("{}: half a body (it has a group `symmetry`) cannot take lateral creepage or "
                    "spin; do: mesh the whole body, or set both to 0",
                    name));
  options.extent = distance_to_fixed(mesh);
  try {
    return std::make_unique<Body>(shape, material, options, mesh, communicator);
  } catch (const contact::InputError& error) {
    throw contact::InputError(fmt::format("{}: {}", name, error.what()));
  }
}

constexpr double default_rim_thickness = 65.0;  // mm
constexpr double default_cut_depth = 172.0;     // mm, the whole rail

meshes::TrueSection section_of(const contact::Case& input, bool is_wheel) {
  if (is_wheel)
    return meshes::wheel_section(*input.patch,
                                 input.fem.rim_thickness.value_or(default_rim_thickness));
  meshes::RailStand stand;
  stand.inclination = input.track.inclination;
  stand.field_at_left = input.place && !input.place->left;
  stand.cut_depth = input.fem.depth.value_or(default_cut_depth);
  return meshes::rail_section(*input.patch, stand);
}

std::unique_ptr<Body> section_body(const contact::Case& input, const SurfaceShape& shape,
                                   const contact::Material& material, BodyOptions options,
                                   MPI_Comm communicator) {
  options.depth.reset();
  try {
    const CoarseBody coarse =
        true_section_mesh(section_of(input, shape.is_wheel), shape, options, communicator);
    options.extent = distance_to_fixed(coarse.mesh);
    return std::make_unique<Body>(shape, material, options, coarse, communicator);
  } catch (const contact::InputError& error) {
    throw contact::InputError(fmt::format("{}: {}", input.file, error.what()));
  }
}

std::string section_note(const contact::Case& input) {
  return fmt::format(
      "bodies are true sections: the rail with the underside of the head, web and foot of 60E1, "
      "cut "
      "and held {:.4g} mm below its top, the rim held {:.4g} mm below the contact, both held at "
      "their ends along rolling",
      std::min(default_cut_depth, input.fem.depth.value_or(default_cut_depth)),
      input.fem.rim_thickness.value_or(default_rim_thickness));
}

void check_far_boundary(const contact::Case& input) {
  if (has_true_sections(input) && input.fem.far_boundary == contact::FarBoundary::point_load)
    throw contact::InputError(fmt::format(
        "{}: fem.far_boundary = \"point_load\" moves the far boundary as that of a half-space, "
        "which "
        "true sections with their free sides are not; allowed with profiles: \"clamped\"; do: "
        "remove it, or lay boxes on the surface ([fem] mesh = \"structured\")",
        input.file));
}

}  // namespace

void set_segment_sizes(const contact::Case& input, BodyOptions& options) {
  options.family = input.fem.mesh.value_or(MeshFamily::structured);
  if (input.fem.width) options.half_width = 0.5 * *input.fem.width;
  if (input.fem.length) options.half_length = 0.5 * *input.fem.length;
  options.depth = input.fem.depth;
}

CaseBodies make_bodies(const contact::Case& input, const BodyOptions& options,
                       MPI_Comm communicator) {
  const SurfaceShape wheel =
      input.patch ? profile_surface(input.patch, true)
                  : SurfaceShape{true, input.wheel.rolling_radius, input.wheel.transverse_radius};
  const SurfaceShape rail =
      input.patch ? profile_surface(input.patch, false)
                  : SurfaceShape{false, contact::infinity, input.rail.transverse_radius};
  check_far_boundary(input);
  const bool sections = has_true_sections(input);
  CaseBodies bodies;
  const auto make = [&](const std::string& key, const std::string& file, const SurfaceShape& shape,
                        const contact::Material& material) {
    if (file.empty() && sections)
      return section_body(input, shape, material, options, communicator);
    if (file.empty()) return std::make_unique<Body>(shape, material, options, communicator);
    bodies.notes.push_back(fmt::format("the {} has the mesh of {}", key, file));
    return imported_body(input, key, file, shape, material, options, communicator);
  };
  bodies.wheel = make("wheel", input.wheel.mesh, wheel, input.wheel.material);
  bodies.rail = make("rail", input.rail.mesh, rail, input.rail.material);
  const auto reach = [sections](const Body& body, bool imported) {
    const BodyOptions& o = body.options();
    return imported || sections ? o.extent : std::min({o.reach_s(), o.reach_t(), o.reach_depth()});
  };
  bodies.reach = std::min(reach(*bodies.wheel, !input.wheel.mesh.empty()),
                          reach(*bodies.rail, !input.rail.mesh.empty()));
  if (sections)
    bodies.notes.push_back(section_note(input));
  else if (options.family == MeshFamily::gmsh)
    bodies.notes.push_back("meshes are made by gmsh: cross-sections of quadrilaterals, swept");
  return bodies;
}

}  // namespace rollfem::fem
