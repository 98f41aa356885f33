// SPDX-License-Identifier: LGPL-2.1-or-later
// Counts that do not fit are refused by name; those that do are the number.
#include "base/count.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"

TEST(Count, IsTheWholeNumber) {
  for (const double number : {0.0, 1.0, -7.0, 1e8, -1e8})
    EXPECT_EQ(static_cast<double>(count_of(number, "cells")), number);
}

TEST(Count, IsRefusedWhereAnIntWouldOverflow) {
  for (const double number : {1.1e8, -1.1e8, 1e300, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    const char* what = "cells of the grid (contact_grid.cell_size)";
    EXPECT_EQ(refusal<InputError>([&] {
                count_of(number, what);
              }).rfind("cells of the grid (contact_grid.cell_size): ", 0),
              0u)
        << number;
  }
}

TEST(Count, SaysNoNumberWhereThereIsNone) {
  for (const double number : {HUGE_VAL, std::nan("")}) {
    const std::string message = refusal<InputError>([&] { count_of(number, "cells"); });
    EXPECT_TRUE(says(message, "not finite", "do: give", "check the units"));
    EXPECT_FALSE(says(message, "nan"));
    EXPECT_FALSE(says(message, "inf "));
  }
}
