// SPDX-License-Identifier: LGPL-2.1-or-later
// Fraction of peak performance reached by the product of the half-space: flops per second against a
// loop of multiply-adds in registers, bytes per second against a triad. One core; prints the rows
// of docs/benchmarks.md.
#include "base/threads.hpp"
#include "halfspace/elasticity/fft.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include <fmt/format.h>

#include "tests/support/thesis_cases.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace {

using namespace rollfem;

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Smallest CPU time of several calls, s.
template <class Work>
double seconds_of(Work&& work) {
  double least = 1e30;
  const double begin = cpu_seconds();
  for (int k = 0; k < 5 || cpu_seconds() - begin < 0.3; ++k) {
    const double before = cpu_seconds();
    work();
    least = std::min(least, cpu_seconds() - before);
  }
  return least;
}

#if defined(__x86_64__)
#define ROLLFEM_FUSED __attribute__((target("avx2,fma")))
#else
#define ROLLFEM_FUSED
#endif

typedef double Four __attribute__((vector_size(32)));

/// Twelve sums at once hide the latency of a multiply-add.
ROLLFEM_FUSED double multiply_adds(long rounds, double first) {
  Four sum[12];
  for (int i = 0; i < 12; ++i) sum[i] = Four{first, first, first, first} * (1.0 + i);
  const Four a = {first, first, first, first};
  const Four b = {1e-9, 1e-9, 1e-9, 1e-9};
  for (long k = 0; k < rounds; ++k)
    for (Four& s : sum) s = s * a + b;
  double total = 0.0;
  for (const Four& s : sum) total += s[0] + s[1] + s[2] + s[3];
  return total;
}

double peak_gigaflops() {
  constexpr long rounds = 10'000'000;
  volatile double one = 1.0;  // unknown to the compiler
  volatile double keep = 0.0;
  const double seconds = seconds_of([&] { keep = keep + multiply_adds(rounds, one); });
  return 2.0 * 4.0 * 12.0 * rounds / seconds * 1e-9;
}

double triad_gigabytes() {
  const std::size_t n = 16'000'000;
  std::vector<double> a(n, 1.0), b(n, 2.0), c(n, 3.0);
  const double seconds = seconds_of([&] {
    for (std::size_t k = 0; k < n; ++k) a[k] = b[k] + 0.5 * c[k];
  });
  return 3.0 * 8.0 * static_cast<double>(n) / seconds * 1e-9;
}

/// Two components forward and back: real transforms of the nonzero rows, complex transforms of all
/// columns (5 n log2 n each, half if real), and 28 flops per frequency between.
double product_flops(double ny, double px, double py) {
  const double columns = px / 2.0 + 1.0;
  const double transforms = ny * 2.5 * px * std::log2(px) + columns * 5.0 * py * std::log2(py);
  return 4.0 * transforms + 28.0 * columns * py;
}

/// Every pass over a spectrum or over the rows, each read and written once: rows, columns and the
/// product with three symbols.
double product_bytes(double ny, double px, double py) {
  const double spectrum = 16.0 * (px / 2.0 + 1.0) * py;
  const double rows = 8.0 * ny * px;
  return 4.0 * (2.0 * rows + 3.0 * spectrum) + (4.0 * spectrum + 1.5 * spectrum);
}

}  // namespace

int main() {
  const double peak = peak_gigaflops();
  const double triad = triad_gigabytes();
  fmt::print("one core: {:.1f} Gflop/s of multiply-adds (AVX2), {:.1f} GB/s of a triad\n\n", peak,
             triad);
  fmt::print(
      "| product of D A_tt, elements across | ms | Gflop/s | of the peak | GB/s | of the triad "
      "|\n|---|---|---|---|---|---|\n");
  const contact::Threads alone(1);
  for (const int across : {40, 80, 160, 320, 640}) {
    const contact::ContactGrid grid = testing::Benchmark9().grid(across);
    const halfspace::HalfspaceCompliance compliance(grid, testing::steel());
    const auto& rolling = compliance.rolling(contact::UpwindOrder::second);
    const contact::TangentialField p{contact::Field::Ones(grid.size()),
                                     contact::Field::Ones(grid.size())};
    const double seconds = seconds_of([&] { rolling.apply(p); });
    const double px = halfspace::good_fft_size(2 * grid.nx + 3);
    const double py = halfspace::good_fft_size(2 * grid.ny);
    const double flops = product_flops(grid.ny, px, py) / seconds * 1e-9;
    const double bytes = product_bytes(grid.ny, px, py) / seconds * 1e-9;
    fmt::print("| {} | {:.3f} | {:.1f} | {:.0f} % | {:.1f} | {:.0f} % |\n", across, 1e3 * seconds,
               flops, 100.0 * flops / peak, bytes, 100.0 * bytes / triad);
  }
  return 0;
}
