// SPDX-License-Identifier: LGPL-2.1-or-later
// The control groups (v1 and v2) of this process: what a container or job may use of its machine.
#pragma once

#include <functional>
#include <string>

namespace rollfem::contact {

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
