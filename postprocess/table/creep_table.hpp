// The creep force law of Hertzian contacts as a table: forces of full friction over scaled
// creepages and the ratio of the ellipse's axes, as Kalker's (1996) and USETAB's tables have it,
// and what it says between its points. Python and C read it through here (docs/tables.md).
//
// With c = sqrt(a b), the combined shear modulus G, the bound mu F_n and Kalker's coefficients:
//   xi' = xi G c^2 C11 / (3 mu F_n)    eta' = eta G c^2 C22 / (3 mu F_n)
//   phi' = phi G c^3 sqrt(C23^2 + C33^2) / (mu F_n)
// Signs are those of contact::Creepage; forces act on the wheel.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::postprocess {

/// xi', eta', phi'; or F_x/(mu F_n), F_y/(mu F_n), M_z/(mu F_n c).
using Scaled = std::array<double, 3>;

/// What is found between grid points less what is solved for there, at points at random: of the
/// force vector in mu F_n, of the moment in mu F_n c.
struct InterpolationError {
  int points = 0;
  unsigned seed = 0;
  double force_rms = 0.0, force_95 = 0.0, force_max = 0.0;
  double moment_rms = 0.0, moment_95 = 0.0, moment_max = 0.0;
};

/// Its errors by the names that files and Python have them under.
inline constexpr std::pair<const char*, double InterpolationError::*> interpolation_errors[] = {
    {"force_rms", &InterpolationError::force_rms}, {"force_95", &InterpolationError::force_95},
    {"force_max", &InterpolationError::force_max}, {"moment_rms", &InterpolationError::moment_rms},
    {"moment_95", &InterpolationError::moment_95}, {"moment_max", &InterpolationError::moment_max}};

/// A point at which it was found.
struct CheckedPoint {
  double axis_ratio = 1.0;
  Scaled creepage{}, interpolated{}, solved{};
};

struct CreepTable {
  std::string title, case_file, case_text, program, command, started;
  double poisson_ratio = 0.0;
  std::vector<double> axis_ratio;  ///< a/b, increasing
  /// xi' and eta' from 0 on, phi' with its mirror image; increasing. Negative xi' and eta' follow:
  /// the force law is odd, and the mirror image of a contact changes eta, phi, F_y and M_z.
  std::array<std::vector<double>, 3> creepage;
  /// Of every ratio: what xi G c^2/(mu F_n), eta G c^2/(mu F_n), phi G c^3/(mu F_n) are multiplied
  /// by.
  std::vector<Scaled> scale;
  // Of every point, the last axis the fastest: ratio, xi', eta', phi'.
  std::vector<Scaled> forces;
  std::vector<std::array<double, 2>> bars;  ///< of the force vector and of the moment
  std::vector<int> elements_across;         ///< of the finer of the two grids
  InterpolationError interpolation;
  std::vector<CheckedPoint> checked;

  std::size_t size() const;
  std::size_t place(std::size_t ratio, std::size_t i, std::size_t j, std::size_t k) const;
};

/// In what axes are even and interpolation works: x up to 1, 1 + ln x beyond, odd.
double table_coordinate(double scaled_creepage);
double creepage_at(double coordinate);

/// From 0 to `largest` in even steps of the coordinate; of both signs for a spin.
std::vector<double> creepages_to(double largest, int count);
std::vector<double> spins_to(double largest, int count);

/// What a table says at a point. Bars: of the forces, those of the grid around the point and what
/// 95 of 100 points at random were off by interpolation.
struct TableForces {
  Scaled forces{};
  double force_bar = 0.0, moment_bar = 0.0;
};

/// Answers; made once of a table, which it holds. Nothing is allocated, and threads may ask at
/// once.
class CreepTableReader {
 public:
  /// Throws contact::InputError where the table does not fit together.
  explicit CreepTableReader(CreepTable table);

  const CreepTable& table() const { return table_; }

  /// Beyond the largest creepages all are reduced alike to the end of the grid: full sliding knows
  /// their direction only. Throws contact::InputError for a ratio outside of the table (one in a
  /// thousand is let pass) and for what is not finite.
  TableForces at(double axis_ratio, const Scaled& creepage) const;

  /// Factors of the creepages (CreepTable::scale) at any ratio of the table.
  Scaled scale_at(double axis_ratio) const;

  /// Forces in the units of the arguments, consistent ones. Semi-axes along rolling and across,
  /// combined shear modulus, mu F_n > 0, creepages xi, eta and phi.
  TableForces physical(double semi_axis_x, double semi_axis_y, double shear_modulus,
                       double friction_bound, const Scaled& creepage) const;

 private:
  double logarithm_of(double axis_ratio) const;

  CreepTable table_;
  std::vector<double> log_ratio_;
  std::array<std::vector<double>, 3> coordinate_;
};

}  // namespace rollfem::postprocess
