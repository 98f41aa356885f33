// SPDX-License-Identifier: LGPL-2.1-or-later
// A load that pressure and friction carry together, because it is not normal to the surface.
#pragma once

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rollfem::contact {

/// Part along the load (`direction`: y, z) of a pressure on a surface with this slope, before the
/// cosine of the slope. A surface parallel to the load carries almost none of it.
inline double carried_part(const std::array<double, 2>& direction, double climb) {
  constexpr double least = 0.05;
  return std::max(direction[1] - direction[0] * climb, least);
}

/// The force that the pressure carries is a fixed point: friction under this pressure leaves a
/// share of the load to the pressure. Found by the secant method: plain iteration is slow for
/// slopes near one and diverges for steep ones.
class PressureShare {
 public:
  double load = 0.0;       ///< N
  double tolerance = 0.0;  ///< of the share, relative to the load
  int most_turns = 40;
  /// Divergence limit: share over load.
  double largest_share = std::numeric_limits<double>::infinity();
  /// The first step assumes friction proportional to the pressure, as in full sliding; else
  /// friction that stays.
  bool sliding = false;
  /// Cleared by a turn whose patches have still to adapt to each other. Then the iteration goes on,
  /// with steps as the first one: a secant would take their adaption for an effect of the share.
  bool settled = true;

  /// `carry(share, turn)` solves for a pressure that carries `share`, and for friction under it; it
  /// returns the share that this friction leaves to the pressure. Throws SolveError if they do not
  /// converge.
  template <class Carry>
  void solve(double share, const Carry& carry) {
    for (int turn = 0; turn < most_turns && share <= largest_share * load; ++turn) {
      const double image = carry(share, turn);
      if (settled && std::abs(image - share) <= tolerance * load) return;
      const double together = load - image + share;  // carried by pressure and friction
      const bool slides = sliding && together > 0.0 && (turn == 0 || !settled);
      share = slides ? load * share / together : next(share, image);
    }
    throw SolveError(
        fmt::format("pressure and friction do not converge to carry {:g} N together in {} "
                    "iterations: friction on the tilted surface carries nearly all of the load or "
                    "more (Nadal's limit)",
                    load, most_turns));
  }

 private:
  double next(double share, double image) {
    const double change = image - share;
    double step = change;
    if (known_ && share != last_share_) {
      const double slope = (change - last_change_) / (share - last_share_);
      if (slope < 0.0) step = -change / slope;
    }
    known_ = true;
    last_share_ = share;
    last_change_ = change;
    // The solution is positive; steps below zero are shortened.
    return share + step > 0.0 ? share + step : 0.25 * share;
  }

  bool known_ = false;
  double last_share_ = 0.0;
  double last_change_ = 0.0;
};

}  // namespace rollfem::contact
