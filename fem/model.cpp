#include "fem/model.hpp"

#include "fem/contact_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace rollfem::fem {

namespace {

using contact::Case;
using contact::ModelResult;

/// The order in h that the two-level estimate assumes, measured on case a (docs/verification.md).
constexpr double assumed_order = 1.5;

/// Error of the fine value from the change between the two levels, relative to the fine value or to
/// `scale` where that is larger (a quantity that vanishes has no relative error).
double two_level_error(double fine, double coarse, double scale) {
  const double reference = std::max(std::abs(fine), scale);
  const double change = std::abs(fine - coarse) / (std::pow(2.0, assumed_order) - 1.0);
  return reference > 0.0 ? change / reference : 0.0;
}

/// Adds to what a point's estimate holds already (the finite segments' part of the approach).
void estimate_errors(ModelResult& fine, const ModelResult& coarse, double friction) {
  for (std::size_t k = 0; k < fine.points.size(); ++k) {
    contact::PointResult& f = fine.points[k];
    const contact::PointResult& c = coarse.points[k];
    const auto set = [&](const char* name, double contact::PointResult::*quantity, double scale) {
      f.error_estimate[name] += two_level_error(f.*quantity, c.*quantity, scale);
    };
    using Point = contact::PointResult;
    set("max_pressure", &Point::max_pressure, 0.0);
    set("normal_force", &Point::normal_force, 0.0);
    set("approach", &Point::approach, 0.0);
    set("semi_axis_x", &Point::semi_axis_x, 0.0);
    set("semi_axis_y", &Point::semi_axis_y, 0.0);
    set("max_traction_x", &Point::max_traction_x, 0.01 * friction * f.max_pressure);
    set("traction_coefficient", &Point::traction_coefficient, 0.01 * friction);
  }
}

}  // namespace

ModelResult run_fem(const Case& input, const contact::Progress& progress,
                    contact::Checkpoint* checkpoint) {
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const double cell = default_cell_size(input);
  refuse_beyond_memory(input, cell);
  const ModelResult coarse =
      run_level(input, {2.0 * cell, "estimate: ", false, checkpoint}, progress);
  const double estimate_seconds = elapsed();
  ModelResult result = run_level(input, {cell, "", input.output.fields, checkpoint}, progress);
  estimate_errors(result, coarse, input.friction_coefficient);
  result.seconds["estimate"] = estimate_seconds;
  result.seconds["total"] = elapsed();
  result.notes.push_back(fmt::format(
      "error estimates: change between cells of {:.4g} and {:.4g} mm divided by 2^{:.1f} - 1",
      2.0 * cell, cell, assumed_order));
  return result;
}

}  // namespace rollfem::fem
