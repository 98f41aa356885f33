// SPDX-License-Identifier: LGPL-2.1-or-later
// Material points of a body on its streamlines (straight in a rail, circles in a wheel): strain
// there from a nodal displacement, and the load of a plastic strain given there.
#pragma once

#include "fem/discretisation/body.hpp"
#include "fem/plasticity/plastic_law.hpp"
#include "fem/stress/stress_recovery.hpp"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace rollfem::fem {

/// A box of lattice cells in (s, t, even depth), each with 2 x 2 x 2 Gauss points. Strain is
/// plastic on streamlines through this box alone. Material enters at its largest s.
struct StreamLattice {
  double cell = 0.0;            ///< mm
  std::array<int, 2> along{};   ///< first and end, in cells
  std::array<int, 2> across{};  ///< the same
  int down = 0;                 ///< rows of cells below the surface
  GradedDepth rows;             ///< their depths

  /// Points of a streamline, from the leading one.
  std::size_t stations() const { return 2 * static_cast<std::size_t>(along[1] - along[0]); }
  /// Streamlines of one depth, which follow one another.
  std::size_t width() const { return 2 * static_cast<std::size_t>(across[1] - across[0]); }
  std::size_t streams() const { return width() * 2 * static_cast<std::size_t>(down); }
  std::size_t points() const { return stations() * streams(); }
  /// Of the section behind the load that results show: a cell before the trailing end.
  std::size_t section_station() const { return stations() - 3; }
  /// mm, of a point counted from a cell; down: even depth
  double place(int first, std::size_t point) const;
  double s(std::size_t station) const { return place(along[0], stations() - 1 - station); }  ///< mm
  /// t and depth, mm.
  std::array<double, 2> section(std::size_t stream) const {
    return {place(across[0], stream % width()), rows.depth(place(0, stream / width()))};
  }
};

/// The symmetric components of deviators are those of the section of the body that moves with the
/// material: x along rolling, y and z of the section turned back to s = 0.
class Streamlines : public StreamLattice {
 public:
  /// The body must outlive the streamlines. Collective. Throws contact::InputError when a point of
  /// the lattice is not in the body.
  Streamlines(const Body& body, const StreamLattice& lattice);
  ~Streamlines();
  /// In increasing order: at all others load() is 0.
  std::vector<dealii::types::global_dof_index> unknowns() const;
  MPI_Comm communicator() const;
  /// mm^3, of the point k = stream * stations() + station.
  double volume(std::size_t k) const;
  /// Deviators of the strain of a displacement with ghost values. Collective.
  std::vector<Deviator> strains(const Vector& displacement) const;
  /// b_i = int 2 G eps_p : eps(N_i): on streamlines the plastic strain is that of `plastic` at the
  /// points, `inflow` before and `outflow` behind them, to both ends of the body. Collective.
  void load(const std::vector<Deviator>& plastic, const std::vector<PlasticState>& inflow,
            const std::vector<PlasticState>& outflow, Vector& b) const;

  /// Stress in space at a point, turned to the section (xx yy zz xy yz xz).
  contact::SymmetricTensor in_section(const contact::SymmetricTensor& stress, std::size_t station,
                                      std::size_t stream) const;
  /// All but the residual stress, at the nodes of cells on streamlines: from linear functions in
  /// each cell, averaged. Arguments as of load(); `before`: stress along and across before the
  /// first pass, MPa, over depth. Collective.
  YieldedFields at_nodes(const std::vector<Deviator>& plastic,
                         const std::vector<double>& accumulated,
                         const std::vector<PlasticState>& inflow,
                         const std::vector<PlasticState>& outflow,
                         const std::function<std::array<double, 2>(double depth)>& before) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rollfem::fem
