// SPDX-License-Identifier: LGPL-2.1-or-later
// One process works for all: the others execute its commands, sleep between them, and end as it
// ends.
#include "base/errors.hpp"
#include "base/threads.hpp"
#include "fem/linear/root_process.hpp"

#include <deal.II/base/mpi.h>

#include "support/mpi_environment.hpp"
#include <chrono>
#include <ctime>
#include <new>
#include <sys/resource.h>
#include <thread>

namespace {

int processes() {
  return static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What arrives on this process when the work of the first one throws `error`.
template <class Arriving, class Error>
std::string arriving(const Error& error) {
  fem::RootProcess first(MPI_COMM_WORLD);
  try {
    first.run([&] { throw error; });
  } catch (const Arriving& caught) {
    return caught.what();
  }
  return "nothing";
}

TEST(RootProcess, CallsAllInTheOrderOfItsWork) {
  fem::RootProcess first(MPI_COMM_WORLD);
  std::vector<std::string> done;
  std::vector<double> sums;
  const auto together = [&](const std::string& command) {
    done.push_back(command);
    sums.push_back(dealii::Utilities::MPI::sum(1.0, MPI_COMM_WORLD));
  };
  int works = 0;
  first.run(
      [&] {
        ++works;
        for (const std::string command : {"", "a", "bc"})
          first.call(command, [&] { together(command); });
      },
      together);
  EXPECT_EQ(works, first.here() ? 1 : 0);
  EXPECT_EQ(done, (std::vector<std::string>{"", "a", "bc"}));
  EXPECT_EQ(sums, std::vector<double>(3, processes()));
}

TEST(RootProcess, WhatItThrowsIsThrownOnAll) {
  EXPECT_EQ(arriving<contact::InputError>(contact::InputError("input")), "input");
  EXPECT_EQ(arriving<contact::SolveError>(contact::SolveError("solve")), "solve");
  EXPECT_EQ(arriving<contact::UnfitGrid>(contact::UnfitGrid("grid")), "grid");
  EXPECT_EQ(arriving<std::exception>(std::logic_error("defect")), "defect");
  EXPECT_NE(arriving<std::bad_alloc>(std::bad_alloc()), "nothing");
}

TEST(RootProcess, WhatAllThrowTogetherEndsTheWorkOnce) {
  fem::RootProcess first(MPI_COMM_WORLD);
  const auto together = [](const std::string& command) { throw contact::SolveError(command); };
  for (int round = 0; round < 2; ++round)
    EXPECT_THROW(first.run([&] { first.call("fails", [&] { together("fails"); }); }, together),
                 contact::SolveError);
  EXPECT_EQ(dealii::Utilities::MPI::sum(1, MPI_COMM_WORLD), processes());
}

TEST(RootProcess, OthersSleepWhileItWorks) {
  fem::RootProcess first(MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = cpu_seconds();
  constexpr std::chrono::milliseconds work(500);
  first.run([&] {
    for (const auto end = std::chrono::steady_clock::now() + work;
         std::chrono::steady_clock::now() < end;)
      ;
  });
  if (!first.here()) {
    EXPECT_LT(cpu_seconds() - begin, 0.05);
  }
}

/// Not the CPU time, which yielding does not take either on a busy machine.
TEST(RootProcess, OthersSleepInAnyCallOfMpi) {
  const bool first = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  MPI_Barrier(MPI_COMM_WORLD);
  rusage begin{}, end{};
  getrusage(RUSAGE_THREAD, &begin);
  if (first) std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(dealii::Utilities::MPI::sum(1, MPI_COMM_WORLD), processes());
  getrusage(RUSAGE_THREAD, &end);
  if (!first) {
    EXPECT_GT(end.ru_nvcsw - begin.ru_nvcsw, 50);  // 500 naps of 1 ms
  }
}

TEST(RootProcess, HasTheThreadsOfAllWhileItWorksAlone) {
  const int own = contact::threads();
  fem::RootProcess first(MPI_COMM_WORLD);
  int alone = 0;
  first.run([&] { alone = contact::threads(); });
  const int cores = std::min(static_cast<int>(std::thread::hardware_concurrency()),
                             contact::allowed_cores("/proc", "/sys/fs/cgroup"));
  if (first.here()) {
    EXPECT_GE(alone, std::max(own, std::min(processes(), cores)));
  }
  EXPECT_EQ(contact::threads(), own);
}

}  // namespace
