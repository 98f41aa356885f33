// SPDX-License-Identifier: LGPL-2.1-or-later
// Translates exceptions to a status and a text for C.
#pragma once

#include "contact/base/errors.hpp"

#include <fmt/format.h>

#include "rollfem/rollfem.h"
#include <algorithm>
#include <cstring>
#include <new>
#include <string>

namespace rollfem::capi {

inline void tell(const std::string& text, char* message, size_t size) {
  if (message == nullptr || size == 0) return;
  const size_t length = std::min(size - 1, text.size());
  std::memcpy(message, text.data(), length);
  message[length] = '\0';
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

/// Runs `work` and translates its exceptions.
template <class Work>
rollfem_status guarded(const Work& work, char* message, size_t size) {
  try {
    tell("", message, size);
    work();
    return ROLLFEM_OK;
  } catch (const contact::InputError& error) {
    tell(error.what(), message, size);
    return ROLLFEM_REFUSED;
  } catch (const std::bad_alloc&) {
    tell("out of memory", message, size);
  } catch (const std::exception& error) {
    tell(error.what(), message, size);
  }
  return ROLLFEM_FAILED;
}

}  // namespace rollfem::capi
