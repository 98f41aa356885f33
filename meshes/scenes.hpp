// The scenes of a case with profiles: one case for each patch of each wheel at each position, with
// the geometry in the frame of the patch, its load and its creepages, ready for any model.
#pragma once

#include "contact/case.hpp"
#include "meshes/contact_search.hpp"
#include "meshes/wheelset_motion.hpp"

#include <vector>

namespace rollfem::meshes {

/// `input` has patch, place, load.normal_force (or approach) and rolling.creepages; `contact` what
/// free rolling and the sharing of a load need.
struct Scene {
  contact::Case input;
  WheelRailContact contact;
};

/// Scenes in the order positions, left and right wheel, patches; near misses make none. The normal
/// force is that of vertical_force without friction for a wheel with one patch, and the estimate of
/// load_estimate.hpp where several share it: the caller corrects both with forces it has found
/// (set_normal_forces). Creepages that the case gives (Rolling::given) replace those of the motion.
/// Throws what find_contacts throws; contact::InputError when a normal force is given for a wheel
/// with several patches.
std::vector<Scene> make_scenes(const contact::Case& input, const SearchScene& scene,
                               const SearchOptions& options = {});

/// The same with the profiles that the case names.
std::vector<Scene> make_scenes(const contact::Case& input, const SearchOptions& options = {});

/// Creepages of the scene at a rotation of the wheelset other than that of the case (free rolling):
/// one change for all load points.
void set_rotation_change(Scene& scene, double rotation_change);

/// Normal forces of the load points from a vertical force and the lateral forces found at each.
void set_normal_forces(Scene& scene, double vertical, const std::vector<double>& lateral);

}  // namespace rollfem::meshes
