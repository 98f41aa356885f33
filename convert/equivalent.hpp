// SPDX-License-Identifier: LGPL-2.1-or-later
// The equivalent of a CONTACT case in keys of a case file, and the parts without equivalent.
// docs/coming_from_contact.md maps digits and signs.
#pragma once

#include <fmt/format.h>

#include "convert/contact_reader.hpp"
#include <map>
#include <string>
#include <vector>

namespace rollfem::convert {

/// A coordinate, cleaned of the rounding error of its sum.
double in_mm(double place);

struct Equivalent {
  std::string model = "halfspace";
  std::string problem;        ///< a word of rolling.problem
  bool continues = false;     ///< starts from the state of the previous case
  bool from_sliding = false;  ///< friction.branch
  /// Lines `key = value` of each section, the same for all cases that share a file.
  std::map<std::string, std::vector<std::string>> fixed;
  /// Values that may differ between load points, by `section.key`.
  std::map<std::string, double> varied;
  double place = 0.0;     ///< x of the patch in CONTACT's axes where ours move with it, mm
  double approach = 0.0;  ///< of the load by Hertz, mm; 0: other shapes
  std::string stresses;   ///< [[subsurface.*]] entries
  std::map<std::string, std::string>
      files;  ///< files beside the case file: name without stem, text

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
  void set(const std::string& section, const std::string& key, double value,
           const std::string& comment = {});
  void set_list(const std::string& section, const std::string& key,
                const std::vector<double>& values, const std::string& comment = {});
  void set_word(const std::string& section, const std::string& key, const std::string& word);
};

/// `profile_folder`: path from the case file to the folder of the input file, to which its profiles
/// are relative; empty: the same folder.
Equivalent equivalent_of(const ContactCase& given, const std::string& profile_folder);

/// FASTSIM and FaStrip.
bool is_simplified(const Digits& digits);

/// Whether CHI turns the axes of module 3 by half a turn.
bool rolls_backwards(const ContactCase& given);

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
