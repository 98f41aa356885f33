// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory still available on this machine, so that a run that does
// not fit reports it instead of being killed.
#pragma once

#include <string>

namespace rollfem::contact {

/// Memory available to this process: the smaller of MemAvailable in /proc/meminfo and the remainder
/// of its cgroup limit (v1 or v2); the environment variable ROLLFEM_MEMORY_GB (GB of 1e9 bytes)
/// overrides both. Infinite when none can be read. Throws InputError for a value that is not a
/// number.
double available_bytes();

/// The same with folders that replace /proc and /sys/fs/cgroup, for tests.
double available_bytes(const std::string& proc, const std::string& cgroup);

/// "2.5 GB", of 1e9 bytes; "unknown memory" for infinity.
std::string in_gigabytes(double bytes);

}  // namespace rollfem::contact
