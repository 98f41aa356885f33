// SPDX-License-Identifier: LGPL-2.1-or-later
// The state behind the functions of CONTACT's library: result elements, their contact problems,
// and the log. Every function runs inside `guarded`, so that no call ends the client.
#pragma once

#include "bindings/contact/problem.hpp"

#include <array>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

namespace rollfem::addon {

// Arguments of the interface, all by reference.
using Int = const int*;
using Real = const double*;

/// A pair of wheel and rail (module 1, one problem with any number of patches), or a set of contact
/// problems (module 3).
struct Element {
  int module = 3;
  std::mutex mutex;  ///< held by each call
  std::map<int, Problem> problems;
  Problem as_set_for_all;  ///< of module 3 by icp <= 0: what new problems begin with
};

/// All result elements; one for each process.
class Library {
 public:
  static Library& here();

  /// `ioutput` 1: the log also goes to the screen. Folders may be empty: the current one.
  void open(const std::string& work_folder, const std::string& log_folder, int ioutput);
  void set_flag(int code, int value);
  /// Creates the element anew if it is not of this module.
  std::shared_ptr<Element> begin(int ire, int module);
  /// Null: unknown.
  std::shared_ptr<Element> find(int ire) const;
  /// Throws Refusal for an unknown one.
  std::shared_ptr<Element> at(int ire) const;
  void end(int ire);
  void end_all();

  /// A line of contact_addon.out.
  void log(const std::string& line);
  /// A file as a client names it.
  std::string path_of(const std::string& name) const;
  int threads() const { return threads_; }

 private:
  mutable std::mutex mutex_;
  std::map<int, std::shared_ptr<Element>> elements_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> log_{nullptr, &std::fclose};
  std::string work_folder_, log_folder_;
  bool logged_ = false, screen_ = false;
  int debug_ = 1, threads_ = 1;
};

/// Runs a function of the interface: null arguments and exceptions become a line of the log and,
/// where the function has one, its error code (`ierror` may be null); otherwise that is what `work`
/// returns.
void guarded(const char* function, std::initializer_list<const void*> arguments, int* ierror,
             const std::function<int()>& work);
void guarded(const char* function, std::initializer_list<const void*> arguments,
             const std::function<void()>& work);

/// Calls `work` for the problems that a setting concerns: module 1 has one; in module 3 icp <= 0
/// concerns all. Creates the element (module 3) and the problem where they are new.
void for_problems(int ire, int icp, const std::function<void(Problem&)>& work);

/// Calls `work` for the problem of a wheel and its rail. Throws Refusal in module 3.
void for_pair(int ire, const std::function<void(Problem&)>& work);

/// Calls `work` for an existing problem.
void for_problem(int ire, int icp, const std::function<void(Problem&)>& work);

/// Calls `work` for a solved patch: number icp of module 1, the first for icp <= 0; the only one of
/// module 3.
void for_patch(int ire, int icp, const std::function<void(Problem&, const Patch&)>& work);

/// The text of a client: up to its length or its first 0, without blanks at the ends.
std::string text_of(const char* text, int length);

/// Throws Refusal for null arrays of integers and reals that have a length.
void demand_arrays(Int nints, Int iparam, Int nreals, Real rparam);

}  // namespace rollfem::addon
