// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane strain by finite elements: a slab one cell wide whose sides do not move across, under
// Hertz's pressure of a line contact; or, with the same cells along and down, half of a body in
// three dimensions under a patch so wide that its middle is in plane strain.
#pragma once

#include "meshes/segment_mesh.hpp"

#include "support/fem_rolled_body.hpp"
#include "support/mesh_examples.hpp"

namespace rollfem::testing {

/// Lengths in half-widths of the contact.
struct SlabOptions {
  int per_half_width = 8;               ///< cells
  double extent = 10.0;                 ///< to the clamped ends and bottom
  int ahead = 2, behind = 2, deep = 2;  ///< of the material points
  bool wheel = false;
  double wide = 0.0;       ///< half of the patch across; 0: plane strain
  double growth = 1.3;     ///< of cells outwards
  double first_row = 0.0;  ///< height of the cells at the surface; 0: equal rows
  int at_once = 8;         ///< rows that the largest cells cover
};

/// Half-width 1 mm, pressure sqrt(1 - x^2) MPa as far across as the patch is wide.
inline std::unique_ptr<RolledBody> rolled_slab(const SlabOptions& options = {}) {
  const double h = 1.0 / options.per_half_width;
  const auto along = meshes::outward_steps(h, std::max(options.ahead, options.behind),
                                           options.extent, options.growth);
  fem::GradedDepth rows;
  if (options.first_row > 0.0) rows = fem::GradedDepth(options.first_row, h, options.at_once);
  std::vector<double> z{0.0};
  double even = 0.0;
  for (const double step : meshes::outward_steps(h, rows.even(options.deep),
                                                 rows.even(options.extent), options.growth)) {
    even += step;
    if (options.wheel)
      z.push_back(rows.depth(even));
    else
      z.insert(z.begin(), -rows.depth(even));
  }
  const bool plane = options.wide == 0.0;
  std::vector<double> y{0.0};
  for (const double step : meshes::outward_steps(
           h, options.wide, plane ? h : options.wide + options.extent, options.growth))
    y.push_back(y.back() + step);
  meshes::HexMesh mesh =
      block(meshes::points_both_ways(along), y, z, !options.wheel, nullptr, true);
  for (auto& quad : mesh.sides) {
    if (!plane) break;
    const auto beyond = [&](int corner) { return std::abs(mesh.points[corner][1] - h) < 1e-12; };
    if (std::all_of(quad.corners.begin(), quad.corners.end(), beyond))
      quad.side = meshes::Side::symmetry;
  }
  fem::BodyOptions body;
  body.cell_size = h;
  body.growth = 1e6;
  body.half = true;
  body.fine_half_length = options.ahead - 0.5 * h;  // no cell beyond is refined
  body.fine_half_width = h;
  body.extent = options.extent + options.wide;
  body.rows = rows;
  const int strips = plane ? 1 : static_cast<int>(std::lround(options.wide / h));
  const auto grid = contact::ContactGrid::centred(2 * ((5 * options.per_half_width + 3) / 4),
                                                  2 * strips, h, h, 0.0, 0.0);
  const auto below = [](double x) {  // integral of the pressure
    x = std::clamp(x, -1.0, 1.0);
    return 0.5 * (x * std::sqrt(1.0 - x * x) + std::asin(x));
  };
  const contact::Field pressure =
      grid.sample([&](double x, double) { return (below(x + 0.5 * h) - below(x - 0.5 * h)) / h; });
  fem::StreamLattice lattice;
  lattice.cell = h;
  lattice.along = {-options.behind * options.per_half_width,
                   options.ahead * options.per_half_width};
  lattice.across = {0, plane ? 1 : strips + 1};
  lattice.down = static_cast<int>(std::ceil(rows.even(options.deep) / h - 1e-6));
  lattice.rows = rows;
  // A wheel so large that its tread is flat: it leaves the plane by 2e-5 mm at 20 mm.
  constexpr double flat = 1e7;
  const auto shape =
      options.wheel ? wheel_shape(flat, contact::infinity) : rail_shape(contact::infinity);
  return std::make_unique<RolledBody>(
      std::make_unique<fem::Body>(shape, contact::Material{210e3, 0.3}, body, mesh, MPI_COMM_WORLD),
      grid, pressure, lattice);
}

/// The slabs of a process by elements per half-width, extent, and whether a wheel.
inline std::map<std::tuple<int, double, bool>, std::unique_ptr<RolledBody>> slabs;

/// Their meshes must go before MPI.
class EndOfSlabs : public ::testing::Environment {
  void TearDown() override { slabs.clear(); }
};
inline const auto* const end_of_slabs = ::testing::AddGlobalTestEnvironment(new EndOfSlabs);

/// A slab in plane strain, the same for all tests of a process.
inline const RolledBody& slab_of(int per_half_width, double extent, bool wheel = false) {
  std::unique_ptr<RolledBody>& slab = slabs[{per_half_width, extent, wheel}];
  if (!slab) {
    SlabOptions options;
    options.per_half_width = per_half_width;
    options.extent = extent;
    options.wheel = wheel;
    slab = rolled_slab(options);
  }
  return *slab;
}

/// Residual stress along and across the rolling direction behind the load, MPa, where that normal
/// to the surface vanishes: {depth: mean of the stations from `from` to `to`}, of the first cell
/// across.
inline std::map<double, std::array<double, 2>> residual_below(const Passes& passes, double from,
                                                              double to) {
  const auto stress = passes.residual_stress();
  const fem::Streamlines& lines = passes.of.lines;
  std::map<double, std::array<double, 2>> mean;
  std::map<double, int> count;
  for (std::size_t k = 0; k < lines.points(); ++k) {
    const double s = lines.s(k % lines.stations());
    const auto [y, depth] = lines.section(k / lines.stations());
    if (s < from || s > to || y > lines.section(1)[0]) continue;
    mean[depth][0] += stress[k][0] - stress[k][2];
    mean[depth][1] += stress[k][1] - stress[k][2];
    ++count[depth];
  }
  for (auto& [depth, sums] : mean)
    for (double& sum : sums) sum /= count[depth];
  return mean;
}

/// The same at a depth between two streamlines.
inline std::array<double, 2> residual_at(const Passes& passes, double depth, double from,
                                         double to) {
  const auto profile = residual_below(passes, from, to);
  const auto below = profile.lower_bound(depth), above = std::prev(below);
  const double share = (depth - above->first) / (below->first - above->first);
  return {(1.0 - share) * above->second[0] + share * below->second[0],
          (1.0 - share) * above->second[1] + share * below->second[1]};
}

}  // namespace rollfem::testing
