#include "contact/solve/point_motion.hpp"

namespace rollfem::contact {

using Eigen::Vector2d;

PointMotion::PointMotion(const Scene& scene, const ChartedGeometry& geometry,
                         const ContactGrid& grid)
    : scene_(scene), geometry_(geometry), grid_(grid), history_(grid, scene.upwind_order) {}

Vector2d PointMotion::given_unknowns(std::size_t k) const {
  const LoadPoint& point = scene_.points[k];
  if (scene_.problem == Problem::shift) return {point.longitudinal_shift, point.lateral_shift};
  return {point.creepage.longitudinal, point.creepage.lateral};
}

TangentialField PointMotion::rigid_slip(const Creepage& creepage, double step) const {
  TangentialField slip = geometry_.rigid_slip(creepage, grid_);
  slip.y.array() += creepage.spin * upstream_of_spin(scene_.upwind_order, step);
  if (extra_.x.size() != 0) {
    slip.x += extra_.x;
    slip.y += extra_.y;
  }
  return slip;
}

TangentialMotion PointMotion::at(std::size_t k, const Vector2d& unknowns) const {
  const LoadPoint& point = scene_.points[k];
  if (scene_.problem == Problem::shift) {
    const StepProblem step =
        history_.shift_step(uniform_slip({unknowns.x(), unknowns.y(), point.spin_shift}, grid_));
    return {step.rigid_slip, Motion::shift, step.slip_factor, 0.0};
  }
  const bool steps = scene_.problem == Problem::transient;
  const TangentialField slip = rigid_slip({unknowns.x(), unknowns.y(), point.creepage.spin},
                                          steps ? point.step_length : grid_.dx);
  if (!steps) return {slip, Motion::rolling, 1.0, 1.0};
  const StepProblem step = history_.rolling_step(slip, point.step_length);
  // Curved streamlines strain the material while it rolls; the problem of the step is in mm.
  return {step.rigid_slip, Motion::shift, step.slip_factor, 1.0 / step.slip_factor};
}

void PointMotion::describe(std::size_t k, const Vector2d& unknowns, PointResult& point) {
  const LoadPoint& given = scene_.points[k];
  point.creepage = given.creepage;
  if (scene_.problem == Problem::shift) {
    sum_.longitudinal += unknowns.x();
    sum_.lateral += unknowns.y();
    sum_.spin += given.spin_shift;
  } else {
    point.creepage.longitudinal = unknowns.x();
    point.creepage.lateral = unknowns.y();
  }
  if (!scene_.is_history()) return;
  point.step = static_cast<int>(k) + 1;
  if (scene_.problem == Problem::transient) sum_.distance += given.step_length;
  point.longitudinal_shift = sum_.longitudinal;
  point.lateral_shift = sum_.lateral;
  point.spin_shift = sum_.spin;
  point.distance = sum_.distance;
}

void PointMotion::advance(std::size_t k, const TangentialField& displacement) {
  if (!scene_.is_history()) return;
  const bool rolls = scene_.problem == Problem::transient;
  history_.advance(displacement, rolls ? scene_.points[k].step_length : 0.0);
}

void PointMotion::take_up(const PointResult& point) {
  sum_ = {point.longitudinal_shift, point.lateral_shift, point.spin_shift, point.distance};
}

}  // namespace rollfem::contact
