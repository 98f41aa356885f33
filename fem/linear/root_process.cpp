// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fem/linear/root_process.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

namespace rollfem::fem {

namespace {

/// The first letter of a message of the root process: a command, the end of its work, or its error.
constexpr char command_letter = 'o', end_letter = 'e', input_letter = 'i', unfit_letter = 'u',
               solve_letter = 's', memory_letter = 'm', other_letter = 'x';

char letter_of(const std::exception& error) {
  if (dynamic_cast<const contact::InputError*>(&error) != nullptr) return input_letter;
  if (dynamic_cast<const contact::UnfitGrid*>(&error) != nullptr) return unfit_letter;
  if (dynamic_cast<const contact::SolveError*>(&error) != nullptr) return solve_letter;
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? memory_letter : other_letter;
}

[[noreturn]] void throw_of(char letter, const std::string& text) {
  if (letter == input_letter) throw contact::InputError(text);
  if (letter == unfit_letter) throw contact::UnfitGrid(text);
  if (letter == solve_letter) throw contact::SolveError(text);
  if (letter == memory_letter) throw std::bad_alloc();
  throw std::runtime_error(text);
}

/// While it exists, this thread and the threads it starts run on these cores.
class OnCores {
 public:
  OnCores(const cpu_set_t& cores, const cpu_set_t& afterwards) : afterwards_(afterwards) {
    sched_setaffinity(0, sizeof cores, &cores);
  }
  ~OnCores() { sched_setaffinity(0, sizeof afterwards_, &afterwards_); }
  OnCores(const OnCores&) = delete;
  OnCores& operator=(const OnCores&) = delete;

 private:
  cpu_set_t afterwards_;
};

}  // namespace

RootProcess::RootProcess(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &processes_);
  if (processes_ == 1) return;
  MPI_Comm machine;
  MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  CPU_ZERO(&cores_);
  sched_getaffinity(0, sizeof cores_, &cores_);
  MPI_Allreduce(&cores_, &cores_of_machine_, sizeof cores_, MPI_BYTE, MPI_BOR, machine);
  const int own = contact::threads();
  MPI_Allreduce(&own, &threads_of_machine_, 1, MPI_INT, MPI_SUM, machine);
  threads_of_machine_ = std::min({threads_of_machine_, CPU_COUNT(&cores_of_machine_),
                                  contact::allowed_cores("/proc", "/sys/fs/cgroup")});
  MPI_Comm_free(&machine);
}

void RootProcess::run(const std::function<void()>& work,
                      const std::function<void(const Command&)>& execute) {
  if (processes_ == 1)
    work();
  else if (here())
    lead(work);
  else
    listen(execute);
}

/// Waits for all processes. Waiting in MPI calls would occupy a core.
void RootProcess::meet() const {
  constexpr std::chrono::microseconds longest(1000);
  std::chrono::microseconds nap(20);
  MPI_Request request;
  MPI_Ibarrier(communicator_, &request);
  for (;;) {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return;
    std::this_thread::sleep_for(nap);
    nap = std::min(2 * nap, longest);
  }
}

std::string RootProcess::from_root(const std::string& message) const {
  meet();
  return dealii::Utilities::MPI::broadcast(communicator_, message);
}

void RootProcess::end(char letter, const std::string& text) {
  if (together_) return;  // the others throw the same error
  from_root(letter + text);
}

void RootProcess::lead(const std::function<void()>& work) {
  together_ = false;
  try {
    const OnCores cores(cores_of_machine_, cores_);
    const contact::Threads threads(threads_of_machine_);
    work();
  } catch (const std::exception& error) {
    end(letter_of(error), error.what());
    throw;
  }
  end(end_letter, "");
}

void RootProcess::listen(const std::function<void(const Command&)>& execute) const {
  for (;;) {
    std::string message = from_root({});
    const char letter = message.front();
    message.erase(0, 1);
    if (letter == end_letter) return;
    if (letter != command_letter) throw_of(letter, message);
    execute(message);
  }
}

void RootProcess::call(const Command& command, const std::function<void()>& own) {
  if (processes_ == 1) return own();
  from_root(command_letter + command);
  const OnCores cores(cores_, cores_of_machine_);
  together_ = true;
  own();
  together_ = false;
}

void one_at_a_time(const std::function<void()>& work) {
  static std::mutex at_work;
  const std::lock_guard<std::mutex> lock(at_work);
  contact::isolated(work);
}

void beside_or_in_turn(MPI_Comm communicator, std::size_t count,
                       const std::function<void(std::size_t)>& work) {
  if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
    return contact::for_each_index(count, work);
  for (std::size_t k = 0; k < count; ++k) work(k);
}

}  // namespace rollfem::fem
