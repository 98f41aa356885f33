// SPDX-License-Identifier: LGPL-2.1-or-later
// Fraction of a core's peak performance reached by finite elements: the product with the
// matrix-free stiffness in both precisions against bandwidth and matrix multiplication of this
// machine, the factorisation against matrix multiplication. Half a rail of case a, one process, CPU
// seconds, best of several.
//   benchmark_fem_roofline product CELL_MM ... factorisation CELL_MM ...
#include "fem/discretisation/body.hpp"
#include "fem/discretisation/elasticity_assembly.hpp"
#include "fem/discretisation/elasticity_operator.hpp"
#include "fem/linear/cholmod.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <limits>
#include <string>
#include <vector>

extern "C" {
void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*,
            const double*, const int*, const double*, const int*, const double*, double*,
            const int*);
void sgemm_(const char*, const char*, const int*, const int*, const int*, const float*,
            const float*, const int*, const float*, const int*, const float*, float*, const int*);
}

using namespace rollfem;

namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <typename F>
double best_seconds(int repetitions, const F& f) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repetitions; ++k) {
    const double begin = cpu_seconds();
    f();
    best = std::min(best, cpu_seconds() - begin);
  }
  return best;
}

/// GFlop/s of a product of square matrices.
template <typename Number, typename Gemm>
double multiplication(const Gemm& gemm) {
  constexpr int n = 1024;
  const std::vector<Number> a(n * n, Number(1)), b(a);
  std::vector<Number> c(a);
  const Number one = 1, zero = 0;
  const double seconds = best_seconds(5, [&] {
    gemm("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
  });
  return 2e-9 * std::pow(n, 3) / seconds;
}

/// GB/s of a = b + s c on arrays beyond the cache.
double bandwidth() {
  constexpr std::size_t n = 20'000'000;
  std::vector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  const double seconds = best_seconds(5, [&] {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 0.5 * c[i];
  });
  return 24e-9 * static_cast<double>(n) / seconds;
}

/// Operations on one cell of degree 2, counted from the loops of elasticity_kernel.cpp: for each
/// component six products of nine lines with values, of eight operations by even and odd parts, and
/// six with derivatives, of nine, two of which add; at each of 27 points two products with the
/// geometry and Hooke's law; the sum into the result.
constexpr double cell_operations = 3 * (6 * 9 * 8 + 6 * 9 * 9 + 2 * 27) + 27 * (2 * 45 + 15) + 81;

fem::Body rail(double cell) {
  constexpr double semi_axis_x = 3.79236, semi_axis_y = 10.87295;  // Hertz's ellipse of case a, mm
  fem::BodyOptions options;
  options.cell_size = cell;
  options.fine_half_length = 1.1 * std::ceil(semi_axis_x / cell) * cell;
  options.fine_half_width = 1.1 * std::ceil(semi_axis_y / cell) * cell;
  options.extent = 8 * semi_axis_y;
  options.half = true;
  return fem::Body({false, contact::infinity, 2000.0}, {}, options, MPI_COMM_WORLD);
}

/// `straightened`: as on multigrid's levels; 0: the true geometry.
template <typename Number>
void measure_product(const fem::LocalCells& cells, double straightened, double gigaflops,
                     double gigabytes) {
  const fem::ElasticityOperator<Number> stiffness(cells, straightened);
  auto x = stiffness.make_vector(), y = x;
  x = Number(1);
  const double unknowns = static_cast<double>(x.size());
  const double seconds = best_seconds(20, [&] { stiffness.vmult(y, x); });
  const double operations = cell_operations * static_cast<double>(cells.count) / seconds;
  // Data stored once; x and y copied, the result cleared, gathered and summed up.
  const double bytes = (stiffness.memory_bytes() + 6.0 * unknowns * sizeof(Number)) / seconds;
  fmt::print("| product, {} | {:.0f} | {:.1f} | {:.1f} | {:.0f} | {:.1f} | {:.0f} |\n",
             straightened > 0      ? "single, on a level"
             : sizeof(Number) == 4 ? "single"
                                   : "double",
             unknowns, 1e-6 * unknowns / seconds, 1e-9 * operations, 1e-7 * operations / gigaflops,
             1e-9 * bytes, 1e-7 * bytes / gigabytes);
}

void measure_factorisation(const fem::Body& body, double gigaflops) {
  const auto problem = body.problem();
  auto unknowns = fem::number_free_unknowns(problem.dofs, problem.constraints);
  fem::order_for_elimination(problem.dofs, unknowns);
  const auto matrix = fem::assemble(problem, {&unknowns}).front();
  double operations = 0;
  const double seconds = best_seconds(1, [&] {
    const fem::CholeskyFactor factor(matrix, {"factorisation", "none"});
    operations = factor.operations();
  });
  fmt::print("| factorisation | {} | | {:.1f} | {:.0f} | | |\n", body.unknowns(),
             1e-9 * operations / seconds, 1e-7 * operations / seconds / gigaflops);
}

}  // namespace

int main(int argc, char** argv) {
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try {
    const double twice = multiplication<double>(dgemm_), once = multiplication<float>(sgemm_);
    const double gigabytes = bandwidth();
    fmt::print("one core: {:.1f} GFlop/s in double, {:.1f} in single precision, {:.1f} GB/s\n\n",
               twice, once, gigabytes);
    fmt::print(
        "| what | unknowns | 10^6 unknowns/s | GFlop/s | % | GB/s | % |\n"
        "|---|---|---|---|---|---|---|\n");
    bool factorise = false;
    for (int k = 1; k < argc; ++k) {
      const std::string word = argv[k];
      if (word == "product" || word == "factorisation") {
        factorise = word == "factorisation";
        continue;
      }
      const fem::Body body = rail(std::stod(word));
      if (factorise) {
        measure_factorisation(body, twice);
        continue;
      }
      const fem::LocalCells cells = fem::make_local_cells(body.problem());
      measure_product<float>(cells, 0.02, once, gigabytes);
      measure_product<float>(cells, 0.0, once, gigabytes);
      measure_product<double>(cells, 0.0, twice, gigabytes);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
