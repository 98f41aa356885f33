// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions for stresses below the surface, in blocks of points. z > 0 is body 1.
#include "halfspace/stress/subsurface.hpp"

#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"
#include "result/stress_measures.hpp"

#include <fmt/format.h>

#include "convert/stress_block.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
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

/// The tensor (xx, yy, zz, xy, yz, xz) in CONTACT's axes: signs of their directions against ours.
std::array<double, 21> row_of(const std::array<double, 3>& place,
                              const halfspace::SubsurfaceState& state,
                              const std::array<double, 3>& sign) {
  const auto& s = state.stress;
  const double xy = sign[0] * sign[1] * s[3], yz = sign[1] * sign[2] * s[4],
               xz = sign[0] * sign[2] * s[5];
  const std::array<double, 3> principal = contact::principal(s);
  return {place[0],
          place[1],
          place[2],
          sign[0] * state.displacement[0],
          sign[1] * state.displacement[1],
          sign[2] * state.displacement[2],
          contact::hydrostatic(s),
          contact::von_mises(s),
          principal[0] - principal[2],
          principal[0],
          principal[1],
          principal[2],
          s[0],
          xy,
          xz,
          xy,
          s[1],
          yz,
          xz,
          yz,
          s[2]};
}

constexpr double most_points = 1e7;

/// In module 1 the rail is body 1, at z > 0 in axes that point down.
BlockStresses stresses_of(const Block& block, const Problem& problem, const Patch& patch) {
  const Axes axes = axes_of(block, problem.units, patch);
  BlockStresses found;
  double size = 1.0;
  for (std::size_t c = 0; c < 3; ++c) {
    found.count[c] = static_cast<int>(axes[c].size());
    size *= found.count[c];
  }
  if (size > most_points) throw Refusal(err_other, "a block of more than 1e7 points");
  const bool on_track = problem.given.module == 1;
  const std::array<double, 3> sign{on_track ? 1.0 : patch.along, on_track ? -1.0 : patch.across,
                                   on_track ? -1.0 : 1.0};
  const contact::Scene& scene = *patch.scene;
  found.rows.resize(static_cast<std::size_t>(size));
  for (std::size_t k = 0; k < axes[2].size(); ++k) {
    const bool wheel = (axes[2][k] >= 0.0) != on_track;
    const halfspace::LoadedBody body{wheel ? halfspace::Body::wheel : halfspace::Body::rail,
                                     wheel ? scene.wheel.material : scene.rail.material, patch.grid,
                                     patch.point.fields.traction};
    std::vector<halfspace::SubsurfacePoint> points;
    for (const double y : axes[1])
      for (const double x : axes[0])
        points.push_back({sign[0] * x, sign[1] * y, std::abs(axes[2][k])});
    const bool lattice = block.kind == 1 || block.kind == 5;
    std::vector<halfspace::SubsurfaceState> states;
    if (lattice) {
      contact::ContactGrid grid = patch.grid;
      grid.nx = patch.nx;
      grid.ny = patch.ny;
      grid.x_first = patch.grid.x(patch.first_column);
      grid.y_first = patch.grid.y(patch.first_row);
      states = halfspace::subsurface_box(body, grid, {std::abs(axes[2][k])}).front().states;
    } else {
      states = halfspace::smooth_subsurface_at(body, points);
    }
    const std::size_t nx = axes[0].size(), ny = axes[1].size();
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        const std::size_t column = lattice && patch.turns_columns ? nx - 1 - i : i,
                          row = lattice && patch.turns_rows ? ny - 1 - j : j;
        found.rows[(k * ny + j) * nx + i] =
            row_of({axes[0][i], axes[1][j], axes[2][k]}, states[row * nx + column], sign);
      }
  }
  return found;
}

const BlockStresses& block_of(const Patch& patch, int block) {
  const auto found = patch.stresses.find(block);
  if (found == patch.stresses.end()) throw Refusal(err_icp, "there is no such block of stresses");
  return found->second;
}

/// Powers of length of the 21 columns.
int power_of(int column) {
  return column <= 6 ? 1 : -2;
}

}  // namespace

extern "C" {

/// Discards all blocks with this number or a higher one.
void subs_addblock(const int* ire, const int* icp, const int* iblk, const int* isubs,
                   const int* npx, const int* npy, const int* npz, const double* xparam,
                   const double* yparam, const double* zparam) {
  guarded("subs_addblock", {ire, icp, iblk, isubs, npx, npy, npz}, nullptr, [&] {
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
      if (values[c] == nullptr) throw Refusal(err_other, "an argument is null");
      block.given[c].assign(values[c], values[c] + *count[c]);
      for (const double value : block.given[c])
        if (!std::isfinite(value)) throw Refusal(err_other, "a value is not finite");
    }
    for_problems(*ire, *icp, [&](Problem& problem) {
      problem.blocks.erase(problem.blocks.lower_bound(*iblk), problem.blocks.end());
      problem.blocks[*iblk] = block;
    });
    return 0;
  });
}

void subs_calculate(const int* ire, const int* icp, int* ierror) {
  guarded("subs_calculate", {ire, icp, ierror}, ierror, [&] {
    for_problem(*ire, *icp, [&](Problem& problem) {
      if (problem.cases == 0) throw Refusal(err_icp, "it is not solved");
      const bool one = problem.given.module == 1 && *icp > 0;
      for (std::size_t k = 0; k < problem.patches.size(); ++k) {
        Patch& patch = problem.patches[k];
        if (one && static_cast<int>(k) + 1 != *icp) continue;
        patch.stresses.clear();
        for (const auto& [number, block] : problem.blocks)
          patch.stresses[number] = stresses_of(block, problem, patch);
      }
    });
    return 0;
  });
}

void subs_getblocksize(const int* ire, const int* icp, const int* iblk, int* nx, int* ny, int* nz) {
  guarded("subs_getblocksize", {ire, icp, iblk, nx, ny, nz}, nullptr, [&] {
    *nx = *ny = *nz = 0;
    for_patch(*ire, *icp, [&](Problem&, const Patch& patch) {
      const auto& count = block_of(patch, *iblk).count;
      *nx = count[0];
      *ny = count[1];
      *nz = count[2];
    });
    return 0;
  });
}

void subs_getresults(const int* ire, const int* icp, const int* iblk, const int* lenarr,
                     const int* ncol, const int* icol, double* values) {
  guarded("subs_getresults", {ire, icp, iblk, lenarr, ncol, icol, values}, nullptr, [&] {
    if (*lenarr < 0 || *ncol < 0 || *ncol > 1000) throw Refusal(err_other, "an impossible length");
    const auto length = static_cast<std::size_t>(*lenarr);
    std::fill_n(values, length * static_cast<std::size_t>(*ncol),
                std::numeric_limits<double>::quiet_NaN());
    for_patch(*ire, *icp, [&](Problem& problem, const Patch& patch) {
      const BlockStresses& block = block_of(patch, *iblk);
      for (int c = 0; c < *ncol; ++c) {
        if (icol[c] < 1 || icol[c] > 21)
          throw Refusal(err_other, fmt::format("there is no column {}", icol[c]));
        const double factor = problem.units.out(1.0, power_of(icol[c]));
        for (std::size_t k = 0; k < std::min(length, block.rows.size()); ++k)
          values[static_cast<std::size_t>(c) * length + k] =
              factor * block.rows[k][static_cast<std::size_t>(icol[c] - 1)];
      }
    });
    return 0;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
