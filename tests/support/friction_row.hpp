// SPDX-License-Identifier: LGPL-2.1-or-later
// One row of elements in contact, for tests of friction along it.
#pragma once

#include "contact/iteration/friction_state.hpp"

#include "support/test.hpp"
#include <memory>
#include <numeric>

namespace rollfem::testing {

template <class Law>
contact::Friction shared(const Law& law) {
  return std::make_shared<const Law>(law);
}

/// In contact at x in (0, 1): its pressure rises as p_0 sqrt(1 - x) from the leading edge.
struct FrictionRow {
  explicit FrictionRow(int elements, double highest = 1.0) {
    grid.nx = elements + 4;
    grid.ny = 1;
    grid.dx = 1.0 / elements;
    grid.dy = 1.0;
    grid.x_first = -1.5 * grid.dx;
    pressure = contact::Field::Zero(grid.nx);
    places.resize(static_cast<std::size_t>(elements));
    std::iota(places.begin(), places.end(), 2);
    for (Eigen::Index e = 0; e < count(); ++e) pressure[place(e)] = highest * std::sqrt(1.0 - x(e));
    still.rigid_slip = {contact::Field::Zero(grid.nx), contact::Field::Zero(grid.nx)};
  }

  Eigen::Index count() const { return static_cast<Eigen::Index>(places.size()); }
  Eigen::Index place(Eigen::Index e) const { return places[static_cast<std::size_t>(e)]; }
  double x(Eigen::Index e) const { return grid.x(static_cast<int>(place(e))); }

  /// |w| = 0.6 and 0.8 of `size` along x and y.
  template <class Size>
  Eigen::VectorXd slip(const Size& size) const {
    Eigen::VectorXd values(2 * count());
    for (Eigen::Index e = 0; e < count(); ++e) {
      values[e] = 0.6 * size(x(e));
      values[count() + e] = -0.8 * size(x(e));
    }
    return values;
  }

  /// Surfaces at rest: slips are given directly.
  contact::TangentialMotion motion(double slip_factor,
                                   const std::optional<contact::FrictionPast>& past = {}) const {
    return {still.rigid_slip, contact::Motion::rolling, slip_factor, 1.0, past};
  }

  /// Bounds under these slips.
  Eigen::VectorXd bound(contact::FrictionState& state, const Eigen::VectorXd& slip) const {
    Eigen::VectorXd found(count());
    state.set_bound(slip, slip, found);
    return found;
  }

  contact::ContactGrid grid;
  contact::Field pressure;
  std::vector<Eigen::Index> places;
  contact::TangentialMotion still;
};

}  // namespace rollfem::testing
