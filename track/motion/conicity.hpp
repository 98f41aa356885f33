// Equivalent conicity of a wheelset from the difference of its rolling radii over the lateral
// shift: the angle of the cones that would have the same lateral motion.
#pragma once

#include <optional>
#include <vector>

namespace rollfem::track {

/// Radius of the right wheel less that of the left one over the lateral shift, for a wheelset and
/// track that are the same on both sides: odd, linear between the given shifts.
class RadiusDifference {
 public:
  /// Shifts rise from 0, where the difference is 0; both in mm.
  RadiusDifference(std::vector<double> shift, std::vector<double> difference);

  double largest_shift() const { return shift_.back(); }  ///< mm
  /// mm, at a shift from 0 to the largest.
  double at(double shift) const;
  /// Its integral from 0, mm^2.
  double integral(double shift) const;

  /// By harmonic linearisation: half the slope of the straight line whose work over a sine of this
  /// amplitude (mm) is the same, 1/(2 pi A) int difference(A sin t) sin t dt.
  double harmonic_conicity(double amplitude) const;

  /// Wave length (mm) of the free rolling wheelset without creepage, e r y'' + difference(y) = 0
  /// with the distance e of the contacts and the rolling radius r, at this amplitude; nothing where
  /// it does not swing back. (Klingel's equation with the real radii: UIC 519, EN 15302.)
  std::optional<double> wave_length(double amplitude, double contact_distance,
                                    double rolling_radius) const;

 private:
  std::size_t piece(double shift) const;

  std::vector<double> shift_, difference_, integral_;
};

/// Of the cones whose free wheelset has this wave length (mm): 2 pi^2 e r / L^2.
double conicity_of_wave(double wave_length, double contact_distance, double rolling_radius);

}  // namespace rollfem::track
