// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds the contacts of a placed wheelset with its rails: its height and roll, points of first
// contact, near misses, and which of them form one patch under load (docs/track.md).
#pragma once

#include "case/case.hpp"
#include "track/placement/wheelset_pose.hpp"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace rollfem::track {

/// One contact, or a near miss, of one wheel at one position. A contact holds all patches whose
/// normals differ little, wherever they are: one scene on one contact grid. Its reference point is
/// the mean position of the overlap of the undeformed bodies at the estimated approach, weighted by
/// the square of the depth over the area; its plane has the mean slope of the common surface there.
/// For a near miss they are the point of least distance and the tangent.
struct WheelRailContact {
  /// position, patch and patches count from 1; patch is 0 for a near miss.
  contact::ContactPlace place;
  contact::PatchGeometry geometry;  ///< sunk vertically until this patch touches in one point
  WheelsetPose pose;                ///< at first contact of the wheel
  /// Track frame, at first contact: the axle about which the wheel rolls, displaced with it, from
  /// its centre to the right; and the middle of the wheelset's axle, moved as far as the wheel.
  contact::Axle axle;
  contact::Vector3 middle{};
  /// Track frame: velocity at the origin over the forward speed, and rotation in rad/mm, of the
  /// wheel carried forward and by itself less those of its rail or roller (Displacement).
  contact::Vector3 own_velocity{}, own_turning{};
  contact::Vector3 origin{};  ///< contact reference point on the rail, track frame
  /// Approach along the normal at which the next hump overlaps, mm; infinite where the load reaches
  /// no other hump.
  double next_hump = std::numeric_limits<double>::infinity();
  /// A near miss with a separate plane that the load may reach if the estimate is too small.
  bool reserve = false;
  /// Directions of the patch frame in the track frame.
  contact::Vector3 along{}, across{}, normal{};
  /// Estimates (patch_groups.hpp) of the load's normal force and approach along the normal; 0 for
  /// a near miss.
  double normal_force = 0.0;  ///< N
  double approach = 0.0;      ///< mm
  /// Range of y in the patch frame over which the bodies overlap at this approach: contains all
  /// patches.
  std::array<double, 2> reach{};
  /// y of the patch frame beyond which another contact begins; infinite where there is none.
  std::array<double, 2> limits{};
  /// Standard deviation of the normals of the common surface over the overlap, rad, with the
  /// weights of the reference point.
  double spread_of_normals = 0.0;
  /// Lowest points within the overlap: y of the patch frame, separation along the normal.
  std::vector<std::array<double, 2>> touching;
};

struct SearchOptions {
  double near_miss = 1.0;  ///< mm, largest separation along the normal reported as a near miss
  /// rad: patches whose normals differ more are separate contacts. Default 0.35 (20 degrees, within
  /// which a plane changes the pressure by 2 %), or 0.8 where the case uses the local normals of a
  /// curved surface.
  std::optional<double> merge_angle;
  /// mm, to the field: shifts the reference to another point of the overlap, with the tangent of
  /// the common surface there; has no effect with local normals.
  double reference_offset = 0.0;
  /// mm: transforms wheel and rail into the frame of a contact only this far beyond the overlap of
  /// the bodies; infinite: as far as they are heights there.
  double around_overlap = std::numeric_limits<double>::infinity();
  /// Sinking of the wheel below first touch, or height of its pose, mm; either overrides the load
  /// of the case. A wheel that does not touch has near misses only.
  std::optional<double> sinking, height;
  bool with_reserve = false;  ///< also scenes of contacts that the load may reach (make_scenes)
};

/// Patches of a wheel under the load of the case, the most loaded first, then near misses, nearest
/// first. The height of `pose` is set to that at which this wheel touches; with a found roll it is
/// the same for both. Throws contact::SolveError when the wheel has left its rail,
/// contact::InputError when a profile ends where the bodies would touch or within a patch.
std::vector<WheelRailContact> find_contacts(const contact::Case& input, const SearchScene& scene,
                                            const WheelsetPose& pose, int position, bool left,
                                            const SearchOptions& options = {});

/// All contacts of the wheels selected by wheelset.side at a position: left before right.
std::vector<WheelRailContact> find_contacts(const contact::Case& input, const SearchScene& scene,
                                            int position, const SearchOptions& options = {});

}  // namespace rollfem::track
