// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory still available on this machine, so that a run that does
// not fit reports it instead of being killed.
#pragma once

#include <string>

namespace rollfem::contact {

/// What this machine still has for this process: MemAvailable of /proc/meminfo, what a cgroup (v1
/// or v2) leaves, or the environment variable ROLLFEM_MEMORY_GB (GB of 1e9 bytes) in place of both.
/// Infinite when none can be read. Throws InputError for a value that is not a number.
double available_bytes();

/// The same from given places, for tests: a folder that stands for /proc and one for
/// /sys/fs/cgroup.
double available_bytes(const std::string& proc, const std::string& cgroup);

/// "2.5 GB", of 1e9 bytes; "unknown memory" for infinity.
std::string in_gigabytes(double bytes);

}  // namespace rollfem::contact
