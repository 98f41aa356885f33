// SPDX-License-Identifier: LGPL-2.1-or-later
// gmsh cross-sections and sweeps; mesh files that are written are read again.
#include "base/errors.hpp"
#include "meshes/gmsh_sections.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/segment_mesh.hpp"

#include "support/mesh_examples.hpp"

using meshes::HexMesh;
using meshes::Side;

namespace {

/// Circle of radius R, tangent beyond 0.7 R as the bodies have it.
std::function<double(double)> arc(double R) {
  return [R](double y) {
    const double size = std::abs(R);
    const double a = std::min(std::abs(y), 0.7 * size);
    const double root = std::sqrt(1.0 - (a / size) * (a / size));
    const double drop = size * (1.0 - root) + a / (size * root) * (std::abs(y) - a);
    return R > 0 ? drop : -drop;
  };
}

meshes::SectionOptions section_options(double R, bool half) {
  meshes::SectionOptions options;
  options.drop = arc(R);
  options.half_width = 87;
  options.depth = 80;
  options.fine_half_width = 14;
  options.fine_depth = 2;
  options.cell_size = 4;
  options.half = half;
  return options;
}

double area(const meshes::Section& section) {
  double sum = 0.0;
  for (const auto& quad : section.quads) {
    double twice = 0.0;
    for (int k = 0; k < 4; ++k) {
      const auto& a = section.points[quad[k]];
      const auto& b = section.points[quad[(k + 1) % 4]];
      twice += a[0] * b[1] - a[1] * b[0];
    }
    sum += 0.5 * std::abs(twice);
  }
  return sum;
}

/// The section along x (v downwards), or about an axle at z = 405 by angles.
HexMesh swept(const meshes::Section& section, bool wheel, const std::vector<double>& steps) {
  return meshes::sweep(section, steps.size(), [&](const auto& p, std::size_t k) {
    const double radius = 405.0 - p[1];
    return wheel ? Point{radius * std::sin(steps[k]), p[0], 405.0 - radius * std::cos(steps[k])}
                 : Point{steps[k], p[0], -p[1]};
  });
}

std::string check(const HexMesh& mesh) {
  return refusal<contact::InputError>([&] { meshes::check_mesh(mesh, "rail.msh"); });
}

}  // namespace

TEST(MeshSection, ProfileNodesLieOnTheProfileAndCellsAreSound) {
  for (const bool half : {false, true})
    for (const double R : {1e9, 100.0, 50.0, -105.263, -51.282}) {
      const auto options = section_options(R, half);
      const auto section = meshes::mesh_section(options);
      int contact = 0;
      double reach = 0.0, finest = 1e9;
      for (const auto& edge : section.edges) {
        if (edge.side == Side::symmetry) {
          EXPECT_TRUE(half);
          for (const int end : edge.ends) EXPECT_NEAR(section.points[end][0], 0.0, 1e-12);
        }
        if (edge.side != Side::contact) continue;
        ++contact;
        for (const int end : edge.ends) {
          const auto& p = section.points[end];
          EXPECT_NEAR(p[1], options.drop(p[0]), 1e-12);
          reach = std::max(reach, p[0]);
        }
        const auto& a = section.points[edge.ends[0]];
        const auto& b = section.points[edge.ends[1]];
        finest = std::min(finest, std::hypot(a[0] - b[0], a[1] - b[1]));
        if (std::abs(a[0] + b[0]) < 2 * 14) {
          EXPECT_LE(std::abs(a[0] - b[0]), options.cell_size * (1 + 1e-9));
        }
      }
      EXPECT_GE(contact, half ? 8 : 16);
      EXPECT_NEAR(reach, 87.0, 1e-9);
      EXPECT_GT(finest, 0.9 * options.cell_size);
      EXPECT_GT(smallest_scaled_jacobian(swept(section, false, {0.0, 4.0})), 0.25) << R;
    }
}

TEST(MeshSection, HasTheAreaBetweenProfileAndFarSide) {
  // The profile is replaced by chords: at most c^2 / (8 R) is missing, 21 mm the longest chord.
  for (const double R : {1e9, 500.0, -300.0}) {
    const auto options = section_options(R, false);
    const int steps = 20000;
    double exact = 0.0;
    for (int k = 0; k < steps; ++k) {
      const double y = -87.0 + (k + 0.5) * 174.0 / steps;
      exact += (80.0 - options.drop(y)) * 174.0 / steps;
    }
    EXPECT_NEAR(area(meshes::mesh_section(options)), exact,
                1e-6 + 174.0 * 21.0 * 21.0 / (8.0 * std::abs(R)));
  }
}

TEST(MeshSection, AFlatProfileIsMeshedWithCellsOfAnySize) {
  // With these, the next node of the block was lost to rounding.
  auto flat = section_options(1e9, false);
  flat.drop = [](double) { return 0.0; };
  flat.cell_size = 1.3;
  EXPECT_NEAR(area(meshes::mesh_section(flat)), 174.0 * 80.0, 1e-6);
}

