// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/discretisation/elasticity_kernel.hpp"

#include "base/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>

// Vectors of 64 bytes never cross the boundary of a non-inlined function.
#pragma GCC diagnostic ignored "-Wpsabi"

#define ROLLFEM_INLINE inline __attribute__((always_inline))

namespace rollfem::fem {

namespace {

// Nodes of a batch of cells between memory (four entries per node) and rows of lanes (one component
// per row).

/// A register of this many bytes. GCC 12 implements vectors wider than the registers of the
/// instruction set through memory, six times slower.
template <typename Number, int bytes>
struct Simd {
  using type [[gnu::vector_size(bytes)]] = Number;
};

/// Four lanes of each component from four nodes: the transpose, without its last row.
template <typename Node>
ROLLFEM_INLINE void to_lanes(const Node& a, const Node& b, const Node& c, const Node& d, Node& x,
                             Node& y, Node& z) {
  const Node ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Node cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  x = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  y = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  z = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                              __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5);
}

/// u[component][node][lane] of the cells of a batch. Always four lanes at a time: wider ones are
/// not faster, and narrower ones would process wide shuffles lane by lane.
template <int nodes, typename Number>
ROLLFEM_INLINE void gather_nodes(const unsigned int* offsets, const Number* x, Number* u) {
  using Node = typename NodeEntries<Number>::type;
  constexpr int groups = lanes<Number> / entries_per_node;
  Node* const to = reinterpret_cast<Node*>(u);
  const auto node = [=](unsigned int k) { return *reinterpret_cast<const Node*>(x + k); };
  for (int i = 0; i < nodes * groups; ++i) {
    const unsigned int* const at = offsets + entries_per_node * i;
    to_lanes(node(at[0]), node(at[1]), node(at[2]), node(at[3]), to[i], to[nodes * groups + i],
             to[2 * nodes * groups + i]);
  }
}

/// The reverse, added to y. One node after the other, because lanes may share nodes.
template <int nodes, typename Number>
ROLLFEM_INLINE void scatter_nodes(const Number* u, const unsigned int* offsets, Number* y) {
  using Node = typename NodeEntries<Number>::type;
  constexpr int groups = lanes<Number> / entries_per_node;
  const Node* const from = reinterpret_cast<const Node*>(u);
  const auto node = [=](unsigned int k) -> Node& { return *reinterpret_cast<Node*>(y + k); };
  for (int i = 0; i < nodes * groups; ++i) {
    const unsigned int* const at = offsets + entries_per_node * i;
    const Node a = from[i], b = from[nodes * groups + i], c = from[2 * nodes * groups + i];
    const Node zero{};
    const Node ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const Node cz = __builtin_shufflevector(c, zero, 0, 4, 1, 5);
    node(at[0]) += __builtin_shufflevector(ab, cz, 0, 1, 4, 5);
    node(at[1]) += __builtin_shufflevector(ab, cz, 2, 3, 6, 7);
    const Node ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Node cz_high = __builtin_shufflevector(c, zero, 2, 6, 3, 7);
    node(at[2]) += __builtin_shufflevector(ab_high, cz_high, 0, 1, 4, 5);
    node(at[3]) += __builtin_shufflevector(ab_high, cz_high, 2, 3, 6, 7);
  }
}

/// Prefetches the nodes of the next batch while this one is computed. Neighbours in single
/// precision share cache lines, so that prefetching some of them is sufficient (measured).
template <typename Number>
ROLLFEM_INLINE void fetch_nodes(const unsigned int* offsets, int nodes, const Number* x,
                                const Number* y) {
  constexpr int step = lanes<Number> == 16 ? 4 : 1;
  for (int i = 0; i < nodes * lanes<Number>; i += step) {
    __builtin_prefetch(x + offsets[i]);
    __builtin_prefetch(y + offsets[i], 1);
  }
}

/// One-dimensional matrices at the Gauss points.
template <int n>
struct Shape {
  double value[n][n];     ///< [point][node]: Lagrange polynomials
  double gradient[n][n];  ///< [point][point]: derivative of the interpolant through the points
};

template <int n>
constexpr Shape<n> make_shape();

template <>
constexpr Shape<2> make_shape<2>() {
  constexpr double r = 0.577350269189625764509148780502;  // sqrt(1/3)
  constexpr double a = (1 + r) / 2, b = (1 - r) / 2, g = 1 / r;
  return {{{a, b}, {b, a}}, {{-g, g}, {-g, g}}};
}

template <>
constexpr Shape<3> make_shape<3>() {
  // Nodes 0, 1/2, 1; points (1 -+ r)/2 and 1/2, r = sqrt(3/5): the factors of the Lagrange formula.
  constexpr double r = 0.774596669241483377035853079956;
  constexpr double a = r * (1 + r) / 2, b = 1 - r * r, c = -r * (1 - r) / 2;
  constexpr double d = 1 / r;
  return {{{a, b, c}, {0, 1, 0}, {c, b, a}}, {{-3 * d, 4 * d, -d}, {-d, 0, d}, {d, -4 * d, 3 * d}}};
}

/// Weights of the Gauss points of the unit cube.
template <int n, typename Number>
constexpr std::array<Number, n * n * n> gauss_weights() {
  constexpr auto one = [](int point) { return n == 2 ? 0.5 : point == 1 ? 4.0 / 9.0 : 5.0 / 18.0; };
  std::array<Number, n * n * n> weights{};
  for (int q = 0; q < n * n * n; ++q)
    weights[q] = static_cast<Number>(one(q % n) * one(q / n % n) * one(q / (n * n)));
  return weights;
}

/// M or its transpose times x; for three nodes by even and odd parts, because both matrices are
/// symmetric or antisymmetric when points and nodes are counted from the other end.
template <int n, bool transpose, typename V, typename Number>
ROLLFEM_INLINE void multiply(const double (&m)[n][n], bool odd, const V (&x)[n], V (&out)[n]) {
  const auto entry = [&](int i, int j) {
    return static_cast<Number>(transpose ? m[j][i] : m[i][j]);
  };
  if constexpr (n == 3) {
    const V sum = x[0] + x[2], difference = x[0] - x[2];
    const Number half_sum = (entry(0, 0) + entry(0, 2)) / 2;
    const Number half_difference = (entry(0, 0) - entry(0, 2)) / 2;
    const V uneven = half_difference * difference;
    V even = half_sum * sum;
    if (entry(0, 1) != 0) even += entry(0, 1) * x[1];
    out[0] = even + uneven;
    out[2] = odd ? uneven - even : even - uneven;
    if (odd)
      out[1] = entry(1, 0) * difference;
    else
      out[1] = transpose ? entry(1, 0) * sum + entry(1, 1) * x[1] : x[1];
  } else {
#pragma GCC unroll 4
    for (int i = 0; i < n; ++i) {
      out[i] = entry(i, 0) * x[0];
#pragma GCC unroll 4
      for (int j = 1; j < n; ++j) out[i] += entry(i, j) * x[j];
    }
  }
}

/// Number of registers for one row of a batch's lanes, which is also the stride of rows in memory.
template <typename V>
constexpr int parts = 64 / static_cast<int>(sizeof(V));

/// out (+)= M in along one direction of an n^3 array; `transpose` takes M^T. `odd`: the matrix of
/// derivatives, otherwise of values. Entries of `in` and `out` are `in_step` and `out_step` apart.
template <int n, int direction, bool transpose, bool odd, bool add, typename V, typename Number,
          int in_step = 1, int out_step = 1>
ROLLFEM_INLINE void contract(const double (&matrix)[n][n], const V* in, V* out) {
  constexpr int stride = direction == 0 ? 1 : direction == 1 ? n : n * n;
  for (int line = 0; line < n * n; ++line) {
    const int start = direction == 0   ? line * n
                      : direction == 1 ? (line / n) * n * n + line % n
                                       : line;
    V x[n], product[n];
#pragma GCC unroll 4
    for (int i = 0; i < n; ++i) x[i] = in[(start + i * stride) * in_step];
    multiply<n, transpose, V, Number>(matrix, odd, x, product);
#pragma GCC unroll 4
    for (int i = 0; i < n; ++i) {
      if (add)
        out[(start + i * stride) * out_step] += product[i];
      else
        out[(start + i * stride) * out_step] = product[i];
    }
  }
}

/// One register's part of a batch of CellBatches, entries parts<V> apart, and the number of
/// functions for the dilatation.
template <typename V>
struct CellData {
  const V *geometry, *flow, *dilatation;
  bool parallelepipeds;
};
template <int n>
constexpr int dilatation_functions = n == 2 ? 1 : 4;

/// Trace of grad u = h^T g.
template <typename V>
ROLLFEM_INLINE V trace(const V* h, const V (&g)[3][3]) {
  V sum{};
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c)
    sum += g[c][0] * h[c * parts<V>] + g[c][1] * h[(3 + c) * parts<V>] +
           g[c][2] * h[(6 + c) * parts<V>];
  return sum;
}

