// SPDX-License-Identifier: LGPL-2.1-or-later
// Messages when Ctrl-C, SIGTERM or SIGHUP ends the program.
#pragma once

#include <string>

namespace rollfem::app {

/// From here on such a signal says what was said last to `say_when_interrupted`, and then ends the
/// program as it would have (status 130 for Ctrl-C, 143 for SIGTERM). One that is ignored stays so.
void tell_of_interruptions();

/// One sentence without the end; empty: nothing is said.
void say_when_interrupted(const std::string& what);

/// A file, or a folder if it is empty, that is removed then; in the order of the calls. Some
/// hundred at most.
void remove_when_interrupted(const std::string& path);
/// They stay.
void remove_nothing_when_interrupted();

}  // namespace rollfem::app
