// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/derived.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace rollfem::contact {

namespace {

void check_sizes(const ContactGrid& grid, std::initializer_list<const Field*> fields,
                 const char* what) {
  for (const Field* field : fields)
    if (field->size() != grid.size())
      throw InputError(
          fmt::format("{} has {} values for a contact grid of {} by {}; allowed: one per element",
                      what, field->size(), grid.nx, grid.ny));
}

/// Moment of the tangential tractions about the origin, N mm.
double spin_moment(const ContactGrid& grid, const SurfaceField& traction) {
  double moment = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      moment += grid.x(i) * traction.y[k] - grid.y(j) * traction.x[k];
    }
  return moment * grid.element_area();
}

}  // namespace

double elastic_energy(const ContactGrid& grid, const SurfaceField& traction,
                      const SurfaceField& displacement) {
  check_sizes(grid, {&traction.x, &traction.y, &traction.n}, "traction");
  check_sizes(grid, {&displacement.x, &displacement.y, &displacement.n}, "displacement");
  return 0.5 * grid.element_area() *
         (traction.x.dot(displacement.x) + traction.y.dot(displacement.y) +
          traction.n.dot(displacement.n));
}

PowerBalance power_balance(const ContactGrid& grid, const SurfaceField& traction,
                           const TangentialField& slip, const Creepage& creepage, double speed,
                           const TangentialField& extra_slip) {
  check_sizes(grid, {&traction.x, &traction.y}, "traction");
  const double area = grid.element_area();
  const auto product = [&](const TangentialField& with, const char* what) {
    check_sizes(grid, {&with.x, &with.y}, what);
    return (traction.x.dot(with.x) + traction.y.dot(with.y)) * area;
  };
  double work = creepage.longitudinal * traction.x.sum() * area +
                creepage.lateral * traction.y.sum() * area +
                creepage.spin * spin_moment(grid, traction);
  if (extra_slip.x.size() != 0 || extra_slip.y.size() != 0)
    work += product(extra_slip, "extra slip");
  PowerBalance balance{-speed * product(slip, "slip"), -speed * work};
  const double scale = std::max(std::abs(balance.friction), std::abs(balance.creepage));
  if (scale > 0.0) balance.difference = std::abs(balance.friction - balance.creepage) / scale;
  return balance;
}

bool found_for_force(const PointResult& point, const std::string& name) {
  const auto word = point.no_bar.find(name);
  if (word != point.no_bar.end())
    return word->second != no_bar::given && word->second != no_bar::balance;
  // Of a wheelset that rolls freely the spin has a bar, too.
  return point.error_estimate.count(name) != 0 && point.error_estimate.count("spin") == 0;
}

}  // namespace rollfem::contact
