// SPDX-License-Identifier: LGPL-2.1-or-later
// Expected errors and costs of half-space, hybrid and finite elements from the size of the contact
// alone. The constants are measured; method and reliability: docs/choice.md, docs/accuracy.md.
#pragma once

#include "models/choice/forecast.hpp"

#include <vector>

namespace rollfem::modelling {

/// What is known of a contact before anything is solved.
struct ContactSize {
  double half_length = 0.0;     ///< mm, of the patch along rolling
  double half_width = 0.0;      ///< mm, across
  double rolling_radius = 0.0;  ///< mm; infinity: none
  double radius_across = 0.0;   ///< mm, the smaller of wheel and rail without sign; infinity: flat
  double friction = 0.0;        ///< coefficient; 0: no tractions are asked for
  bool bodies_known = true;     ///< by radii or profiles; else by their distance alone
  std::size_t load_points = 1;
  /// The patch of the smallest load over that of the largest: elements are of one size.
  double smallest_part = 1.0;
  bool symmetric = true;         ///< about the plane along rolling: half of each body is meshed
  bool line = false;             ///< endless rollers
  bool true_sections = false;    ///< bodies are meshed as whole sections, not as boxes
  bool steep = false;            ///< profiles are beside the patch
  bool shares_load = false;      ///< friction carries a part of the load of a tilted contact
  bool coupled = false;          ///< pressure and friction of a half-space change each other
  int meshed_bodies = 2;         ///< neither rigid nor flat (hybrid)
  bool correction_kept = false;  ///< the hybrid's is there from an earlier run
};

/// Grids that are tried.
const std::vector<int>& grids_across();  ///< of half-space and hybrid
const std::vector<int>& cells_across();  ///< of finite elements

/// As part of the whole of the worst quantity; 0 where bodies are not known.
double expected_model_error(const ContactSize& size);

/// What the half-space's model error is solved for on: 0 where it need not be, as twice what is
/// expected is no more than half the accuracy.
int elements_of_model_error(const ContactSize& size, double accuracy);

/// Above all model errors found, as part of the whole of the worst quantity.
double largest_model_error(const ContactSize& size);

/// Without the names of the models. `accuracy`: that is asked for.
Forecast halfspace_forecast(const ContactSize& size, double accuracy);
Forecast hybrid_forecast(const ContactSize& size);
Forecast fem_forecast(const ContactSize& size);

}  // namespace rollfem::modelling
