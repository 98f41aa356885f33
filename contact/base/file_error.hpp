// SPDX-License-Identifier: LGPL-2.1-or-later
// A file that is missing, cannot be read or written, is damaged or of another kind: an InputError
// that callers may tell from wrong values.
#pragma once

#include "contact/base/errors.hpp"

namespace rollfem::contact {

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
