// SPDX-License-Identifier: LGPL-2.1-or-later
// FFT products of the half-space compliance against direct summation, symmetry, definiteness.
#include "halfspace/elasticity/fft.hpp"

#include "base/pi.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"
#include "halfspace/elasticity/influence.hpp"

#include <Eigen/Eigenvalues>

#include "support/random_field.hpp"
#include <complex>
#include <future>

namespace rollfem::halfspace {
namespace {

/// Displacement at any (also exterior) column and row by summing over all elements.
void direct(const ContactGrid& grid, const contact::CombinedMaterial& material,
            const SurfaceField& p, int i, int j, double u[3]) {
  u[0] = u[1] = u[2] = 0.0;
  for (int l = 0; l < grid.ny; ++l)
    for (int k = 0; k < grid.nx; ++k) {
      const Influence a =
          rectangle_influence((i - k) * grid.dx, (j - l) * grid.dy, grid.dx, grid.dy, material);
      const int e = grid.index(k, l);
      u[0] += a.xx * p.x[e] + a.xy * p.y[e] + a.xn * p.n[e];
      u[1] += a.xy * p.x[e] + a.yy * p.y[e] + a.yn * p.n[e];
      u[2] += -a.xn * p.x[e] - a.yn * p.y[e] + a.nn * p.n[e];
    }
}

const contact::CombinedMaterial unlike = contact::combine({210e3, 0.3}, {70e3, 0.33});

TEST(Fft, SizesAreEvenSmoothAndLargeEnough) {
  for (int n = 1; n < 3000; ++n) {
    int size = good_fft_size(n);
    EXPECT_GE(size, n);
    EXPECT_EQ(size % 2, 0);
    for (const int factor : {2, 3, 5, 7})
      while (size % factor == 0) size /= factor;
    EXPECT_EQ(size, 1);
  }
}

TEST(Fft, RoundTripGivesTheFieldBack) {
  const PaddedFft fft(13, 7, 30, 16);
  const Field field = random_field(ContactGrid::centred(13, 7, 1.0, 1.0), 5).n;
  PaddedFft::Spectrum spectrum;
  fft.forward(field, spectrum);
  Field back;
  fft.backward(spectrum, back);
  EXPECT_LT((back - field).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Fft, SpectrumIsTheSumOverAllElements) {
  // Rows go in pairs and eight at a time: one, an odd number, more than eight, and all of a plane.
  for (const auto& [nx, ny, px, py] : {std::array{5, 1, 8, 2}, std::array{6, 7, 12, 14},
                                       std::array{4, 19, 10, 20}, std::array{6, 10, 6, 10}}) {
    const PaddedFft fft(nx, ny, px, py);
    const Field field = random_field(ContactGrid::centred(nx, ny, 1.0, 1.0), 7).n;
    PaddedFft::Spectrum spectrum;
    fft.forward(field, spectrum);
    for (int kx = 0; kx <= px / 2; ++kx)
      for (int ky = 0; ky < py; ++ky) {
        std::complex<double> sum;
        for (int j = 0; j < ny; ++j)
          for (int i = 0; i < nx; ++i)
            sum += field[j * nx + i] * std::polar(1.0, -2.0 * contact::pi *
                                                           (static_cast<double>(kx) * i / px +
                                                            static_cast<double>(ky) * j / py));
        EXPECT_LT(std::abs(spectrum[static_cast<std::size_t>(kx) * py + ky] - sum), 1e-12)
            << nx << ' ' << ny;
      }
  }
}

TEST(Fft, ThreadsThatPlanAndTransformAtOnceGetWhatOneGets) {
  const auto round_trip = [](int n) {
    const PaddedFft fft(n, n + 3, 2 * n, 2 * n + 6);
    const Field field = random_field(ContactGrid::centred(n, n + 3, 1.0, 1.0), 9).n;
    PaddedFft::Spectrum spectrum;
    Field back;
    fft.forward(field, spectrum);
    fft.backward(spectrum, back);
    return back;
  };
  constexpr int sizes = 12;
  std::vector<std::future<std::vector<Field>>> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.push_back(std::async(std::launch::async, [&] {
      std::vector<Field> found;
      for (int n = 0; n < sizes; ++n) found.push_back(round_trip(40 + 5 * n));
      return found;
    }));
  std::vector<std::vector<Field>> found;
  for (auto& thread : threads) found.push_back(thread.get());
  for (int n = 0; n < sizes; ++n) {
    const Field alone = round_trip(40 + 5 * n);
    for (const auto& of_thread : found)
      EXPECT_EQ((of_thread[static_cast<std::size_t>(n)] - alone).cwiseAbs().maxCoeff(), 0.0) << n;
  }
}

class ComplianceOfGrid : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  ContactGrid grid = ContactGrid::centred(GetParam().first, GetParam().second, 0.3, 0.5);
  HalfspaceCompliance compliance{grid, unlike};
};

TEST_P(ComplianceOfGrid, EqualsDirectSummation) {
  const SurfaceField p = random_field(grid, 1);
  const SurfaceField u = compliance.apply(p);
  const double scale = u.n.cwiseAbs().maxCoeff();
  Field normal;
  compliance.normal().apply(p.n, normal);
  const TangentialField shift = compliance.shift().apply({p.x, p.y});
  const SurfaceField tangential_only{p.x, p.y, Field::Zero(grid.size())};
  const SurfaceField normal_only{Field::Zero(grid.size()), Field::Zero(grid.size()), p.n};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int e = grid.index(i, j);
      double all[3], t[3], n[3];
      direct(grid, unlike, p, i, j, all);
      direct(grid, unlike, tangential_only, i, j, t);
      direct(grid, unlike, normal_only, i, j, n);
      EXPECT_NEAR(u.x[e], all[0], 1e-13 * scale);
      EXPECT_NEAR(u.y[e], all[1], 1e-13 * scale);
      EXPECT_NEAR(u.n[e], all[2], 1e-13 * scale);
      EXPECT_NEAR(normal[e], n[2], 1e-13 * scale);
      EXPECT_NEAR(shift.x[e], t[0], 1e-13 * scale);
      EXPECT_NEAR(shift.y[e], t[1], 1e-13 * scale);
    }
}

TEST_P(ComplianceOfGrid, RollingIsTheUpwindDifferenceUpToTheBorder) {
  SurfaceField p = random_field(grid, 3);
  p.n.setZero();
  for (const UpwindOrder order : {UpwindOrder::first, UpwindOrder::second}) {
    const TangentialField w = compliance.rolling(order).apply({p.x, p.y});
    const double scale = w.x.cwiseAbs().maxCoeff();
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        double u0[3], u1[3], u2[3];
        direct(grid, unlike, p, i, j, u0);
        direct(grid, unlike, p, i + 1, j, u1);
        direct(grid, unlike, p, i + 2, j, u2);
        for (int c = 0; c < 2; ++c) {
          const double expected = order == UpwindOrder::first
                                      ? (u0[c] - u1[c]) / grid.dx
                                      : (3 * u0[c] - 4 * u1[c] + u2[c]) / (2 * grid.dx);
          const Field& component = c == 0 ? w.x : w.y;
          EXPECT_NEAR(component[grid.index(i, j)], expected, 1e-12 * scale);
        }
      }
  }
}

