// MPI, initialised only while parallel models run.
#pragma once

#include "models/fem/fem_library.hpp"

#include <string>

namespace rollfem::modelling {

/// Starts MPI, which the finite-element library brings; ends it when it goes.
class ParallelSession {
 public:
  /// `asked_by`: what asked for a parallel model, for the message of a build without the library.
  ParallelSession(const std::string& asked_by, int argc, char** argv);
  ~ParallelSession();
  ParallelSession(const ParallelSession&) = delete;
  ParallelSession& operator=(const ParallelSession&) = delete;

  /// Collective: the text of the first process on every process.
  std::string from_first(const std::string& text) const { return entry_.from_first(text); }

 private:
  const fem::Entry& entry_;
};

}  // namespace rollfem::modelling
