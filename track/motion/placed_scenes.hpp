// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of a case with profiles: one for each patch of each wheel at each position, with the
// geometry in the frame of the patch, its load and its creepages, ready for any model.
#pragma once

#include "scene/scene.hpp"
#include "track/motion/wheelset_motion.hpp"
#include "track/search/contact_search.hpp"

#include <vector>

namespace rollfem::track {

/// A patch ready to be solved, with the data for free rolling and load sharing.
struct PlacedScene {
  contact::Scene scene;
  WheelRailContact contact;
};

/// The case's profiles.
ProfilePair profiles_of(const contact::Case& input);
/// A body that changes along its way has the section of the first position.
void take_first_sections(const contact::Case& input, ProfilePair& pair);

/// Input of the contact search, with the case's profiles. Reads and smooths the profile files, so
/// create it once and pass it on.
SearchScene search_scene_of(const contact::Case& input);

/// The case at one position, counted from 0: of a wheel's history the step there alone, with the
/// velocities of its motion; otherwise the case itself.
contact::Case case_at(const contact::Case& input, std::size_t position);

/// Scenes in the order positions, left and right wheel, patches; near misses have no scene. A
/// vertical force is the load of a wheel with one patch, along the vertical; where several patches
/// share it, each has the estimate of patch_groups.hpp, which the caller corrects. Creepages given
/// by the case (Rolling::given) replace those of the motion. Throws as find_contacts, and
/// contact::InputError when a normal force is given for a wheel with several patches.
std::vector<PlacedScene> make_scenes(const contact::Case& input, const SearchScene& scene,
                                     const SearchOptions& options = {});

/// Those of one position (1, 2, ...); `here`: case_at.
std::vector<PlacedScene> scenes_at(const contact::Case& here, const SearchScene& scene,
                                   int position, const SearchOptions& options = {});

/// The contact of one of these scenes after their balance.
const WheelRailContact& contact_of(const contact::Scene& scene,
                                   const std::vector<PlacedScene>& placed);

/// The same with the profiles that the case names.
std::vector<PlacedScene> make_scenes(const contact::Case& input, const SearchOptions& options = {});

/// Fraction to which the surface of the half-space follows the bodies (contact::Scene) for normals
/// with this standard deviation, rad.
double follows_surface(double spread_of_normals);

/// Relative changes of the rotation given by the case, one for each load point; default 0.
std::vector<double> rotation_changes(const contact::Case& input);

/// Creepages of the scene at rotations of the wheelset other than those of the case (free rolling):
/// one for each load point.
void set_rotation_changes(PlacedScene& scene, const contact::Case& input,
                          const std::vector<double>& rotation_changes);

/// Lateral position on the track (mm) of y (mm) in the patch frame.
double track_y(const contact::ContactPlace& place, double y);

}  // namespace rollfem::track
