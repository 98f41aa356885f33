// SPDX-License-Identifier: LGPL-2.1-or-later
// The bytes of a .msh file and the reading position: numbers as text or binary, never beyond the
// end. Internal to meshes/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rollfem::meshes {

/// Advice for a damaged file, unless another one is given.
inline constexpr const char* save_msh_again = "save the mesh again (gmsh -format msh41)";

/// Format of a .msh file from its section $MeshFormat.
struct MshFormat {
  bool old = false;              ///< 2.2 instead of 4.1
  bool binary = false;           ///< numbers are in this machine's binary format
  std::size_t count_bytes = 8U;  ///< a count or tag in the binary format 4.1: 4 or 8 bytes
};

/// Every reading function throws contact::InputError naming the file and the line (text) or byte
/// (binary) when the file ends early or holds something else. `what` names the expected value: "the
/// number of nodes".
class MshBytes {
 public:
  /// Reads the file. `name` is used in messages. Throws contact::InputError when the file cannot be
  /// read.
  MshBytes(const std::string& path, std::string name);

  void set_format(const MshFormat& format) { format_ = format; }
  const MshFormat& format() const { return format_; }

  /// Skips white space; true at the end of the file.
  bool at_end();
  /// The rest of the line without blanks at its ends.
  std::string_view line();
  /// Skips to the line equal to `text`; false when there is none.
  bool pass(std::string_view text);

  /// A whole number; an int in a binary file.
  std::int64_t integer(const char* what, std::int64_t least, std::int64_t most);
  /// A whole number; in a binary file of 4.1 one of count_bytes.
  std::int64_t large(const char* what, std::int64_t least, std::int64_t most);
  /// Number of items that follow, each of at least `text_bytes` or `binary_bytes`; limited to what
  /// the rest of the file can hold. A line of text in 2.2.
  std::size_t count(const char* what, std::size_t text_bytes, std::size_t binary_bytes);
  /// May be infinite or NaN.
  double real(const char* what);

  /// Byte of the last item read.
  std::size_t place() const { return place_; }
  [[noreturn]] void fail(const std::string& wrong,
                         const std::string& action = save_msh_again) const {
    fail_at(place_, wrong, action);
  }
  [[noreturn]] void fail_at(std::size_t place, const std::string& wrong,
                            const std::string& action) const;
  /// A failure that concerns the whole file.
  [[noreturn]] void fail_file(const std::string& wrong, const std::string& action) const;

 private:
  std::string_view token(const char* what);
  template <class Number>
  Number raw(const char* what);
  std::int64_t from_text(const char* what);
  std::int64_t checked(std::int64_t number, const char* what, std::int64_t least,
                       std::int64_t most) const;

  std::string bytes_;
  std::string name_;
  MshFormat format_;
  std::size_t next_ = 0;   ///< first byte that was not read
  std::size_t place_ = 0;  ///< where the last item read begins
};

}  // namespace rollfem::meshes
