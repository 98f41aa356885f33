// Anderson acceleration of a fixed-point iteration d <- F(d) (Anderson 1965; Walker & Ni 2011,
// algorithm AA): the next iterate minimises the linearised residual over the last few steps.
#pragma once

#include <Eigen/Core>

#include <deque>

namespace rollfem::contact {

class Anderson {
 public:
  /// `depth` 0 is the plain iteration.
  explicit Anderson(int depth) : depth_(depth) {}

  /// Next iterate from the iterate d and its image F(d).
  Eigen::VectorXd next(const Eigen::VectorXd& iterate, const Eigen::VectorXd& image);

  /// Forgets the history: after a change of the problem or when the residual has grown.
  void restart();

 private:
  int depth_;
  std::deque<Eigen::VectorXd> residual_steps_;
  std::deque<Eigen::VectorXd> image_steps_;
  Eigen::VectorXd last_residual_;
  Eigen::VectorXd last_image_;
};

}  // namespace rollfem::contact
