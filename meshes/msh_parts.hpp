// SPDX-License-Identifier: LGPL-2.1-or-later
// The bytes of a .msh file and the reading position: numbers as text or
// binary, never beyond the end. Internal to meshes/.
#pragma once

#include "meshes/hex_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rollfem::meshes {

/// Advice for a damaged file.
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
  [[noreturn]] void fail(const std::string& wrong, const std::string& action) const {
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

// Builds hexahedra, and quadrilaterals by group, from the
// elements of a .msh file. Internal to meshes/.

/// A kind of element, by its number in .msh files.
struct MshKind {
  int dimension;
  int nodes;
  const char* name;  ///< "Tetrahedron 4"
};

class MshElements {
 public:
  explicit MshElements(const MshBytes& bytes) : bytes_(bytes) {}

  /// Throws contact::InputError for a number that is not one of gmsh's kinds.
  const MshKind& kind(std::int64_t type) const;

  /// Adds the node at the last position read. Throws contact::InputError when the number exists
  /// already or a coordinate is not finite.
  void add_node(std::int64_t number, const std::array<double, 3>& coordinates);
  /// Adds the element at the last position read: its nodes, and its group of faces (4.1: the
  /// surface, 2.2: the physical group). Throws contact::InputError when there is no such node.
  void add(std::int64_t number, const MshKind& kind, int group,
           const std::vector<std::int64_t>& nodes);

  /// The hexahedra with their nodes, and the faces for which `side_of` gives a side. Throws
  /// contact::InputError when these are not quadrilaterals or not faces of the hexahedra.
  HexMesh mesh(const std::function<std::vector<Side>(int group)>& side_of) const;

 private:
  struct Face {
    std::size_t place;  ///< in the file
    int count;          ///< of nodes, 4 for a quadrilateral
    std::array<int, 4> corners{};
  };

  const MshBytes& bytes_;
  std::vector<std::array<double, 3>> points_;
  std::unordered_map<std::int64_t, int> index_;  ///< in points_, by number
  std::vector<std::array<int, 8>> cells_;
  std::set<std::array<int, 8>> once_;       ///< the cells of 2.2
  std::map<int, std::vector<Face>> faces_;  ///< by group
};

}  // namespace rollfem::meshes
