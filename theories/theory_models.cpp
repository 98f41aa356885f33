// SPDX-License-Identifier: LGPL-2.1-or-later
#include "theories/theory_models.hpp"

#include "theories/carter.hpp"
#include "theories/closed_forms.hpp"
#include "theories/elliptic_patch.hpp"
#include "theories/fastsim.hpp"
#include "theories/strip.hpp"

#include <utility>

namespace rollfem::theories {

const contact::ModelRegistry& models() {
  static const contact::ModelRegistry all = [] {
    contact::ModelRegistry list;
    for (auto* model : {hertz_model, linear_model, vermeulen_johnson_model, polach_model,
                        carter_model, fastsim_model, fastrip_model, strip_model})
      list.add(model());
    return list;
  }();
  return all;
}

}  // namespace rollfem::theories
