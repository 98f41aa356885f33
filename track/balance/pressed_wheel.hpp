// SPDX-License-Identifier: LGPL-2.1-or-later
// One wheel pressed on its rail without friction: its contacts, and their creep forces under fixed
// normal forces. Used to fill tables over lateral shifts.
#pragma once

#include "case/case.hpp"
#include "result/result.hpp"
#include "track/motion/placed_scenes.hpp"

#include <optional>
#include <vector>

namespace rollfem::track {

/// The main contact is the most loaded one.
struct PressedState {
  contact::ContactPlace place;    ///< of the main contact
  int contacts = 1;               ///< in separate planes; each may hold several patches
  double normal_force = 0.0;      ///< N, of all contacts, each along its own normal
  double lateral_pressure = 0.0;  ///< N, force of the main contact's pressure along its y
  /// mm, half extents along x and y that carry the load of the main contact: the semi-axes of an
  /// ellipse under Hertz's pressure (ExpectedPatch::carrying_length).
  double semi_axis_x = 0.0, semi_axis_y = 0.0;
  double max_pressure = 0.0;  ///< MPa
  double contact_area = 0.0;  ///< mm^2, of all contacts
};

/// Force of friction on the wheel in the frame of the main contact, and its moment about the normal
/// through the main reference point.
struct FrictionForce {
  double longitudinal = 0.0, lateral = 0.0;  ///< N
  double normal = 0.0;       ///< N; nonzero on a curved surface and with contacts in other planes
  double spin_moment = 0.0;  ///< N mm
  double force_bar = 0.0;    ///< N, error bar of the force vector
  double moment_bar = 0.0;   ///< N mm
  double rise = 0.0;         ///< K, largest of the temperature in contact; 0 without heat
};

class PressedWheel {
 public:
  /// `input`: profiles, one wheel at one position. The load is applied without friction; friction,
  /// creepages and motion are ignored. `search`: the case's contact search. Throws
  /// contact::InputError and contact::SolveError where the wheel does not touch, like
  /// find_contacts.
  PressedWheel(const contact::Case& input, const SearchScene& search);

  const PressedState& state() const { return state_; }

  /// Forces by the model halfspace on the case's contact grid, with error bars, under any friction
  /// law (not null). The creepages refer to the main contact; the others follow from the rigid-body
  /// motion of the wheel. Displacements of one contact by the tangential forces of another are
  /// neglected. Throws contact::SolveError.
  /// `heat`: empty: no temperatures.
  std::vector<FrictionForce> forces(const std::vector<contact::Creepage>& creepages,
                                    const contact::Friction& friction,
                                    const std::optional<contact::SurfaceHeat>& heat = {}) const;

 private:
  struct Contact {
    contact::Scene scene;  ///< under its normal force
    WheelRailContact where;
    double lateral = 0.0, normal = 0.0, spin_moment = 0.0;  ///< of the pressure; N, N mm
  };

  void press(contact::Scene scene, const WheelRailContact& where);
  std::vector<contact::Creepage> creepages_of(
      const Contact& contact, const std::vector<contact::Creepage>& creepages) const;
  void add(const Contact& contact, double coefficient, const contact::PointResult& point,
           FrictionForce& sum) const;

  std::vector<Contact> contacts_;  ///< the main one first
  PressedState state_;
  bool extra_slip_ = true;
  double rolling_radius_ = 0.0;  ///< mm, of the wheel
};

}  // namespace rollfem::track
