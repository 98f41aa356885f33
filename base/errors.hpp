// SPDX-License-Identifier: LGPL-2.1-or-later
// The two ways in which a run fails: the input is wrong (exit status 2) or the solution failed
// (exit status 1). Everything else is a defect of rollfem.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Where something failed, from the outside inwards: file, wheel, model. Parts may be empty.
using FailurePlace = std::vector<std::string>;

/// Either of the two.
class Failure : public std::runtime_error {
 public:
  enum class Cause { input, grid, solution };  ///< grid: another one has a solution

  explicit Failure(const std::string& text) : std::runtime_error(text), words_(text) {}
  Failure(const FailurePlace& place, const std::string& text) : Failure(text) { put_at(place); }
  /// `text` as for fmt::format.
  template <class... Values>
  Failure(const FailurePlace& place, fmt::format_string<Values...> text, Values&&... values)
      : Failure(place, fmt::format(text, std::forward<Values>(values)...)) {}
  /// Place and text.
  const char* what() const noexcept override { return words_.c_str(); }
  std::string text() const { return std::runtime_error::what(); }
  virtual Cause cause() const = 0;
  /// Inserts the parts of an outer place that this one does not begin with.
  void put_at(const FailurePlace& outer) {
    const auto [own, other] =
        std::mismatch(place_.begin(), place_.end(), outer.begin(), outer.end());
    place_.insert(own, other, outer.end());
    words_.clear();
    for (const std::string& part : place_) words_ += part + (part.empty() ? "" : ": ");
    words_ += text();
  }

 private:
  FailurePlace place_;
  std::string words_;
};

/// The case file or the call is wrong. The text names file, line, key, value, allowed values and
/// remedy.
class InputError : public Failure {
 public:
  using Failure::Failure;
  Cause cause() const override { return Cause::input; }
};

/// The problem is valid but has no solution or none was found: no contact, infeasible force, an
/// iteration that did not converge. The text states the cause and the residual.
class SolveError : public Failure {
 public:
  using Failure::Failure;
  Cause cause() const override { return Cause::solution; }
};

/// The grid is too coarse for a meaningful solution, or too small for the patch; another grid has a
/// solution.
class UnfitGrid : public SolveError {
 public:
  using SolveError::SolveError;
  Cause cause() const override { return Cause::grid; }
};

/// Contacts of a wheel, each solved in its own plane, touch or overlap: one conformal contact,
/// which only the common surface of the bodies represents (halfspace.surface = "curved").
class ConformalContact : public SolveError {
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

/// Calls `work`, whose failures happen at this place.
template <class Work>
auto at_place(const FailurePlace& place, const Work& work) {
  try {
    return work();
  } catch (Failure& failure) {
    failure.put_at(place);
    throw;
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
