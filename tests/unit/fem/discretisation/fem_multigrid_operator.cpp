// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrix-free stiffness: rigid motions, strain energy, symmetry, diagonal and the two
// precisions, on skew cells with hanging nodes; on any number of processes.
#include "fem/discretisation/elasticity_operator.hpp"

#include <fmt/format.h>

#include "support/fem_elastic_block.hpp"
#include "support/mpi_environment.hpp"

namespace {

using dealii::Point;
using dealii::Tensor;
using fem::Vector;

/// Every variant of the kernel: degree, projected dilatation, inertia.
struct Variant {
  unsigned int degree;
  double poisson_ratio = 0.3;
  double speed = 0;  ///< mm/s, slantwise
};

void PrintTo(const Variant& of, std::ostream* stream) {
  *stream << "degree " << of.degree << ", nu " << of.poisson_ratio << ", speed " << of.speed;
}

class Stiffness : public ::testing::TestWithParam<Variant> {
 protected:
  Stiffness()
      : block(options(), {}), cells(fem::make_local_cells(block.problem())), stiffness(cells) {}

  static BlockOptions options() {
    BlockOptions result;
    result.degree = GetParam().degree;
    result.material.poisson_ratio = GetParam().poisson_ratio;
    result.motion.velocity = GetParam().speed * Tensor<1, 3>({0.6, 0.0, 0.8});
    result.bend = 0.2;
    return result;
  }
  /// Nodal values of a field, zero at constrained dofs: they are not unknowns.
  template <typename F>
  Vector unknowns_of(const F& field) const {
    auto x = stiffness.make_vector();
    block.for_each_dof([&](const Point<3>& p, unsigned int component, auto dof) {
      if (x.in_local_range(dof)) x(dof) = field(p)[component];
    });
    for (const unsigned int row : cells.dofs->owned_constrained()) x.local_element(row) = 0;
    return x;
  }
  Vector rough(double seed) const {
    return unknowns_of([=](const Point<3>& p) {
      Tensor<1, 3> u;
      for (unsigned int c = 0; c < 3; ++c)
        u[c] = std::sin(seed * (91 * p[0] + 57 * p[1] - 73 * p[2] + c));
      return u;
    });
  }
  Vector times(const Vector& x) const {
    auto product = stiffness.make_vector();
    stiffness.vmult(product, x);
    return product;
  }

  Block block;
  fem::LocalCells cells;
  fem::ElasticityOperator<double> stiffness;
};

TEST_P(Stiffness, HasHangingNodesToDealWith) {
  EXPECT_GT(dealii::Utilities::MPI::sum(cells.dofs->owned_hanging, MPI_COMM_WORLD), 35U);
}

TEST_P(Stiffness, ResistsNoRigidMotion) {
  const double scale = times(rough(1)).linfty_norm();
  for (unsigned int axis = 0; axis < 3; ++axis) {
    Tensor<1, 3> e;
    e[axis] = 1;
    EXPECT_LT(times(unknowns_of([&](const Point<3>&) { return e; })).linfty_norm(), 1e-12 * scale);
    if (GetParam().speed > 0) continue;  // a turned body has other accelerations
    EXPECT_LT(times(unknowns_of([&](const Point<3>& p) {
                return dealii::cross_product_3d(e, Tensor<1, 3>(p));
              })).linfty_norm(),
              1e-12 * scale);
  }
}

// W = V/2 (lambda tr(eps)^2 + 2 mu eps:eps - rho |grad u v|^2) for a uniform gradient, V = 12 mm^3.
TEST_P(Stiffness, StoresTheStrainEnergyOfUniformStrain) {
  Tensor<2, 3> gradient;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j) gradient[i][j] = 0.3 + 0.7 * i - 0.4 * j + 0.2 * i * j;
  const auto u = unknowns_of([&](const Point<3>& p) { return gradient * Tensor<1, 3>(p); });
  const auto strain = dealii::symmetrize(gradient);
  const auto& material = block.problem().material;
  const double e = material.young_modulus, nu = material.poisson_ratio;
  const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
  const double momentum =
      material.density * (gradient * block.problem().motion.velocity).norm_square();
  const double exact = 6 * (lambda * dealii::trace(strain) * dealii::trace(strain) +
                            2 * mu * (strain * strain) - momentum);
  EXPECT_NEAR(0.5 * (u * times(u)), exact, 1e-12 * exact);
}

TEST_P(Stiffness, IsSymmetricAndPositive) {
  const auto x = rough(1), y = rough(0.37);
  const auto kx = times(x), ky = times(y);
  EXPECT_NEAR(x * ky, y * kx, 1e-12 * std::sqrt((x * kx) * (y * ky)));
  EXPECT_GT(x * kx, 0);
}

TEST_P(Stiffness, DiagonalIsThatOfTheProducts) {
  const auto inverse = stiffness.inverse_diagonal();
  const auto size = inverse.size();
  for (dealii::types::global_dof_index dof = 1; dof < size; dof += size / 23) {
    auto unit = stiffness.make_vector();
    if (unit.in_local_range(dof)) unit(dof) = 1;
    const double diagonal = unit * times(unit);
    EXPECT_NEAR((unit * inverse) * diagonal, 1, 1e-12) << "dof " << dof;
  }
}

TEST_P(Stiffness, AssembledEntriesGiveTheSameProduct) {
  const auto x = rough(1);
  // x^T K x from the lower triangle; unconstrained columns of other processes are needed, so x is
  // taken with all its entries.
  std::vector<double> all(x.size(), 0);
  for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
    all[x.get_partitioner()->local_to_global(i)] = x.local_element(i);
  dealii::Utilities::MPI::sum(all, MPI_COMM_WORLD, all);
  double energy = 0;
  for (const auto& entry : stiffness.assemble())
    energy +=
        (entry.row == entry.column ? 1 : 2) * all[entry.row] * entry.value * all[entry.column];
  const double exact = x * times(x);
  EXPECT_NEAR(dealii::Utilities::MPI::sum(energy, MPI_COMM_WORLD), exact, 1e-12 * exact);
}

TEST_P(Stiffness, SinglePrecisionAgrees) {
  const fem::ElasticityOperator<float> single(cells);
  const auto x = rough(1);
  auto x_single = single.make_vector(), product = x_single;
  x_single = x;
  single.vmult(product, x_single);
  const auto exact = times(x);
  Vector difference = exact;
  for (unsigned int i = 0; i < difference.locally_owned_size(); ++i)
    difference.local_element(i) -= static_cast<double>(product.local_element(i));
  EXPECT_LT(difference.linfty_norm(), 1e-5 * exact.linfty_norm());
}

constexpr double fast = 2e6;  // mm/s, 0.68 of steel's Rayleigh speed

INSTANTIATE_TEST_SUITE_P(Variants, Stiffness,
                         ::testing::Values(Variant{1}, Variant{2}, Variant{1, 0.48},
                                           Variant{2, 0.48}, Variant{1, 0.3, fast},
                                           Variant{2, 0.3, fast}, Variant{1, 0.48, fast},
                                           Variant{2, 0.48, fast}),
                         [](const auto& test) {
                           const Variant& v = test.param;
                           return fmt::format("Degree{}Poisson{:.0f}{}", v.degree,
                                              100 * v.poisson_ratio, v.speed > 0 ? "Fast" : "");
                         });

}  // namespace
