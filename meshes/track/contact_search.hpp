// Where the wheels of a placed wheelset touch their rails: height and roll of the wheelset, points
// of first contact, near misses, and which of them are one patch under the load (docs/track.md).
#pragma once

#include "contact/case/case.hpp"
#include "meshes/track/wheelset_pose.hpp"

#include <array>
#include <vector>

namespace rollfem::meshes {

/// One patch, or a near miss, of one wheel at one position. The reference point of a patch is the
/// mean place of the overlap of the undeformed bodies at its estimated approach, weighted by the
/// square of the depth over the area; that of a near miss is the point of least distance.
struct WheelRailContact {
  /// position, patch and patches count from 1; of a near miss patch is 0.
  contact::ContactPlace place;
  contact::PatchGeometry geometry;  ///< sunk vertically until this patch touches in one point
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
};

struct SearchOptions {
  double near_miss = 1.0;     ///< mm, largest separation along the normal that is still reported
  double merge_angle = 0.35;  ///< rad: patches that meet but whose normals differ more stay apart
};

/// Patches of a wheel under the load of the case, the most loaded first, then near misses, nearest
/// first. The height of `pose` is set to that at which this wheel touches; with a found roll it is
/// the same for both. Throws contact::SolveError when the wheel has left its rail,
/// contact::InputError when a profile ends where the bodies would touch or within a patch.
std::vector<WheelRailContact> find_contacts(const contact::Case& input, const SearchScene& scene,
                                            const WheelsetPose& pose, int position, bool left,
                                            const SearchOptions& options = {});

/// All contacts of the wheels that wheelset.side asks for at a position: left before right.
std::vector<WheelRailContact> find_contacts(const contact::Case& input, const SearchScene& scene,
                                            int position, const SearchOptions& options = {});

}  // namespace rollfem::meshes
