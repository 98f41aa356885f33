// SPDX-License-Identifier: LGPL-2.1-or-later
// Initialises MPI for a test program that is linked with gtest_main, and limits deal.II to one
// thread. Include it in exactly one source of the program. Under mpirun every process runs the same
// tests; only the first one prints more than failures.
#pragma once

#include <deal.II/base/mpi.h>

#include "support/test.hpp"
#include <cstdio>
#include <sched.h>

namespace rollfem::testing {

/// Output of processes after the first: failures only.
class FailurePrinter : public ::testing::EmptyTestEventListener {
  void OnTestPartResult(const ::testing::TestPartResult& result) override {
    if (result.failed())
      std::printf("process %u: %s:%d: %s\n",
                  dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD), result.file_name(),
                  result.line_number(), result.message());
  }
};

class MpiEnvironment : public ::testing::Environment {
 public:
  void SetUp() override {
    // No arguments of the command line are for MPI.
    static int argc = 1;
    static char name[] = "test";
    static char* arguments[] = {name, nullptr};
    static char** argv = arguments;
    // Waiting sleeps as in the program: this links its sched_yield.
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    sched_yield();
    mpi_ = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) {
      auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
      silenced_.reset(listeners.Release(listeners.default_result_printer()));
      listeners.Append(new FailurePrinter);
    }
  }
  void TearDown() override { mpi_.reset(); }

 private:
  std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi_;
  std::unique_ptr<::testing::TestEventListener> silenced_;
};

[[maybe_unused]] inline ::testing::Environment* const mpi_environment =
    ::testing::AddGlobalTestEnvironment(new MpiEnvironment);

}  // namespace rollfem::testing
