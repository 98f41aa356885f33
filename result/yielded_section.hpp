// SPDX-License-Identifier: LGPL-2.1-or-later
// What one pass of a load leaves in a body that yields: the section behind the load, and what
// becomes of it with further passes. A step of a body that is pressed, not rolled over, has the
// same: its section is below the middle of the contact, its verdict that of the step.
#pragma once

#include "base/members.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rollfem::contact {

/// How a body responds to the passes, or to cycles of several load points.
enum class YieldVerdict {
  elastic,            ///< it does not yield
  elastic_shakedown,  ///< it yields no more
  plastic_shakedown,  ///< the same closed cycle again and again: the lasting strain falls so fast
                      ///< that all further cycles together leave at most 5 % of the strain of one
  ratchetting,        ///< strain grows with every cycle, about as much
  settling,           ///< it still changes from cycle to cycle
  yields,             ///< when pressed: more in this step
  holds,              ///< when pressed: not in this step
  beyond_shakedown,   ///< it yields by the same strain in every cycle, of which what lasts still
                      ///< falls
};

constexpr const char* word_of(YieldVerdict verdict) {
  constexpr std::array<const char*, 8> words{
      "elastic", "elastic shakedown",  "plastic shakedown", "ratchetting", "settling",
      "yields",  "nothing new yields", "beyond shakedown"};
  return words[static_cast<std::size_t>(verdict)];
}

/// How sure a verdict is, by the same passes on cells of twice the size.
enum class YieldEvidence {
  one_mesh,      ///< no second mesh to compare
  both_meshes,   ///< the same verdict, and about the same strain
  not_resolved,  ///< the strain of the verdict depends on the mesh
  meshes_differ  ///< another verdict there
};

constexpr const char* word_of(YieldEvidence evidence) {
  constexpr std::array<const char*, 4> words{"one mesh", "both meshes", "not resolved",
                                             "meshes differ"};
  return words[static_cast<std::size_t>(evidence)];
}

/// Streamlines of the section in order of depth, then y (`y` fastest); tensors are xx yy zz xy yz
/// xz, x along rolling, in the section's own axes.
struct YieldedSection {
  std::string body;
  YieldVerdict verdict = YieldVerdict::settling;
  YieldEvidence evidence = YieldEvidence::one_mesh;
  std::string finding;
  double shakedown_load = 0.0, elastic_shakedown_load = 0.0;
  int from_pass = 0, iterations = 0, cycle = 1;
  double increment = 0.0, net_increment = 0.0, cycle_increment = 0.0, cycle_net_increment = 0.0;
  double plastic_strain = 0.0, plastic_work = 0.0, utilisation = 0.0, residual = 0.0;
  int across = 0, down = 0;
  std::vector<double> y, depth;
  std::vector<std::array<float, 6>> strain, stress;
  std::vector<float> accumulated;
  std::vector<double> surface_y, groove, forward_flow;

  static constexpr Listed listed = Listed::by_first;
  static constexpr auto members() {
    using S = YieldedSection;
    return std::tuple(
        member("body", &S::body, "", "wheel or rail"),
        member("verdict", &S::verdict, "", "response to the passes"),
        member("evidence", &S::evidence, "",
               "how sure the verdict is: both meshes, not resolved, meshes differ, one mesh"),
        member("finding", &S::finding, "", "verdict with its evidence, in words"),
        member("shakedown_load", &S::shakedown_load, "-",
               "load of the pass over the limit of shakedown of steel that does not harden"),
        member("elastic_shakedown_load", &S::elastic_shakedown_load, "-",
               "the same for the largest pressure of elastic bodies"),
        member("from_pass", &S::from_pass, "-", "the verdict has held since this pass"),
        member("iterations", &S::iterations, "-", "of the pass"),
        member("cycle", &S::cycle, "-",
               "load points of a cycle, the last whole one of which is judged"),
        member("increment", &S::increment, "-",
               "largest increase of the accumulated plastic strain"),
        member("net_increment", &S::net_increment, "-",
               "largest change of plastic strain, sqrt(2/3) |d eps_p|"),
        member("cycle_increment", &S::cycle_increment, "-",
               "increment of the cycle that is judged"),
        member("cycle_net_increment", &S::cycle_net_increment, "-", "the same of net_increment"),
        member("plastic_strain", &S::plastic_strain, "-", "largest accumulated plastic strain"),
        member("plastic_work", &S::plastic_work, "N",
               "N mm per mm of track; of a step of a pressed body N mm"),
        member("utilisation", &S::utilisation, "-",
               "largest von Mises stress over the yield surface, during the pass"),
        member("residual", &S::residual, "-",
               "out-of-balance forces relative to those of plastic strain"),
        member("across", &S::across, "-", "streamlines across"),
        member("down", &S::down, "-", "streamlines down"),
        member("y", &S::y, "mm", "of the streamlines"),
        member("depth", &S::depth, "mm", "of the streamlines, below the surface"),
        member("strain", &S::strain, "-",
               "plastic strain xx, yy, zz, xy, yz, xz (tensor components), x along rolling"),
        member("stress", &S::stress, "MPa",
               "residual stress xx, yy, zz, xy, yz, xz; tension positive"),
        member("accumulated", &S::accumulated, "-", "accumulated plastic strain"),
        member("surface_y", &S::surface_y, "mm", "of groove and forward_flow"),
        member("groove", &S::groove, "mm",
               "plastic displacement of the surface, negative into the body"),
        member("forward_flow", &S::forward_flow, "mm",
               "plastic displacement of the surface along rolling; of a pressed body empty"));
  }
};

}  // namespace rollfem::contact
