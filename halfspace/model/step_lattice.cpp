// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/model/step_lattice.hpp"

#include "halfspace/elasticity/halfspace_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rollfem::halfspace {

using contact::ContactGrid;
using contact::Field;
using contact::PastPatch;
using contact::PastPatches;
using contact::Scene;
using contact::SurfaceField;
using contact::TangentialField;

namespace {

/// Whole columns and rows from the first element of one grid to that of another on its lattice.
struct Offset {
  int columns, rows;
};

Offset offset_of(const ContactGrid& part, const ContactGrid& whole) {
  return {static_cast<int>(std::lround((part.x_first - whole.x_first) / whole.dx)),
          static_cast<int>(std::lround((part.y_first - whole.y_first) / whole.dy))};
}

/// `nx` by `ny` elements of the lattice of a grid, from a column and a row of it on.
ContactGrid part_of(const ContactGrid& grid, Offset from, int nx, int ny) {
  return {nx, ny, grid.dx, grid.dy, grid.x(from.columns), grid.y(from.rows), grid.line_reference};
}

/// Copies values to the elements that two grids of one lattice share.
void copy(const ContactGrid& from, const Field& values, const ContactGrid& to, Field& result) {
  if (values.size() != from.size()) return;
  const Offset offset = offset_of(from, to);
  for (int j = std::max(0, -offset.rows); j < std::min(from.ny, to.ny - offset.rows); ++j)
    for (int i = std::max(0, -offset.columns); i < std::min(from.nx, to.nx - offset.columns); ++i)
      result[to.index(i + offset.columns, j + offset.rows)] = values[from.index(i, j)];
}

/// The grid with all elements of the patches.
ContactGrid enclosing(const ContactGrid& grid, const PastPatches& patches) {
  Offset lower{0, 0}, upper{grid.nx, grid.ny};
  for (const PastPatch& patch : patches) {
    const Offset offset = offset_of(patch.grid, grid);
    lower = {std::min(lower.columns, offset.columns), std::min(lower.rows, offset.rows)};
    upper = {std::max(upper.columns, offset.columns + patch.grid.nx),
             std::max(upper.rows, offset.rows + patch.grid.ny)};
  }
  return part_of(grid, lower, upper.columns - lower.columns, upper.rows - lower.rows);
}

/// The tangential displacements of half-spaces by tractions that patches have left.
class LeftTractions {
 public:
  LeftTractions(const Scene& scene, const ContactGrid& grid, const contact::PastLevel& past)
      : couples_(scene.material.couples()), grid_(grid) {
    if (past.last.empty() && past.before_last.empty()) return;
    compliance_.emplace(enclosing(enclosing(grid, past.last), past.before_last), scene.material);
  }

  TangentialField displacement(const PastPatches& patches) const {
    const Field none = Field::Zero(grid_.size());
    TangentialField found{none, none};
    if (patches.empty()) return found;
    const ContactGrid& whole = compliance_->grid();
    const Field zero = Field::Zero(whole.size());
    SurfaceField traction{zero, zero, zero};
    for (const PastPatch& patch : patches)
      for (Field SurfaceField::*part : {&SurfaceField::x, &SurfaceField::y, &SurfaceField::n})
        copy(patch.grid, patch.traction.*part, whole, traction.*part);
    TangentialField all;
    if (couples_) {
      SurfaceField moved = compliance_->apply(traction);
      all = {std::move(moved.x), std::move(moved.y)};
    } else {
      all = compliance_->shift().apply({traction.x, traction.y});
    }
    copy(whole, all.x, grid_, found.x);
    copy(whole, all.y, grid_, found.y);
    return found;
  }

 private:
  bool couples_;
  const ContactGrid& grid_;
  std::optional<HalfspaceCompliance> compliance_;
};

}  // namespace

Scene on_lattice(const Scene& scene, const contact::PastLevel& level) {
  Scene own = scene;
  auto past = std::make_shared<contact::StepPast>(*scene.past);
  past->levels = {level};
  own.contact_grid.cell_size = past->levels.front().cell;
  own.contact_grid.middle = past->levels.front().middle;
  own.past = std::move(past);
  return own;
}

contact::History inherited_on(const Scene& scene, const contact::ChartedGeometry& geometry,
                              const ContactGrid& grid) {
  const contact::PastLevel& past = scene.past->levels.front();
  contact::FrictionPast after;
  const contact::Friction law = contact::friction_on(scene, geometry);
  if (law && (law->memory() || law->plasticity)) {
    after = contact::friction_after(law, grid);
    for (const PastPatch& patch : past.last) {
      copy(patch.grid, patch.coefficient, grid, after.coefficient);
      copy(patch.grid, patch.plastic, grid, after.plastic);
    }
  }
  const LeftTractions left(scene, grid, past);
  contact::History history(grid, scene.upwind_order);
  history.inherit(left.displacement(past.last), left.displacement(past.before_last), past.lengths,
                  std::move(after));
  return history;
}

PastPatch left_by(const contact::LevelResult& solved) {
  const ContactGrid& grid = solved.grid;
  const contact::ContactFields& fields = solved.points.back().fields;
  const Field& plastic = solved.after.plastic;
  Offset lower{grid.nx, grid.ny}, upper{0, 0};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int k = grid.index(i, j);
      if (!(fields.traction.n[k] > 0.0) && !(plastic.size() > 0 && plastic[k] != 0.0)) continue;
      lower = {std::min(lower.columns, i), std::min(lower.rows, j)};
      upper = {std::max(upper.columns, i + 1), std::max(upper.rows, j + 1)};
    }
  if (upper.columns == 0) return {};
  PastPatch left;
  left.grid = part_of(grid, lower, upper.columns - lower.columns, upper.rows - lower.rows);
  const auto cut = [&](const Field& values, Field& part) {
    if (values.size() != grid.size()) return;
    part.resize(left.grid.size());
    copy(grid, values, left.grid, part);
  };
  cut(fields.traction.x, left.traction.x);
  cut(fields.traction.y, left.traction.y);
  cut(fields.traction.n, left.traction.n);
  cut(solved.after.coefficient, left.coefficient);
  cut(plastic, left.plastic);
  cut(solved.heat.wheel, left.heat_wheel);
  cut(solved.heat.rail, left.heat_rail);
  return left;
}

}  // namespace rollfem::halfspace
