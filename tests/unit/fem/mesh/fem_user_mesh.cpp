// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies on meshes that are given: put on the true surface, refined, coupled with faces that follow
// no lattice.
#include "base/errors.hpp"
#include "fem/linear/factorisation.hpp"
#include "fem/mesh/chart_face.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "fem/trace/far_field.hpp"
#include "fem/trace/fem_compliance.hpp"

#include "support/fem_test_support.hpp"
#include "support/mesh_examples.hpp"

namespace {

constexpr contact::Material user_steel{210e3, 0.3};
const std::vector<double> lateral_lines{-16, -7, -3, 1, 4, 8, 16};
const std::vector<double> depth_lines{0, 2, 5, 12};

/// Lines turned by 25 degrees and sheared in the chart: no face side follows s or t.
meshes::HexMesh turned_mesh(const fem::SurfaceShape& shape) {
  std::vector<double> z = depth_lines;
  if (!shape.is_wheel) {
    std::reverse(z.begin(), z.end());
    for (double& depth : z) depth = -depth;
  }
  return block(lateral_lines, lateral_lines, z, !shape.is_wheel, [&](const Point& p) {
    const double angle = 25.0 * M_PI / 180.0;
    const double skew = p[0] + 0.15 * p[1] + 0.004 * p[0] * p[1];
    const auto at = shape.place(std::cos(angle) * skew - std::sin(angle) * p[1],
                                std::sin(angle) * skew + std::cos(angle) * p[1], std::abs(p[2]));
    return Point{at[0], at[1], at[2]};
  });
}

std::unique_ptr<fem::Body> turned_body(const fem::SurfaceShape& shape,
                                       MPI_Comm communicator = MPI_COMM_SELF) {
  return std::make_unique<fem::Body>(shape, user_steel, small_options(), turned_mesh(shape),
                                     communicator);
}

contact::ContactGrid odd_grid() {
  return contact::ContactGrid::centred(5, 4, 1.3, 1.1, 0.2, -0.1);
}

}  // namespace

TEST(ChartFace, OverlapsOfASkewFaceAddUpToItsAreaAndMoments) {
  const fem::ChartFace face({{{0.1, -0.2}, {1.3, 0.3}, {-0.4, 1.1}, {0.9, 1.2}}});
  EXPECT_TRUE(face.is_convex());
  // Area and first moments by the trapezoid formulas of a polygon.
  const double x[] = {0.1, 1.3, 0.9, -0.4}, y[] = {-0.2, 0.3, 1.2, 1.1};
  double area = 0, moment_s = 0, moment_t = 0;
  for (int k = 0; k < 4; ++k) {
    const int n = (k + 1) % 4;
    const double cross = x[k] * y[n] - x[n] * y[k];
    area += cross / 2;
    moment_s += (x[k] + x[n]) * cross / 6;
    moment_t += (y[k] + y[n]) * cross / 6;
  }
  double sum = 0, sum_s = 0, sum_t = 0, weights = 0;
  std::vector<fem::FacePoint> rule;
  for (int i = -3; i < 8; ++i)
    for (int j = -3; j < 8; ++j) {
      sum += face.overlap({0.3 * i, 0.3 * (i + 1)}, {0.25 * j, 0.25 * (j + 1)}, 3, rule);
      for (const auto& point : rule) {
        weights += point.weight;
        sum_s += point.weight * point.s;
        sum_t += point.weight * point.t;
        // The place on the reference face leads back.
        const double u = point.reference[0], v = point.reference[1];
        const double s =
            0.1 * (1 - u) * (1 - v) + 1.3 * u * (1 - v) - 0.4 * (1 - u) * v + 0.9 * u * v;
        EXPECT_NEAR(s, point.s, 1e-13);
        EXPECT_GT(u, -1e-12);
        EXPECT_LT(u, 1 + 1e-12);
      }
    }
  EXPECT_NEAR(sum, area, 1e-13);
  EXPECT_NEAR(weights, area, 1e-13);
  EXPECT_NEAR(sum_s, moment_s, 1e-13);
  EXPECT_NEAR(sum_t, moment_t, 1e-13);
  const fem::ChartFace dented({{{0, 0}, {1, 0}, {0, 1}, {0.2, 0.2}}});
  EXPECT_FALSE(dented.is_convex());
}

