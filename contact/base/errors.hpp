// SPDX-License-Identifier: LGPL-2.1-or-later
// The two ways in which a run fails: the input is wrong (exit status 2) or the solution failed
// (exit status 1). Everything else is a defect of rollfem.
#pragma once

#include <stdexcept>
#include <string>

namespace rollfem::contact {

/// The case file or the call is wrong. The text names file, line, key, value, allowed values and
/// remedy.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The problem is valid but has no solution or none was found: no contact, infeasible force, an
/// iteration that did not converge. The text states the cause and the residual.
class SolveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The grid is too coarse for a meaningful solution, or too small for the patch; another grid has a
/// solution.
class UnfitGrid : public SolveError {
 public:
  using SolveError::SolveError;
};

/// A file that is missing, cannot be read or written, is damaged or of another kind: callers may
/// tell it from wrong values.
class FileError : public InputError {
 public:
  using InputError::InputError;
};

/// The call is right, but its output cannot be written: the disk is full or fails (exit status 1).
class OutputError : public FileError {
 public:
  using FileError::FileError;
};

}  // namespace rollfem::contact
