// SPDX-License-Identifier: LGPL-2.1-or-later
// The two ways in which a run fails: the input is wrong (exit status 2) or the solution failed
// (exit status 1). Everything else is a defect of rollfem.
#pragma once

#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace rollfem::contact {

/// Either of the two.
class Failure : public std::runtime_error {
 public:
  enum class Cause { input, grid, solution };  ///< grid: another one has a solution

  using std::runtime_error::runtime_error;
  virtual Cause cause() const = 0;
  /// The same failure with another text, which says where it happened.
  virtual std::exception_ptr retold(const std::string& text) const = 0;
};

/// The case file or the call is wrong. The text names file, line, key, value, allowed values and
/// remedy.
class InputError : public Failure {
 public:
  using Failure::Failure;
  Cause cause() const override { return Cause::input; }
  std::exception_ptr retold(const std::string& text) const override {
    return std::make_exception_ptr(InputError(text));
  }
};

/// The problem is valid but has no solution or none was found: no contact, infeasible force, an
/// iteration that did not converge. The text states the cause and the residual.
class SolveError : public Failure {
 public:
  using Failure::Failure;
  Cause cause() const override { return Cause::solution; }
  std::exception_ptr retold(const std::string& text) const override {
    return std::make_exception_ptr(SolveError(text));
  }
};

/// The grid is too coarse for a meaningful solution, or too small for the patch; another grid has a
/// solution.
class UnfitGrid : public SolveError {
 public:
  using SolveError::SolveError;
  Cause cause() const override { return Cause::grid; }
  std::exception_ptr retold(const std::string& text) const override {
    return std::make_exception_ptr(UnfitGrid(text));
  }
};

/// Contacts of a wheel, each solved in its own plane, touch or overlap: one conformal contact,
/// which only the common surface of the bodies represents (halfspace.surface = "curved").
class ConformalContact : public SolveError {
 public:
  using SolveError::SolveError;
  std::exception_ptr retold(const std::string& text) const override {
    return std::make_exception_ptr(ConformalContact(text));
  }
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

/// Calls `work`; the text of its failure then begins with `where`, once.
template <class Work>
auto at_place(const std::string& where, const Work& work) {
  try {
    return work();
  } catch (const Failure& failure) {
    const std::string text = failure.what();
    if (text.compare(0, where.size(), where) == 0) throw;
    std::rethrow_exception(failure.retold(where + text));
  }
}

/// What some work gave, or why it failed.
template <class Value>
struct Attempt {
  std::optional<Value> value;
  std::exception_ptr failure;  ///< null if there is a value
  std::string why;             ///< the text of the failure

  explicit operator bool() const { return value.has_value(); }
  Value& operator*() { return *value; }
  const Value& operator*() const { return *value; }
  Value* operator->() { return &*value; }
  const Value* operator->() const { return &*value; }
};

/// For callers that go on without a value. Only failures are caught: defects get through.
template <class Work>
auto attempt(const Work& work) -> Attempt<decltype(work())> {
  try {
    return {work(), nullptr, {}};
  } catch (const Failure& failure) {
    return {std::nullopt, std::current_exception(), failure.what()};
  }
}

}  // namespace rollfem::contact
