// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies lie on the true surface, have sound cells, and refuse what cannot be meshed.
#include "base/errors.hpp"
#include "fem/mesh/surface_shape.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "support/fem_test_support.hpp"

namespace {

std::vector<fem::SurfaceShape> thesis_shapes() {
  const double flat = contact::infinity;
  return {wheel_shape(405, flat),    wheel_shape(405, 105.263), wheel_shape(405, -105.263),
          wheel_shape(405, -51.282), rail_shape(flat),          rail_shape(2000),
          rail_shape(500),           rail_shape(100),           rail_shape(50)};
}

fem::BodyOptions thesis_options() {
  fem::BodyOptions options;
  options.cell_size = 2.0;
  options.fine_half_length = 4.0;
  options.fine_half_width = 12.0;
  options.extent = 80.0;
  options.growth = 1.0;
  options.half = true;
  return options;
}

/// Distance from the surface that the radii define, not through place() or coordinates().
double distance_from_surface(const fem::SurfaceShape& shape, const dealii::Point<3>& p) {
  const double R = shape.transverse_radius;
  const double drop =
      std::isfinite(R) ? std::copysign(1.0, R) * (std::abs(R) - std::sqrt(R * R - p[1] * p[1])) : 0;
  if (!shape.is_wheel) return p[2] + drop;
  return std::hypot(p[0], shape.rolling_radius - p[2]) - (shape.rolling_radius - drop);
}

TEST(SurfaceShape, CoordinatesInvertPlace) {
  for (const auto& shape : thesis_shapes())
    for (const double s : {-70.0, -3.0, 0.0, 0.5, 60.0})
      for (const double t : {-60.0, -10.0, 0.0, 4.0, 45.0})
        for (const double depth : {0.0, 1.0, 80.0}) {
          const auto c = shape.coordinates(shape.place(s, t, depth));
          EXPECT_NEAR(c[0], s, 1e-11);
          EXPECT_NEAR(c[1], t, 1e-11);
          EXPECT_NEAR(c[2], depth, 1e-11);
        }
}

TEST(SurfaceShape, IsRoundAsFarAsTheCaseSays) {
  for (auto shape : {wheel_shape(405, -10), wheel_shape(405, 10), rail_shape(10)}) {
    shape.round_to = 0.85;
    EXPECT_NEAR(distance_from_surface(shape, shape.place(3.0, 8.4, 0.0)), 0.0, 1e-11);
    EXPECT_GT(std::abs(distance_from_surface(shape, shape.place(3.0, 8.6, 0.0))), 1e-3);
    EXPECT_NEAR(std::abs(shape.drop_at(9.5).slope), 0.85 / std::sqrt(1.0 - 0.85 * 0.85), 1e-12);
  }
}

TEST(SurfaceShape, FrameIsOrthonormalAndTangentToTheSurface) {
  const double step = 1e-5;
  for (const auto& shape : thesis_shapes())
    for (const double s : {-5.0, 0.0, 3.0})
      for (const double t : {-12.0, 0.0, 7.0}) {
        const auto [rolling, lateral, normal] = shape.frame(s, t);
        EXPECT_NEAR((dealii::cross_product_3d(rolling, lateral) - normal).norm(), 0.0, 1e-14);
        EXPECT_NEAR(rolling.norm(), 1.0, 1e-14);
        EXPECT_GT(normal[2], 0.5);  // into the wheel, for both bodies
        const auto along = shape.place(s + step, t, 0) - shape.place(s - step, t, 0);
        const auto across = shape.place(s, t + step, 0) - shape.place(s, t - step, 0);
        EXPECT_NEAR((along / along.norm() - rolling).norm(), 0.0, 1e-8);
        // Lines of equal arc length s lean against the wheel's meridians, along rolling.
        const auto upright = across - (across * rolling) * rolling;
        EXPECT_NEAR((upright / upright.norm() - lateral).norm(), 0.0, 1e-8);
        const double area = dealii::cross_product_3d(along, across).norm() / (4 * step * step);
        const double slope = contact::profile_drop(shape.transverse_radius, t).slope;
        EXPECT_NEAR(std::sqrt(1.0 + slope * slope), area, 1e-7);
      }
}

TEST(SurfaceShape, ManifoldGradientMatchesDifferences) {
  const double step = 1e-5;
  for (const auto& shape : thesis_shapes()) {
    const fem::MeansInChart manifold = fem::surface_manifold(shape);
    const dealii::Point<3> at(6.0, -9.0, 4.0);
    const auto gradient = manifold.push_forward_gradient(at);
    for (unsigned int d = 0; d < 3; ++d) {
      auto plus = at, minus = at;
      plus[d] += step;
      minus[d] -= step;
      const auto difference =
          (manifold.push_forward(plus) - manifold.push_forward(minus)) / (2 * step);
      for (unsigned int c = 0; c < 3; ++c) EXPECT_NEAR(gradient[c][d], difference[c], 1e-8);
    }
  }
}

TEST(Body, SurfaceNodesLieOnTheTrueSurfaceAndCellsArePositive) {
  for (const auto& shape : thesis_shapes()) {
    const fem::Body body(shape, {}, thesis_options(), MPI_COMM_SELF);
    const auto& element = body.dofs().get_fe();
    dealii::FEValues<3> nodes(body.mapping(), element,
                              dealii::Quadrature<3>(element.get_unit_support_points()),
                              dealii::update_quadrature_points);
    dealii::FEValues<3> inside(body.mapping(), element, dealii::QGauss<3>(3),
                               dealii::update_JxW_values);
    int on_surface = 0;
    double volume = 0;
    for (const auto& cell : body.dofs().active_cell_iterators()) {
      inside.reinit(cell);  // throws on a distorted cell
      for (const unsigned int q : inside.quadrature_point_indices()) {
        ASSERT_GT(inside.JxW(q), 0.0);
        volume += inside.JxW(q);
      }
      for (const unsigned int face : cell->face_indices()) {
        if (!cell->face(face)->at_boundary() ||
            cell->face(face)->boundary_id() != fem::contact_surface)
          continue;
        nodes.reinit(cell);
        for (unsigned int i = 0; i < element.dofs_per_cell; ++i) {
          const auto& p = nodes.quadrature_point(i);
          if (!element.has_support_on_face(i, face) || std::abs(p[1]) > 30) continue;
          ++on_surface;
          ASSERT_NEAR(distance_from_surface(shape, p), 0.0, 1e-9);
        }
      }
    }
    EXPECT_GT(on_surface, 1000);
    if (!shape.is_wheel) {  // extruded, every depth line as long as the next
      EXPECT_NEAR(volume / (160.0 * 80.0 * 80.0), 1.0, 1e-6);
    }
  }
}

TEST(Body, FineSurfaceFacesLieOnTheLattice) {
  for (const bool half : {false, true}) {
    auto options = thesis_options();
    options.half = half;
    const fem::Body body(wheel_shape(405, 105.263), {}, options, MPI_COMM_SELF);
    int fine_faces = 0;
    for (const auto& cell : body.dofs().active_cell_iterators())
      for (const auto& face : cell->face_iterators()) {
        if (!face->at_boundary() || face->boundary_id() != fem::contact_surface) continue;
        const auto box = fem::chart_box(body.shape(), face);
        const bool fine = box.lower[0] > -4.001 && box.upper[0] < 4.001 && box.upper[1] < 12.001 &&
                          box.lower[1] > -12.001;
        if (!fine) continue;
        ++fine_faces;
        for (unsigned int d = 0; d < 2; ++d) {
          EXPECT_NEAR(box.upper[d] - box.lower[d], 2.0, 1e-9);
          EXPECT_NEAR(std::remainder(box.lower[d], 2.0), 0.0, 1e-9);
        }
      }
    EXPECT_EQ(fine_faces, half ? 4 * 6 : 4 * 12);
  }
}

TEST(Body, RefusesWhatCannotBeMeshed) {
  auto options = thesis_options();
  options.fine_half_width = 100.0;
  EXPECT_THROW(fem::Body(rail_shape(2000), {}, options, MPI_COMM_SELF), contact::InputError);
  options = thesis_options();
  EXPECT_THROW(fem::Body(wheel_shape(100, 2000), {}, options, MPI_COMM_SELF), contact::InputError);
  options.cell_size = 0.0;
  EXPECT_THROW(fem::Body(rail_shape(2000), {}, options, MPI_COMM_SELF), contact::InputError);
}

}  // namespace
