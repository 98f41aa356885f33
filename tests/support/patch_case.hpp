// SPDX-License-Identifier: LGPL-2.1-or-later
// A case with the geometry of one patch set by hand, for tests of single patches; for true profiles
// on a track the program gets a contact::Scene from track/motion.
#pragma once

#include "scene/scene.hpp"

#include "support/test.hpp"

namespace rollfem::testing {

struct PatchCase : contact::Case {
  PatchCase() = default;
  PatchCase(const contact::Case& input) : contact::Case(input) {}  // NOLINT: as good as a case

  std::shared_ptr<const contact::PatchGeometry> patch;
  std::optional<contact::ContactPlace> place;
  std::vector<double> normal_forces;  ///< N, of each load point; empty: that of the case

  /// Input of the models.
  operator contact::Scene() const {  // NOLINT(google-explicit-constructor)
    contact::Scene scene(static_cast<const contact::Case&>(*this));
    if (patch) scene.geometry.surface = contact::ContactSurface::of(patch);
    scene.place = place;
    for (std::size_t k = 0; k < normal_forces.size(); ++k)
      scene.points.at(k).load = {normal_forces[k], {}};
    return scene;
  }
};

}  // namespace rollfem::testing
