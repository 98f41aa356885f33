// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers that a test passes to the verification book (benchmarks/book), which quotes them beside
// their closed form.
#pragma once

#include <fmt/format.h>

#include "support/test.hpp"

namespace rollfem::testing {

/// Records `value` with all digits in the report of the running test (GoogleTest's RecordProperty).
inline void record(const std::string& name, double value) {
  ::testing::Test::RecordProperty(name, fmt::format("{:.10g}", value));
}

}  // namespace rollfem::testing
