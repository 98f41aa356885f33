// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangential solver and GMRES on problems small enough to know the answer.
#include "contact/iteration/tangential.hpp"

#include "base/errors.hpp"
#include "contact/iteration/gmres.hpp"

#include <Eigen/LU>

#include "support/springs.hpp"

namespace rollfem::contact {
namespace {

TEST(SolveTangential, OfSpringsIsTheProjection) {
  const ContactGrid grid = ContactGrid::centred(5, 1, 1.0, 1.0);
  const Springs springs(grid, 0.01);
  TangentialProblem problem;
  problem.friction = coulomb(1.0);
  problem.pressure = Field::Zero(5);
  problem.pressure << 0.0, 1.0, 1.0, 10.0, 0.5;
  problem.motion.rigid_slip = {Field::Constant(5, 0.03), Field::Constant(5, -0.04)};  // |s| / c = 5
  const TangentialSolution s = solve_tangential(springs, problem);
  const double expected[] = {0.0, 1.0, 1.0, 5.0, 0.5};
  const ElementState states[] = {ElementState::exterior, ElementState::slip, ElementState::slip,
                                 ElementState::adhesion, ElementState::slip};
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(s.traction.x[k], -0.6 * expected[k], 1e-5);
    EXPECT_NEAR(s.traction.y[k], 0.8 * expected[k], 1e-5);
    EXPECT_EQ(s.state[static_cast<std::size_t>(k)], states[k]);
    EXPECT_NEAR(s.slip.x[k], 0.03 - 0.006 * expected[k], 1e-7);
  }
}

TEST(SolveTangential, WithoutSlipOrBoundReturnsZeroAtOnce) {
  const ContactGrid grid = ContactGrid::centred(3, 2, 1.0, 1.0);
  const Springs springs(grid, 0.01);
  TangentialProblem problem{
      Field::Constant(6, 2.0), {{Field::Zero(6), Field::Zero(6)}}, coulomb(1.0)};
  const TangentialSolution still = solve_tangential(springs, problem);
  EXPECT_EQ(still.newton_steps, 0);
  EXPECT_EQ(still.traction.x.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(still.state[0], ElementState::adhesion);
  problem.pressure.setZero();
  problem.motion.rigid_slip.x.setOnes();
  const TangentialSolution frictionless = solve_tangential(springs, problem);
  EXPECT_EQ(frictionless.traction.x.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(frictionless.slip.x[0], 1.0);
  EXPECT_EQ(frictionless.state[0], ElementState::exterior);
}

TEST(SolveTangential, RefusesFieldsOfAnotherGridAndNan) {
  const Springs springs(ContactGrid::centred(3, 1, 1.0, 1.0), 0.01);
  EXPECT_THROW(solve_tangential(springs, {Field::Ones(2), {{Field::Ones(3), Field::Ones(3)}}, {}}),
               SolveError);
  EXPECT_THROW(
      solve_tangential(springs,
                       {Field::Ones(3), {{Field::Constant(3, std::nan("")), Field::Ones(3)}}, {}}),
      SolveError);
}

TEST(Gmres, SolvesANonsymmetricSystemAndReportsTheTrueResidual) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(40, 40) * 3.0;
  for (int i = 0; i + 1 < 40; ++i) {
    matrix(i, i + 1) = 1.5;
    matrix(i + 1, i) = -0.7;
  }
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(40, -1.0, 2.0);
  const auto apply = [&](const Gmres::Given& v, Gmres::Vector result) { result = matrix * v; };
  const auto none = [](const Gmres::Given& v, Gmres::Vector result) { result = v; };
  Gmres gmres;
  Eigen::VectorXd x(40);
  for (const int restart : {5, 100}) {
    const GmresResult result = gmres.solve(apply, none, b, {1e-10, 400, restart}, x);
    EXPECT_TRUE(result.converged);
    EXPECT_LT((matrix * x - b).norm(), 1.01e-10 * b.norm());
    EXPECT_NEAR((matrix * x - b).norm() / b.norm(), result.residual, 1e-12);
  }
  const Eigen::MatrixXd inverse = matrix.inverse();
  const auto exact = [&](const Gmres::Given& v, Gmres::Vector result) { result = inverse * v; };
  EXPECT_EQ(gmres.solve(apply, exact, b, {1e-8, 400, 50}, x).iterations, 1);
  EXPECT_EQ(gmres.solve(apply, none, Eigen::VectorXd::Zero(40), {1e-8, 400, 50}, x).iterations, 0);
  EXPECT_FALSE(gmres.solve(apply, none, b, {1e-12, 3, 50}, x).converged);
}

}  // namespace
}  // namespace rollfem::contact
