// SPDX-License-Identifier: LGPL-2.1-or-later
// Expected errors and costs of half-space, hybrid and finite elements from the size of the contact
// alone. The constants are measured; method and reliability: docs/choice.md, docs/accuracy.md.
#pragma once

#include "modelling/choice/forecast.hpp"

#include <vector>

namespace rollfem::modelling {

/// Properties of a contact known before it is solved.
struct ContactSize {
  double half_length = 0.0;     ///< mm, of the patch along rolling
  double half_width = 0.0;      ///< mm, across
  double rolling_radius = 0.0;  ///< mm; infinity: none
  double radius_across = 0.0;   ///< mm, the smaller of wheel and rail without sign; infinity: flat
  double friction = 0.0;        ///< coefficient; 0: without tractions
  bool bodies_known = true;     ///< given by radii or profiles, not only by their distance
  std::size_t load_points = 1;
  /// Size of the patch at the smallest load over that at the largest; both have elements of the
  /// same size.
  double smallest_part = 1.0;
  bool symmetric = true;         ///< about the plane along rolling: half of each body is meshed
  bool line = false;             ///< endless rollers
  bool true_sections = false;    ///< bodies are meshed as whole sections, not as boxes
  bool steep = false;            ///< steep profiles beside the patch
  bool shares_load = false;      ///< friction carries a part of the load of a tilted contact
  bool coupled = false;          ///< pressure and friction of a half-space influence each other
  int meshed_bodies = 2;         ///< neither rigid nor flat, for the hybrid
  bool correction_kept = false;  ///< the hybrid's correction is in the cache
  double wider = 1.0;            ///< width that bodies are laid out around over the loaded width
};

/// Grids that are tried, by elements across.
const std::vector<int>& grids_across();  ///< of half-space and hybrid
const std::vector<int>& cells_across();  ///< of finite elements

/// Expected model error of the half-space as part of the whole of the worst quantity; 0 if the
/// bodies are not known.
double expected_model_error(const ContactSize& size);

/// Forecasts without the names of the models.
Forecast halfspace_forecast(const ContactSize& size);
Forecast hybrid_forecast(const ContactSize& size);
Forecast fem_forecast(const ContactSize& size);

}  // namespace rollfem::modelling
