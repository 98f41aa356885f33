// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite-element bodies of true profiles: the chart about a tilted axle, boxes and true sections on
// the true surface, meshes at the root of the flange.
#include "base/errors.hpp"
#include "fem/discretisation/case_bodies.hpp"
#include "fem/fem_options.hpp"
#include "fem/linear/multigrid.hpp"
#include "fem/mesh/coarse_mesh.hpp"
#include "fem/mesh/run_layout.hpp"
#include "meshes/hex_mesh.hpp"
#include "meshes/true_section.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "support/fem_test_support.hpp"
#include "support/mesh_examples.hpp"
#include "support/profile_patches.hpp"
#include "support/profile_scenes.hpp"

namespace {

contact::Vector3 tilted(double angle) {
  return {0.0, std::cos(angle), std::sin(angle)};
}

std::vector<fem::SurfaceShape> shapes() {
  std::vector<fem::SurfaceShape> result;
  const auto add = [&](contact::PatchGeometry geometry) {
    const auto shared = std::make_shared<contact::PatchGeometry>(std::move(geometry));
    for (const bool is_wheel : {true, false})
      result.push_back(fem::profile_surface(shared, is_wheel));
  };
  add(circle_pair(405.0, -105.263, 100.0));
  add(sphere_on_circle(460.0, 80.0, tilted(0.3)));
  add(sphere_on_circle(460.0, 80.0, tilted(-1.0)));
  return result;
}

double volume_of(const fem::Body& body) {
  const dealii::QGauss<3> rule(3);
  dealii::FEValues<3> values(body.mapping(), body.dofs().get_fe(), rule, dealii::update_JxW_values);
  double sum = 0.0;
  for (const auto& cell : body.dofs().active_cell_iterators()) {
    values.reinit(cell);
    for (const auto q : values.quadrature_point_indices()) sum += values.JxW(q);
  }
  return sum;
}

/// How far the wheel's section, cubics between knots 0.05 mm apart, is off its true one: nothing to
/// speak of but where arcs join. Such a cubic is off a jump J of the second derivative in its piece
/// h by 0.0162 J h^2 at most (both in the frame of the section, whose slopes are below 1).
double allowed_off(const contact::HeightCurve& radius, double axial) {
  constexpr double h = 0.05;
  const double slope = radius.at(axial).slope;
  const double jump = std::abs(radius.at(axial + h).second - radius.at(axial - h).second);
  return 1e-8 + std::sqrt(2.0) * 0.0162 * h * h * jump / (1.0 + slope * slope);
}

/// Every vertex of a contact face has depth 0 and lies on wheel or rail as the geometry says; where
/// the profile ends or is too steep a box goes on straight.
void expect_on_surface(const fem::Body& body, const contact::PatchGeometry& geometry) {
  int faces = 0;
  for (const auto& cell : body.dofs().active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() != fem::contact_surface) continue;
      ++faces;
      for (const unsigned int v : face->vertex_indices()) {
        const auto p = face->vertex(v);
        const double t = body.shape().coordinates(p)[1];
        if (t < body.shape().lower_t() || t > body.shape().upper_t()) continue;
        if (body.shape().is_wheel) {
          const contact::AxlePlace at = geometry.axle_place({p[0], p[1], p[2]});
          const contact::HeightCurve& radius = geometry.wheel_radius();
          EXPECT_NEAR(at.radius, radius.at(at.axial).value, allowed_off(radius, at.axial));
        } else {
          EXPECT_NEAR(p[2], geometry.rail().at(p[1]).value, 1e-10);
        }
      }
    }
  EXPECT_GT(faces, 0);
}

/// By the shoelace formula.
double area_of(const meshes::TrueSection& outline) {
  std::vector<meshes::SectionPoint> polygon = outline.profile;
  polygon.insert(polygon.end(), outline.around.begin() + 1, outline.around.end() - 1);
  double sum = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& a = polygon[k];
    const auto& b = polygon[(k + 1) % polygon.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return std::abs(sum);
}

}  // namespace

TEST(ProfileChart, CoordinatesInvertPlace) {
  for (const auto& shape : shapes())
    for (const double s : {-40.0, -3.0, 0.0, 0.5, 25.0})
      for (const double t : {-15.0, 0.0, 4.0, 30.0})
        for (const double depth : {-0.1, 0.0, 1.0, 40.0}) {
          const auto c = shape.coordinates(shape.place(s, t, depth));
          EXPECT_NEAR(c[0], s, 1e-10);
          EXPECT_NEAR(c[1], t, 1e-10);
          EXPECT_NEAR(c[2], depth, 1e-10);
        }
}