TEST(MeshSweep, VolumesOfBlockAndSectorAreRight) {
  auto flat = section_options(1e9, false);
  flat.drop = [](double) { return 0.0; };
  const auto section = meshes::mesh_section(flat);
  for (const bool wheel : {false, true}) {
    std::vector<double> steps{-0.02, 0.0, 0.015, 0.02};
    if (!wheel)
      for (double& s : steps) s *= 1000.0;
    const auto mesh = swept(section, wheel, steps);
    EXPECT_GT(smallest_scaled_jacobian(mesh), 0.25);
    EXPECT_EQ(check(mesh), "");
    double volume = 0.0;  // divergence theorem over the outside faces
    for (const auto& side : mesh.sides) {
      Point middle{};
      for (const int c : side.corners)
        for (int d = 0; d < 3; ++d) middle[d] += 0.25 * mesh.points[c][d];
      const auto& a = mesh.points[side.corners[0]];
      const auto& b = mesh.points[side.corners[1]];
      const auto& c = mesh.points[side.corners[2]];
      const auto& e = mesh.points[side.corners[3]];
      const Point p{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      const Point q{e[0] - b[0], e[1] - b[1], e[2] - b[2]};
      const Point n{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                    p[0] * q[1] - p[1] * q[0]};
      // Outward: away from a point inside.
      const Point inside{0.0, 0.0, wheel ? 40.0 : -40.0};
      double flux = 0.0;
      for (int d = 0; d < 3; ++d) flux += 0.5 * n[d] * (middle[d] - inside[d]);
      volume += std::abs(flux) / 3.0;
    }
    const double exact =
        wheel ? 0.5 * 0.04 * (405.0 * 405.0 - 325.0 * 325.0) * 174.0 : 40.0 * 174.0 * 80.0;
    EXPECT_NEAR(volume / exact, 1.0, wheel ? 1e-4 : 1e-9);  // chords of at most 0.02 rad
  }
}

TEST(Grading, StepsMakeTheWholeAndGrow) {
  const auto steps = meshes::outward_steps(2.0, 5.0, 60.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    sum += steps[k];
    if (k > 0) {
      EXPECT_GE(steps[k], 0.99 * steps[k - 1]);
      EXPECT_LT(steps[k], 2.0 * steps[k - 1]);
    }
  }
  EXPECT_NEAR(sum, 60.0, 1e-12);
  EXPECT_EQ(steps[0], 2.0);
  EXPECT_EQ(steps[2], 2.0);
  EXPECT_EQ(meshes::points_both_ways({1.0, 2.0}), (std::vector<double>{-3, -1, 0, 1, 3}));
}

TEST(CellQuality, OfKnownCells) {
  std::array<Point, 8> cell{
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}}};
  EXPECT_DOUBLE_EQ(meshes::cell_quality(cell).scaled_jacobian, 1.0);
  EXPECT_DOUBLE_EQ(meshes::cell_quality(cell).aspect_ratio, 2.0);
  EXPECT_DOUBLE_EQ(meshes::cell_quality(cell).shortest_edge, 1.0);
  EXPECT_DOUBLE_EQ(meshes::cell_quality(cell).longest_edge, 2.0);
  for (int k = 4; k < 8; ++k) cell[k][0] += 1.0;  // sheared by 45 degrees
  EXPECT_NEAR(meshes::cell_quality(cell).scaled_jacobian, std::sqrt(0.5), 1e-14);
  for (int k = 0; k < 4; ++k) std::swap(cell[k], cell[k + 4]);
  EXPECT_NEAR(meshes::cell_quality(cell).scaled_jacobian, -std::sqrt(0.5), 1e-14);
}

TEST(MeshFile, RoundTripKeepsEveryDigit) {
  const TemporaryFolder folder;
  const auto mesh = block(
      {-1, 0.1, 1}, {0, 1.0 / 3.0, 1}, {-2, -1, 0}, true,
      [](const Point& p) {
        return Point{p[0] * M_PI, p[1], p[2] + 1e-7 * p[0] * p[0]};
      },
      true);
  const auto back = meshes::read_msh(folder.file("m.msh", meshes::msh_text(mesh)), "m.msh");
  ASSERT_EQ(back.cells.size(), mesh.cells.size());
  ASSERT_EQ(back.points.size(), mesh.points.size());
  ASSERT_EQ(back.sides.size(), mesh.sides.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 8; ++k)
      EXPECT_EQ(back.points[back.cells[c][k]], mesh.points[mesh.cells[c][k]]);
  std::array<int, 3> before{}, after{};
  for (const auto& quad : mesh.sides) ++before[static_cast<std::size_t>(quad.side)];
  for (const auto& quad : back.sides) ++after[static_cast<std::size_t>(quad.side)];
  EXPECT_EQ(before, after);
  EXPECT_EQ(check(back), "");
}

TEST(MeshFile, ThatIsNoFileIsRefused) {
  const TemporaryFolder folder;
  for (const auto& [name, said] : {std::pair("none.msh", "rail.msh: there is no such file"),
                                   std::pair(".", "rail.msh: is a folder, not a file")})
    EXPECT_TRUE(
        says(refusal<contact::InputError>([&] { meshes::read_msh(folder.path(name), "rail.msh"); }),
             said, "do: "));
}
