// SPDX-License-Identifier: LGPL-2.1-or-later
// Work of one process for all, such as solving the contact problem: the others sleep until it calls
// them for collective work.
#pragma once

#include <functional>
#include <mpi.h>
#include <sched.h>
#include <string>

namespace rollfem::fem {

class FirstProcess {
 public:
  using Order = std::string;

  /// Collective.
  explicit FirstProcess(MPI_Comm communicator);

  /// Runs `work` on the first process, with all cores and threads of the processes on its machine.
  /// The others sleep except when executing orders, and return when it ends. Its exceptions are
  /// thrown on all processes. Collective.
  void run(const std::function<void()>& work, const std::function<void(const Order&)>& obey = {});

  /// Within `work`: collective work, done by the others in `obey(order)`. It throws on all of them
  /// or on none.
  void call(const Order& order, const std::function<void()>& own);

  /// Whether this is the first process.
  bool here() const { return rank_ == 0; }

 private:
  void meet() const;
  void lead(const std::function<void()>& work);
  void follow(const std::function<void(const Order&)>& obey) const;
  void end(char letter, const std::string& text);
  std::string from_first(const std::string& said) const;

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
