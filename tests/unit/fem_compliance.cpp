// Coupling and compliance: resultants, transpose consistency, symmetry, the mirrored half body.
#include "contact/errors.hpp"
#include "fem/compliance.hpp"
#include "fem/factorisation.hpp"

#include <deal.II/dofs/dof_tools.h>

#include "fem_test_support.hpp"
#include <cmath>

using namespace rollfem;
using namespace rollfem::test;

namespace {

constexpr contact::Material steel{210e3, 0.3};
constexpr contact::Material soft{70e3, 0.4};

struct Pair {
  explicit Pair(bool half)
      : wheel(wheel_shape(100, -30), steel, options(half), MPI_COMM_SELF),
        rail(rail_shape(20), soft, options(half), MPI_COMM_SELF),
        wheel_solver(fem::make_factorisation(wheel.problem())),
        rail_solver(fem::make_factorisation(rail.problem())) {}
  static fem::BodyOptions options(bool half) {
    auto result = small_options();
    result.half = half;
    return result;
  }
  fem::FemCompliance compliance(const contact::ContactGrid& grid) const {
    return {{&wheel, wheel_solver.get()}, {&rail, rail_solver.get()}, grid};
  }
  fem::Body wheel, rail;
  std::unique_ptr<fem::LinearSolver> wheel_solver, rail_solver;
};

/// Made once for all tests and released before MPI ends.
class BodiesEnvironment : public ::testing::Environment {
 public:
  void TearDown() override {
    full.reset();
    half.reset();
  }
  std::unique_ptr<Pair> full, half;
};
auto* const bodies = new BodiesEnvironment;
[[maybe_unused]] auto* const registered = ::testing::AddGlobalTestEnvironment(bodies);

const Pair& full() {
  if (!bodies->full) bodies->full = std::make_unique<Pair>(false);
  return *bodies->full;
}

const Pair& half() {
  if (!bodies->half) bodies->half = std::make_unique<Pair>(true);
  return *bodies->half;
}

/// Elements that neither match nor divide the 1 mm faces.
contact::ContactGrid odd_grid() {
  return contact::ContactGrid::centred(3, 4, 1.3, 1.1, 0.2, -0.15);
}

dealii::Tensor<1, 3> resultant(const fem::Body& body, const fem::Vector& b) {
  dealii::Tensor<1, 3> sum;
  std::vector<bool> seen(body.unknowns(), false);
  std::vector<dealii::types::global_dof_index> indices(body.dofs().get_fe().dofs_per_cell);
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i) {
      if (seen[indices[i]]) continue;
      seen[indices[i]] = true;
      sum[body.dofs().get_fe().system_to_component_index(i).first] += b(indices[i]);
    }
  }
  return sum;
}

TEST(SurfaceCoupling, ResultantIsTractionTimesArea) {
  // Flat bodies: every component; curved ones: pressure has the resultant of its projection.
  auto options = small_options();
  const fem::Body flat(rail_shape(contact::infinity), steel, options, MPI_COMM_SELF);
  const auto grid = odd_grid();
  const auto p = random_field(grid, 1);
  auto b = fem::make_vector(flat.dofs());
  fem::SurfaceCoupling(flat, grid).load(p, b);
  const auto sum = resultant(flat, b);
  EXPECT_NEAR(sum[0], p.x.sum() * grid.element_area(), 1e-12);
  EXPECT_NEAR(sum[1], p.y.sum() * grid.element_area(), 1e-12);
  EXPECT_NEAR(sum[2], p.n.sum() * grid.element_area(), 1e-12);

  auto pressure = p;
  pressure.x.setZero();
  pressure.y.setZero();
  auto curved = fem::make_vector(full().rail.dofs());
  fem::SurfaceCoupling(full().rail, grid).load(pressure, curved);
  EXPECT_NEAR(resultant(full().rail, curved)[2], pressure.n.sum() * grid.element_area(), 1e-8);
}

