// The scenes of a case with profiles: one case for each patch of each wheel at each position, with
// the geometry in the frame of the patch, its load and its creepages, ready for any model.
#pragma once

#include "contact/case/case.hpp"
#include "meshes/track/contact_search.hpp"
#include "meshes/track/wheelset_motion.hpp"

#include <vector>

namespace rollfem::meshes {

/// `input` has patch, place, load.normal_force (or approach) and rolling.creepages; `contact` what
/// free rolling and the sharing of a load need.
struct Scene {
  contact::Case input;
  WheelRailContact contact;
};

/// What the search for contacts needs, with the profiles that the case names. Reads and smooths
/// their files: made once, and passed on.
SearchScene search_scene_of(const contact::Case& input);

/// Scenes in the order positions, left and right wheel, patches; near misses make none. The normal
/// force is that of vertical_force without friction for a wheel with one patch, and the estimate of
/// load_estimate.hpp where several share it: the caller corrects both with forces it has found.
/// Creepages that the case gives (Rolling::given) replace those of the motion.
/// Throws what find_contacts throws; contact::InputError when a normal force is given for a wheel
/// with several patches.
std::vector<Scene> make_scenes(const contact::Case& input, const SearchScene& scene,
                               const SearchOptions& options = {});

/// The same with the profiles that the case names.
std::vector<Scene> make_scenes(const contact::Case& input, const SearchOptions& options = {});

/// Relative changes of the rotation that the case gives, one for each load point; 0 where it gives
/// none.
std::vector<double> rotation_changes(const contact::Case& input);

/// Creepages of the scene at rotations of the wheelset other than those of the case (free rolling):
/// one for each load point, or one for all.
void set_rotation_changes(Scene& scene, const std::vector<double>& rotation_changes);

}  // namespace rollfem::meshes
