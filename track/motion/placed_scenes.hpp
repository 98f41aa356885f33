// SPDX-License-Identifier: LGPL-2.1-or-later
// The scenes of a case with profiles: one for each patch of each wheel at each position, with the
// geometry in the frame of the patch, its load and its creepages, ready for any model.
#pragma once

#include "contact/scene/scene.hpp"
#include "track/motion/wheelset_motion.hpp"
#include "track/search/contact_search.hpp"

#include <vector>

namespace rollfem::track {

/// A patch ready to be solved, and what free rolling and the sharing of a load need to know of it.
struct PlacedScene {
  contact::Scene scene;
  WheelRailContact contact;
};

/// What the search for contacts needs, with the profiles that the case names. Reads and smooths
/// their files: made once, and passed on.
SearchScene search_scene_of(const contact::Case& input);

/// Scenes in the order positions, left and right wheel, patches; near misses make none. A vertical
/// force is the load of a wheel with one patch, along the vertical; where several share it each has
/// the estimate of load_estimate.hpp, which the caller corrects. Creepages that the case gives
/// (Rolling::given) replace those of the motion. Throws what find_contacts throws;
/// contact::InputError when a normal force is given for a wheel with several patches.
std::vector<PlacedScene> make_scenes(const contact::Case& input, const SearchScene& scene,
                                     const SearchOptions& options = {});

/// The same with the profiles that the case names.
std::vector<PlacedScene> make_scenes(const contact::Case& input, const SearchOptions& options = {});

/// How far the surface of a half-space follows that of the bodies (contact::Scene) where the
/// normals of a contact differ by this standard deviation, rad.
double follows_surface(double spread_of_normals);

/// Relative changes of the rotation that the case gives, one for each load point; 0 where it gives
/// none.
std::vector<double> rotation_changes(const contact::Case& input);

/// Creepages of the scene at rotations of the wheelset other than those of the case (free rolling):
/// one for each load point.
void set_rotation_changes(PlacedScene& scene, const contact::Case& input,
                          const std::vector<double>& rotation_changes);

/// Where a place y (mm) of the patch frame is across the track, mm.
double track_y(const contact::ContactPlace& place, double y);

/// The vertical in the frame of the patch, upwards on the wheel: NormalLoad::direction of a
/// vertical force.
std::array<double, 2> upwards(const contact::ContactPlace& place);

}  // namespace rollfem::track