TEST(SurfaceCoupling, SampleIsTheTransposeOfLoad) {
  for (const fem::Body* body : {&full().wheel, &full().rail}) {
    const auto grid = odd_grid();
    const fem::SurfaceCoupling coupling(*body, grid);
    const auto p = random_field(grid, 2);
    auto u = fem::make_vector(body->dofs());
    auto b = fem::make_vector(body->dofs());
    std::mt19937 generator(3);
    for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
      u.local_element(i) = generator() * 1e-9;
    coupling.load(p, b);
    const double work = b * u;
    EXPECT_NEAR(dot(p, coupling.sample(u)) * grid.element_area() / work, 1.0, 1e-12);
  }
}

namespace {

/// The same displacement at every node of a body.
fem::Vector rigid_displacement(const fem::Body& body, const std::array<double, 3>& displacement) {
  auto u = fem::make_vector(body.dofs());
  std::vector<dealii::types::global_dof_index> indices(body.dofs().get_fe().dofs_per_cell);
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    cell->get_dof_indices(indices);
    for (unsigned int i = 0; i < indices.size(); ++i)
      u(indices[i]) = displacement[body.dofs().get_fe().system_to_component_index(i).first];
  }
  return u;
}

}  // namespace

TEST(SurfaceCoupling, SamplesARigidDisplacementExactly) {
  const auto grid = odd_grid();
  const fem::Body flat(rail_shape(contact::infinity), steel, small_options(), MPI_COMM_SELF);
  const auto sampled =
      fem::SurfaceCoupling(flat, grid).sample(rigid_displacement(flat, {1.0, 2.0, 3.0}));
  for (int e = 0; e < grid.size(); ++e) {
    EXPECT_NEAR(sampled.x[e], 1.0, 1e-12);
    EXPECT_NEAR(sampled.y[e], 2.0, 1e-12);
    EXPECT_NEAR(sampled.n[e], 3.0, 1e-12);
  }
}

