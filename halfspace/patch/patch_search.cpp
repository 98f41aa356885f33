// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/patch/patch_search.hpp"

#include "base/count.hpp"
#include "base/errors.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "scene/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Scene;

namespace {

/// Cache of the latest patches of true profiles, each with its ridge. A run requests the same patch
/// many times: to choose a model, to lay out grids, bodies and ellipses, and to find stored smooth
/// parts.
class FoundPatches {
 public:
  struct Entry {
    std::shared_ptr<const ExpectedPatch> patch;
    std::shared_ptr<const Ridge> ridge;
  };

  Entry of(const Scene& scene, SearchDetail detail) {
    const contact::NormalLoad load = contact::largest_load(scene);
    const Key key{scene.material.shear_modulus,
                  scene.material.poisson_ratio,
                  scene.material.contact_modulus,
                  load.force,
                  load.approach,
                  detail};
    const std::weak_ptr<const contact::PatchGeometry> profiles = scene.geometry.surface.profiles;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const Known& known : found_)
        if (known.key == key && !known.profiles.owner_before(profiles) &&
            !profiles.owner_before(known.profiles))
          return known.entry;
    }
    Entry entry;
    entry.ridge = std::make_shared<const Ridge>(*scene.geometry.surface.profiles);
    entry.patch =
        std::make_shared<const ExpectedPatch>(patch_of_profiles(scene, *entry.ridge, detail));
    const std::lock_guard<std::mutex> lock(mutex_);
    if (found_.size() == most_kept) found_.pop_front();
    found_.push_back({profiles, key, entry});
    return entry;
  }

 private:
  using Key = std::tuple<double, double, double, std::optional<double>, std::optional<double>,
                         SearchDetail>;
  struct Known {
    std::weak_ptr<const contact::PatchGeometry> profiles;
    Key key;
    Entry entry;
  };
  static constexpr std::size_t most_kept = 16;

  std::mutex mutex_;
  std::deque<Known> found_;
};

}  // namespace

const ExpectedPatch& PatchSearch::patch() const {
  static FoundPatches found;
  if (patch_) return *patch_;
  if (scene_.has_profiles()) {
    FoundPatches::Entry entry = found.of(scene_, detail_);
    patch_ = std::move(entry.patch);
    ridge_ = std::move(entry.ridge);
  } else {
    const bool by_points = scene_.geometry.distance_values && !scene_.given_pressure;
    patch_ = std::make_shared<const ExpectedPatch>(by_points ? patch_of_points(scene_)
                                                             : patch_of_ellipse(scene_));
  }
  return *patch_;
}

const Ridge& PatchSearch::ridge() const {
  patch();
  return *ridge_;
}

PatchBox PatchSearch::box() const {
  const ExpectedPatch& found = patch();
  const Box& near = found.near;
  return {std::max(-near.x_lower, near.x_upper), 0.5 * (near.y_upper - near.y_lower),
          0.5 * (near.y_lower + near.y_upper), 0.5 * found.covered_width()};
}

// The potential contact area.

namespace {

/// More elements than this are a mistake in the case file.
constexpr double largest_number_of_elements = 4e7;
constexpr const char* of_grid = "elements of the contact grid (contact_grid)";

int elements(double extent, double cell, int margin) {
  // An extent of a whole number of cells must not gain one by rounding.
  return contact::count_of(std::ceil(extent / cell - 1e-6), of_grid) + 2 * margin;
}

void check_cells(const Scene& scene, const PatchExtent& extent, double dx, double dy, int margin) {
  if (dx > 0.0 && dy > 0.0) {
    const double nx = extent.length / dx + 2.0 * margin, ny = extent.width / dy + 2.0 * margin;
    if (nx * std::max(ny, 1.0) <= largest_number_of_elements && ny <= largest_number_of_elements)
      return;
  }
  throw contact::InputError(
      scene.where(),
      "contact_grid.cell_size = [{}, {}] mm: a patch of about {:.4g} by {:.4g} mm needs cells "
      "above 0 and at most {:.0e} of them; do: choose larger cells",
      dx, dy, extent.length, extent.width, largest_number_of_elements);
}

/// A tiny patch may lie far from the origin, where the bodies touch first.
void check_distance(const Scene& scene, const ExpectedPatch& patch, double dx, double dy) {
  const double length = std::max(patch.x_upper, 0.0) - std::min(patch.x_lower, 0.0);
  const double width = std::max(patch.y_upper, 0.0) - std::min(patch.y_lower, 0.0);
  if (length / dx * (width / dy) <= largest_number_of_elements) return;
  throw contact::SolveError(
      scene.where(),
      "the patch, of about {:.3g} by {:.3g} mm, lies up to {:.3g} mm from the place where "
      "wheel and rail touch first, which the contact grid contains too: it needs more than {:.0e} "
      "elements; do: give a larger load, or a larger contact_grid.cell_size",
      patch.length, patch.width, std::max(length, width), largest_number_of_elements);
}

/// Elements of dx by dy that contain the patch, the origin and a margin, on the lattice with a
/// corner at the origin (and at the requested middle): a patch has the same elements whether or not
/// the grid contains another patch.
ContactGrid anchored_grid(const ExpectedPatch& patch, const std::array<double, 2>& middle,
                          double dx, double dy, int margin) {
  const auto first = [&](double lower, double cell) {
    return contact::count_of(std::floor(std::min(lower, 0.0) / cell + 1e-6), of_grid) - margin;
  };
  const auto last = [&](double upper, double cell) {
    return contact::count_of(std::ceil(std::max(upper, 0.0) / cell - 1e-6), of_grid) + margin;
  };
  const int i = first(patch.x_lower, dx), j = first(patch.y_lower, dy);
  return {last(patch.x_upper, dx) - i, last(patch.y_upper, dy) - j, dx, dy,
          middle[0] + (i + 0.5) * dx,  middle[1] + (j + 0.5) * dy};
}

/// Whole elements that fit into a given extent.
int elements_within(double extent, double cell) {
  return std::max(1, contact::count_of(std::floor(extent / cell + 1e-6), of_grid));
}

}  // namespace

