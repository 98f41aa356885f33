// SPDX-License-Identifier: LGPL-2.1-or-later
// Interface of a fuzz target, with libFuzzer or without it (replay.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

/// "" if the input was accepted, otherwise the message of the refusal. Any other end, by a signal
/// or another exception, is a finding.
std::string outcome_of(const std::string& input);

/// Whether it is a single printable line that says what to do, or "".
bool is_line_with_advice(const std::string& message);

/// Aborts unless a refusal is a single line with advice.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