TEST_P(ComplianceOfGrid, NormalPreconditionerIsSymmetricPositiveDefinite) {
  const contact::NormalOperator& normal = compliance.normal();
  for (unsigned seed = 30; seed < 40; ++seed) {
    const Field p = random_field(grid, seed).n, q = random_field(grid, seed + 100).n;
    Field of_p, of_q;
    normal.precondition(p, of_p);
    normal.precondition(q, of_q);
    const double energy = p.dot(of_p);
    EXPECT_GT(energy, 0.0);
    EXPECT_NEAR(q.dot(of_p), p.dot(of_q), 1e-12 * energy);
  }
}

TEST_P(ComplianceOfGrid, DiagonalIsTheMeanOfTheMatrixDiagonal) {
  SurfaceField unit = {Field::Zero(grid.size()), Field::Zero(grid.size()),
                       Field::Zero(grid.size())};
  const int e = grid.index(grid.nx / 2, grid.ny / 2);
  unit.x[e] = 1.0;
  unit.y[e] = 1.0;
  for (const contact::TangentialOperator* t :
       {&compliance.shift(), &compliance.rolling(UpwindOrder::first),
        &compliance.rolling(UpwindOrder::second)}) {
    const TangentialField w = t->apply({unit.x, unit.y});
    EXPECT_NEAR(0.5 * (w.x[e] + w.y[e]), t->diagonal(), 1e-12 * t->diagonal());
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ComplianceOfGrid,
                         ::testing::Values(std::pair{12, 9}, std::pair{7, 14}, std::pair{1, 5},
                                           std::pair{6, 1}, std::pair{3, 3}));

TEST(HalfspaceCompliance, OfASmallGridHasPositiveEigenvalues) {
  const ContactGrid grid = ContactGrid::centred(8, 6, 0.4, 0.1);
  const HalfspaceCompliance compliance(grid, unlike);
  const int n = grid.size();
  Eigen::MatrixXd matrix(3 * n, 3 * n);
  for (int k = 0; k < 3 * n; ++k) {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(3 * n);
    unit[k] = 1.0;
    const SurfaceField u =
        compliance.apply({unit.segment(0, n), unit.segment(n, n), unit.segment(2 * n, n)});
    matrix.col(k) << u.x, u.y, u.n;
  }
  EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(),
            1e-14 * matrix.cwiseAbs().maxCoeff());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0.01 * matrix(0, 0));
}

}  // namespace
}  // namespace rollfem::halfspace
