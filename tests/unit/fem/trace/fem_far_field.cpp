// SPDX-License-Identifier: LGPL-2.1-or-later
// The far boundary that moves as a half-space under a point load: prescribed displacement, signs on
// wheel and rail, linearity, symmetry, and that surface and body show the same displacement.
#include "case/reading/case_reader.hpp"
#include "fem/fem_options.hpp"
#include "fem/trace/far_field.hpp"
#include "halfspace/closed_forms/point_loads.hpp"
#include "scene/geometry.hpp"

#include "support/fem_body_pair.hpp"
#include "support/model_keys.hpp"
#include "support/places.hpp"

namespace {

auto* const bodies = new PairEnvironment(405);
[[maybe_unused]] auto* const registered = ::testing::AddGlobalTestEnvironment(bodies);

const Pair& full() {
  return bodies->full();
}

const Pair& half() {
  return bodies->half();
}

double largest(const contact::SurfaceField& u) {
  return std::max(
      {u.x.cwiseAbs().maxCoeff(), u.y.cwiseAbs().maxCoeff(), u.n.cwiseAbs().maxCoeff()});
}

contact::SurfaceField difference(const contact::SurfaceField& a, const contact::SurfaceField& b) {
  return {a.x - b.x, a.y - b.y, a.n - b.n};
}

using Motion = std::function<dealii::Tensor<1, 3>(const dealii::Point<3>&)>;

/// Prescribes the motion on what the solver's conditions hold; the inside has to follow, across
/// hanging nodes.
void expect_to_follow(const fem::Body& body, const fem::LinearSolver& solver,
                      const Motion& motion) {
  const auto everywhere = fem::nodal_values(body.problem(), motion);
  const auto hanging = fem::make_constraints(body.dofs(), body.mapping(), {});
  auto held = fem::make_vector(body.dofs());
  unsigned int count = 0;
  for (const auto dof : body.dofs().locally_owned_dofs())
    if (body.constraints().is_constrained(dof) && !hanging.is_constrained(dof)) {
      held(dof) = everywhere(dof);
      ++count;
    }
  ASSERT_GT(count, 100u);
  ASSERT_LT(count, body.unknowns() / 2);
  auto u = fem::solve_with_prescribed(body.problem(), solver, {held}).front();
  u -= everywhere;
  EXPECT_LT(u.linfty_norm(), 1e-10 * everywhere.linfty_norm());
}

}  // namespace

TEST(ResultantForce, OnASlopeIsTrueAreaTimesTheTurnedTraction) {
  const contact::ContactGrid grid = contact::ContactGrid::centred(1, 1, 0.5, 0.25);
  const double angle = 0.3;
  contact::PatchShape shape;
  shape.climb = contact::Field::Constant(1, std::tan(angle));
  shape.stretch = contact::Field::Constant(1, 1.0 / std::cos(angle));
  const auto force =
      fem::resultant_force(shape, grid,
                           {contact::Field::Constant(1, 20.0), contact::Field::Constant(1, -35.0),
                            contact::Field::Constant(1, 400.0)});
  const double area = 0.125 / std::cos(angle);
  EXPECT_NEAR(force[0], area * 20.0, 1e-12);
  EXPECT_NEAR(force[1], area * (-35.0 * std::cos(angle) - 400.0 * std::sin(angle)), 1e-12);
  EXPECT_NEAR(force[2], area * (-35.0 * std::sin(angle) + 400.0 * std::cos(angle)), 1e-12);
}

TEST(PrescribedDisplacement, OfARigidMotionMovesTheBodyRigidly) {
  const dealii::Tensor<1, 3> shift({1.0, 2.0, 3.0}), turn({0.01, -0.02, 0.03});
  const auto translation = [&](const dealii::Point<3>&) { return shift; };
  expect_to_follow(full().rail, *full().rail_solver, translation);
  expect_to_follow(full().wheel, *full().wheel_solver, translation);
  // A rotation is linear in place, which hanging nodes follow exactly on flat bodies only.
  const fem::Body flat(rail_shape(contact::infinity), steel, small_options(), MPI_COMM_SELF);
  expect_to_follow(flat, *fem::make_factorisation(flat.problem()),
                   [&](const dealii::Point<3>& place) {
                     return shift + dealii::cross_product_3d(turn, dealii::Tensor<1, 3>(place));
                   });
}

