// SPDX-License-Identifier: LGPL-2.1-or-later
// Structures of a C program, its units, and exceptions as a status and a text for it.
#pragma once

#include "base/errors.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"
#include <algorithm>
#include <cstring>
#include <new>
#include <string>

namespace rollfem::capi {

inline void copy_message(const std::string& text, char* message, size_t size) {
  if (message == nullptr || size == 0) return;
  const size_t length = std::min(size - 1, text.size());
  std::memcpy(message, text.data(), length);
  message[length] = '\0';
}

[[noreturn]] inline void refuse_size(const char* name, size_t size, size_t first, size_t last) {
  throw contact::InputError(fmt::format(
      "{}: struct_size = {}: is not of this library, version {}; allowed: {} to {}; do: set it to "
      "the sizeof of the structure, and compile with the header of this library or an earlier one",
      name, size, ROLLFEM_VERSION, first, last));
}

/// Dereferences a pointer of the caller. `from`: its origin. Throws contact::InputError for NULL,
/// most often after a refused creation that the caller did not check.
template <class T>
T& wanted(T* pointer, const char* name, const char* from) {
  if (pointer == nullptr)
    throw contact::InputError(fmt::format(
        "{} is NULL; allowed: {}; do: check the status and message of the previous call", name,
        from));
  return *pointer;
}

/// Copies a structure of the caller; members beyond its struct_size are zero. Throws
/// contact::InputError for NULL and for invalid sizes. `first`: its size in the first version.
template <class T>
T taken(const T* given, const char* name, const char* from, size_t first = sizeof(T)) {
  const size_t size = wanted(given, name, from).struct_size;
  if (size < first || size > sizeof(T)) refuse_size(name, size, first, sizeof(T));
  T value{};
  std::memcpy(static_cast<void*>(&value), given, size);
  return value;
}

/// A result of the caller, written up to its struct_size.
template <class T>
class Given {
 public:
  /// Sets all members but struct_size to zero.
  explicit Given(T* place) : place_(place) {
    if (fits()) give({});
  }
  /// Throws contact::InputError as taken() does.
  void check(const char* name, const char* from) const {
    const size_t size = wanted(place_, name, from).struct_size;
    if (!fits()) refuse_size(name, size, sizeof(size_t), sizeof(T));
  }
  bool fits() const {
    return place_ != nullptr && place_->struct_size >= sizeof(size_t) &&
           place_->struct_size <= sizeof(T);
  }
  void give(T value) {
    value.struct_size = place_->struct_size;
    std::memcpy(static_cast<void*>(place_), &value, value.struct_size);
  }

 private:
  T* place_;
};

/// Runs `work` and translates its exceptions.
template <class Work>
rollfem_status guarded(const Work& work, char* message, size_t size) {
  try {
    copy_message("", message, size);
    work();
    return ROLLFEM_OK;
  } catch (const contact::InputError& error) {
    copy_message(error.what(), message, size);
    return ROLLFEM_REFUSED;
  } catch (const std::bad_alloc&) {
    copy_message("out of memory", message, size);
  } catch (const std::exception& error) {
    copy_message(error.what(), message, size);
  }
  return ROLLFEM_FAILED;
}

/// The caller's units in mm and N.
struct Units {
  double length = 1.0;
  double force = 1.0;
  double stress() const { return force / (length * length); }
};

inline Units units_of(rollfem_units units) {
  switch (units) {
    case ROLLFEM_MM_N:
      return {1.0, 1.0};
    case ROLLFEM_M_N:
      return {1e3, 1.0};
    case ROLLFEM_MM_KN:
      return {1.0, 1e3};
  }
  throw contact::InputError(fmt::format(
      "units = {}: is not known; allowed: ROLLFEM_MM_N, ROLLFEM_M_N, ROLLFEM_MM_KN; do: set it to "
      "one of these",
      static_cast<int>(units)));
}

}  // namespace rollfem::capi
