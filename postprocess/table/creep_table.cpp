#include "postprocess/table/creep_table.hpp"

#include "contact/base/errors.hpp"
#include "postprocess/table/axis_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::postprocess {

namespace {

constexpr double ratio_let_pass = 1e-3;

bool increasing(const std::vector<double>& values) {
  return !values.empty() &&
         std::adjacent_find(values.begin(), values.end(),
                            [](double a, double b) { return !(a < b); }) == values.end();
}

void refuse_shape(const std::string& what) {
  throw contact::InputError("table: " + what + "; do: read a file that rollfem table has written");
}

/// The weights of a place on all four axes, of forces that pass 0 smoothly along an axis of
/// creepage and of those that do not.
struct Stencil {
  AxisWeights ratio;
  std::array<std::array<AxisWeights, 2>, 3> creepage;
};

/// What F_x, F_y and M_z do along xi', eta' and phi': those that a creepage makes are bent at 0.
constexpr AtZero at_zero[3][3] = {{AtZero::bent, AtZero::smooth, AtZero::smooth},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent},
                                  {AtZero::smooth, AtZero::bent, AtZero::bent}};

/// Sum over the nodes of a stencil of force q. Node -1 of xi' is node 1 under -xi', where F_x turns
/// round; node -1 of eta' is node 1 in the mirror, where phi', F_y and M_z turn round. Only what
/// does not turn round is smooth there.
double sum_of(const CreepTable& table, const Stencil& stencil, std::size_t q) {
  const auto weights_of = [&](std::size_t axis) -> const AxisWeights& {
    return stencil.creepage[axis][static_cast<std::size_t>(at_zero[q][axis])];
  };
  const AxisWeights &x = weights_of(0), &y = weights_of(1), &z = weights_of(2);
  const auto spins = static_cast<int>(table.creepage[2].size());
  double sum = 0.0;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const double w = stencil.ratio.weight[r] * x.weight[i] * y.weight[j];
        if (w == 0.0) continue;
        const int m = x.first + static_cast<int>(i), n = y.first + static_cast<int>(j);
        for (std::size_t k = 0; k < 4; ++k) {
          if (z.weight[k] == 0.0) continue;
          const int spin = z.first + static_cast<int>(k);
          sum += w * z.weight[k] *
                 table.forces[table.place(
                     static_cast<std::size_t>(stencil.ratio.first) + r,
                     static_cast<std::size_t>(std::abs(m)), static_cast<std::size_t>(std::abs(n)),
                     static_cast<std::size_t>(n < 0 ? spins - 1 - spin : spin))][q];
        }
      }
  return sum;
}

/// The two nodes around the place: slots 1 and 2, where they are there.
std::array<std::size_t, 2> around(const AxisWeights& axis, std::size_t count) {
  if (count == 1) return {0, 0};
  const auto lower = static_cast<std::size_t>(axis.first + 1);
  return {lower, lower + 1};
}

std::array<double, 2> bars_of(const CreepTable& table, const Stencil& stencil) {
  std::array<double, 2> largest{};
  for (const std::size_t r : around(stencil.ratio, table.axis_ratio.size()))
    for (const std::size_t i : around(stencil.creepage[0][0], table.creepage[0].size()))
      for (const std::size_t j : around(stencil.creepage[1][0], table.creepage[1].size()))
        for (const std::size_t k : around(stencil.creepage[2][0], table.creepage[2].size()))
          for (std::size_t q = 0; q < 2; ++q)
            largest[q] = std::max(largest[q], table.bars[table.place(r, i, j, k)][q]);
  return largest;
}

}  // namespace

std::size_t CreepTable::size() const {
  return axis_ratio.size() * creepage[0].size() * creepage[1].size() * creepage[2].size();
}

std::size_t CreepTable::place(std::size_t ratio, std::size_t i, std::size_t j,
                              std::size_t k) const {
  return ((ratio * creepage[0].size() + i) * creepage[1].size() + j) * creepage[2].size() + k;
}

double table_coordinate(double scaled_creepage) {
  const double size = std::abs(scaled_creepage);
  return std::copysign(size <= 1.0 ? size : 1.0 + std::log(size), scaled_creepage);
}

double creepage_at(double coordinate) {
  const double size = std::abs(coordinate);
  return std::copysign(size <= 1.0 ? size : std::exp(size - 1.0), coordinate);
}

std::vector<double> creepages_to(double largest, int count) {
  const double end = table_coordinate(largest);
  std::vector<double> found;
  for (int k = 0; k < count; ++k) found.push_back(creepage_at(end * k / (count - 1)));
  found.back() = largest;
  return found;
}

std::vector<double> spins_to(double largest, int count) {
  const double end = table_coordinate(largest);
  std::vector<double> found;
  for (int k = 0; k < count; ++k)
    found.push_back(creepage_at(end * (2 * k - (count - 1)) / (count - 1)));
  found.front() = -largest;
  found.back() = largest;
  return found;
}

