// One position of the wheelset in balance: the loads of its patches and its rotation.
#pragma once

#include "wheelset/balance.hpp"

namespace rollfem::wheelset {

/// Scenes of the wheels at one position, those that carry no load left out; throws as balance().
std::vector<contact::Case> balanced_position(const contact::Case& input,
                                             const std::vector<PlacedWheel>& wheels);

}  // namespace rollfem::wheelset
