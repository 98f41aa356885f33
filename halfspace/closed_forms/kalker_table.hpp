// Kalker's table of creepage coefficients at the ratios 0.1, 0.2, ... 1 and nu = 0, 1/4, 1/2.
#pragma once

#include "halfspace/closed_forms/kalker.hpp"

#include <array>

namespace rollfem::halfspace {

/// Coefficients at nu = 0, 1/4, 1/2.
using KalkerRow = std::array<KalkerCoefficients, 3>;
/// Rows for the ratios 0.1, 0.2, ..., 1.
using KalkerTable = std::array<KalkerRow, 10>;

/// Ratio a/b: patches wider than long.
const KalkerTable& kalker_table_short();
/// Ratio b/a: patches longer than wide. The last row is that of the other table.
const KalkerTable& kalker_table_long();

}  // namespace rollfem::halfspace