TEST(PointLoadDisplacement, IsThatOfTheHalfSpaceOnEitherSide) {
  const halfspace::ElasticHalfspace space{contact::shear_modulus(steel), steel.poisson_ratio};
  const dealii::Point<3> in_wheel(5, -7, 11), in_rail(5, -7, -11);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const auto wheel = fem::point_load_displacement(wheel_shape(405, 1e9), steel, axis, in_wheel);
    const auto rail = fem::point_load_displacement(rail_shape(1e9), steel, axis, in_rail);
    // The mirror image at z = 0 has the same force along x and y and the opposite along z.
    const double sign = axis == 2 ? -1.0 : 1.0;
    EXPECT_DOUBLE_EQ(rail[0], sign * wheel[0]);
    EXPECT_DOUBLE_EQ(rail[1], sign * wheel[1]);
    EXPECT_DOUBLE_EQ(rail[2], -sign * wheel[2]);
    EXPECT_GT(wheel[axis], 0.0);
    EXPECT_GT(rail[axis], 0.0);
  }
  const auto cerruti = halfspace::cerruti_displacement(space, 1.0, {5, -7, 11});
  const auto boussinesq = halfspace::boussinesq_displacement(space, 1.0, {5, -7, 11});
  const auto along_x = fem::point_load_displacement(wheel_shape(405, 1e9), steel, 0, in_wheel);
  const auto along_z = fem::point_load_displacement(wheel_shape(405, 1e9), steel, 2, in_wheel);
  for (unsigned int c = 0; c < 3; ++c) {
    EXPECT_DOUBLE_EQ(along_x[c], cerruti[c]);
    EXPECT_DOUBLE_EQ(along_z[c], boussinesq[c]);
  }
  // Along y: that along x turned by a right angle about z.
  const auto along_y =
      fem::point_load_displacement(wheel_shape(405, 1e9), steel, 1, dealii::Point<3>(7, 5, 11));
  EXPECT_DOUBLE_EQ(along_y[1], along_x[0]);
  EXPECT_DOUBLE_EQ(along_y[0], -along_x[1]);
  EXPECT_DOUBLE_EQ(along_y[2], along_x[2]);
}

TEST(PointLoadBoundary, IsLinearAndFollowsTheForceAlone) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  const auto clamped = full().compliance(grid, fem::FarBoundary::clamped);
  const auto moving = full().compliance(grid, fem::FarBoundary::point_load);
  const auto p = random_field(grid, 1), q = random_field(grid, 2);
  const auto Ap = moving.apply(p), Aq = moving.apply(q);
  const auto both = moving.apply({2 * p.x + q.x, 2 * p.y + q.y, 2 * p.n + q.n});
  const contact::SurfaceField sum{2 * Ap.x + Aq.x, 2 * Ap.y + Aq.y, 2 * Ap.n + Aq.n};
  EXPECT_LT(largest(difference(both, sum)), 1e-10 * largest(sum));

  // Without a resultant nothing moves far away; on the axis the surface follows the force.
  const auto shape = contact::patch_shape(full().surface(), grid);
  contact::SurfaceField turning = p;
  turning.n.setZero();
  turning.y.setZero();
  turning.x.array() -= turning.x.dot(shape.stretch) / shape.stretch.sum();
  EXPECT_LT(largest(difference(moving.apply(turning), clamped.apply(turning))),
            1e-12 * largest(clamped.apply(turning)));
  const contact::Field zero = contact::Field::Zero(grid.size()), one = zero.array() + 1.0;
  EXPECT_GT(
      difference(moving.apply({one, zero, zero}), clamped.apply({one, zero, zero})).x.minCoeff(),
      0.0);
  EXPECT_GT(
      difference(moving.apply({zero, one, zero}), clamped.apply({zero, one, zero})).y.minCoeff(),
      0.0);
  EXPECT_GT(
      difference(moving.apply({zero, zero, one}), clamped.apply({zero, zero, one})).n.minCoeff(),
      0.0);
}