/// g[c][e] = d u_c / d xi_e, times the geometry: stress, pulled back in place. One quadrature
/// point. With h = sqrt(w) dxi/dx, grad u = h^T g and the integrand is (h^T grad v) : sigma.
/// `projected` is sqrt(w) lambda times the projected dilatation; null: the dilatation of g.
template <typename V, typename Number>
ROLLFEM_INLINE void apply_stress(const V* h, const LameConstants<Number>& material,
                                 const V* projected, V (&g)[3][3]) {
  V grad[3][3];
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c)
#pragma GCC unroll 3
    for (int d = 0; d < 3; ++d)
      grad[c][d] = g[c][0] * h[d * parts<V>] + g[c][1] * h[(3 + d) * parts<V>] +
                   g[c][2] * h[(6 + d) * parts<V>];
  const V pressure =
      projected != nullptr ? *projected : material.lambda * (grad[0][0] + grad[1][1] + grad[2][2]);
  V s[3][3];
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c) s[c][c] = pressure + 2 * material.mu * grad[c][c];
  s[0][1] = s[1][0] = material.mu * (grad[0][1] + grad[1][0]);
  s[0][2] = s[2][0] = material.mu * (grad[0][2] + grad[2][0]);
  s[1][2] = s[2][1] = material.mu * (grad[1][2] + grad[2][1]);
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c)
#pragma GCC unroll 3
    for (int e = 0; e < 3; ++e)
      g[c][e] = s[c][0] * h[3 * e * parts<V>] + s[c][1] * h[(3 * e + 1) * parts<V>] +
                s[c][2] * h[(3 * e + 2) * parts<V>];
}

