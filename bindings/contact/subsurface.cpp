// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions for stresses below the surface, in blocks of points. z > 0 is body 1.
#include "halfspace/stress/subsurface.hpp"

#include "bindings/contact/rows.hpp"
#include "result/stress_measures.hpp"

#include <fmt/format.h>

#include "convert/stress_block.hpp"
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace rollfem::addon {

namespace {

using Axes = std::array<std::vector<double>, 3>;

/// x, y, z in mm in CONTACT's axes of the patch.
Axes axes_of(const Block& block, const Units& units, const Patch& patch) {
  const auto& z = block.given[2];
  if (block.kind < 5 && !(z.size() >= 3 && z[0] >= 1.0 && z[0] <= 10000.0))
    throw Refusal(err_other, "NZ, ZL, DZ: NZ: allowed: 1 to 10000");
  const convert::StressBlock made =
      convert::stress_block(block.kind, block.given, {patch.nx, patch.ny});
  Axes axes{made.x, made.y, made.z};
  for (double& x : axes[0]) x = made.by_element ? patch.x(x - 1.0) : units.in(x);
  for (double& y : axes[1]) y = made.by_element ? patch.y(y - 1.0) : units.in(y);
  for (double& depth : axes[2]) depth = units.in(depth);
  return axes;
}

/// The columns of subs_getresults, in CONTACT's axes: signs of their directions against ours.
std::array<double, 21> row_of(const std::array<double, 3>& place,
                              const halfspace::SubsurfaceState& state,
                              const std::array<double, 3>& sign) {
  const contact::SymmetricTensor& s = state.stress;
  const std::array<double, 3> principal = contact::principal(s);
  std::array<double, 21> row{};
  for (std::size_t k = 0; k < 3; ++k) {
    row[k] = place[k];
    row[3 + k] = sign[k] * state.displacement[k];
    row[9 + k] = principal[k];
  }
  row[6] = contact::hydrostatic(s);
  row[7] = contact::von_mises(s);
  row[8] = principal[0] - principal[2];
  constexpr std::array<std::size_t, 9> component{0, 3, 5, 3, 1, 4, 5, 4, 2};
  for (std::size_t k = 0; k < 9; ++k) row[12 + k] = sign[k / 3] * sign[k % 3] * s[component[k]];
  return row;
}

/// The elements of the potential contact area as a lattice.
contact::ContactGrid lattice_of(const Patch& patch) {
  contact::ContactGrid grid = patch.grid;
  grid.nx = patch.nx;
  grid.ny = patch.ny;
  grid.x_first = patch.grid.x(patch.first_column);
  grid.y_first = patch.grid.y(patch.first_row);
  return grid;
}

/// In module 1 the rail is body 1, at z > 0 in axes that point down.
BlockStresses stresses_of(const Block& block, const Problem& problem, const Patch& patch) {
  constexpr double most_points = 1e7;
  const auto [x, y, z] = axes_of(block, problem.units, patch);
  const std::size_t nx = x.size(), ny = y.size();
  if (static_cast<double>(nx * ny) * static_cast<double>(z.size()) > most_points)
    throw Refusal(err_other, "a block of more than 1e7 points");
  BlockStresses found;
  found.count = {static_cast<int>(nx), static_cast<int>(ny), static_cast<int>(z.size())};
  const bool on_track = problem.given.module == 1;
  const std::array<double, 3> sign{on_track ? 1.0 : patch.along, on_track ? -1.0 : patch.across,
                                   on_track ? -1.0 : 1.0};
  const bool lattice = block.kind == 1 || block.kind == 5;
  for (const double depth : z) {
    const bool wheel = (depth >= 0.0) != on_track;
    const contact::Scene& scene = *patch.scene;
    const halfspace::LoadedBody body{wheel ? halfspace::Body::wheel : halfspace::Body::rail,
                                     wheel ? scene.wheel.material : scene.rail.material, patch.grid,
                                     patch.point.fields.traction};
    std::vector<halfspace::SubsurfacePoint> points;
    for (std::size_t k = 0; k < (lattice ? 0 : nx * ny); ++k)
      points.push_back({sign[0] * x[k % nx], sign[1] * y[k / nx], std::abs(depth)});
    const std::vector<halfspace::SubsurfaceState> states =
        lattice
            ? halfspace::subsurface_box(body, lattice_of(patch), {std::abs(depth)}).front().states
            : halfspace::smooth_subsurface_at(body, points);
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t column = lattice && patch.turns_columns ? nx - 1 - i : i,
                          row = lattice && patch.turns_rows ? ny - 1 - j : j;
        found.rows.push_back(row_of({x[i], y[j], depth}, states[row * nx + column], sign));
      }
  }
  return found;
}

const BlockStresses& block_of(const Patch& patch, int block) {
  const auto found = patch.stresses.find(block);
  if (found == patch.stresses.end()) throw Refusal(err_icp, "there is no such block of stresses");
  return found->second;
}

}  // namespace