TEST(GivenMesh, RefinedNodesLieOnTheTrueSurface) {
  for (const auto& shape : {wheel_shape(100, -30), rail_shape(20)}) {
    const auto body = turned_body(shape);
    EXPECT_GE(body->triangulation().n_levels(), 3u);
    int nodes = 0;
    for (const auto& cell : body->dofs().active_cell_iterators())
      for (const unsigned int f : cell->face_indices()) {
        if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != fem::contact_surface)
          continue;
        for (unsigned int v = 0; v < 4; ++v) {
          ++nodes;
          EXPECT_NEAR(shape.coordinates(cell->face(f)->vertex(v))[2], 0.0, 1e-11);
        }
      }
    EXPECT_GT(nodes, 300);
  }
}

TEST(GivenMesh, CouplingIsExactOnTurnedFaces) {
  // On every number of processes: each integrates its own faces.
  const auto body = turned_body(rail_shape(contact::infinity), MPI_COMM_WORLD);
  const auto grid = odd_grid();
  const fem::SurfaceCoupling coupling = own_coupling(*body, grid);
  // A displacement that is linear in the place is in the space; its mean is the value in the
  // middle.
  const auto sampled =
      coupling.sample(fem::nodal_values(body->problem(), [](const dealii::Point<3>& p) {
        return dealii::Tensor<1, 3>({1.0 + 0.3 * p[0] - 0.2 * p[1], 2.0 * p[1], 3.0 - p[0]});
      }));
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const int e = grid.index(i, j);
      EXPECT_NEAR(sampled.x[e], 1.0 + 0.3 * grid.x(i) - 0.2 * grid.y(j), 1e-11);
      EXPECT_NEAR(sampled.y[e], 2.0 * grid.y(j), 1e-11);
      EXPECT_NEAR(sampled.n[e], 3.0 - grid.x(i), 1e-11);
    }
  const auto p = random_field(grid, 1);
  auto b = fem::make_vector(body->dofs());
  coupling.load(p, b);
  const auto one = [&](unsigned int axis) {
    return fem::nodal_values(body->problem(), [axis](const dealii::Point<3>&) {
      dealii::Tensor<1, 3> unit;
      unit[axis] = 1.0;
      return unit;
    });
  };
  EXPECT_NEAR(b * one(0), p.x.sum() * grid.element_area(), 1e-11);
  EXPECT_NEAR(b * one(1), p.y.sum() * grid.element_area(), 1e-11);
  EXPECT_NEAR(b * one(2), p.n.sum() * grid.element_area(), 1e-11);
}

TEST(GivenMesh, ComplianceIsSymmetricAndPositive) {
  const auto wheel = turned_body(wheel_shape(100, -30));
  const auto rail = turned_body(rail_shape(20));
  const auto wheel_solver = fem::make_factorisation(wheel->problem());
  const auto rail_solver = fem::make_factorisation(rail->problem());
  const auto grid = odd_grid();
  const auto surface = common_surface(wheel->shape(), rail->shape());
  const fem::FemCompliance compliance({wheel.get(), wheel_solver.get()},
                                      {rail.get(), rail_solver.get()}, surface, grid);
  const auto area = contact::patch_shape(surface, grid).stretch;
  const auto work = [&](const contact::SurfaceField& p, const contact::SurfaceField& u) {
    return area.dot(p.x.cwiseProduct(u.x) + p.y.cwiseProduct(u.y) + p.n.cwiseProduct(u.n));
  };
  const auto p = random_field(grid, 10);
  const auto q = random_field(grid, 20);
  const auto Ap = compliance.apply(p);
  const auto Aq = compliance.apply(q);
  EXPECT_GT(work(p, Ap), 0.0);
  EXPECT_NEAR(work(p, Aq), work(q, Ap), 1e-10 * std::sqrt(work(p, Ap) * work(q, Aq)));
}

TEST(GivenMesh, RefusesGridsThatAreTooFineOrReachTooFar) {
  const auto rail = turned_body(rail_shape(20));
  using contact::ContactGrid;
  EXPECT_THROW(own_coupling(*rail, ContactGrid::centred(4, 4, 0.4, 0.4)), contact::InputError);
  EXPECT_THROW(own_coupling(*rail, ContactGrid::centred(4, 4, 10, 10)), contact::InputError);
}

