// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact/result/derived.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::contact {

namespace {

void check_size(const Field& field, const ContactGrid& grid, const char* name) {
  if (field.size() != grid.size())
    throw InputError(
        fmt::format("{} has {} values for a contact grid of {} by {}; allowed: one per element",
                    name, field.size(), grid.nx, grid.ny));
}

void check_tangential(const SurfaceField& traction, const ContactGrid& grid) {
  check_size(traction.x, grid, "traction.x");
  check_size(traction.y, grid, "traction.y");
}

double tangential_product(const ContactGrid& grid, const SurfaceField& traction,
                          const TangentialField& slip, const char* name) {
  check_tangential(traction, grid);
  check_size(slip.x, grid, name);
  check_size(slip.y, grid, name);
  return (traction.x.dot(slip.x) + traction.y.dot(slip.y)) * grid.element_area();
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
  check_tangential(traction, grid);
  check_size(traction.n, grid, "traction.n");
  check_size(displacement.x, grid, "displacement.x");
  check_size(displacement.y, grid, "displacement.y");
  check_size(displacement.n, grid, "displacement.n");
  return 0.5 * grid.element_area() *
         (traction.x.dot(displacement.x) + traction.y.dot(displacement.y) +
          traction.n.dot(displacement.n));
}

double frictional_power(const ContactGrid& grid, const SurfaceField& traction,
                        const TangentialField& slip, double speed) {
  return -speed * tangential_product(grid, traction, slip, "slip");
}

double creepage_power(const ContactGrid& grid, const SurfaceField& traction,
                      const Creepage& creepage, double speed, const TangentialField& extra_slip) {
  check_tangential(traction, grid);
  const double area = grid.element_area();
  const double moment = spin_moment(grid, traction);
  double work = creepage.longitudinal * traction.x.sum() * area +
                creepage.lateral * traction.y.sum() * area + creepage.spin * moment;
  if (extra_slip.x.size() != 0 || extra_slip.y.size() != 0)
    work += tangential_product(grid, traction, extra_slip, "extra slip");
  return -speed * work;
}

PowerBalance power_balance(const ContactGrid& grid, const SurfaceField& traction,
                           const TangentialField& slip, const Creepage& creepage, double speed,
                           const TangentialField& extra_slip) {
  PowerBalance balance;
  balance.friction = frictional_power(grid, traction, slip, speed);
  balance.creepage = creepage_power(grid, traction, creepage, speed, extra_slip);
  const double scale = std::max(std::abs(balance.friction), std::abs(balance.creepage));
  if (scale > 0.0) balance.difference = std::abs(balance.friction - balance.creepage) / scale;
  return balance;
}

PowerBalance power_balance(const ContactGrid& grid, const PointResult& point, double speed,
                           const TangentialField& extra_slip) {
  return power_balance(grid, point.fields.traction, point.fields.slip, point.creepage, speed,
                       extra_slip);
}

bool found_for_force(const PointResult& point, const std::string& name) {
  const auto word = point.no_bar.find(name);
  if (word != point.no_bar.end())
    return word->second != no_bar::given && word->second != no_bar::balance;
  // Of a wheelset that rolls freely the spin has a bar, too.
  return point.error_estimate.count(name) != 0 && point.error_estimate.count("spin") == 0;
}

}  // namespace rollfem::contact
