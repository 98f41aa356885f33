// SPDX-License-Identifier: LGPL-2.1-or-later
// The same contact under different meshes: the program's two families, segments of two sizes, and
// meshes of a user whose lines follow neither rolling nor the lateral direction.
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"

#include "support/committed_cases.hpp"
#include "support/mesh_examples.hpp"
#include "support/mpi_environment.hpp"

namespace {

/// A rail of transverse radius 2000 mm, with graded lines along and across that are turned by 20
/// degrees about z, and every node inside moved by up to a fifth of a cell: distorted hexahedra.
meshes::HexMesh distorted_rail() {
  constexpr double reach = 75, shift = 2.3;
  const std::vector<double> along{-reach, -45, -25, -11.6, 0, 11.6, 25, 45, reach};
  return block(along, along, {-reach, -46, -26, -11, 0}, true, [=](Point p) {
    const double phase = 1.3 * p[0] + 2.1 * p[1] + 3.7 * p[2];
    if (std::abs(p[0]) < reach && std::abs(p[1]) < reach && p[2] > -reach) {
      p[0] += shift * std::sin(phase);
      p[1] += shift * std::cos(2 * phase);
      if (p[2] < 0) p[2] += shift * std::sin(3 * phase);
    }
    const double c = std::cos(20.0 * M_PI / 180.0), s = std::sin(20.0 * M_PI / 180.0);
    const double y = s * p[0] + c * p[1];
    return Point{c * p[0] - s * p[1], y, p[2] - (2000.0 - std::sqrt(4e6 - y * y))};
  });
}

}  // namespace

TEST(FemMeshFamilies, AgreeOnTheCurvedCase) {
  // Faces of gmsh's meshes do not make up the contact elements, so that what cells of their size
  // lack of short waves stays in them: forces differ by what that is worth at four cells in the
  // semi-axis.
  contact::Case input = committed_case('e', {0.002});
  const auto one = fem::run_level(input, {0.94, "", false}, {}).points.front();
  input.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh;
  const auto other = fem::run_level(input, {0.94, "", false}, {}).points.front();
  EXPECT_NEAR(other.max_pressure / one.max_pressure, 1.0, 5e-3);
  EXPECT_NEAR(other.traction_coefficient, one.traction_coefficient, 0.01 * 0.55);
  EXPECT_NEAR(other.approach / one.approach, 1.0, 5e-3);
}

TEST(FemUserMeshes, GiveHertzOnTurnedAndDistortedHexahedra) {
  // The whole rail on the user's mesh under half a wheel of the program's. Cells of half of the
  // smaller semi-axis: p0 is off Hertz's by what four elements across bring (half-spaces have +0.8
  // % there, with edges elsewhere in the elements), and the distorted mesh must not add to it.
  const TemporaryFolder folder;
  contact::Case input = committed_case('a', {0.002});
  const auto own = fem::run_level(input, {1.88, "", false}, {}).points.front();
  input.file = folder.path("case.toml");
  folder.file("rail.msh", meshes::msh_text(distorted_rail()));
  input.rail.mesh = "rail.msh";
  const auto point = fem::run_level(input, {1.88, "", false}, {}).points.front();
  EXPECT_NEAR(point.max_pressure / 578.967, 1.0, 3e-2);
  EXPECT_NEAR(point.max_pressure / own.max_pressure, 1.0, 5e-3);
  EXPECT_NEAR(point.traction_coefficient, own.traction_coefficient, 5e-3 * 0.55);
}

TEST(FemSegments, LeaveTheForceWithoutCreepageWhereverTheyEnd) {
  // Four and eight larger semi-axes. The force is the strain of the wheel's circles under load,
  // which a perturbation of the half-space puts at 0.0030 of F_z; without -u_n/R it would be
  // -0.006.
  contact::Case input = committed_case('a', {0.0});
  double coefficient[2];
  for (const int k : {0, 1}) {
    input.body_extent = k == 0 ? 43.5 : 87.0;
    const auto point = fem::run_level(input, {1.88, "", false}, {}).points.front();
    coefficient[k] = point.traction_coefficient;
  }
  EXPECT_NEAR(coefficient[0], coefficient[1], 3e-4 * 0.55);
  EXPECT_NEAR(coefficient[1], 0.0030, 0.0008);
}
