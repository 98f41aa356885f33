// SPDX-License-Identifier: LGPL-2.1-or-later
// The two ways to sum the fields of all contact elements (subsurface.hpp chooses): directly, and by
// Fourier transform on a lattice. In the local frame of cell_stress.hpp.
#pragma once

#include "contact/base/grid.hpp"
#include "halfspace/elasticity/fft.hpp"
#include "halfspace/stress/cell_stress.hpp"

#include <vector>

namespace rollfem::halfspace {

/// Loads on the surface of one half-space in its local frame, with the constants of its material.
struct LocalProblem {
  contact::ContactGrid grid;
  std::array<contact::Field, 3> loads;  ///< MPa, along x, y, z
  double shear_modulus = 0.0;
  double poisson_ratio = 0.0;
};

/// Sums over the loaded elements of one problem at any point.
class DirectSum {
 public:
  /// Keeps a reference to the problem.
  explicit DirectSum(const LocalProblem& problem);
  explicit DirectSum(LocalProblem&&) = delete;
  LocalState at(double x, double y, double z) const;
  /// Elements in the smallest rectangle that contains all loads.
  long elements() const;

 private:
  using Loads = Eigen::Array<double, potential_count, 3>;
  Loads near_sum(double x, double y, double z) const;
  Loads far_sum(double x, double y, double z) const;

  const LocalProblem& problem_;
  int i_first_ = 0, i_last_ = -1, j_first_ = 0, j_last_ = -1;
};

/// Convolution on a lattice with the spacing of the contact grid, layer by layer: the spectra of
/// the loads and the plans are kept.
class LayerConvolution {
 public:
  /// Keeps a reference to the problem.
  LayerConvolution(const LocalProblem& problem, const contact::ContactGrid& points);
  LayerConvolution(LocalProblem&&, const contact::ContactGrid&) = delete;
  /// One state per point of the lattice.
  std::vector<LocalState> at(double z) const;

 private:
  std::vector<Potentials> corners(double z) const;
  void transform_kernels(double z) const;

  const LocalProblem& problem_;
  contact::ContactGrid points_;
  PaddedFft loads_fft_;
  PaddedFft kernel_fft_;
  PaddedFft points_fft_;
  std::array<PaddedFft::Spectrum, 3> loads_;
  mutable std::array<PaddedFft::Spectrum, potential_count> kernels_;
};

}  // namespace rollfem::halfspace
