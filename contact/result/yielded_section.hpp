// SPDX-License-Identifier: LGPL-2.1-or-later
// What one pass of a load leaves in a body that yields: the section behind the load, and what
// becomes of it with further passes.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Streamlines of the section in order of depth, then y (`y` fastest); tensors are xx yy zz xy yz
/// xz, x along rolling, in the section's own axes.
struct YieldedSection {
  std::string body;              ///< "wheel", "rail"
  std::string verdict;           ///< a word of yield_verdicts
  int cycle = 1;                 ///< load points of a cycle, the last whole one of which is judged
  int from_pass = 0;             ///< the verdict has held since this pass
  int iterations = 0;            ///< of the pass
  double residual = 0.0;         ///< out-of-balance forces relative to those of plastic strain
  double increment = 0.0;        ///< largest increase of the accumulated plastic strain
  double net_increment = 0.0;    ///< largest change of plastic strain, sqrt(2/3) |d eps_p|
  double cycle_increment = 0.0;  ///< the same of the cycle that is judged
  double cycle_net_increment = 0.0;  ///< the same
  double plastic_strain = 0.0;       ///< largest accumulated
  double plastic_work = 0.0;         ///< N mm per mm of track
  double utilisation = 0.0;  ///< largest von Mises stress over the yield surface, during the pass
  int across = 0, down = 0;  ///< streamlines
  std::vector<double> y, depth;              ///< mm, of each
  std::vector<std::array<float, 6>> strain;  ///< plastic
  std::vector<std::array<float, 6>> stress;  ///< MPa, residual
  std::vector<float> accumulated;            ///< plastic strain
  std::vector<double> surface_y;             ///< mm, from one side of the patch to the other
  std::vector<double> groove;  ///< mm, plastic displacement out of the body there, negative in
  std::string memory;          ///< of the body, for checkpoints: what the next pass starts from
  std::vector<double> forward_flow;  ///< mm, along +x
};

/// Numbers of the pass as a whole, by name.
inline std::array<std::pair<const char*, double>, 8> scalars_of(const YieldedSection& section) {
  return {{{"increment", section.increment},
           {"net_increment", section.net_increment},
           {"cycle_increment", section.cycle_increment},
           {"cycle_net_increment", section.cycle_net_increment},
           {"plastic_strain", section.plastic_strain},
           {"plastic_work", section.plastic_work},
           {"utilisation", section.utilisation},
           {"residual", section.residual}}};
}

/// How a body takes the passes, or cycles of several load points: it does not yield; it yields no
/// more (elastic shakedown); the same closed cycle again and again (plastic shakedown: what lasts
/// falls so fast that all further cycles together leave at most 5 % of the strain of one); strain
/// grows with every cycle, about as much (ratchetting); it still changes from cycle to cycle.
inline constexpr std::array<const char*, 5> yield_verdicts{
    "elastic", "elastic shakedown", "plastic shakedown", "ratchetting", "settling"};

}  // namespace rollfem::contact
