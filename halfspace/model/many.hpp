// Steady rolling of very many Hertzian contacts: forces for a list of creepages on a list of
// ellipses, as needed for tables of vehicle dynamics. Everything is scaled, so that one value
// covers contacts of any size, load and stiffness; nothing is written.
#pragma once

#include <cstddef>
#include <vector>

namespace rollfem::halfspace {

/// Hertz's ellipse between bodies of like material.
struct EllipseShape {
  double axis_ratio = 1.0;  ///< a/b, a along rolling
  double poisson_ratio = 0.28;
};

/// With c = sqrt(a b), the combined shear modulus G and the bound mu F_n of friction. Signs are
/// those of contact::Creepage.
struct CreepPoint {
  std::size_t shape = 0;      ///< place in the list of shapes
  double longitudinal = 0.0;  ///< xi G c^2 / (mu F_n)
  double lateral = 0.0;       ///< eta G c^2 / (mu F_n)
  double spin = 0.0;          ///< phi G c^3 / (mu F_n)
};

/// On the wheel.
struct ScaledForces {
  double longitudinal = 0.0;  ///< F_x / (mu F_n)
  double lateral = 0.0;       ///< F_y / (mu F_n)
  double spin_moment = 0.0;   ///< M_z / (mu F_n c)
};

/// The limit of the two finest grids of a point.
struct ManyForces {
  ScaledForces limit;
  ScaledForces correction;  ///< of the finer one to the limit: the size of the error, no bound
  int elements_across = 0;  ///< of the finer one
};

/// Points that a thread solves in turn.
inline constexpr std::size_t longest_chain = 64;

struct ManyOptions {
  /// Grids are doubled from 10 across on until the correction of the forces is at most this of
  /// mu F_n and that of the moment four times as much of mu F_n c. 0.003: forces within 0.2 %, the
  /// moment within 1 % (docs/benchmarks.md).
  double largest_correction = 0.003;
  int most_across = 80;  ///< where that ends: 20, 40, 80 or 160
  int threads = 0;       ///< 0: contact::threads()
};

/// Forces of all points, in their order. Points of a shape are solved in the order of the list,
/// each from the one before: neighbours should follow each other. They are those of each point
/// alone to 1e-10 and to the last bit whatever the number of threads. Throws contact::InputError
/// for shapes, points and options out of range, contact::SolveError where a point does not
/// converge; both say which.
std::vector<ManyForces> solve_many(const std::vector<EllipseShape>& shapes,
                                   const std::vector<CreepPoint>& points,
                                   const ManyOptions& options = {});

}  // namespace rollfem::halfspace
