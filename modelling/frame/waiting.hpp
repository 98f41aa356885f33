// SPDX-License-Identifier: LGPL-2.1-or-later
// How the processes of mpirun wait for each other's messages on cores that others use as well.
#pragma once

#include <string>

namespace rollfem::modelling {

/// The shared library whose sched_yield naps; for LD_PRELOAD of another program, which loads it too
/// late otherwise. Empty in a static build.
std::string library_that_waits();

}  // namespace rollfem::modelling
