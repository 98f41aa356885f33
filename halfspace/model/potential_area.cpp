#include "contact/base/errors.hpp"
#include "halfspace/model/expected_patch.hpp"
#include "halfspace/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

using contact::ContactGrid;

namespace {

/// More elements than this are a mistake in the case file, not a wish.
constexpr double largest_number_of_elements = 4e7;

int elements(double extent, double cell, int margin) {
  // An extent of a whole number of cells must not gain one by rounding.
  return static_cast<int>(std::ceil(extent / cell - 1e-6)) + 2 * margin;
}

void check_cells(const contact::Scene& scene, const PatchExtent& extent, double dx, double dy,
                 int margin) {
  if (dx > 0.0 && dy > 0.0 &&
      (extent.length / dx + 2.0 * margin) * (extent.width / dy + 2.0 * margin) <=
          largest_number_of_elements)
    return;
  throw contact::InputError(fmt::format(
      "{}: contact_grid.cell_size = [{}, {}] mm: a patch of about {:.4g} by {:.4g} mm needs cells "
      "above 0 and at most {:.0e} of them; do: choose larger cells",
      scene.file, dx, dy, extent.length, extent.width, largest_number_of_elements));
}

/// Elements of dx by dy that hold the patch, the origin and a margin, of the lattice with a corner
/// at the origin (and the middle that the case asks for): the same elements about a patch whether
/// the grid holds another one beside it or not.
ContactGrid anchored_grid(const ExpectedPatch& patch, const std::array<double, 2>& middle,
                          double dx, double dy, int margin) {
  const auto first = [&](double lower, double cell) {
    return static_cast<int>(std::floor(std::min(lower, 0.0) / cell + 1e-6)) - margin;
  };
  const auto last = [&](double upper, double cell) {
    return static_cast<int>(std::ceil(std::max(upper, 0.0) / cell - 1e-6)) + margin;
  };
  const int i = first(patch.x_lower, dx), j = first(patch.y_lower, dy);
  return {last(patch.x_upper, dx) - i, last(patch.y_upper, dy) - j, dx, dy,
          middle[0] + (i + 0.5) * dx,  middle[1] + (j + 0.5) * dy};
}

/// Whole elements that fit into a given extent.
int elements_within(double extent, double cell) {
  return std::max(1, static_cast<int>(std::floor(extent / cell + 1e-6)));
}

}  // namespace

const ExpectedPatch& AreaOfPatch::patch() const {
  if (!patch_) patch_ = expected_patch(scene_);
  return *patch_;
}

PatchExtent AreaOfPatch::extent() const {
  if (const auto& values = scene_.geometry.distance_values) {
    if (scene_.contact_grid.extent)
      return {(*scene_.contact_grid.extent)[0], (*scene_.contact_grid.extent)[1]};
    return {(values->nx - 1) * values->dx, (values->ny - 1) * values->dy};
  }
  return {patch().carrying_length, patch().carrying_width};
}

PatchExtent expected_extent(const contact::Scene& scene) {
  return AreaOfPatch(scene).extent();
}

ContactGrid AreaOfPatch::grid(double dx, double dy, int margin) const {
  const contact::GridOptions& options = scene_.contact_grid;
  const auto& values = scene_.geometry.distance_values;
  if (!options.extent && !values) {
    const PatchExtent box{patch().length(), patch().width()};
    check_cells(scene_, box, dx, dy, margin);
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

ContactGrid potential_area(const contact::Scene& scene, double dx, double dy, int margin) {
  return AreaOfPatch(scene).grid(dx, dy, margin);
}

ContactGrid potential_area(const contact::Scene& scene, int margin) {
  const contact::GridOptions& options = scene.contact_grid;
  if (!options.cell_size && options.elements_across < 1)
    throw contact::InputError(
        fmt::format("{}: contact_grid.elements_across = {}: must be at least 1", scene.file,
                    options.elements_across));
  const AreaOfPatch area(scene);
  const PatchExtent extent = area.extent();
  const double across = options.elements_across;
  const double dx = options.cell_size ? (*options.cell_size)[0] : extent.length / across;
  const double dy = options.cell_size ? (*options.cell_size)[1] : extent.width / across;
  return area.grid(dx, dy, margin);
}

}  // namespace rollfem::halfspace
