// SPDX-License-Identifier: LGPL-2.1-or-later
// Memory and cores available to this process: /proc/meminfo, cgroups of both versions, the
// environment.
#include "base/available_memory.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"

#include "support/temporary_folder.hpp"

namespace {

/// Folders that stand for /proc and /sys/fs/cgroup.
class Machine : public TemporaryFolder {
 public:
  Machine() { file("proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable: 4000000 kB\n"); }
  double available() const { return contact::available_bytes(path("proc"), path("cgroup")); }
  int cores() const { return contact::allowed_cores(path("proc"), path("cgroup")); }
};

TEST(AvailableMemory, IsWhatTheKernelSays) {
  const Machine machine;
  EXPECT_EQ(machine.available(), 4000000.0 * 1024.0);
}

TEST(AvailableMemory, IsNoMoreThanACgroupOfVersionTwoLeaves) {
  const Machine machine;
  machine.file("proc/self/cgroup", "0::/user/job\n");
  machine.file("cgroup/user/job/memory.max", "max\n");
  machine.file("cgroup/user/job/memory.current", "500\n");
  EXPECT_EQ(machine.available(), 4000000.0 * 1024.0);
  machine.file("cgroup/user/memory.max", "2000000000\n");
  machine.file("cgroup/user/memory.current", "1500000000\n");
  machine.file("cgroup/user/memory.stat", "anon 700000000\ninactive_file 300000000\n");
  EXPECT_EQ(machine.available(), 800000000.0);
}

TEST(AvailableMemory, IsNoMoreThanACgroupOfVersionOneLeaves) {
  const Machine machine;
  machine.file("proc/self/cgroup", "4:cpu,cpuacct:/x\n3:memory:/docker/abc\n");
  // In a container the group itself is mounted as the root.
  machine.file("cgroup/memory/memory.limit_in_bytes", "3000000000\n");
  machine.file("cgroup/memory/memory.usage_in_bytes", "1000000000\n");
  EXPECT_EQ(machine.available(), 2000000000.0);
}

TEST(AvailableMemory, IsWhatTheEnvironmentSays) {
  setenv("ROLLFEM_MEMORY_GB", "1.5", 1);
  EXPECT_EQ(contact::available_bytes(), 1.5e9);
  setenv("ROLLFEM_MEMORY_GB", "plenty", 1);
  EXPECT_THROW(contact::available_bytes(), contact::InputError);
  unsetenv("ROLLFEM_MEMORY_GB");
}

TEST(AllowedCores, AreWhatTheTightestGroupLeaves) {
  const Machine machine;
  EXPECT_GT(machine.cores(), 1000000);
  machine.file("proc/self/cgroup", "0::/user/job\n");
  machine.file("cgroup/user/job/cpu.max", "max 100000\n");
  EXPECT_GT(machine.cores(), 1000000);
  machine.file("cgroup/user/cpu.max", "300000 100000\n");
  EXPECT_EQ(machine.cores(), 3);
  machine.file("cgroup/user/job/cpu.max", "20000 100000\n");
  EXPECT_EQ(machine.cores(), 1);
}

TEST(AllowedCores, OfVersionOneHaveAQuota) {
  const Machine machine;
  machine.file("proc/self/cgroup", "4:cpu,cpuacct:/x\n");
  machine.file("cgroup/cpu/x/cpu.cfs_quota_us", "-1\n");
  machine.file("cgroup/cpu/x/cpu.cfs_period_us", "100000\n");
  EXPECT_GT(machine.cores(), 1000000);
  machine.file("cgroup/cpu/x/cpu.cfs_quota_us", "200000\n");
  EXPECT_EQ(machine.cores(), 2);
}

}  // namespace
