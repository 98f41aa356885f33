// SPDX-License-Identifier: LGPL-2.1-or-later
// Wheel and rail of a case as finite-element bodies: meshed by rollfem, or on the user's meshes.
#pragma once

#include "fem/discretisation/body.hpp"
#include "result/note.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rollfem::fem {

struct CaseBodies {
  std::unique_ptr<Body> wheel;  ///< null: rigid
  std::unique_ptr<Body> rail;
  double reach = 0.0;                ///< mm, from the patch to the nearer clamped boundary
  std::vector<contact::Note> notes;  ///< on rigid bodies and meshes not of the family `structured`

  BodyPair both() const { return {wheel.get(), rail.get()}; }
  /// Whether half of each body is modelled.
  bool half() const { return (!wheel || wheel->options().half) && (!rail || rail->options().half); }
};

/// Requested bodies.
struct MeshedBodies {
  bool wheel = true;
  bool rail = true;
};

/// Collective. Bodies that are not requested are null like rigid ones. Throws contact::InputError.
CaseBodies make_bodies(const contact::Scene& scene, const BodyOptions& options,
                       MPI_Comm communicator, const MeshedBodies& wanted = {});

}  // namespace rollfem::fem