TEST(ProfileChart, OfCirclesIsThatOfTheRadii) {
  const fem::SurfaceShape wheel = shapes()[0], rail = shapes()[1];
  for (const double s : {-20.0, 3.0})
    for (const double t : {-15.0, 4.0})
      for (const double depth : {0.0, 8.0}) {
        EXPECT_LT(
            wheel.place(s, t, depth).distance(wheel_shape(405.0, -105.263).place(s, t, depth)),
            1e-8);
        EXPECT_LT(rail.place(s, t, depth).distance(rail_shape(100.0).place(s, t, depth)), 1e-8);
      }
}

TEST(ProfileChart, GradientAndFrameAreThoseOfThePlaces) {
  const double h = 1e-5;
  for (const auto& shape : shapes())
    for (const double s : {-9.0, 0.0, 4.0})
      for (const double t : {-8.03, 5.0}) {
        const fem::MeansInChart manifold = fem::surface_manifold(shape);
        const dealii::Point<3> chart(s, t, 3.0);
        const auto gradient = manifold.push_forward_gradient(chart);
        for (unsigned int d = 0; d < 3; ++d) {
          auto ahead = chart, behind = chart;
          ahead[d] += h;
          behind[d] -= h;
          const auto change =
              (manifold.push_forward(ahead) - manifold.push_forward(behind)) / (2.0 * h);
          for (unsigned int c = 0; c < 3; ++c) EXPECT_NEAR(gradient[c][d], change[c], 2e-8);
        }
        const auto [rolling, lateral, normal] = shape.frame(s, t);
        const auto along = (shape.place(s + h, t, 0.0) - shape.place(s - h, t, 0.0)) / (2.0 * h);
        EXPECT_LT((rolling - along).norm(), 1e-8);
        EXPECT_LT((dealii::cross_product_3d(rolling, lateral) - normal).norm(), 1e-12);
        // At s = 0 the lateral tangent is that of the section.
        if (s == 0.0) {
          const auto across = (shape.place(0, t + h, 0) - shape.place(0, t - h, 0)) / (2.0 * h);
          EXPECT_LT((lateral - across / across.norm()).norm(), 1e-8);
        }
        EXPECT_GT(normal[2], 0.0);
      }
}

TEST(ProfileBox, LiesOffTheCentreOnTheTrueSurface) {
  const auto geometry =
      std::make_shared<contact::PatchGeometry>(sphere_on_circle(460.0, 80.0, tilted(0.3)));
  fem::BodyOptions options = small_options();
  options.middle = -4.0;
  options.half_width = 12.0;
  for (const bool is_wheel : {true, false}) {
    const fem::Body body(fem::profile_surface(geometry, is_wheel), {}, options, MPI_COMM_WORLD);
    expect_on_surface(body, *geometry);
    // The extruded box has the volume of one that is not sheared; the wheel's shrinks inwards.
    if (!is_wheel) {
      EXPECT_NEAR(volume_of(body) / (32.0 * 24.0 * 16.0), 1.0, 1e-6);
    }
  }
  options.half_width = 30.0;  // the curves end at 20 mm, and the box goes on straight
  const fem::Body wide(fem::profile_surface(geometry, true), {}, options, MPI_COMM_WORLD);
  expect_on_surface(wide, *geometry);
  options.fine_half_width = 24.0;
  EXPECT_THROW(fem::Body(fem::profile_surface(geometry, true), {}, options, MPI_COMM_WORLD),
               contact::InputError);
}

/// The profiles leave the patch in slopes up to the steepest that boxes follow. Every cell must be
/// sound, and multigrid must need no more iterations than on gentle profiles (8 to 10).
TEST(ProfileBox, FollowsASteepProfileWithSoundCells) {
  const contact::Scene scene = flange_scene();
  EXPECT_FALSE(fem::has_true_sections(scene));
  const fem::RunLayout layout = fem::run_layout(scene, 4.0 * fem::default_cell_size(scene));
  EXPECT_GE(layout.bodies.reach_t(), 2.5 * layout.patch.larger());
  const fem::CaseBodies bodies = fem::make_bodies(scene, layout.bodies, MPI_COMM_WORLD);
  double steepest = 0.0;
  for (const fem::Body* body : {bodies.wheel.get(), bodies.rail.get()}) {
    expect_on_surface(*body, *scene.geometry.surface.profiles);
    for (const double side : {-1.0, 1.0})
      steepest = std::max(
          steepest,
          std::abs(body->shape()
                       .profile->height(layout.bodies.middle + side * layout.bodies.reach_t())
                       .slope));
    // sin 15 degrees, where the surface is as steep as a box follows it.
    EXPECT_GT(smallest_scaled_jacobian(fem::hex_mesh(body->triangulation())), 0.25);
    const auto solver = fem::make_multigrid(body->problem(), {1e-10});
    auto load = fem::make_vector(body->dofs()), u = load;
    for (const auto dof : load.locally_owned_elements()) load(dof) = dof % 3 == 2 ? 1.0 : 0.3;
    solver->solve(u, load);
    RecordProperty(body->shape().is_wheel ? "iterations_wheel" : "iterations_rail",
                   solver->last_iterations());
    EXPECT_LE(solver->last_iterations(), 12);
  }
  EXPECT_GT(steepest, 2.0);
  RecordProperty("steepest", std::to_string(steepest));
}

