#include "halfspace/curvature/corners.hpp"

namespace rollfem::halfspace {

namespace {

/// Sum over the four elements of a corner, each with its sign: `x` for those at larger x, `y` at
/// larger y.
Plane gathered(const Plane& u, double x, double y) {
  const Eigen::Index n = u.rows() - 1, m = u.cols() - 1;
  return x * y * u.bottomRightCorner(n, m) + x * u.bottomLeftCorner(n, m) +
         y * u.topRightCorner(n, m) + u.topLeftCorner(n, m);
}

Plane scattered(const Plane& c, double x, double y) {
  const Eigen::Index n = c.rows(), m = c.cols();
  Plane u = Plane::Zero(n + 1, m + 1);
  u.bottomRightCorner(n, m) += x * y * c;
  u.bottomLeftCorner(n, m) += x * c;
  u.topRightCorner(n, m) += y * c;
  u.topLeftCorner(n, m) += c;
  return u;
}

}  // namespace

Plane Corners::along_x(const Plane& u) const {
  return gathered(u, -1.0, 1.0) * (-0.5 / dx);
}

Plane Corners::along_y(const Plane& u) const {
  return gathered(u, 1.0, -1.0) * (-0.5 / dy);
}

Plane Corners::mean(const Plane& u) {
  return 0.25 * gathered(u, 1.0, 1.0);
}

Plane Corners::from_x(const Plane& m) const {
  return scattered(m, -1.0, 1.0) * (-0.5 / dx);
}

Plane Corners::from_y(const Plane& m) const {
  return scattered(m, 1.0, -1.0) * (-0.5 / dy);
}

Plane Corners::from_mean(const Plane& m) {
  return 0.25 * scattered(m, 1.0, 1.0);
}

}  // namespace rollfem::halfspace
