// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/program.hpp"
#include "modelling/registry.hpp"

#include <malloc.h>

namespace {

/// Grids of all sizes come and go: glibc would give their memory back to the system and fetch it
/// again, page by page, thousands of times a second. These are the limits that it takes itself
/// once a block of 32 MB has been freed.
void keep_freed_memory() {
#ifdef M_MMAP_THRESHOLD
  constexpr int largest_in_heap = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, largest_in_heap);
  mallopt(M_TRIM_THRESHOLD, 2 * largest_in_heap);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  return rollfem::app::run_program(argc, argv, rollfem::modelling::built_in_models());
}
