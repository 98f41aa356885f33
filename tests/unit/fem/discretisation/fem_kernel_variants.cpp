// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/errors.hpp"
#include "fem/discretisation/elasticity_kernel.hpp"

#include "support/temporary_folder.hpp"

namespace {

using fem::lanes;

/// Numbers at random, the same in every run, from a multiple of 64 bytes.
template <typename Number>
class Numbers {
 public:
  Numbers(std::size_t count, unsigned seed)
      : store_(
            static_cast<Number*>(std::aligned_alloc(64, (count * sizeof(Number) + 63) / 64 * 64)),
            &std::free) {
    std::mt19937 random(seed);
    for (std::size_t i = 0; i < count; ++i)
      store_.get()[i] = static_cast<Number>(random() / static_cast<double>(random.max()) - 0.5);
  }
  Number* data() const { return store_.get(); }

 private:
  std::unique_ptr<Number, decltype(&std::free)> store_;
};

/// A few batches of cells that share nodes, of any geometry: products are sums of the same terms
/// whatever it means.
template <typename Number>
struct Cells {
  static constexpr std::size_t batches = 3, most_nodes = 200;
  int nodes;
  std::vector<unsigned int> offsets;
  Numbers<Number> geometry, flow, dilatation;

  explicit Cells(int degree)
      : nodes((degree + 1) * (degree + 1) * (degree + 1)),
        geometry(batches * 9 * nodes * lanes<Number>, 1),
        flow(batches * 3 * nodes * lanes<Number>, 2),
        dilatation(batches * 4 * nodes * lanes<Number>, 3) {
    std::mt19937 random(4);
    for (std::size_t i = 0; i < batches * nodes * lanes<Number>; ++i)
      offsets.push_back(4 * static_cast<unsigned int>(random() % most_nodes));
  }
  /// Kind 0: parallelepipeds; 1: of any shape; 2: with flow, 3: with dilatation, 4: with both.
  fem::CellBatches<Number> of_kind(int kind) const {
    fem::CellBatches<Number> all;
    all.count = batches;
    all.nodes = offsets.data();
    all.geometry = geometry.data();
    all.parallelepipeds = kind == 0;
    if (kind == 2 || kind == 4) all.flow = flow.data();
    if (kind == 3 || kind == 4) all.dilatation = dilatation.data();
    return all;
  }
};

template <typename Number>
std::vector<Number> product(const fem::ElasticityKernel<Number>& kernel,
                            const fem::CellBatches<Number>& cells) {
  const std::size_t size = 4 * Cells<Number>::most_nodes;
  const Numbers<Number> x(size, 5), y(size, 6);
  kernel.add_product(cells, {Number(1.2), Number(0.8)}, x.data(), y.data());
  return {y.data(), y.data() + size};
}

template <typename Number>
void expect_alike(int degree) {
  const Cells<Number> cells(degree);
  for (int kind = 0; kind < 5; ++kind) {
    const auto plain = product(fem::elasticity_kernel<Number>(degree, "sse2"), cells.of_kind(kind));
    for (const std::string& variant : fem::simd_variants()) {
      const auto other =
          product(fem::elasticity_kernel<Number>(degree, variant), cells.of_kind(kind));
      const double rounding = 200.0 * std::numeric_limits<Number>::epsilon();
      for (std::size_t i = 0; i < plain.size(); ++i) {
        if (i % 4 == 3) continue;  // the entry that does not count
        ASSERT_NEAR(other[i], plain[i], rounding)
            << variant << ", degree " << degree << ", kind " << kind << ", entry " << i;
      }
    }
  }
}

TEST(KernelVariants, GiveTheSameProductsToRounding) {
  for (const int degree : {1, 2}) {
    expect_alike<double>(degree);
    expect_alike<float>(degree);
  }
}

/// The matrix of a cell times a vector is the product of that cell.
TEST(KernelVariants, MultiplyByTheirOwnElementMatrices) {
  constexpr int degree = 2, nodes = 27, dofs = 3 * nodes, width = lanes<double>;
  const Cells<double> cells(degree);
  std::vector<unsigned int> apart(nodes * width);
  for (int i = 0; i < nodes * width; ++i)
    apart[static_cast<std::size_t>(i)] = 4U * static_cast<unsigned int>(i);
  fem::CellBatches<double> one = cells.of_kind(4);
  one.count = 1;
  one.nodes = apart.data();
  const std::size_t size = 4 * apart.size();
  const Numbers<double> x(size, 7);
  for (const std::string& variant : fem::simd_variants()) {
    const auto kernel = fem::elasticity_kernel<double>(degree, variant);
    Numbers<double> y(size, 8);
    std::fill(y.data(), y.data() + size, 0.0);
    kernel.add_product(one, {1.2, 0.8}, x.data(), y.data());
    std::vector<double> matrices(static_cast<std::size_t>(dofs) * dofs * width);
    kernel.element_matrices(one, {1.2, 0.8}, 0, matrices.data());
    for (const int lane : {0, 1, width - 1})
      for (int row = 0; row < dofs; ++row) {
        double sum = 0.0;
        for (int column = 0; column < dofs; ++column)
          sum += matrices[static_cast<std::size_t>((row * dofs + column) * width + lane)] *
                 x.data()[4 * (column % nodes * width + lane) + column / nodes];
        ASSERT_NEAR(y.data()[4 * (row % nodes * width + lane) + row / nodes], sum, 1e-13)
            << variant;
      }
  }
}

TEST(KernelVariants, AreChosenByTheEnvironment) {
  for (const std::string& variant : fem::simd_variants()) {
    setenv("ROLLFEM_SIMD", variant.c_str(), 1);
    EXPECT_EQ(fem::simd_variant(), variant);
  }
  setenv("ROLLFEM_SIMD", "neon", 1);
  EXPECT_TRUE(says(refusal<contact::InputError>([] { fem::simd_variant(); }), "ROLLFEM_SIMD = neon",
                   "allowed: sse2", "unset it"));
  unsetenv("ROLLFEM_SIMD");
  EXPECT_EQ(fem::simd_variant(), fem::simd_variants().back());
}

}  // namespace
