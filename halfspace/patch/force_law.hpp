// The force carried by one contact of a wheel at a given approach, without friction;
// used to share the load among the contacts of a wheel.
#pragma once

#include "contact/scene/scene.hpp"
#include "contact/solve/compliance.hpp"
#include "contact/solve/standin.hpp"

#include <memory>
#include <vector>

namespace rollfem::halfspace {

/// Force of the pressure of a scene with profiles on one grid that holds every patch up to a
/// largest approach: one continuous function of the approach, good to some 0.5 % there and less at
/// a small part of it.
class ForceLaw {
 public:
  /// The scene must outlive this. `direction`: y and z of the patch frame, that along which the
  /// wheel sinks. Throws as expected_patch does. `largest_approach` in mm along z.
  ForceLaw(const contact::Scene& scene, const std::array<double, 2>& direction,
           double largest_approach);

  /// Presses at an approach; `beside`: what loads the surface beside the contact.
  void press(double approach, const std::vector<contact::LoadBeside>& beside);

  double normal_force() const { return force_[1]; }   ///< N, along z; 0 where nothing touches
  double lateral_force() const { return force_[0]; }  ///< N, along y: not 0 on a curved surface

  /// The pressure as point loads, each that of a block of elements.
  std::vector<contact::LoadBeside> point_loads() const;

 private:
  contact::CombinedMaterial material_;
  std::unique_ptr<const contact::SolvableCompliance> compliance_;
  contact::PatchShape shape_;
  contact::CoupledProblem problem_;
  contact::Field distance_;
  contact::Field pressure_;  ///< of the last approach
  std::array<double, 2> force_{};
};

}  // namespace rollfem::halfspace