PatchExtent PatchSearch::extent() const {
  if (const auto& values = scene_.geometry.distance_values) {
    if (scene_.contact_grid.extent)
      return {(*scene_.contact_grid.extent)[0], (*scene_.contact_grid.extent)[1]};
    return {(values->nx - 1) * values->dx, (values->ny - 1) * values->dy};
  }
  return {patch().carrying_length, patch().carrying_width};
}

/// There is no contact far beyond the profiles.
void PatchSearch::check_extent_of_profiles() const {
  const auto& extent = scene_.contact_grid.extent;
  if (!extent) return;
  constexpr double most_times = 10.0;
  const contact::HeightCurve& rail = scene_.geometry.surface.profiles->rail();
  const double most = most_times * (rail.last() - rail.first());
  if (std::max((*extent)[0], (*extent)[1]) <= most) return;
  throw contact::InputError(
      scene_.where(),
      "contact_grid.extent = [{:.4g}, {:.4g}] mm: the rail's profile is {:.4g} mm wide; "
      "allowed: up to {:g} times that, {:.4g} mm; do: give the extent of the patches, or "
      "remove it",
      (*extent)[0], (*extent)[1], rail.last() - rail.first(), most_times, most);
}

/// Rejects an area that cannot contain the patch, or is far too large for it, by the closed form.
/// The true patch of strongly curved bodies may be about ten per cent smaller than Hertz's ellipse,
/// but not half of it.
void PatchSearch::check_extent() const {
  const contact::GridOptions& options = scene_.contact_grid;
  if (scene_.geometry.distance_values) return;
  if (scene_.has_profiles()) {
    check_extent_of_profiles();
    return;
  }
  const std::array<double, 2> size{patch().length, patch().width};
  // Without an extent the area grows until it holds the patch, a few times.
  constexpr double least_share = 0.5, most_times = 100.0, reach_by_growing = 10.0;
  bool fits = true;
  for (int k = 0; k < 2; ++k) {
    const double extent = options.extent ? (*options.extent)[k] : reach_by_growing * size[k];
    fits = fits && extent <= most_times * size[k] &&
           0.5 * extent - std::abs(options.middle[k]) >= 0.5 * least_share * size[k];
  }
  if (fits) return;
  const std::array<double, 2> extent = options.extent.value_or(size);
  throw contact::InputError(
      scene_.where(),
      "contact_grid.extent = [{:.4g}, {:.4g}] mm about [{:g}, {:g}]: the patch, of "
      "about {:.4g} by {:.4g} mm about [0, 0] by Hertz, is not inside it, or smaller "
      "than a hundredth of it; allowed: an extent from that of the patch to {:g} times "
      "as much; do: correct contact_grid.extent or middle, or remove them",
      extent[0], extent[1], options.middle[0], options.middle[1], size[0], size[1], most_times);
}

