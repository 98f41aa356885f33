// SPDX-License-Identifier: LGPL-2.1-or-later
// Material points on streamlines: strain of a displacement in the section's axes, and the load of
// plastic strain, which is its adjoint.
#include "base/errors.hpp"
#include "fem/discretisation/elastic_problem.hpp"
#include "fem/plasticity/streamlines.hpp"
#include "fem/trace/far_field.hpp"

#include "support/fem_fields.hpp"
#include "support/fem_plane_strain.hpp"
#include "support/fem_test_support.hpp"

namespace {

using fem::Deviator;
using Gradient = dealii::Tensor<2, 3>;

const Gradient of_field{{{1e-3, 2e-4, 3e-4}, {-1e-4, 5e-4, 2e-4}, {1e-4, -3e-4, -7e-4}}};
constexpr contact::Material elastic_steel{210e3, 0.3};

fem::Vector linear_field(const fem::Body& body) {
  return fem::nodal_values(body.problem(), [](const dealii::Point<3>& p) { return of_field * p; });
}

Deviator deviator_of_gradient(const Gradient& g) {
  const double mean = trace(g) / 3.0;
  return {g[0][0] - mean,
          g[1][1] - mean,
          g[2][2] - mean,
          0.5 * (g[0][1] + g[1][0]),
          0.5 * (g[1][2] + g[2][1]),
          0.5 * (g[0][2] + g[2][0])};
}

fem::StreamLattice lattice_of(double cell, std::array<int, 2> along, std::array<int, 2> across,
                              int down) {
  fem::StreamLattice lattice;
  lattice.cell = cell;
  lattice.along = along;
  lattice.across = across;
  lattice.down = down;
  return lattice;
}

/// Crosses hanging nodes: the fine region is one cell deep.
const fem::StreamLattice across_hanging_nodes = lattice_of(1.0, {-5, 4}, {-3, 4}, 4);

double volume_of(const fem::Streamlines& lines) {
  double sum = 0.0;
  for (std::size_t k = 0; k < lines.points(); ++k) sum += lines.volume(k);
  return sum;
}

std::vector<Deviator> random_deviators(std::size_t count, unsigned int seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
  std::vector<Deviator> result(count);
  for (Deviator& d : result) {
    for (double& component : d) component = uniform(generator);
    d[2] = -d[0] - d[1];
  }
  return result;
}

fem::Vector random_displacement(const fem::Body& body) {
  auto u = fem::make_vector(body.dofs());
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const auto i : u.locally_owned_elements()) u(i) = uniform(generator);
  body.constraints().distribute(u);
  u.update_ghost_values();
  return u;
}

}  // namespace

TEST(Streamlines, StrainOfALinearDisplacementIsExactInACurvedRail) {
  const fem::Body body(rail_shape(50), elastic_steel, small_options(), MPI_COMM_WORLD);
  const fem::Streamlines lines(body, across_hanging_nodes);
  const Deviator expected = deviator_of_gradient(of_field);
  for (const Deviator& strain : lines.strains(linear_field(body)))
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(strain[c], expected[c], 1e-15);
}

TEST(Streamlines, StrainInAWheelIsThatOfItsSectionTurnedBack) {
  const double radius = 60.0;
  const fem::Body body(wheel_shape(radius, -40), elastic_steel, small_options(), MPI_COMM_WORLD);
  const fem::Streamlines lines(body, across_hanging_nodes);
  const auto strains = lines.strains(linear_field(body));
  for (std::size_t k = 0; k < lines.points(); ++k) {
    const double s = lines.s(k % lines.stations());
    const double t = lines.section(k / lines.stations())[0];
    // Columns are the section's axes in space: x forwards and towards the axle, y level, z.
    const double angle = s / body.shape().streamline_radius(t);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const Gradient axes{{{cosine, 0, -sine}, {0, 1, 0}, {sine, 0, cosine}}};
    const Deviator expected = deviator_of_gradient(transpose(axes) * of_field * axes);
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(strains[k][c], expected[c], 1e-15) << s;
  }
}

TEST(Streamlines, LoadIsTheAdjointOfStrain) {
  for (const fem::SurfaceShape& shape : {rail_shape(50), wheel_shape(60, -40)}) {
    const fem::Body body(shape, elastic_steel, small_options(), MPI_COMM_WORLD);
    ASSERT_GT(body.constraints().n_constraints(), 0u);
    const fem::Streamlines lines(body, across_hanging_nodes);
    const auto plastic = random_deviators(lines.points(), 3);
    const std::vector<fem::PlasticState> none(lines.streams());
    const auto u = random_displacement(body);
    auto load = fem::make_vector(body.dofs());
    lines.load(plastic, none, none, load);
    const auto strains = lines.strains(u);
    double work = 0.0, size = 0.0;
    for (std::size_t k = 0; k < lines.points(); ++k) {
      const double w = 2.0 * fem::lame_mu(elastic_steel) * lines.volume(k) *
                       fem::product(plastic[k], strains[k]);
      work += w;
      size += std::abs(w);
    }
    EXPECT_NEAR(load * u, work, 1e-13 * size);
  }
}

