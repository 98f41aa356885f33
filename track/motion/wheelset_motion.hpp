// SPDX-License-Identifier: LGPL-2.1-or-later
// Slip of wheel over rail from the motion of the wheelset, and the forces on the wheelset from the
// forces of the patches. Motion is relative to the forward speed V of the middle of the axle: V
// = 1. Frames and signs: docs/track.md.
#pragma once

#include "case/case.hpp"
#include "track/search/contact_search.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace rollfem::track {

/// Motion of a wheelset over its forward speed.
struct Motion {
  double rotation = 0.0;          ///< 1/mm, about the axle, positive when rolling forward
  double lateral_velocity = 0.0;  ///< positive to the right
  double yaw_velocity = 0.0;      ///< rad/mm, positive from x to y
  double roll_velocity = 0.0;     ///< rad/mm, positive from y to z
  /// Positive down; not given: wheel and rail neither part nor overlap at the reference point.
  std::optional<double> vertical_velocity{};
};

/// (1 + rotation_change) / rolling_radius, and the velocities of the case.
Motion motion_of(const contact::Case& input, double rotation_change);

/// Velocity of the wheel's material at a point of the patch frame (mm) relative to the rail, in the
/// patch frame.
contact::Vector3 slip_at(const WheelRailContact& contact, const Motion& motion,
                         const contact::Vector3& place);

/// The wheel's surface over the reference point at first contact of the wheel, in the patch frame:
/// (0, 0, undeformed distance and separation). Its circle has the local rolling radius.
contact::Vector3 surface_place(const WheelRailContact& contact);

/// xi, eta, phi of the patch as a plane: slip of the wheel's undeformed surface over the reference
/// point, and the component of the total rotation along the normal. Where several patches share one
/// plane, the reference point may lie in the gap between them; the wheel's surface there has a
/// different rolling radius, from which the slip of every point follows
/// (ChartedGeometry::rigid_slip).
contact::Creepage creepage_of(const WheelRailContact& contact, const Motion& motion);

/// The same at the reference point on the rail, as in CONTACT: for a plane whose only slip is xi,
/// eta and phi (ExtraSlip::none); close to the creepages of patches beside a gap.
contact::Creepage creepage_on_rail(const WheelRailContact& contact, const Motion& motion);

/// Derivatives of xi, eta and phi by rotation, lateral and yaw velocity, in which both are affine.
Eigen::Matrix3d creepage_by_motion(const WheelRailContact& contact, bool on_rail = false);

/// Forces of a patch on the wheel in its frame, and the moment about its normal.
struct PatchForce {
  double longitudinal = 0.0;  ///< F_x, N
  double lateral = 0.0;       ///< F_y, N
  double normal = 0.0;        ///< N
  double spin_moment = 0.0;   ///< M_z, N mm
};

/// Moment on the wheelset about its axle from forces at the surface point, N mm, positive when it
/// drives the wheelset forward. Free rolling of a wheelset: the sum over all patches of both wheels
/// is 0.
double driving_moment(const WheelRailContact& contact, const PatchForce& force);

/// Upward force on the wheel, N.
double vertical_force(double normal, double lateral, const contact::ContactPlace& place);

/// Force on the wheel along y of the track (to the right), N.
double lateral_force(double normal, double lateral, const contact::ContactPlace& place);

// Equivalent conicity of a wheelset from the difference of its rolling radii over the lateral
// shift: the angle of the cones that would have the same lateral motion.

/// Radius of the right wheel less that of the left one over the lateral shift, linear between the
/// given shifts; odd for a wheelset and track that are the same on both sides.
class RadiusDifference {
 public:
  /// Shifts rise; both in mm. From 0 on, where the difference is 0: odd. From a negative shift on:
  /// left and right differ.
  RadiusDifference(std::vector<double> shift, std::vector<double> difference);

  double largest_shift() const { return shift_.back(); }  ///< mm
  /// mm, at one of the given shifts or between them.
  double at(double shift) const;
  /// Integral of the difference from the first shift, mm^2; even where the difference is odd.
  double integral(double shift) const;

  /// By harmonic linearisation: half the slope of the straight line whose work over a sine of this
  /// amplitude (mm) is the same, 1/(2 pi A) int difference(A sin t) sin t dt. Of an odd difference.
  double harmonic_conicity(double amplitude) const;

  /// Wavelength (mm) of the freely rolling wheelset without creepage, e r y'' + difference(y) = 0
  /// with the distance e of the contacts and the rolling radius r, at this amplitude: half the way
  /// between its turning points. Empty where it does not recentre. (Klingel's equation with the
  /// real radii: UIC 519, EN 15302.)
  std::optional<double> wave_length(double amplitude, double contact_distance,
                                    double rolling_radius) const;

 private:
  /// Middle between the turning points at an amplitude; NaN where they are beyond the given shifts.
  double middle(double amplitude) const;

  std::vector<double> shift_, difference_, integral_;
};

/// Conicity of the cones whose free wheelset has this wavelength (mm): 2 pi^2 e r / L^2.
double conicity_of_wave(double wave_length, double contact_distance, double rolling_radius);

}  // namespace rollfem::track