template <int points, typename V>
ROLLFEM_INLINE void gather_point(const V (&gradient)[3][3][points], int q, V (&g)[3][3]) {
#pragma GCC unroll 3
  for (int c = 0; c < 3; ++c)
#pragma GCC unroll 3
    for (int e = 0; e < 3; ++e) g[c][e] = gradient[c][e][q];
}

/// lambda times the coefficients of the projected dilatation.
template <int n, typename V, typename Number>
ROLLFEM_INLINE void project(const CellData<V>& cell, const LameConstants<Number>& material,
                            const V (&gradient)[3][3][n * n * n], V* coefficients) {
  constexpr int functions = dilatation_functions<n>;
  for (int k = 0; k < functions; ++k) coefficients[k] = V{};
  for (int q = 0; q < n * n * n; ++q) {
    V g[3][3];
    gather_point<n * n * n>(gradient, q, g);
    const V dilatation = trace(cell.geometry + 9 * q * parts<V>, g);
#pragma GCC unroll 4
    for (int k = 0; k < functions; ++k)
      coefficients[k] += cell.dilatation[(functions * q + k) * parts<V>] * dilatation;
  }
  for (int k = 0; k < functions; ++k) coefficients[k] *= material.lambda;
}

/// At every quadrature point: the stress of the gradient less the flux of momentum, pulled back.
/// Parallelepipeds have one geometry matrix, and the weights are those of the quadrature.
template <int n, bool projected, bool flows, bool parallelepiped, typename V, typename Number>
ROLLFEM_INLINE void apply_law(const CellData<V>& cell, const LameConstants<Number>& material,
                              V (&gradient)[3][3][n * n * n]) {
  constexpr int functions = dilatation_functions<n>;
  V coefficients[functions];
  if constexpr (projected) project<n>(cell, material, gradient, coefficients);
  for (int q = 0; q < n * n * n; ++q) {
    V g[3][3];
    gather_point<n * n * n>(gradient, q, g);
    [[maybe_unused]] V pressure{}, along[3];
    if constexpr (projected) {
#pragma GCC unroll 4
      for (int k = 0; k < functions; ++k)
        pressure += cell.dilatation[(functions * q + k) * parts<V>] * coefficients[k];
    }
    if constexpr (flows) {
      const V* const a = cell.flow + 3 * q * parts<V>;
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c)
        along[c] = a[0] * g[c][0] + a[parts<V>] * g[c][1] + a[2 * parts<V>] * g[c][2];
    }
    if constexpr (parallelepiped) {
      constexpr auto weights = gauss_weights<n, Number>();
      const LameConstants<Number> weighted{weights[q] * material.lambda, weights[q] * material.mu};
      apply_stress(cell.geometry, weighted, static_cast<const V*>(nullptr), g);
    } else {
      apply_stress(cell.geometry + 9 * q * parts<V>, material, projected ? &pressure : nullptr, g);
    }
    if constexpr (flows) {
      const V* const a = cell.flow + 3 * q * parts<V>;
#pragma GCC unroll 3
      for (int c = 0; c < 3; ++c)
#pragma GCC unroll 3
        for (int e = 0; e < 3; ++e) g[c][e] -= a[e * parts<V>] * along[c];
    }
#pragma GCC unroll 3
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 3
      for (int e = 0; e < 3; ++e) gradient[c][e][q] = g[c][e];
  }
}

