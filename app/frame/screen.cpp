// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/frame/screen.hpp"

#include "modelling/program/provenance.hpp"

#include <iostream>
#include <streambuf>

namespace rollfem::app {

namespace {

/// Accepts everything and keeps nothing.
class Nowhere : public std::streambuf {
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

std::streambuf* shown = nullptr;

}  // namespace

void silence() {
  static Nowhere nowhere;
  if (shown == nullptr) shown = std::cout.rdbuf(&nowhere);
}

void print_result(const std::string& json) {
  std::streambuf* const before = shown == nullptr ? nullptr : std::cout.rdbuf(shown);
  std::cout << json << (json.empty() || json.back() != '\n' ? "\n" : "") << std::flush;
  // A failure of the real output stays in the state of the stream.
  const std::ios::iostate state = std::cout.rdstate();
  if (before != nullptr) std::cout.rdbuf(before);
  std::cout.setstate(state);
}

nlohmann::ordered_json result_head(const std::string& kind) {
  return {{"format", 1},
          {"kind", kind},
          {"program", {{"version", modelling::version()}, {"commit", modelling::commit()}}}};
}

}  // namespace rollfem::app