TEST(GivenMesh, OfAnyChartIsAccepted) {
  // A hole of radius 10 in a block below: s is the arc along the hole, material outside.
  auto chart = std::make_shared<fem::ChartFunctions>();
  chart->place = [](const dealii::Point<3>& c) {
    return dealii::Point<3>((10 + c[2]) * std::sin(c[0] / 10), c[1],
                            10 - (10 + c[2]) * std::cos(c[0] / 10));
  };
  chart->coordinates = [](const dealii::Point<3>& p) {
    return dealii::Point<3>(10 * std::atan2(p[0], 10 - p[2]), p[1],
                            std::hypot(p[0], 10 - p[2]) - 10);
  };
  chart->frame = [](double s, double) -> fem::SurfaceFrame {
    const double c = std::cos(s / 10), n = std::sin(s / 10);
    return {dealii::Tensor<1, 3>({c, 0, n}), dealii::Tensor<1, 3>({0, 1, 0}),
            dealii::Tensor<1, 3>({-n, 0, c})};
  };
  fem::SurfaceShape hole{false, 10.0, contact::infinity, chart};
  const auto mesh = block({-12, -6, 0, 6, 12}, {-4, 0, 4}, {-6, -2, 0}, true, [&](const Point& p) {
    const auto at = hole.place(p[0], p[1], -p[2]);
    return Point{at[0], at[1], at[2]};
  });
  const fem::Body body(hole, user_steel, small_options(), mesh, MPI_COMM_SELF);
  const auto grid = contact::ContactGrid::centred(6, 4, 1.0, 1.0);
  const fem::SurfaceCoupling coupling = own_coupling(body, grid);
  // A displacement along the hole's own normal is sampled as such, to the curvature of a cell.
  const auto sampled =
      coupling.sample(fem::nodal_values(body.problem(), [](const dealii::Point<3>& p) {
        const double angle = std::atan2(p[0], 10 - p[2]);
        return dealii::Tensor<1, 3>({-std::sin(angle), 0.0, std::cos(angle)});
      }));
  for (int e = 0; e < grid.size(); ++e) {
    EXPECT_NEAR(sampled.n[e], 1.0, 1e-5);
    EXPECT_NEAR(sampled.x[e], 0.0, 1e-5);
  }
}

TEST(GivenMesh, TooCoarseForTheCellSizeIsRefused) {
  auto options = small_options();
  options.cell_size = 0.05;
  options.fine_half_length = options.fine_half_width = 0.1;
  const auto mesh = block({-16, 0, 16}, {-16, 0, 16}, {-16, 0}, true);
  EXPECT_TRUE(says(refusal<contact::InputError>([&] {
                     fem::Body(rail_shape(contact::infinity), user_steel, options, mesh,
                               MPI_COMM_SELF);
                   }),
                   "too coarse"));
}

TEST(UserMesh, NodesWithSmallErrorsAreMovedToTheSurface) {
  const TemporaryFolder folder;
  meshes::HexMesh given = turned_mesh(rail_shape(20));
  for (auto& p : given.points) p[2] -= 0.01;
  const std::string path = folder.file("rail.msh", meshes::msh_text(given));
  const auto mesh = fem::user_mesh(path, "rail.msh", rail_shape(20), small_options()).mesh;
  for (const auto& quad : mesh.sides)
    if (quad.side == meshes::Side::contact)
      for (const int corner : quad.corners) {
        const auto& p = mesh.points[corner];
        EXPECT_NEAR(rail_shape(20).coordinates({p[0], p[1], p[2]})[2], 0.0, 1e-12);
      }
}

TEST(UserMesh, SymmetryGroupMeansTheHalfAboveZero) {
  const TemporaryFolder folder;
  const auto half = block(
      {-16, -4, 0, 4, 16}, {0, 4, 16}, {-12, -4, 0}, true,
      [](const Point& p) {
        const auto at = rail_shape(20).place(p[0], p[1], -p[2]);
        return Point{at[0], at[1], at[2]};
      },
      true);
  const std::string path = folder.file("rail.msh", meshes::msh_text(half));
  EXPECT_TRUE(fem::user_mesh(path, "rail.msh", rail_shape(20), small_options()).mesh.half());
}
