// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/mesh/graded_depth.hpp"

#include "base/root.hpp"

#include <algorithm>
#include <cmath>

namespace rollfem::fem {

namespace {

constexpr double growth = 1.4;

/// Stretch at the surface with which the first row is `first` times as high as equal ones, where
/// the stretch grows by the same factor over each of `pieces` pieces, and linearly within them.
double surface_stretch(double first, int pieces, int rows) {
  const auto excess = [&](double stretch) {
    const double next = std::pow(stretch, 1.0 - 1.0 / pieces);
    return stretch + 0.5 * (next - stretch) / rows - first;
  };
  return excess(0.0) >= 0.0
             ? 0.0
             : contact::bracketed_root(excess, 0.0, 1.0, 1e-12, "height of the surface cells");
}

}  // namespace

GradedDepth::GradedDepth(double first, double cell, int at_once) : step_(at_once * cell) {
  if (!(first < cell)) return;
  int count = 1;
  double stretch = 0.0;
  for (;; ++count) {
    stretch = surface_stretch(first / cell, count, at_once);
    if (stretch >= std::pow(growth, -at_once * count)) break;
  }
  const double factor = std::pow(stretch, -1.0 / count);
  double depth = 0.0;
  for (int k = 0; k < count; ++k, stretch *= factor) {
    pieces_.push_back({depth, stretch, stretch * (factor - 1.0) / step_});
    depth += 0.5 * stretch * (1.0 + factor) * step_;
  }
  pieces_.push_back({depth, 1.0, 0.0});
}

double GradedDepth::depth(double even) const {
  if (equal_rows() || even < 0.0) return even;
  const auto k = static_cast<std::size_t>(
      std::min(std::floor(even / step_), static_cast<double>(pieces_.size() - 1)));
  const Piece& piece = pieces_[k];
  const double further = even - static_cast<double>(k) * step_;
  return piece.depth + further * (piece.stretch + 0.5 * piece.rise * further);
}

double GradedDepth::even(double depth) const {
  if (equal_rows() || depth < 0.0) return depth;
  std::size_t k = 0;
  while (k + 1 < pieces_.size() && pieces_[k + 1].depth <= depth) ++k;
  const Piece& piece = pieces_[k];
  const double further = depth - piece.depth;
  const double root = std::sqrt(piece.stretch * piece.stretch + 2.0 * piece.rise * further);
  return static_cast<double>(k) * step_ + 2.0 * further / (piece.stretch + root);
}

double GradedDepth::stretch(double even) const {
  if (equal_rows()) return 1.0;
  const auto k = static_cast<std::size_t>(
      std::clamp(std::floor(even / step_), 0.0, static_cast<double>(pieces_.size() - 1)));
  return pieces_[k].stretch + pieces_[k].rise * (even - static_cast<double>(k) * step_);
}

}  // namespace rollfem::fem
