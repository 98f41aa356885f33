// SPDX-License-Identifier: LGPL-2.1-or-later
// Work of one process for all, such as solving the contact problem: the others sleep until it calls
// them for collective work.
#pragma once

#include <functional>
#include <mpi.h>
#include <sched.h>
#include <string>

namespace rollfem::fem {

class RootProcess {
 public:
  using Command = std::string;

  /// Collective.
  explicit RootProcess(MPI_Comm communicator);

  /// Runs `work` on the root process (rank 0), with all cores and threads of the processes on its
  /// machine. The others sleep except when executing commands, and return when it ends. Its
  /// exceptions are thrown on all processes. Collective.
  void run(const std::function<void()>& work,
           const std::function<void(const Command&)>& execute = {});

  /// Within `work`: collective work, done by the others in `execute(command)`. It throws on all of
  /// them or on none.
  void call(const Command& command, const std::function<void()>& own);

  /// Whether this is the root process.
  bool here() const { return rank_ == 0; }

 private:
  void meet() const;
  void lead(const std::function<void()>& work);
  void listen(const std::function<void(const Command&)>& execute) const;
  void end(char letter, const std::string& text);
  std::string from_root(const std::string& message) const;

  MPI_Comm communicator_;
  int rank_ = 0;
  int processes_ = 1;
  bool together_ = false;  ///< within a call
  // Cores of this process, and of all processes of the machine.
  cpu_set_t cores_{}, cores_of_machine_{};
  int threads_of_machine_ = 1;
};

/// Work that calls MPI or changes meshes, which threads may do one after the other only.
void one_at_a_time(const std::function<void()>& work);

/// Calls work(0), ... work(count - 1), which may be collective: side by side in a single process,
/// by several one after the other. Collective.
void beside_or_in_turn(MPI_Comm communicator, std::size_t count,
                       const std::function<void(std::size_t)>& work);

}  // namespace rollfem::fem
