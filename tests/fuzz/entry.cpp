// SPDX-License-Identifier: LGPL-2.1-or-later
// libFuzzer's entry: every refusal is one printable line with advice.
#include "fuzz/target.hpp"
#include <cstdio>
#include <cstdlib>

bool is_line_with_advice(const std::string& message) {
  bool fine = message.empty() || message.find("do: ") != std::string::npos;
  for (const char c : message) fine = fine && static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
  return fine;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string message = outcome_of(std::string(reinterpret_cast<const char*>(data), size));
  if (!is_line_with_advice(message)) {
    std::fprintf(stderr, "not a line that says what to do: %s\n", message.c_str());
    std::abort();
  }
  return 0;
}
