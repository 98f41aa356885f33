// SPDX-License-Identifier: LGPL-2.1-or-later
// The equivalent of a CONTACT case in keys of a case, and the parts without equivalent.
// docs/coming_from_contact.md maps digits and signs.
#pragma once

#include "case/case.hpp"
#include "case/keys/case_keys.hpp"

#include <fmt/format.h>

#include "convert/contact_case.hpp"
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::convert {

/// A coordinate, cleaned of the rounding error of its sum.
double in_mm(double place);

/// A key with its value.
struct Setting {
  std::string key;
  contact::KeyValue value;
  std::string comment;
  /// `key = value  # comment`: numbers have twelve digits.
  std::string line() const;
  bool operator==(const Setting& other) const { return line() == other.line(); }
};

/// Values that may differ between load points, by `section.key`; a force that is not prescribed is
/// nan.
using Point = std::map<std::string, double>;

struct Equivalent {
  std::string model = "halfspace";
  std::string problem;         ///< a word of rolling.problem
  bool continues = false;      ///< starts from the state of the previous case
  bool from_sliding = false;   ///< friction.branch
  bool starts_steady = false;  ///< history.start: the first step of a transient is steady rolling
  /// Of each section, the same for all cases that share a file.
  std::map<std::string, std::vector<Setting>> fixed;
  Point varied;
  double place = 0.0;     ///< x of the patch in CONTACT's axes where ours move with it, mm
  double approach = 0.0;  ///< of the load by Hertz, mm; 0: other shapes
  std::string stresses;   ///< [[subsurface.*]] entries
  /// x, y and undeformed distance of every element, mm; empty: given by keys.
  std::vector<std::array<double, 3>> distance;

  std::vector<std::string> impossible;  ///< physics without an equivalent, one sentence each
  std::vector<std::string>
      notes;  ///< features ignored or treated differently, with the same physics

  bool history() const { return problem == "shift" || problem == "transient"; }
  void refuse(bool refused, const std::string& reason) {
    if (refused) impossible.push_back(reason);
  }
  void refuse(bool refused, const char* digit, int value, const char* what) {
    refuse(refused, fmt::format("digit {} = {}: {}", digit, value, what));
  }
  void note(bool noted, const std::string& text) {
    if (noted) notes.push_back(text);
  }
  void set(const std::string& section, const std::string& key, contact::KeyValue value,
           const std::string& comment = {}) {
    fixed[section].push_back({key, std::move(value), comment});
  }
  void set(const std::string& section, const std::string& key, std::vector<double> values,
           const std::string& comment = {}) {
    set(section, key, contact::KeyValue(std::move(values)), comment);
  }
};

/// `profile_folder`: path from the case file to the folder of the input file, to which its profiles
/// are relative; empty: the same folder.
Equivalent equivalent_of(const ContactCase& given, const std::string& profile_folder);

/// FASTSIM and FaStrip.
bool is_simplified(const Digits& digits);

/// Whether CHI turns the axes of module 3 by half a turn.
bool rolls_backwards(const ContactCase& given);

/// A, B (1/mm) and semi-axes (mm) of a contact by IPOTCN = -1 to -3; none: of another kind.
std::optional<std::array<double, 4>> ellipse_of_case(const ContactCase& given);

/// Of the wheelset over the track, or of the surface of rollers, mm/s: module 1.
double forward_speed(const ContactCase& given);

/// Parts of equivalent_of. Young's modulus, Poisson's ratio and heat of the two bodies in these
/// sections.
void fill_bodies(const ContactCase& given, const std::array<const char*, 2>& sections,
                 Equivalent& made);
/// Entries for the points of digit S with elements starting at (x, y); `sign`: sign of our axes
/// relative to CONTACT's.
struct ElementPlaces {
  double x = 0.0, y = 0.0, dx = 0.0, dy = 0.0;
};
void fill_stresses(const ContactCase& given, const ElementPlaces& elements, double sign,
                   Equivalent& made);

}  // namespace rollfem::convert
