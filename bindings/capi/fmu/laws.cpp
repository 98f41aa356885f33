// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/capi/fmu/laws.h"

#include "case/fall_shape.hpp"

#include <cstdio>
#include <string>

int number_of_law(const char* word, char* message, std::size_t size) {
  std::string words;
  int number = -1;
  for (const rollfem::contact::FallShape& law : rollfem::contact::fall_shapes()) {
    ++number;
    if (std::string(word) == law.word) return number;
    words += (words.empty() ? "" : ", ") + std::string(law.word);
  }
  std::snprintf(message, size, "friction_law; allowed: %s; do: name one of them", words.c_str());
  return -1;
}
