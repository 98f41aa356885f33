// SPDX-License-Identifier: LGPL-2.1-or-later
#include "result/derived.hpp"

#include "base/errors.hpp"
#include "base/pi.hpp"
#include "result/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

SurfaceField times_stretch(const SurfaceField& traction, const PatchShape& shape) {
  if (shape.stretch.size() == 0) return traction;
  return {traction.x.cwiseProduct(shape.stretch), traction.y.cwiseProduct(shape.stretch),
          traction.n.cwiseProduct(shape.stretch)};
}

Field pass_work(const ContactGrid& grid, const SurfaceField& traction,
                const TangentialField& slip) {
  check_sizes(grid, {&traction.x, &traction.y}, "traction");
  check_sizes(grid, {&slip.x, &slip.y}, "slip");
  Field work(grid.ny);
  for (int j = 0; j < grid.ny; ++j) {
    const auto row = [&](const Field& field) { return field.segment(grid.index(0, j), grid.nx); };
    // 0.0 - avoids minus zero.
    work[j] = 0.0 - grid.dx * (row(traction.x).dot(row(slip.x)) + row(traction.y).dot(row(slip.y)));
  }
  return work;
}

Field pass_work(const ContactGrid& grid, const PointResult& point) {
  if (point.fields.work.size() != grid.size()) return {};
  Field work(grid.ny);
  for (int j = 0; j < grid.ny; ++j)
    work[j] = grid.dx * point.fields.work.segment(grid.index(0, j), grid.nx).sum();
  return work;
}

Field slope_along(const ContactGrid& grid, const Field& values) {
  check_sizes(grid, {&values}, "field");
  Field slope = Field::Zero(grid.size());
  for (int j = 0; j < grid.ny; ++j)
    for (int k = grid.index(1, j); k < grid.index(grid.nx - 1, j); ++k)
      slope[k] = (values[k - 1] - values[k + 1]) / (2.0 * grid.dx);
  return slope;
}

void set_pass_work(const ContactGrid& grid, const Field& rows, PointResult& point) {
  const ContactFields& fields = point.fields;
  const SurfaceField& p = fields.traction;
  Eigen::ArrayXd work =
      (0.0 - (p.x.array() * fields.slip.x.array() + p.y.array() * fields.slip.y.array())).max(0.0);
  const Eigen::ArrayXd size = (p.x.array().square() + p.y.array().square()).sqrt();
  for (int j = 0; j < grid.ny; ++j) {
    auto row = work.segment(grid.index(0, j), grid.nx);
    const auto traction = size.segment(grid.index(0, j), grid.nx);
    const double missing = rows[j] / grid.dx - row.sum();
    if (missing < 0.0 && row.sum() > 0.0) {
      row *= rows[j] / grid.dx / row.sum();
      continue;
    }
    Eigen::ArrayXd share = (row > 0.0).select(traction, 0.0);
    for (int i = 0; i < grid.nx && share.sum() == 0.0; ++i) share[i] = traction[i];
    if (share.sum() > 0.0) row += missing / share.sum() * share;
  }
  point.fields.work = work.matrix();
  point.max_pass_work = pass_work(grid, point).maxCoeff();
}

namespace {

/// Work of the rows, where elements have `resolved` of it; 0 outside of the patch.
Eigen::ArrayXd evened_out(const Field& resolved, Eigen::ArrayXd rows) {
  const Eigen::ArrayXd lacking =
      (rows != 0.0).select(((rows - resolved.array()) / rows).abs().min(1.0), 0.0);
  for (int times = 0; times < 2; ++times) {
    const Eigen::ArrayXd before = rows;
    for (Eigen::Index j = 0; j + 1 < rows.size(); ++j) {
      if (before[j] == 0.0 || before[j + 1] == 0.0) continue;
      const double moved = 0.125 * (lacking[j] + lacking[j + 1]) * (before[j + 1] - before[j]);
      rows[j] += moved;
      rows[j + 1] -= moved;
    }
  }
  const double sum = rows.sum();
  rows = rows.max(0.0);
  return sum > 0.0 ? Eigen::ArrayXd(sum / rows.sum() * rows) : rows;
}

/// From a slip by central differences; returns the work of the rows.
Eigen::ArrayXd set_frictional_work(const ContactGrid& grid, const SurfaceField& traction,
                                   const TangentialField& slip, PointResult& point) {
  Eigen::ArrayXd rows = evened_out(pass_work(grid, traction, point.fields.slip),
                                   pass_work(grid, traction, slip).array());
  point.frictional_work = grid.dy * rows.sum();
  return rows;
}

}  // namespace

void set_works(const ContactGrid& grid, const PatchShape& shape, const TangentialField& rigid_slip,
               const TangentialField& extra_slip, bool half_spaces, PointResult& point) {
  const SurfaceField& u = point.fields.displacement;
  const SurfaceField traction = times_stretch(point.fields.traction, shape);
  const TangentialField slip{rigid_slip.x + slope_along(grid, u.x),
                             rigid_slip.y + slope_along(grid, u.y)};
  Eigen::ArrayXd rows = set_frictional_work(grid, traction, slip, point);
  point.creepage_work =
      power_balance(grid, traction, slip, point.creepage, 1.0, extra_slip).creepage;
  // Friction moves the pressure of unlike half-spaces, which then resists rolling.
  if (half_spaces && point.max_traction > 0.0)
    *point.creepage_work += grid.element_area() * traction.n.dot(slope_along(grid, u.n));
  if (shape.stretch.size() != 0)
    for (int j = 0; j < grid.ny; ++j) rows[j] /= shape.stretch[grid.index(0, j)];
  set_pass_work(grid, rows.matrix(), point);
}