extern "C" {

/// Discards all blocks with this number or a higher one.
void subs_addblock(Int ire, Int icp, Int iblk, Int isubs, Int npx, Int npy, Int npz, Real xparam,
                   Real yparam, Real zparam) {
  guarded("subs_addblock", {ire, icp, iblk, isubs, npx, npy, npz}, [&] {
    Block block;
    block.kind = *isubs;
    if (*isubs < 1 || *isubs > 9 || *isubs == 4 || *isubs == 8)
      throw Refusal(err_other, fmt::format("ISUBS = {}: allowed: 1 to 3, 5 to 7, 9", *isubs));
    const std::array<const int*, 3> count{npx, npy, npz};
    const std::array<const double*, 3> values{xparam, yparam, zparam};
    const bool everywhere = *isubs == 1 || *isubs == 5;
    for (std::size_t c = everywhere ? 2 : 0; c < 3; ++c) {
      if (*count[c] < 1 || *count[c] > 100000)
        throw Refusal(err_other, "NPX, NPY, NPZ: allowed: 1 to 100000");
      block.given[c] = finite_values(values[c], *count[c]);
    }
    for_problems(*ire, *icp, [&](Problem& problem) {
      problem.blocks.erase(problem.blocks.lower_bound(*iblk), problem.blocks.end());
      problem.blocks[*iblk] = block;
    });
  });
}

void subs_calculate(Int ire, Int icp, int* ierror) {
  guarded("subs_calculate", {ire, icp, ierror}, ierror, [&] {
    for_problem(*ire, *icp, [&](Problem& problem) {
      for (Patch* patch : patches_of(problem, *icp)) {
        patch->stresses.clear();
        for (const auto& [number, block] : problem.blocks)
          patch->stresses[number] = stresses_of(block, problem, *patch);
      }
    });
    return 0;
  });
}

void subs_getblocksize(Int ire, Int icp, Int iblk, int* nx, int* ny, int* nz) {
  guarded("subs_getblocksize", {ire, icp, iblk, nx, ny, nz}, [&] {
    *nx = *ny = *nz = 0;
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) {
      std::tie(*nx, *ny, *nz) = std::tuple_cat(block_of(patch, *iblk).count);
    });
  });
}

void subs_getresults(Int ire, Int icp, Int iblk, Int lenarr, Int ncol, Int icol, double* values) {
  guarded("subs_getresults", {ire, icp, iblk, lenarr, ncol, icol, values}, [&] {
    if (*lenarr < 0 || *ncol < 0 || *ncol > 1000) throw Refusal(err_other, "an impossible length");
    const auto length = static_cast<std::size_t>(*lenarr);
    std::fill_n(values, length * static_cast<std::size_t>(*ncol), none);
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      const BlockStresses& block = block_of(patch, *iblk);
      for (int c = 0; c < *ncol; ++c) {
        if (icol[c] < 1 || icol[c] > 21)
          throw Refusal(err_other, fmt::format("there is no column {}", icol[c]));
        const double factor = problem.units.out(1.0, icol[c] <= 6 ? 1 : -2);
        for (std::size_t k = 0; k < std::min(length, block.rows.size()); ++k)
          values[static_cast<std::size_t>(c) * length + k] =
              factor * block.rows[k][static_cast<std::size_t>(icol[c] - 1)];
      }
    });
  });
}

}  // extern "C"

}  // namespace rollfem::addon