void PatchSearch::check_shape_of_cells(double dx, double dy) const {
  if (scene_.geometry.distance_values || scene_.geometry.line) return;
  constexpr double most_times = 200.0;
  const PatchExtent extent = this->extent();
  const double nx = extent.length / dx, ny = extent.width / dy;
  if (std::max(nx, ny) <= most_times * std::min(nx, ny)) return;
  throw contact::InputError(
      scene_.where(),
      "contact_grid.cell_size = [{:g}, {:g}] mm gives {:.4g} by {:.4g} elements in "
      "the box of {:.4g} by {:.4g} mm around the patch; allowed: up to {:g} times as "
      "many in one direction as in the other; do: choose cells in the shape of the "
      "patch, or give contact_grid.elements_across",
      dx, dy, nx, ny, extent.length, extent.width, most_times);
}

/// A grid within twice the reference distance keeps the compliance positive: its logarithm is
/// positive up to four times the reference distance. Within a fifth of a finite width, displacement
/// differences are those of endless rollers to some 1 %.
ContactGrid PatchSearch::line_grid(double dx, int margin) const {
  const contact::GridOptions& options = scene_.contact_grid;
  const contact::LineContact& line = *scene_.geometry.line;
  check_extent();
  check_cells(scene_, {patch().length, line.width}, dx, line.width, 0);
  const int nx = options.extent ? elements_within((*options.extent)[0], dx)
                                : elements(patch().length, dx, margin);
  const bool finite = std::isinf(line.reference);
  const double given = reference_of(line);
  const double least = (finite ? 5.0 : 0.5) * nx * dx;
  const double radius = std::abs(scene_.geometry.surface.rolling_radius);
  if (given < least && patch().length > 2.0 * radius)
    throw contact::InputError(
        scene_.where(),
        "the patch of {:.4g} mm by Hertz is longer than the body, whose relative radius is "
        "{:.4g} mm: no half-space; allowed: a patch that is short against the radius; do: "
        "check the load (N), young_modulus (MPa) and the radius (mm)",
        patch().length, radius);
  if (given < least)
    throw contact::InputError(
        scene_.where(),
        "geometry.{} = {:g} mm: the contact grid is {:.4g} mm long; allowed: at least {:.4g} "
        "mm, {} that; do: give a larger one, or a shorter contact_grid.extent",
        finite ? "width" : "reference_distance", given, nx * dx, least,
        finite ? "with reference_distance = inf five times" : "half of");
  ContactGrid grid = ContactGrid::centred(nx, 1, dx, line.width, options.middle[0], 0.0);
  grid.line_reference = line.reference;
  return grid;
}

ContactGrid PatchSearch::grid(double dx, double dy, int margin) const {
  if (scene_.geometry.line) return line_grid(dx, margin);
  const contact::GridOptions& options = scene_.contact_grid;
  const auto& values = scene_.geometry.distance_values;
  check_extent();
  if (!options.extent && !values) {
    const PatchExtent box{patch().length, patch().width};
    check_cells(scene_, box, dx, dy, margin);
    if (scene_.has_profiles()) check_distance(scene_, patch(), dx, dy);
    if (scene_.has_profiles()) return anchored_grid(patch(), options.middle, dx, dy, margin);
    return ContactGrid::centred(elements(box.length, dx, margin), elements(box.width, dy, margin),
                                dx, dy, options.middle[0] + patch().x_middle(),
                                options.middle[1] + patch().y_middle());
  }
  const PatchExtent extent =
      options.extent ? PatchExtent{(*options.extent)[0], (*options.extent)[1]} : this->extent();
  std::array<double, 2> middle = options.middle;
  if (values && !options.extent)
    middle = {values->x_first + 0.5 * extent.length, values->y_first + 0.5 * extent.width};
  check_cells(scene_, extent, dx, dy, 0);
  return ContactGrid::centred(elements_within(extent.length, dx), elements_within(extent.width, dy),
                              dx, dy, middle[0], middle[1]);
}

ContactGrid PatchSearch::grid(int margin) const {
  const contact::GridOptions& options = scene_.contact_grid;
  if (!options.cell_size && options.elements_across < 1)
    throw contact::InputError(scene_.where(),
                              "contact_grid.elements_across = {}: must be at least 1",
                              options.elements_across);
  const PatchExtent extent = this->extent();
  const double across = options.elements_across;
  const double dx = options.cell_size ? (*options.cell_size)[0] : extent.length / across;
  const double dy = options.cell_size ? (*options.cell_size)[1] : extent.width / across;
  check_shape_of_cells(dx, dy);
  return grid(dx, dy, margin);
}

namespace {

void check_curved(const Scene& scene) {
  const auto refuse = [&](bool asked, const char* what) {
    if (!asked) return;
    throw contact::InputError(
        scene.where(),
        "halfspace.surface = \"curved\": cannot be combined with {}; allowed: "
        "wheel and rail with radii or profiles, and no stresses below the surface; do: "
        "remove it, or run with surface = \"planar\"",
        what);
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
