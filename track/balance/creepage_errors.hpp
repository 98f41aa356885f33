// SPDX-License-Identifier: LGPL-2.1-or-later
// Error bars of the creepages at which wheels turn freely.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace rollfem::track {

/// Errors of the creepages from a balance on half as many elements: 1.5 times the change, as for
/// forces (docs/accuracy.md). None where the coarse balance finds other patches.
void add_creepage_errors(const std::vector<contact::Scene>& coarse,
                         std::vector<contact::Scene>& scenes);

}  // namespace rollfem::track
