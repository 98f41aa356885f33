// SPDX-License-Identifier: LGPL-2.1-or-later
// Height and roll of a wheelset on its rails; rejects wheels that have left their rails.
#pragma once

#include "case/case.hpp"
#include "track/placement/placement.hpp"
#include "track/placement/vertical_gap.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace rollfem::track {

/// The case's file as messages name it; "case" for one that was read from none.
std::string file_of(const contact::Case& input);

/// Input of a search besides the case: profiles, and the position of the rail that follows from
/// them.
struct SearchScene {
  ProfilePair profiles;
  double tread_y = 0.0;  ///< mm, of a place on the tread in the wheel's profile coordinates
  WheelPoints wheel;
  /// The rail of one side, in its side frame.
  struct Rail {
    RailPlace place;
    profiles::ProfileCurve curve;
    contact::HeightCurve head;  ///< the same as a height over y
    /// If it changes along the track, or is a roller under a wheel that is not round.
    std::shared_ptr<const profiles::SectionSurface> surface;
  };
  std::array<Rail, 2> rails;  ///< left, right
  const Rail& rail(bool left) const { return rails[left ? 0 : 1]; }
  /// Whether wheel or rail changes along its way.
  bool varies() const { return rails[0].surface || profiles.wheel_sections; }
  /// Gauge face of the head that carries the wheel, as track.gauge_face gives it; none where the
  /// rails are not placed by the gauge.
  std::optional<double> gauge_face;
  /// The wheel's profile about that place as a height over y; empty where it is too steep.
  contact::HeightCurve wheel_tread;
};

/// Throws contact::InputError when the rail's profile does not fit the track.
SearchScene make_search_scene(const contact::Case& input, ProfilePair profiles);

/// Pose of the wheelset for a position (1, 2, ...) without its height: lateral shift, yaw, and roll
/// as given or as found, such that the rigid wheels touch both rails. Throws contact::SolveError
/// when a wheel is not above its rail or there is no such roll.
WheelsetPose find_pose(const contact::Case& input, const SearchScene& scene, int position);

/// Wheel and rail of a position, of which one changes along its way; `axle` in the side frame.
std::shared_ptr<const BodiesAlongWay> bodies_along_way(const contact::Case& input,
                                                       const SearchScene& scene,
                                                       const contact::Axle& axle, int position,
                                                       bool left);

/// Lowers the pose until this wheel touches, and returns the gap under it. Throws
/// contact::SolveError when the wheel stands on the tip of its flange, contact::InputError when it
/// stands on the end of a profile.
VerticalGap touching_gap(const contact::Case& input, const SearchScene& scene, WheelsetPose& pose,
                         int position, bool left);

/// Rejects contact at an end of the known profiles, with `what` in the message.
[[noreturn]] void fail_at_end(const contact::Case& input, const VerticalGap& gap, bool inner,
                              int position, bool left, const std::string& what);
/// A patch that reaches the place along the track where a head of the rail begins or ends.
[[noreturn]] void fail_where_head_ends(const contact::Case& input, int position, bool left);

}  // namespace rollfem::track