/// u = K_cell u for the cells of one register, u[component][node] parts<V> apart.
template <int n, typename V, typename Number>
ROLLFEM_INLINE void cell_product(const CellData<V>& cell, const LameConstants<Number>& material,
                                 V* u) {
  constexpr int nodes = n * n * n;
  constexpr Shape<n> shape = make_shape<n>();
  V gradient[3][3][nodes];
  constexpr int step = parts<V>;
  V work[nodes], v[nodes];
  for (int c = 0; c < 3; ++c) {
    contract<n, 0, false, false, false, V, Number, step, 1>(shape.value, u + c * nodes * step,
                                                            work);
    contract<n, 1, false, false, false, V, Number>(shape.value, work, v);
    contract<n, 2, false, false, false, V, Number>(shape.value, v, work);
    contract<n, 0, false, true, false, V, Number>(shape.gradient, work, gradient[c][0]);
    contract<n, 1, false, true, false, V, Number>(shape.gradient, work, gradient[c][1]);
    contract<n, 2, false, true, false, V, Number>(shape.gradient, work, gradient[c][2]);
  }
  // Decided once per batch, so that bodies at rest have no overhead.
  if (cell.parallelepipeds)
    apply_law<n, false, false, true>(cell, material, gradient);
  else if (cell.dilatation == nullptr && cell.flow == nullptr)
    apply_law<n, false, false, false>(cell, material, gradient);
  else if (cell.dilatation == nullptr)
    apply_law<n, false, true, false>(cell, material, gradient);
  else if (cell.flow == nullptr)
    apply_law<n, true, false, false>(cell, material, gradient);
  else
    apply_law<n, true, true, false>(cell, material, gradient);
  for (int c = 0; c < 3; ++c) {
    contract<n, 0, true, true, false, V, Number>(shape.gradient, gradient[c][0], work);
    contract<n, 1, true, true, true, V, Number>(shape.gradient, gradient[c][1], work);
    contract<n, 2, true, true, true, V, Number>(shape.gradient, gradient[c][2], work);
    contract<n, 2, true, false, false, V, Number>(shape.value, work, v);
    contract<n, 1, true, false, false, V, Number>(shape.value, v, work);
    contract<n, 0, true, false, false, V, Number, 1, step>(shape.value, work, u + c * nodes * step);
  }
}

template <int n, typename V, typename Number>
ROLLFEM_INLINE CellData<V> data_of(const CellBatches<Number>& cells, std::size_t batch, int at) {
  constexpr std::size_t points = n * n * n, width = lanes<Number>;
  const auto part = [=](const Number* data, std::size_t items) {
    return data == nullptr ? nullptr
                           : reinterpret_cast<const V*>(data + batch * items * width) + at;
  };
  return {part(cells.geometry, cells.parallelepipeds ? 9 : 9 * points),
          part(cells.flow, 3 * points), part(cells.dilatation, dilatation_functions<n> * points),
          cells.parallelepipeds};
}

template <int n, int bytes, typename Number>
ROLLFEM_INLINE void add_product(const CellBatches<Number>& cells,
                                const LameConstants<Number>& material, const Number* x, Number* y) {
  using V = typename Simd<Number, bytes>::type;
  constexpr int nodes = n * n * n;
  alignas(64) Number u[3 * nodes * lanes<Number>];
  for (std::size_t batch = 0; batch < cells.count; ++batch) {
    const unsigned int* const offsets = cells.nodes + batch * nodes * lanes<Number>;
    if (batch + 1 < cells.count) fetch_nodes(offsets + nodes * lanes<Number>, nodes, x, y);
    gather_nodes<nodes>(offsets, x, u);
    for (int part = 0; part < parts<V>; ++part)
      cell_product<n, V, Number>(data_of<n, V>(cells, batch, part), material,
                                 reinterpret_cast<V*>(u) + part);
    scatter_nodes<nodes>(u, offsets, y);
  }
}

