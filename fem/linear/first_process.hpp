// SPDX-License-Identifier: LGPL-2.1-or-later
// What one process does for all, as solving the contact problem: the others sleep until it calls
// them for what all do together.
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

  /// On the first process, with all cores and threads that the processes of its machine have:
  /// `work`. The others sleep meanwhile, but for orders, which they obey, and return when it ends.
  /// What it throws is thrown on all of them. Collective.
  void run(const std::function<void()>& work, const std::function<void(const Order&)>& obey = {});

  /// Within `work`: what all do together, the others by `obey(order)`. It throws on all of them or
  /// on none.
  void call(const Order& order, const std::function<void()>& own);

  /// This one.
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
  // Of its own, and of all processes of the machine.
  cpu_set_t cores_{}, cores_of_machine_{};
  int threads_of_machine_ = 1;
};

}  // namespace rollfem::fem
