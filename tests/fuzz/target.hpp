// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fuzz target does with bytes, with libFuzzer or without it (replay.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

/// "" when the input was taken; otherwise the message it was refused with. Any other end, by a
/// signal or an exception that is no refusal, is a finding.
std::string outcome_of(const std::string& input);

/// Aborts where a refusal is not one line that says what to do.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