void set_works(const ContactGrid& grid, const TangentialField& central_slip, PointResult& point) {
  const SurfaceField& traction = point.fields.traction;
  set_pass_work(grid, set_frictional_work(grid, traction, central_slip, point).matrix(), point);
}

double approach_of_ellipsoid(const ContactFields& fields) {
  const Eigen::ArrayXd weight = fields.traction.n.array().cube();
  return 7.0 / 6.0 * (weight * fields.displacement.n.array()).sum() / weight.sum();
}

namespace {

/// y of the wheel's and the rail's profile at y of the patch frame, mm.
std::array<double, 2> profile_places(const PatchGeometry& patch, const ContactPlace& place,
                                     double y) {
  const double axial = patch.axle_place({0.0, y, patch.wheel_under_load(y).value}).axial;
  // From the reference point on the rail to the field side and down on the track, then about the
  // origin of the profile back through the angle by which the rail stands inclined.
  const double outward = place.outward() * y, up = patch.rail().at(y).value;
  const double cosine = std::cos(place.contact_angle), sine = std::sin(place.contact_angle);
  const double field = cosine * outward - sine * up, down = -sine * outward - cosine * up;
  return {place.outward() * axial,
          place.y_rail + std::cos(place.rail_turn) * field + std::sin(place.rail_turn) * down};
}

ProfileRows profile_rows(const ChartedGeometry& geometry, const std::optional<ContactPlace>& place,
                         const ContactGrid& grid) {
  const ContactSurface& surface = geometry.geometry().surface;
  const PatchShape shape = geometry.shape(grid);
  ProfileRows rows{Field(grid.ny), Field(grid.ny), Field::Constant(grid.ny, grid.dy)};
  for (int j = 0; j < grid.ny; ++j) {
    const double y = geometry.lateral_place(grid.y(j));
    const auto [wheel, rail] =
        surface.profiles && place ? profile_places(*surface.profiles, *place, y) : std::array{y, y};
    rows.y_wheel[j] = wheel;
    rows.y_rail[j] = rail;
    if (shape.stretch.size() > 0) rows.width[j] *= shape.stretch[grid.index(0, j)];
  }
  return rows;
}

/// The row of the summit of the parabola through the largest value and its neighbours: also between
/// two equal ones.
double summit(const Field& values) {
  Eigen::Index top = 0;
  values.maxCoeff(&top);
  if (top == 0 || top + 1 == values.size()) return static_cast<double>(top);
  const double before = values[top - 1], behind = values[top + 1];
  const double bend = before - 2.0 * values[top] + behind;
  return static_cast<double>(top) + (bend < 0.0 ? 0.5 * (before - behind) / bend : 0.0);
}

/// A value between two rows.
double between(const Field& values, double row) {
  const auto below = static_cast<Eigen::Index>(row);
  if (below + 1 >= values.size()) return values[below];
  const double part = row - static_cast<double>(below);
  return (1.0 - part) * values[below] + part * values[below + 1];
}

}  // namespace

void place_pass_work(const ChartedGeometry& geometry, const std::optional<ContactPlace>& place,
                     ModelResult& result) {
  result.rows = profile_rows(geometry, place, result.grid);
  const double radius = place ? place->rolling_radius : geometry.geometry().surface.rolling_radius;
  for (PointResult& point : result.points) {
    const Field work = pass_work(result.grid, point);
    if (work.size() == 0) continue;
    // Slip of this size is what the iteration leaves.
    constexpr double no_slip = 1e-9;
    if (work.maxCoeff() > no_slip * point.max_traction * point.contact_length) {
      const double row = summit(work);
      point.pass_work_y_wheel = between(result.rows.y_wheel, row);
      point.pass_work_y_rail = between(result.rows.y_rail, row);
    }
    if (point.frictional_work && std::isfinite(radius) && !geometry.geometry().line)
      point.revolution_work = 1e-3 * *point.frictional_work * 2.0 * pi * radius;
  }
}

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
  double work = creepage.longitudinal * traction.x.sum() * area +
                creepage.lateral * traction.y.sum() * area +
                creepage.spin * spin_moment(grid, traction);
  if (extra_slip.x.size() != 0 || extra_slip.y.size() != 0) {
    check_sizes(grid, {&extra_slip.x, &extra_slip.y}, "extra slip");
    work += (traction.x.dot(extra_slip.x) + traction.y.dot(extra_slip.y)) * area;
  }
  PowerBalance balance{speed * grid.dy * pass_work(grid, traction, slip).sum(), -speed * work};
  const double scale = std::max(std::abs(balance.friction), std::abs(balance.creepage));
  if (scale > 0.0) balance.difference = std::abs(balance.friction - balance.creepage) / scale;
  return balance;
}

bool found_for_force(const PointResult& point, const std::string& name) {
  const auto word = point.no_bar.find(name);
  if (word != point.no_bar.end())
    return word->second != NoBar::given && word->second != NoBar::balance;
  // Of a wheelset that rolls freely the spin has a bar, too.
  return point.has_bar(name) && !point.has_bar("spin");
}

}  // namespace rollfem::contact