TEST(PointLoadBoundary, BodiesShowWhatTheSurfaceShows) {
  // What the boundary brings: the surface has the middles of elements, bodies are sampled by means,
  // and the two differ by the same with either boundary.
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  for (const Pair* pair : {&full(), &half()}) {
    const auto p = symmetric_part(grid, random_field(grid, 3));
    contact::SurfaceField by_bodies[2], by_surface[2];
    for (const int k : {0, 1}) {
      const auto compliance =
          pair->compliance(grid, k == 0 ? fem::FarBoundary::clamped : fem::FarBoundary::point_load);
      const auto u = compliance.body_displacements(p);
      by_bodies[k] =
          difference(fem::SurfaceCoupling(pair->wheel, grid, pair->surface()).sample(u[0]),
                     fem::SurfaceCoupling(pair->rail, grid, pair->surface()).sample(u[1]));
      by_surface[k] = compliance.apply(p);
    }
    const auto brought = difference(by_surface[1], by_surface[0]);
    EXPECT_GT(largest(brought), 1e-3 * largest(by_surface[1]));
    EXPECT_LT(largest(difference(brought, difference(by_bodies[1], by_bodies[0]))),
              1e-12 * largest(by_surface[1]));
  }
}

TEST(PointLoadBoundary, HalfBodyEqualsFullBody) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  const auto p = symmetric_part(grid, random_field(grid, 7));
  const auto whole = full().compliance(grid, fem::FarBoundary::point_load).apply(p);
  const auto mirrored = half().compliance(grid, fem::FarBoundary::point_load).apply(p);
  EXPECT_LT(largest(difference(whole, mirrored)), 1e-8 * largest(whole));
}

namespace {

/// Largest |p.A q - q.A p| / sqrt(p.A p q.A q) over random tractions.
double asymmetry(const Pair& pair, fem::FarBoundary far) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  const auto compliance = pair.compliance(grid, far);
  const contact::Field area = contact::patch_shape(pair.surface(), grid).stretch;
  const auto work = [&](const contact::SurfaceField& p, const contact::SurfaceField& u) {
    return dot({p.x.cwiseProduct(area), p.y.cwiseProduct(area), p.n.cwiseProduct(area)}, u);
  };
  double worst = 0.0;
  for (unsigned int seed = 0; seed < 4; ++seed) {
    auto p = random_field(grid, 10 + seed), q = random_field(grid, 30 + seed);
    p.n.array() += 1.0;  // a pressure with a force
    q.x.array() += 0.5;
    const auto Ap = compliance.apply(p), Aq = compliance.apply(q);
    worst =
        std::max(worst, std::abs(work(p, Aq) - work(q, Ap)) / std::sqrt(work(p, Ap) * work(q, Aq)));
  }
  return worst;
}

}  // namespace

TEST(PointLoadBoundary, IsNearlySymmetric) {
  EXPECT_LT(asymmetry(full(), fem::FarBoundary::clamped), 1e-10);
  // A correction of rank three; the reactions of the clamped boundary, with which Betti's theorem
  // tests it, are those of a point load up to (patch / extent)^2 and the curvature.
  const double moving = asymmetry(full(), fem::FarBoundary::point_load);
  EXPECT_LT(moving, 1e-3);  // 4.7e-4 as measured
  EXPECT_GT(moving, 0.0);
}

TEST(ApproachLeftOut, CoversTheChangesBetweenExtents) {
  // Changes of the approach up to an extent of 12 semi-axes, mm.
  const struct {
    const char* name;
    double semi_axes, change;
  } rows[] = {{"a", 4, 18e-6}, {"a", 6, 1e-6}, {"e", 8, 17e-6}, {"f", 8, 26e-6}};
  for (const auto& row : rows) {
    contact::Case input =
        contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_" + row.name + ".toml");
    const double extent = row.semi_axes * 10.873;
    input.options.set<fem::FemOptions>().far_boundary = fem::FarBoundary::clamped;
    const double clamped = fem::approach_left_out(input, 50e3, extent);
    input.options.set<fem::FemOptions>().far_boundary = fem::FarBoundary::point_load;
    const double moving = fem::approach_left_out(input, 50e3, extent);
    EXPECT_GT(moving, row.change) << row.name;
    EXPECT_LT(moving, 0.25 * clamped) << row.name;
    // On bodies as flat as these it falls with the extent; on steep ones (e, f) the half-space fits
    // a larger segment less.
    if (input.rail.transverse_radius > 1000.0) {
      EXPECT_LT(fem::approach_left_out(input, 50e3, 1.5 * extent), moving) << row.name;
    }
  }
}

TEST(ApproachLeftOut, IsClampedForAMeshOfTheUser) {
  contact::Case input =
      contact::read_case(std::string(ROLLFEM_SOURCE_DIR) + "/cases/thesis_a.toml");
  EXPECT_EQ(fem::far_boundary_of(input), fem::FarBoundary::point_load);
  input.rail.mesh = "rail.msh";
  EXPECT_EQ(fem::far_boundary_of(input), fem::FarBoundary::clamped);
}