TEST(TrueSections, HaveTheSizesOfRailAndRim) {
  const contact::Scene scene = left_wheel_scene();
  const meshes::TrueSection rail =
      meshes::rail_section(*scene.geometry.surface.profiles, {0.025, false, 172.0});
  double lowest = 0.0, left = 0.0, right = 0.0;
  for (const auto& p : rail.around) {
    lowest = std::min(lowest, p[1]);
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
  }
  EXPECT_NEAR(right - left, 150.0, 3.0);  // the foot, leaned
  EXPECT_NEAR(lowest, -172.0, 4.0);
  // EN 13674-1 gives 7670 mm^2; fillets are chords here.
  EXPECT_NEAR(area_of(rail) / 7670.0, 1.0, 0.03);
  const meshes::TrueSection rim = meshes::rim_section(*scene.geometry.surface.profiles, true, 65.0);
  EXPECT_NEAR(rim.around[1][0] - rim.around[2][0], 130.0, 2.0);
  EXPECT_THROW(meshes::rail_section(*scene.geometry.surface.profiles, {0.025, false, 20.0}),
               contact::InputError);
  EXPECT_THROW(meshes::rim_section(*scene.geometry.surface.profiles, true, 1.0),
               contact::InputError);
}

TEST(TrueSections, MeshedHaveTheVolumeOfTheOutlineAndLieOnTheSurface) {
  contact::Scene scene = left_wheel_scene();
  scene.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh;
  const fem::RunLayout layout = fem::run_layout(scene, 2.0);
  const fem::CaseBodies bodies = fem::make_bodies(scene, layout.bodies, MPI_COMM_WORLD);
  expect_on_surface(*bodies.wheel, *scene.geometry.surface.profiles);
  expect_on_surface(*bodies.rail, *scene.geometry.surface.profiles);
  const double area = area_of(meshes::rail_section(
      *scene.geometry.surface.profiles, {scene.rail_inclination, !scene.place->left, 172.0}));
  EXPECT_NEAR(volume_of(*bodies.rail) / (area * 2.0 * layout.bodies.reach_s()), 1.0, 0.01);
  for (const fem::Body* body : {bodies.wheel.get(), bodies.rail.get()})
    EXPECT_GT(smallest_scaled_jacobian(fem::hex_mesh(body->triangulation())), 0.1);
  EXPECT_GT(bodies.reach, 40.0);
}

TEST(TrueSections, AreMeshedAtTheRootOfTheFlange) {
  contact::Scene scene = flange_scene();
  scene.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh;
  EXPECT_GT(std::abs(scene.geometry.surface.profiles->tilt()), 0.5);
  const fem::RunLayout layout = fem::run_layout(scene, 2.0 * fem::default_cell_size(scene));
  const fem::CaseBodies bodies = fem::make_bodies(scene, layout.bodies, MPI_COMM_WORLD);
  for (const fem::Body* body : {bodies.wheel.get(), bodies.rail.get()}) {
    expect_on_surface(*body, *scene.geometry.surface.profiles);
    EXPECT_GT(smallest_scaled_jacobian(fem::hex_mesh(body->triangulation())), 0.1);
    EXPECT_GT(volume_of(*body), 0.0);
  }
}

TEST(TrueSections, RefuseThePointLoadOfAHalfSpace) {
  contact::Scene scene = left_wheel_scene();
  scene.options.set<fem::FemOptions>().mesh = fem::MeshFamily::gmsh;
  scene.options.set<fem::FemOptions>().far_boundary = fem::FarBoundary::point_load;
  EXPECT_THROW(fem::make_bodies(scene, fem::run_layout(scene, 2.0).bodies, MPI_COMM_WORLD),
               contact::InputError);
}
