#include "contact/errors.hpp"
#include "halfspace/hertz.hpp"
#include "halfspace/model.hpp"

#include <fmt/format.h>

#include <algorithm>
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

ContactGrid area_around(const HertzContact& hertz, const std::string& file, double dx, double dy,
                        int margin) {
  const double length = 2.0 * hertz.semi_axis_x;
  const double width = 2.0 * hertz.semi_axis_y;
  if (!(dx > 0.0 && dy > 0.0) ||
      (length / dx + 2.0 * margin) * (width / dy + 2.0 * margin) > largest_number_of_elements)
    throw contact::InputError(
        fmt::format("{}: contact_grid.cell_size = [{}, {}] mm: a patch of about {:.4g} by {:.4g} "
                    "mm needs cells "
                    "above 0 and at most {:.0e} of them; do: choose larger cells",
                    file, dx, dy, length, width, largest_number_of_elements));
  return ContactGrid::centred(elements(length, dx, margin), elements(width, dy, margin), dx, dy);
}

}  // namespace

ContactGrid potential_area(const contact::Case& input, double dx, double dy, int margin) {
  return area_around(hertz_of_case(input), input.file, dx, dy, margin);
}

ContactGrid potential_area(const contact::Case& input, int margin) {
  const HertzContact hertz = hertz_of_case(input);
  const contact::GridOptions& options = input.contact_grid;
  if (!options.cell_size && options.elements_across < 1)
    throw contact::InputError(
        fmt::format("{}: contact_grid.elements_across = {}: must be at least 1", input.file,
                    options.elements_across));
  const double across = options.elements_across;
  const double dx = options.cell_size ? (*options.cell_size)[0] : 2.0 * hertz.semi_axis_x / across;
  const double dy = options.cell_size ? (*options.cell_size)[1] : 2.0 * hertz.semi_axis_y / across;
  return area_around(hertz, input.file, dx, dy, margin);
}

}  // namespace rollfem::halfspace
