// Where the wheels of a placed wheelset touch their rails: height and roll of the wheelset, points
// of first contact, near misses, and which of them are one patch under the load.
#pragma once

#include "contact/case.hpp"
#include "meshes/placement.hpp"
#include "meshes/vertical_gap.hpp"

#include <array>
#include <vector>

namespace rollfem::meshes {

/// One patch, or a near miss, of one wheel at one position.
struct WheelRailContact {
  /// position, patch and patches count from 1; of a near miss patch is 0.
  contact::ContactPlace place;
  contact::PatchGeometry geometry;  ///< touching at the origin: sunk by the gap of this patch
  WheelsetPose pose;                ///< at first contact of the wheel
  contact::Axle axle;               ///< track frame, at first contact; direction to the right
  contact::Vector3 origin{};        ///< contact reference point on the rail, track frame
  /// Directions of the patch frame in the track frame.
  contact::Vector3 along{}, across{}, normal{};
  /// Estimates (load_estimate.hpp) of the load's normal force and approach along the normal; 0 for
  /// a near miss.
  double normal_force = 0.0;  ///< N
  double approach = 0.0;      ///< mm
  /// y of the patch frame between which the bodies overlap at this approach: holds the patch.
  std::array<double, 2> reach{};
  /// y of the patch frame beyond which another patch begins; infinite where there is none.
  std::array<double, 2> limits{};
  /// Points of first contact that went into it: y of the patch frame, separation along the normal.
  std::vector<std::array<double, 2>> touching;

  /// Approach along the normal when the wheel sinks vertically by `sinking` (mm) from its first
  /// contact: the patches of one wheel share one sinking. Negative: no contact.
  double approach_at(double sinking) const;
};

struct SearchOptions {
  double near_miss = 1.0;     ///< mm, largest separation along the normal that is still reported
  double merge_angle = 0.35;  ///< rad: patches that meet but whose normals differ more stay apart
};

/// What a search needs beside the case: profiles, and the rail's place that follows from them.
struct SearchScene {
  ProfilePair profiles;
  RailPlace rail_place;
  ProfileCurve rail;  ///< placed, side frame
};

/// Throws contact::InputError when the rail's profile does not fit the track.
SearchScene make_search_scene(const contact::Case& input, ProfilePair profiles);

/// Pose of the wheelset for a position (1, 2, ...). Without wheelset.roll both rails are touched
/// (rigid bodies, which roll and height follow from); with a given roll the height is that at which
/// this wheel touches, whatever the other does. Throws contact::SolveError when a wheel is not
/// above its rail, contact::InputError when a profile ends where they would touch.
WheelsetPose find_pose(const contact::Case& input, const SearchScene& scene, int position,
                       bool left);

/// Patches of a wheel under the load of the case, the most loaded first, then near misses, nearest
/// first. Throws as find_pose, and contact::InputError when a profile ends within a patch.
std::vector<WheelRailContact> find_contacts(const contact::Case& input, const SearchScene& scene,
                                            int position, bool left,
                                            const SearchOptions& options = {});

}  // namespace rollfem::meshes
