// SPDX-License-Identifier: LGPL-2.1-or-later
// What the driver does where friction falls so steeply that load points have several states or
// none: warns, before and after, and leaves those empty that have none.
#include "contact/iteration/friction_newton.hpp"
#include "contact/solve/contact_run.hpp"
#include "result/quantities.hpp"

#include <fmt/format.h>

#include <utility>

namespace rollfem::contact {

void warn_of_steep_friction(const LevelResult& level, const Friction& friction,
                            std::vector<Note>& notes) {
  if (level.steepness <= 1.0 && level.several == 0) return;
  const std::string found = level.several == 0
                                ? std::string("several states are possible")
                                : fmt::format("there are several states at {} of {} load points",
                                              level.several, level.points.size());
  const bool steps = !level.points.empty() && level.points.front().step > 0;
  const SteepCause steep = steep_cause(*friction, level.steepness, steps ? 0.0 : level.grid.dx);
  add_warning(
      notes, "steep_friction",
      "{} ({:.2g} times what one element withstands) that {}, which depend on the grid: "
      "the result is the one chosen by friction.branch; for one alone: {} (docs/friction.md)",
      steep.cause, level.steepness, found, steep.cure);
}

/// Before load points are solved that may take minutes each.
void ContactRun::warn_if_steep() const {
  if (!friction_ || !friction_->feels_slip() || scene_.problem != Problem::steady) return;
  const double way = result_.grid.dx;
  const double gain =
      steepness(*friction_, result_.pressure.maxCoeff(),
                elasticity_->standin().rolling(scene_.upwind_order).diagonal(), way);
  if (gain <= 1.0) return;
  const SteepCause steep = steep_cause(*friction_, gain, way);
  ProgressEvent event;
  event.note = fmt::format(
      "{} ({:.2g} times what one element withstands) that there may be several states or "
      "none, and a load point may take minutes; do: {}",
      steep.cause, gain, steep.cure);
  event.warns = true;
  tell(event, "friction", true);
}

/// False if no load point is left that has a solution.
bool ContactRun::leave_unsolved(std::size_t k, const NoSteadyFriction& error) {
  result_.unsolved.emplace(k, error.what());
  if (!options_.leaves_unsolved || scene_.is_history() ||
      result_.unsolved.size() == scene_.points.size())
    return false;
  PointResult point;
  motion_->describe(k, motion_->given_unknowns(k), point);
  leave_empty(point);
  result_.points.push_back(std::move(point));
  result_.relative_traction.emplace_back();
  return true;
}

}  // namespace rollfem::contact