TEST(CurvatureSlip, ARigidDisplacementOfTheWheelSlipsNowhere) {
  const auto grid = contact::ContactGrid::centred(6, 4, 1, 1);
  const fem::Body wheel(wheel_shape(405, contact::infinity), steel, small_options(), MPI_COMM_SELF);
  const auto u =
      fem::SurfaceCoupling(wheel, grid).sample(rigid_displacement(wheel, {0.3, 0.1, 0.7}));
  const auto difference =
      contact::upwind_difference(grid, {u.x, u.y}, contact::UpwindOrder::second);
  const contact::Field slip = difference.x + fem::curvature_slip(wheel.shape(), u);
  // u_n / R alone is 1.7e-3; the second-order difference is exact to (dx/R)^2 of it.
  EXPECT_GT(fem::curvature_slip(wheel.shape(), u).minCoeff(), 1e-3);
  EXPECT_LT(slip.cwiseAbs().maxCoeff(), 3e-6);
  EXPECT_LT(difference.y.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceCoupling, RefusesGridsThatDoNotFit) {
  using contact::ContactGrid;
  const auto& rail = full().rail;
  EXPECT_THROW(fem::SurfaceCoupling(rail, ContactGrid::centred(4, 4, 10, 10)), contact::InputError);
  EXPECT_THROW(fem::SurfaceCoupling(rail, ContactGrid::centred(4, 4, 0.5, 1)), contact::InputError);
  EXPECT_THROW(fem::SurfaceCoupling(rail, ContactGrid::centred(4, 4, 1, 0.5)), contact::InputError);
  EXPECT_NO_THROW(fem::SurfaceCoupling(rail, ContactGrid::centred(4, 4, 1, 1)));
  EXPECT_THROW(fem::SurfaceCoupling(half().rail, ContactGrid::centred(4, 4, 1, 1, 0, 0.5)),
               contact::InputError);
}

TEST(FemCompliance, IsSymmetricAndPositive) {
  for (const Pair* pair : {&full(), &half()}) {
    const auto grid = pair == &full() ? odd_grid() : contact::ContactGrid::centred(4, 5, 1.1, 1.0);
    const auto compliance = pair->compliance(grid);
    for (unsigned int seed = 0; seed < 3; ++seed) {
      const auto p = random_field(grid, 10 + seed);
      const auto q = random_field(grid, 20 + seed);
      const auto Ap = compliance.apply(p);
      const auto Aq = compliance.apply(q);
      EXPECT_GT(dot(p, Ap), 0.0);
      EXPECT_NEAR(dot(p, Aq), dot(q, Ap), 1e-10 * std::sqrt(dot(p, Ap) * dot(q, Aq)));
    }
    EXPECT_EQ(compliance.solves(), 6);
  }
}

TEST(FemCompliance, PressureOpensTheGapAndTractionDragsTheWheelAlong) {
  const auto grid = contact::ContactGrid::centred(4, 4, 1, 1);
  const auto zero = contact::Field(contact::Field::Zero(grid.size()));
  const auto one = contact::Field(contact::Field::Ones(grid.size()));
  const auto compliance = full().compliance(grid);
  EXPECT_GT(compliance.apply({zero, zero, one}).n.minCoeff(), 0.0);
  EXPECT_GT(compliance.apply({one, zero, zero}).x.minCoeff(), 0.0);
  EXPECT_GT(compliance.apply({zero, one, zero}).y.minCoeff(), 0.0);
  // The wheel moves up, the rail down.
  const auto u = full().compliance(grid).body_displacements({zero, zero, one});
  fem::SurfaceCoupling wheel(full().wheel, grid), rail(full().rail, grid);
  EXPECT_GT(wheel.sample(u[0]).n.minCoeff(), 0.0);
  EXPECT_LT(rail.sample(u[1]).n.maxCoeff(), 0.0);
}

TEST(FemCompliance, HalfBodyEqualsFullBodyForSymmetricTractions) {
  for (const int ny : {4, 5}) {  // with and without elements astride the symmetry plane
    const auto grid = contact::ContactGrid::centred(4, ny, 1.1, 1.0);
    const auto p = symmetric_part(grid, random_field(grid, 7));
    const auto whole = full().compliance(grid).apply(p);
    const auto mirrored = half().compliance(grid).apply(p);
    const double scale = whole.n.cwiseAbs().maxCoeff();
    EXPECT_LT((whole.x - mirrored.x).cwiseAbs().maxCoeff(), 1e-8 * scale);
    EXPECT_LT((whole.y - mirrored.y).cwiseAbs().maxCoeff(), 1e-8 * scale);
    EXPECT_LT((whole.n - mirrored.n).cwiseAbs().maxCoeff(), 1e-8 * scale);
  }
}

TEST(FemCompliance, WorkOfTheTractionsIsTwiceTheStrainEnergy) {
  // u.b = u.Ku over both bodies, with b from the coupling and u from the solver.
  const auto grid = odd_grid();
  const auto compliance = full().compliance(grid);
  const auto p = random_field(grid, 5);
  const auto u = compliance.body_displacements(p);
  auto b = fem::make_vector(full().wheel.dofs());
  auto r = fem::make_vector(full().rail.dofs());
  fem::SurfaceCoupling(full().wheel, grid).load(p, b);
  fem::SurfaceCoupling(full().rail, grid).load(p, r);
  const double energy = b * u[0] - r * u[1];
  EXPECT_NEAR(dot(p, compliance.apply(p)) * grid.element_area() / energy, 1.0, 1e-10);
}

TEST(Factorisation, RefusesAFloatingBody) {
  auto problem = full().rail.problem();
  dealii::AffineConstraints<double> hanging;
  dealii::DoFTools::make_hanging_node_constraints(problem.dofs, hanging);
  hanging.close();
  EXPECT_THROW(fem::make_factorisation({problem.dofs, problem.mapping, hanging, {}, steel}),
               contact::SolveError);
}

}  // namespace
