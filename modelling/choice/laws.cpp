// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/choice/laws.hpp"

#include "base/pi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rollfem::modelling {

namespace {

/// Errors of the half-space with 24 elements across: the largest bars in the thesis's cases, of the
/// traction coefficient over mu or, without friction, of the pressure.
constexpr int measured_across = 24;
constexpr double error_with_friction = 0.006, error_without_friction = 0.0035;

/// The same for finite elements with 16 cells across.
constexpr int measured_cells = 16;
constexpr double fem_error_with_friction = 0.006, fem_error_without_friction = 0.003;

/// Elements required across the smallest patch (result/validity.cpp), plus one, because the
/// patch may be badly aligned with the grid.
constexpr double fewest_across = 5.0;

// Seconds of one core of an idle machine at 2.5 GHz, -O3.
constexpr double start = 5e-3;        ///< independent of the grid
constexpr double per_element = 6e-6;  ///< per element of the patch and load point
/// Where pressure and friction influence each other, Newton's method solves for both; the factor of
/// time grows with the grid: 4 with 32 elements across, 22 with 320.
constexpr double coupled_times = 4.0, coupled_power = 0.75;
/// Where friction carries a part of the load, pressure and friction are solved for in turn.
constexpr double sharing_times = 2.0;
/// The estimate of the model error takes more iterations on steep profiles.
constexpr double steep_estimate_times = 2.0;
constexpr double of_model_error = 0.1;  ///< per load point
constexpr double hybrid_times = 13.0;   ///< time of the hybrid relative to the half-space
/// Time of the hybrid's correction if it is not cached: for halved bodies, for whole bodies, and
/// the growth with the patch's aspect ratio.
constexpr double halved_correction = 4.5, halved_correction_of_length = 1.1;
constexpr double whole_correction = 12.0, whole_correction_of_length = 4.2;
constexpr double kept_correction = 0.01;
/// Time of finite elements with 16 cells across, per 100 000 unknowns of halved bodies.
constexpr double fem_start = 2.5, fem_point = 0.75, fem_whole_times = 1.85;
constexpr double fem_power = 1.5;  ///< exponent of the cells across
/// Free meshes of whole sections have 110 000 to 300 000 unknowns on their coarsest level, which
/// are factorised: a measured pair took 2.2 times the CPU time of its boxes on 8 cells across; the
/// hybrid took 2.8 times.
constexpr double sections_times = 2.8;
/// Unknowns in 100 000 with 16 cells across: for a patch of equal length and width, and the growth
/// with its aspect ratio.
constexpr double fem_unknowns = 1.7, fem_unknowns_of_length = 0.61;

double elongation(const ContactSize& size) {
  return std::max(size.half_length, size.half_width) / std::min(size.half_length, size.half_width);
}

/// Of the surface under the finest cells.
double longer_than_square(const ContactSize& size) {
  return elongation(size) * size.wider - 1.0;
}

double correction_seconds(const ContactSize& size) {
  if (size.correction_kept) return kept_correction;
  const double longer = longer_than_square(size);
  return 0.5 * size.meshed_bodies * (size.true_sections ? sections_times : 1.0) *
         (size.symmetric ? halved_correction + halved_correction_of_length * longer
                         : whole_correction + whole_correction_of_length * longer);
}

/// A grid on which the smallest patch has too few elements to be considered.
bool too_coarse(const ContactSize& size, int across) {
  return across * size.smallest_part < fewest_across;
}

void leave_out_too_coarse(const ContactSize& size, Forecast& forecast) {
  std::vector<Level>& levels = forecast.levels;
  levels.erase(std::remove_if(levels.begin(), levels.end(),
                              [&](const Level& level) { return too_coarse(size, level.across); }),
               levels.end());
  if (levels.empty())
    forecast.cannot = fmt::format(
        "its elements are too large for the patch of the smallest load, which is {:.2g} of the "
        "largest",
        size.smallest_part);
}

/// Elements of the patch; a line contact has one row.
double elements(const ContactSize& size, int across) {
  return size.line ? across : 0.25 * contact::pi * across * across * elongation(size);
}

double law(double error, int at, double across) {
  return error * std::pow(at / across, assumed_order);
}

/// `times` of the number across: cost of an element relative to a plain half-space.
template <class Times>
Forecast on_grids(const ContactSize& size, double fixed, const Times& times) {
  Forecast forecast;
  const double error = size.friction > 0.0 ? error_with_friction : error_without_friction;
  for (const int across : grids_across())
    forecast.levels.push_back({across, law(error, measured_across, across * size.smallest_part),
                               fixed + times(across) * per_element * elements(size, across) *
                                           static_cast<double>(size.load_points)});
  leave_out_too_coarse(size, forecast);
  return forecast;
}

}  // namespace

const std::vector<int>& grids_across() {
  static const std::vector<int> all{16, 20, 24, 32, 40, 48, 64, 80, 96, 128, 160, 240, 320};
  return all;
}

const std::vector<int>& cells_across() {
  static const std::vector<int> all{16, 24, 32, 48};
  return all;
}

double expected_model_error(const ContactSize& size) {
  if (!size.bodies_known) return 0.0;
  // First order in patch over radius; for conforming bodies the common surface makes it second
  // order across. The error of the forces is a part of the normal force, and percentages refer to
  // friction times normal force.
  const double along = size.half_length / size.rolling_radius;
  const double across = size.half_width / size.radius_across;
  const double of_along = size.friction > 0.0 ? 0.36 / size.friction : 0.05;
  return of_along * along + 0.02 * across + 0.25 * across * across;
}

Forecast halfspace_forecast(const ContactSize& size) {
  const double turns = !size.bodies_known ? 0.0 : size.steep ? steep_estimate_times : 1.0;
  const double estimate = turns * of_model_error * static_cast<double>(size.load_points);
  const auto times = [&](int across) {
    if (size.coupled) return coupled_times * std::pow(across / 32.0, coupled_power);
    return size.shares_load ? sharing_times : 1.0;
  };
  Forecast forecast = on_grids(size, start + estimate, times);
  forecast.once = estimate;
  forecast.label = "half-space";
  forecast.model_error = expected_model_error(size);
  return forecast;
}

Forecast hybrid_forecast(const ContactSize& size) {
  const double correction = correction_seconds(size);
  Forecast forecast = on_grids(size, correction, [](int) { return hybrid_times; });
  forecast.once = correction;
  forecast.label = "hybrid";
  forecast.uncertain_part = 0.1;
  forecast.model_error = forecast.uncertain_part * expected_model_error(size);
  return forecast;
}

Forecast fem_forecast(const ContactSize& size) {
  Forecast forecast;
  forecast.label = "finite elements";
  const double error = size.friction > 0.0 ? fem_error_with_friction : fem_error_without_friction;
  const double unknowns = fem_unknowns + fem_unknowns_of_length * longer_than_square(size);
  const double seconds = (size.symmetric ? 1.0 : fem_whole_times) *
                         (size.true_sections ? sections_times : 1.0) * unknowns *
                         (fem_start + fem_point * static_cast<double>(size.load_points));
  for (const int across : cells_across())
    forecast.levels.push_back(
        {across, law(error, measured_cells, across * size.smallest_part),
         seconds * std::pow(static_cast<double>(across) / measured_cells, fem_power)});
  leave_out_too_coarse(size, forecast);
  return forecast;
}

}  // namespace rollfem::modelling
