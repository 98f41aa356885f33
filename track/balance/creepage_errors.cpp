// SPDX-License-Identifier: LGPL-2.1-or-later
#include "track/balance/creepage_errors.hpp"

#include "result/refinement.hpp"

#include <cmath>

namespace rollfem::track {

void add_creepage_errors(const std::vector<contact::Scene>& coarse,
                         std::vector<contact::Scene>& scenes) {
  if (coarse.size() != scenes.size()) return;
  for (std::size_t s = 0; s < scenes.size(); ++s)
    for (std::size_t k = 0; k < scenes[s].points.size() && k < coarse[s].points.size(); ++k) {
      const contact::Creepage &a = scenes[s].points[k].creepage, &b = coarse[s].points[k].creepage;
      const auto error = [](double fine, double rough) {
        return contact::uneven_safety * std::abs(fine - rough);
      };
      scenes[s].points[k].creepage_error = {error(a.longitudinal, b.longitudinal),
                                            error(a.lateral, b.lateral), error(a.spin, b.spin)};
    }
}

}  // namespace rollfem::track
