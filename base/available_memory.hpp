// SPDX-License-Identifier: LGPL-2.1-or-later
// What a container or job may use of its machine: memory still available, so that a run that does
// not fit reports it instead of being killed, and the control groups (v1 and v2) that limit it.
#pragma once

#include <functional>
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

/// Calls `visit` with the folder of each group that limits `controller` ("memory", "cpu"), from the
/// group of this process up to the root, because all their limits apply; `unified` for version 2.
/// `proc` replaces /proc, `root` replaces /sys/fs/cgroup. Folders need not exist: a container may
/// hide them.
void for_each_cgroup(const std::string& proc, const std::string& root,
                     const std::string& controller,
                     const std::function<void(const std::string& group, bool unified)>& visit);

/// The first number in a file; infinite for "max" and without a number.
double first_number(const std::string& file);

}  // namespace rollfem::contact