template <int n, int bytes, typename Number>
ROLLFEM_INLINE void element_matrices(const CellBatches<Number>& cells,
                                     const LameConstants<Number>& material, std::size_t batch,
                                     Number* matrices) {
  using V = typename Simd<Number, bytes>::type;
  constexpr int width = lanes<Number>, dofs = 3 * n * n * n;
  alignas(64) Number u[dofs * width];
  for (int column = 0; column < dofs; ++column) {
    for (int i = 0; i < dofs * width; ++i) u[i] = static_cast<Number>(i / width == column ? 1 : 0);
    for (int part = 0; part < parts<V>; ++part)
      cell_product<n, V, Number>(data_of<n, V>(cells, batch, part), material,
                                 reinterpret_cast<V*>(u) + part);
    for (int i = 0; i < dofs; ++i)
      for (int lane = 0; lane < width; ++lane)
        matrices[(static_cast<std::size_t>(i) * dofs + column) * width + lane] =
            u[i * width + lane];
  }
}

// The same code compiled for each instruction set; attributes cannot stand in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define ROLLFEM_VARIANT(name, bytes, attribute)                                                    \
  template <int n, typename Number>                                                                \
  attribute void add_product_##name(const CellBatches<Number>& cells,                              \
                                    const LameConstants<Number>& material, const Number* x,        \
                                    Number* y) {                                                   \
    add_product<n, bytes, Number>(cells, material, x, y);                                          \
  }                                                                                                \
  template <int n, typename Number>                                                                \
  attribute void element_matrices_##name(const CellBatches<Number>& cells,                         \
                                         const LameConstants<Number>& material, std::size_t batch, \
                                         Number* matrices) {                                       \
    element_matrices<n, bytes, Number>(cells, material, batch, matrices);                          \
  }                                                                                                \
  template <int n, typename Number>                                                                \
  ElasticityKernel<Number> kernel_##name() {                                                       \
    return {&add_product_##name<n, Number>, &element_matrices_##name<n, Number>};                  \
  }
// NOLINTEND(bugprone-macro-parentheses)

ROLLFEM_VARIANT(sse2, 16, )
#ifdef __x86_64__
ROLLFEM_VARIANT(avx2, 32, __attribute__((target("avx2,fma"))))
ROLLFEM_VARIANT(avx512, 64, __attribute__((target("avx512f,avx512dq,avx512vl,fma"))))
#endif

template <int n, typename Number>
ElasticityKernel<Number> kernel_of(const std::string& variant) {
#ifdef __x86_64__
  if (variant == "avx512") return kernel_avx512<n, Number>();
  if (variant == "avx2") return kernel_avx2<n, Number>();
#endif
  return kernel_sse2<n, Number>();
}

}  // namespace

std::vector<std::string> simd_variants() {
  std::vector<std::string> all{"sse2"};
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.emplace_back("avx2");
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    all.emplace_back("avx512");
#endif
  return all;
}

std::string simd_variant() {
  const std::vector<std::string> all = simd_variants();
  const char* wanted = std::getenv("ROLLFEM_SIMD");
  if (wanted == nullptr || *wanted == '\0') return all.back();
  if (std::find(all.begin(), all.end(), wanted) != all.end()) return wanted;
  std::string allowed;
  for (const std::string& variant : all) allowed += (allowed.empty() ? "" : ", ") + variant;
  throw contact::InputError("ROLLFEM_SIMD = " + std::string(wanted) +
                            ": not an instruction set of this processor; allowed: " + allowed +
                            "; do: choose one of these, or unset it");
}

template <typename Number>
ElasticityKernel<Number> elasticity_kernel(int degree, const std::string& variant) {
  if (degree == 1) return kernel_of<2, Number>(variant);
  if (degree == 2) return kernel_of<3, Number>(variant);
  throw std::invalid_argument("elasticity_kernel: only degrees 1 and 2 are supported");
}

template ElasticityKernel<float> elasticity_kernel(int, const std::string&);
template ElasticityKernel<double> elasticity_kernel(int, const std::string&);

}  // namespace rollfem::fem
