// SPDX-License-Identifier: LGPL-2.1-or-later
#include "halfspace/elasticity/influence_tables.hpp"

#include "contact/iteration/interpolation.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollfem::halfspace {

namespace {

constexpr int steps_of_two = 4;  ///< tables from one ratio to its double
constexpr int octaves = 6;       ///< in both directions from 1

InfluenceTable table_of(int nx, int ny, double ratio, const contact::CombinedMaterial& material) {
  InfluenceTable table;
  table.ratio = ratio;
  table.nx = nx;
  table.ny = ny;
  std::vector<Influence> ahead(static_cast<std::size_t>(nx) + 2);
  const auto of = [&](int i) {
    Influence found = ahead[static_cast<std::size_t>(std::abs(i))];
    if (i < 0) found.xy = -found.xy;
    return found;
  };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i <= nx + 1; ++i)
      ahead[static_cast<std::size_t>(i)] = rectangle_influence(i, j * ratio, 1.0, ratio, material);
    if (j == 0)
      table.diagonal =
          0.25 * (3.0 * (of(0).xx + of(0).yy) - 4.0 * (of(1).xx + of(1).yy) + of(2).xx + of(2).yy);
    for (int i = -nx; i <= nx; ++i) {
      table.nn.push_back(of(i).nn);
      table.xx.push_back(of(i).xx - of(i + 1).xx);
      table.yy.push_back(of(i).yy - of(i + 1).yy);
      table.xy.push_back(of(i).xy - of(i + 1).xy);
    }
  }
  for (auto* list : {&table.nn, &table.xx, &table.yy, &table.xy})
    list->resize(list->size() + read_beyond);
  return table;
}

}  // namespace

InfluenceTables::InfluenceTables(int nx, int ny, const contact::CombinedMaterial& material)
    : nx_(nx), ny_(ny) {
  constexpr int most = steps_of_two * octaves;
  for (int k = -most; k <= most; ++k)
    tables_.push_back(table_of(nx, ny, std::exp2(static_cast<double>(k) / steps_of_two), material));
}

bool InfluenceTables::interpolate(double ratio, InfluenceTable& table) const {
  constexpr int most = steps_of_two * octaves;
  const double place = steps_of_two * std::log2(ratio) + most;
  if (!(place >= 0.0 && place <= 2 * most)) return false;
  const int first = std::clamp(static_cast<int>(place) - 1, 0, 2 * most - 3);
  const auto part =
      contact::lagrange_weights(std::array<double, 4>{0.0, 1.0, 2.0, 3.0}, place - first);
  const InfluenceTable* const at = &tables_[static_cast<std::size_t>(first)];
  table.ratio = ratio;
  table.nx = nx_;
  table.ny = ny_;
  table.diagonal = 0.0;
  for (std::size_t m = 0; m < part.size(); ++m) table.diagonal += part[m] * at[m].diagonal;
  for (std::vector<double> InfluenceTable::*list :
       {&InfluenceTable::nn, &InfluenceTable::xx, &InfluenceTable::yy, &InfluenceTable::xy}) {
    const std::size_t count = (at->*list).size();
    (table.*list).resize(count);
    const double *a = (at[0].*list).data(), *b = (at[1].*list).data(), *c = (at[2].*list).data(),
                 *d = (at[3].*list).data();
    double* to = (table.*list).data();
    for (std::size_t k = 0; k < count; ++k)
      to[k] = part[0] * a[k] + part[1] * b[k] + part[2] * c[k] + part[3] * d[k];
  }
  return true;
}

}  // namespace rollfem::halfspace