CreepTableReader::CreepTableReader(CreepTable table) : table_(std::move(table)) {
  if (!increasing(table_.axis_ratio) || table_.axis_ratio.front() <= 0.0)
    refuse_shape("its ratios of axes do not increase");
  for (std::size_t q = 0; q < 3; ++q) {
    if (table_.creepage[q].size() < 2 || !increasing(table_.creepage[q]))
      refuse_shape("its creepages do not increase");
    for (const double x : table_.creepage[q]) coordinate_[q].push_back(table_coordinate(x));
  }
  const std::vector<double>& spin = table_.creepage[2];
  for (std::size_t k = 0; k < spin.size(); ++k)
    if (spin[k] != -spin[spin.size() - 1 - k]) refuse_shape("its spins are not of both signs");
  if (table_.creepage[0].front() != 0.0 || table_.creepage[1].front() != 0.0)
    refuse_shape("its creepages do not begin with 0");
  if (table_.forces.size() != table_.size() || table_.bars.size() != table_.size() ||
      table_.scale.size() != table_.axis_ratio.size())
    refuse_shape("its forces do not fit its axes");
  for (const double ratio : table_.axis_ratio) log_ratio_.push_back(std::log(ratio));
}

double CreepTableReader::logarithm_of(double axis_ratio) const {
  const double low = table_.axis_ratio.front(), high = table_.axis_ratio.back();
  if (!(axis_ratio >= low * (1.0 - ratio_let_pass) && axis_ratio <= high * (1.0 + ratio_let_pass)))
    throw contact::InputError(fmt::format(
        "table: a/b = {:g}: allowed: {:g} to {:g}; do: make a table with [table] axis_ratio that "
        "holds it",
        axis_ratio, low, high));
  return std::log(std::clamp(axis_ratio, low, high));
}

Scaled CreepTableReader::scale_at(double axis_ratio) const {
  const AxisWeights weights = axis_weights(log_ratio_, logarithm_of(axis_ratio), false);
  Scaled logarithm{};
  for (int r = 0; r < 4; ++r) {
    if (weights.weight[r] == 0.0) continue;
    const Scaled& factor = table_.scale[static_cast<std::size_t>(weights.first + r)];
    for (std::size_t q = 0; q < 3; ++q) logarithm[q] += weights.weight[r] * std::log(factor[q]);
  }
  return {std::exp(logarithm[0]), std::exp(logarithm[1]), std::exp(logarithm[2])};
}

TableForces CreepTableReader::at(double axis_ratio, const Scaled& creepage) const {
  double shrunk = 1.0;
  for (std::size_t q = 0; q < 3; ++q) {
    if (!std::isfinite(creepage[q]))
      throw contact::InputError(
          "table: a creepage is not finite; allowed: numbers; do: look where "
          "it comes from");
    const double end = table_.creepage[q].back();
    if (std::abs(creepage[q]) * shrunk > end) shrunk = end / std::abs(creepage[q]);
  }
  const double along = creepage[0] < 0.0 ? -1.0 : 1.0, across = creepage[1] < 0.0 ? -1.0 : 1.0;
  // Reversing all creepages reverses all forces; mirroring reverses eta, phi, F_y and M_z. Both
  // together reverse xi and F_x.
  const Scaled positive{along * creepage[0], across * creepage[1], across * creepage[2]};
  Stencil stencil;
  stencil.ratio = axis_weights(log_ratio_, logarithm_of(axis_ratio), false);
  for (std::size_t q = 0; q < 3; ++q) {
    const double end = coordinate_[q].back();
    const double place = std::clamp(table_coordinate(shrunk * positive[q]), -end, end);
    for (const AtZero zero : {AtZero::smooth, AtZero::bent})
      stencil.creepage[q][static_cast<std::size_t>(zero)] =
          axis_weights(coordinate_[q], place, q < 2, zero);
  }
  TableForces found;
  found.forces = {along * sum_of(table_, stencil, 0), across * sum_of(table_, stencil, 1),
                  across * sum_of(table_, stencil, 2)};
  const double size = std::hypot(found.forces[0], found.forces[1]);
  if (size > 1.0)
    for (std::size_t q = 0; q < 2; ++q) found.forces[q] /= size;
  const auto bars = bars_of(table_, stencil);
  found.force_bar = bars[0] + table_.interpolation.force_95;
  found.moment_bar = bars[1] + table_.interpolation.moment_95;
  return found;
}

TableForces CreepTableReader::physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                                       double friction_bound, const Scaled& creepage) const {
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(semi_axis_x) || !positive(semi_axis_y) || !positive(shear_modulus) ||
      !positive(friction_bound))
    throw contact::InputError(
        "table: semi-axes, shear modulus and mu F_n: allowed: positive numbers; do: look where "
        "they come from");
  const double ratio = semi_axis_x / semi_axis_y, c2 = semi_axis_x * semi_axis_y;
  const double c = std::sqrt(c2), stiffness = shear_modulus * c2 / friction_bound;
  const Scaled scale = scale_at(ratio);
  TableForces found =
      at(ratio, {scale[0] * stiffness * creepage[0], scale[1] * stiffness * creepage[1],
                 scale[2] * stiffness * c * creepage[2]});
  found.forces = {friction_bound * found.forces[0], friction_bound * found.forces[1],
                  friction_bound * c * found.forces[2]};
  found.force_bar *= friction_bound;
  found.moment_bar *= friction_bound * c;
  return found;
}

}  // namespace rollfem::postprocess
