// Motion of the surfaces at a load point: the rigid slip of steady rolling, or
// of a step of a shift or of transient rolling including what it inherits from
// earlier steps; and its description in results.
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/history.hpp"

#include <Eigen/Core>

#include <utility>

namespace rollfem::contact {

class PointMotion {
 public:
  /// Scene and geometry must outlive this.
  PointMotion(const Scene& scene, const ChartedGeometry& geometry, const ContactGrid& grid);

  /// Slip that comes on top of the geometry's; may be empty.
  void set_extra(TangentialField extra) { extra_ = std::move(extra); }

  /// Creepages xi, eta of load point k, or the shifts of a step, as the scene gives them.
  Eigen::Vector2d given_unknowns(std::size_t k) const;

  /// The tangential problem of load point k with these in their place.
  TangentialMotion at(std::size_t k, const Eigen::Vector2d& unknowns) const;

  /// Load point k is solved: adds up what has been shifted and rolled, and writes it, step and
  /// creepages into `point`.
  void describe(std::size_t k, const Eigen::Vector2d& unknowns, PointResult& point);

  /// What the next step inherits from load point k.
  void advance(std::size_t k, const TangentialField& displacement);

  /// Load point k was taken up from an earlier run, which described it.
  void take_up(const PointResult& point);

 private:
  struct Sum {
    double longitudinal = 0.0, lateral = 0.0, spin = 0.0, distance = 0.0;
  };

  /// `step`: over how many mm the difference reaches that it is put beside.
  TangentialField rigid_slip(const Creepage& creepage, double step) const;

  const Scene& scene_;
  const ChartedGeometry& geometry_;
  ContactGrid grid_;
  TangentialField extra_;
  History history_;
  Sum sum_;
};

}  // namespace rollfem::contact
