// SPDX-License-Identifier: LGPL-2.1-or-later
// Messages when Ctrl-C, SIGTERM or SIGHUP ends the program.
#pragma once

#include <string>

namespace rollfem::modelling {

/// Installs handlers that print the last text given to `say_when_interrupted` and then end the
/// program as usual (status 130 for Ctrl-C, 143 for SIGTERM). Ignored signals stay ignored.
void handle_interruptions();

/// Sets the message: one sentence without a full stop; empty: no message.
void say_when_interrupted(const std::string& what);

/// Registers a file, or a folder if empty, for removal on interruption, in the order of the calls.
/// Holds some hundred entries at most.
void remove_when_interrupted(const std::string& path);
/// Cancels these removals.
void remove_nothing_when_interrupted();

}  // namespace rollfem::modelling