// Quadrature of two points in a row is exact for these, too.
TEST(Streamlines, FollowThinRows) {
  fem::BodyOptions options = small_options();
  options.rows = fem::GradedDepth(0.2, 1.0, 2);
  fem::StreamLattice lattice = across_hanging_nodes;
  lattice.rows = options.rows;
  const double deep = options.rows.depth(4.0);
  EXPECT_LT(deep, 2.0);
  const fem::Body wheel(wheel_shape(60, contact::infinity), elastic_steel, options, MPI_COMM_WORLD);
  const double box = 9.0 * 7.0 * deep * (1.0 - 0.5 * deep / 60.0);
  EXPECT_NEAR(volume_of({wheel, lattice}), box, 1e-10 * box);
  const fem::Body rail(rail_shape(50), elastic_steel, options, MPI_COMM_WORLD);
  const Deviator expected = deviator_of_gradient(of_field);
  for (const Deviator& strain : fem::Streamlines(rail, lattice).strains(linear_field(rail)))
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(strain[c], expected[c], 1e-12);
}

TEST(Streamlines, VolumesAddUpToThatOfTheBox) {
  const double box = 9.0 * 7.0 * 4.0;
  const fem::Body rail(rail_shape(50), elastic_steel, small_options(), MPI_COMM_WORLD);
  EXPECT_NEAR(volume_of({rail, across_hanging_nodes}), box, 1e-10 * box);
  // A flat tread: lengths shrink with the radius, by 2 mm of 60 on average.
  const fem::Body wheel(wheel_shape(60, contact::infinity), elastic_steel, small_options(),
                        MPI_COMM_WORLD);
  EXPECT_NEAR(volume_of({wheel, across_hanging_nodes}), box * (1.0 - 2.0 / 60.0), 1e-10 * box);
}

// A uniform strain derives from a displacement, so that elements under its load take it up without
// stress: the load is that of the uniform stress 2 G eps_p on every cell, quadrature exact on both
// sides.
TEST(Streamlines, UniformPlasticStrainLoadsEveryCellToBothEnds) {
  SlabOptions options;
  options.per_half_width = 2;
  options.extent = 6.0;
  options.deep = 6;
  options.first_row = 0.1;
  const auto slab = rolled_slab(options);
  const Deviator uniform{3e-3, -1e-3, -2e-3, 0.5e-3, -0.7e-3, 2e-3};
  const std::vector<Deviator> points(slab->lines.points(), uniform);
  std::vector<fem::PlasticState> ends(slab->lines.streams());
  for (fem::PlasticState& end : ends) end.strain = uniform;
  auto load = fem::make_vector(slab->body->dofs());
  slab->lines.load(points, ends, ends, load);
  Gradient stress{{{uniform[0], uniform[3], uniform[5]},
                   {uniform[3], uniform[1], uniform[4]},
                   {uniform[5], uniform[4], uniform[2]}}};
  stress *= 2.0 * fem::lame_mu(slab->body->material());
  const auto expected = load_of_stress(slab->problem(), [&](const auto&) { return stress; });
  load -= expected;
  EXPECT_LT(load.linfty_norm(), 1e-10 * expected.linfty_norm());
}

TEST(Streamlines, InflowFillsTheLeadingEndAndOutflowTheOther) {
  SlabOptions options;
  options.per_half_width = 2;
  options.extent = 6.0;
  options.ahead = 3;
  const auto slab = rolled_slab(options);
  const std::vector<Deviator> none(slab->lines.points());
  const std::vector<fem::PlasticState> no_end(slab->lines.streams());
  const auto strain = random_deviators(1, 8)[0];
  std::vector<fem::PlasticState> end(slab->lines.streams());
  for (fem::PlasticState& one : end) one.strain = strain;
  const auto u = linear_field(*slab->body);
  const double energy_density = 2.0 * fem::lame_mu(slab->body->material()) *
                                fem::product(strain, deviator_of_gradient(of_field));
  const double section = 0.5 * options.deep;  // a cell wide
  auto load = fem::make_vector(slab->body->dofs());
  slab->lines.load(none, end, no_end, load);
  EXPECT_NEAR(load * u, energy_density * section * (6.0 - 3.0), 1e-10 * std::abs(energy_density));
  slab->lines.load(none, no_end, end, load);
  EXPECT_NEAR(load * u, energy_density * section * (6.0 - 2.0), 1e-10 * std::abs(energy_density));
}

TEST(Streamlines, PointsOutsideOfTheMeshAreRefused) {
  const fem::Body body(rail_shape(50), elastic_steel, small_options(), MPI_COMM_WORLD);
  for (const auto& lattice :
       {lattice_of(1.0, {-2, 2}, {-2, 2}, 17), lattice_of(1.0, {-2, 17}, {-2, 2}, 2),
        lattice_of(1.0, {-2, 2}, {-17, 2}, 2)})
    try {
      const fem::Streamlines lines(body, lattice);
      FAIL() << "no error";
    } catch (const contact::InputError& error) {
      EXPECT_NE(std::string(error.what()).find("extent"), std::string::npos) << error.what();
    }
}
