// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of the model halfspace: largest expected distance of each number of a load point from
// its value on an infinitely fine grid, from the changes between grids of h, 2h and 4h and from
// features of the solution. Their reliability: docs/accuracy.md, "Bars of the half-space".
#pragma once

#include "contact/result/result.hpp"
#include "contact/scene/scene.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rollfem::halfspace {

// Waves of rough profiles that are too short for the elements of a grid: the resulting error, from
// elements a quarter as wide, and a warning for the reader.

/// Absolute change of frictionless results with elements a quarter as wide, by name of quantity.
using WaveErrors = std::map<std::string, double>;

/// For load point k, solved on `grid` as `point`. Empty where the elements follow the profiles, or
/// without profiles.
std::optional<WaveErrors> wave_errors(const contact::Scene& scene, std::size_t k,
                                      const contact::ContactGrid& grid,
                                      const contact::PointResult& point);

/// Effect of the points' rounding (ProfileKnots::rounding) on frictionless results, by name of
/// quantity; empty without. Fitted to circles of 80 and 300 mm written with four decimals, their
/// points 0.005 to 0.5 mm apart.
WaveErrors rounding_errors(const contact::Scene& scene, const contact::ContactGrid& grid,
                           const contact::PointResult& point);

/// A warning with sufficiently small cells; empty if the cells are sufficient.
std::string wave_warning(const contact::ContactGrid& grid, const contact::PointResult& point,
                         const WaveErrors& errors);

/// Fills `error_estimate` and `richardson` of load point k of the scene, solved on `grid`, from the
/// same load point on cells of twice and four times the size (null: missing), for every quantity
/// that is not prescribed. A creepage found for a force has a bar. `waves`: of the same load point;
/// null where elements follow the profiles.
void set_error_bars(const contact::Scene& scene, std::size_t k, const contact::ContactGrid& grid,
                    const contact::PointResult& coarse, const contact::PointResult* coarsest,
                    contact::PointResult& fine, const WaveErrors* waves = nullptr);

/// The same for the stresses at the requested points ("subsurface_stress", for the worst component
/// of all), and for the largest stresses ("max_von_mises_wheel"). Maxima at the surface have no bar
/// but the word "near surface": those that either grid has marked so, and, unless the stresses are
/// known `to_surface`, those at the end of the layer of one element length, which is excluded from
/// the search and may contain larger ones.
void set_stress_bars(const contact::ContactGrid& grid, const contact::PointResult& coarse,
                     const contact::PointResult* coarsest, bool to_surface,
                     contact::PointResult& fine);

// Error of a transient from the length of its steps: the same history on coarse elements in shorter
// steps.

/// A history whose steps are divided.
struct DividedSteps {
  contact::Scene scene;
  std::vector<std::size_t> ends;  ///< the point that ends each step of the original
};

/// Each step of a transient in two to sixteen equal ones of an eighth of the patch or less; before
/// the last two patch lengths, whose material has all entered within them, in one. Creepages are
/// constant over a step, loads and prescribed forces change linearly.
DividedSteps divided_steps(const contact::Scene& scene, double patch_length);

/// Adds to the error bars of `fine` twice the change between steps as given (`whole`) and divided,
/// both on the same coarse elements: the error of halved steps of order 1.
void add_step_errors(const std::vector<contact::PointResult>& whole,
                     const std::vector<contact::PointResult>& divided, const DividedSteps& steps,
                     std::vector<contact::PointResult>& fine);

/// The note where there is no solution in shorter steps.
inline constexpr const char* steps_left_out =
    "error bars leave out the length of the steps: no solution with shorter ones";

// Indicators of grid errors in a solution: its largest value compared with the neighbours, the
// roughness of its rows of elements, the elements along its front, and the number of elements
// across.

/// The largest value of a field compared with its neighbours.
struct Peak {
  double fall = 0.0;                ///< difference to the closer neighbour along rolling
  double sag_x = 0.0, sag_y = 0.0;  ///< above the mean of both, along and across
};
Peak peak_of(const contact::ContactGrid& grid, const contact::Field& field);

/// Roughness of the sums of a field over the rows of the grid: the root of the sum of squares of
/// their fourth differences, relative to those of uncorrelated errors.
double roughness_of_rows(const contact::ContactGrid& grid, const contact::Field& field);

/// Area of the elements along the border between adhesion and slip, mm^2.
double area_of_front(const contact::ContactGrid& grid,
                     const std::vector<contact::ElementState>& state);

/// Across the smaller side of the patch; at least 1.
double elements_across(const contact::ContactGrid& grid, const contact::PointResult& point);

}  // namespace rollfem::halfspace
