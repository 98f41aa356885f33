// SPDX-License-Identifier: LGPL-2.1-or-later
// Progress events of a running model: stage, load point, iteration. Models only send
// them; the program decides whether and how to show them.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace rollfem::contact {

struct ProgressEvent {
  std::string model;               ///< "fem"
  std::string stage;               ///< "mesh", "factorise wheel", "normal", "rolling", "shift", ...
  int point = 0;                   ///< 1-based load point, 0 for stages outside load points
  int points = 0;                  ///< number of load points
  std::optional<double> creepage;  ///< longitudinal, where the bodies roll with friction
  int iteration = 0;               ///< outer (FE) or Newton (half-space) iteration
  double residual = 0.0;           ///< relative residual of that iteration, 0 if none
  int contact_elements = 0;        ///< active set
  int adhesion_elements = 0;
  bool finished = false;  ///< the stage has finished
  std::string note;       ///< e.g. "2 x 184 512 unknowns"
  bool warns = false;     ///< the note is a warning
};

/// May be empty: models then run silently.
using Progress = std::function<void(const ProgressEvent&)>;

inline void report(const Progress& progress, const ProgressEvent& event) {
  if (progress) progress(event);
}

// Wall-clock seconds since a start: the cost stored with every result.

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace rollfem::contact
