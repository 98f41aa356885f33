// A case as the user describes it: bodies, load, friction, rolling, grids. Values in, no behaviour;
// read from TOML by case_reader.hpp. Units: mm, N, MPa, rad.
#pragma once

#include "contact/compliance.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Linear-elastic isotropic material.
struct Material {
  double young_modulus = 210e3;  ///< MPa
  double poisson_ratio = 0.3;
};

/// Upper body (1): a surface of revolution about the axle.
struct Wheel {
  double rolling_radius = 0.0;          ///< mm, radius at the running circle
  double transverse_radius = infinity;  ///< mm, > 0 convex, < 0 concave, inf flat
  Material material;
};

/// Lower body (2): a straight extruded rail.
struct Rail {
  double transverse_radius = infinity;  ///< mm, > 0 convex, < 0 concave, inf flat
  Material material;
};

/// Exactly one of the two is given.
struct Load {
  std::optional<double> normal_force;  ///< N
  std::optional<double> approach;      ///< mm
};

/// Rigid slip that comes from the shape of the contact surface rather than from the creepages.
enum class ExtraSlip {
  none,
  rolling_radius,  ///< s_x = -z(y)/R: the wheel's radius differs across a curved patch
};

/// One load point of a creep curve.
struct Creepage {
  double longitudinal = 0.0;  ///< xi
  double lateral = 0.0;       ///< eta
  double spin = 0.0;          ///< phi, rad/mm
};

struct Rolling {
  std::vector<Creepage> creepages{Creepage{}};  ///< lists in the file are broadcast to one length
  UpwindOrder upwind_order = UpwindOrder::second;
  ExtraSlip extra_slip = ExtraSlip::none;
};

struct GridOptions {
  int elements_across = 40;                        ///< along the smaller extent of the patch
  std::optional<std::array<double, 2>> cell_size;  ///< dx, dy in mm; overrides elements_across
};

enum class LinearSolver { automatic, factorisation, multigrid };

struct FemOptions {
  std::optional<double> cell_size;    ///< mm, FE cell and contact element in the patch
  int degree = 2;                     ///< polynomial degree of the displacement
  std::optional<double> extent;       ///< mm, how far the segments reach from the patch
  std::optional<double> fine_extent;  ///< finest cells reach this many patch semi-axes
  LinearSolver linear_solver = LinearSolver::automatic;
};

struct OutputOptions {
  std::vector<std::string> paths{"x", "y"};  ///< middle lines written as path_x.csv, path_y.csv
  bool fields = true;                        ///< ParaView files of wheel and rail
};

struct Case {
  std::string title;
  std::string file;  ///< as given by the user
  std::string text;  ///< the whole case file, kept for provenance
  std::vector<std::string> models;
  Load load;
  double friction_coefficient = 0.0;
  Wheel wheel;
  Rail rail;
  Rolling rolling;
  GridOptions contact_grid;
  FemOptions fem;
  OutputOptions output;
};

}  // namespace rollfem::contact
