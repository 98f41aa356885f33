// SPDX-License-Identifier: LGPL-2.1-or-later
// A library that adds the law to those of the process that loads it (tests/python/fmu.py).
#include "support/power_law.hpp"

[[maybe_unused]] static const bool added = (rollfem::test::add_power_law(), true);
