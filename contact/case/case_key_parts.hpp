// What the declarations of the keys share; private to contact/case_keys*.cpp.
#pragma once

#include "contact/case/case_keys.hpp"

#include <algorithm>
#include <optional>

namespace rollfem::contact {

using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

// Radii, forces and moduli have bounds far outside of anything built, which only keep the
// arithmetic away from overflow and underflow.
inline constexpr double smallest = 1e-6;
inline constexpr double largest = 1e9;
inline const Bounds positive{smallest, largest};
inline const Bounds curved_or_flat{smallest, largest, false, true, true};
inline const Bounds at_most_one{0.0, 1.0, false, true};
inline const Bounds any_force{0.0, 1e12, false, true};

inline KeyValue optional_number(const std::optional<double>& value) {
  return value ? KeyValue(*value) : KeyValue();
}

/// Position of an enumerator in the list of words that names it.
template <class Enumeration>
Enumeration enumerator(const KeyValue& value, const Words& words) {
  const auto found = std::find(words.begin(), words.end(), std::get<std::string>(value));
  return static_cast<Enumeration>(found - words.begin());
}

/// One number of every load point; a single one when all share it, nothing when there is none.
template <class Entry, class Get>
KeyValue shortened(const std::vector<Entry>& entries, const Get& get) {
  Numbers values;
  for (const Entry& entry : entries) {
    const std::optional<double> value = get(entry);
    if (value) values.push_back(*value);
  }
  if (values.empty()) return {};
  const bool same = std::all_of(values.begin(), values.end(),
                                [&](double value) { return value == values.front(); });
  if (same) values.resize(1);
  return values;
}

/// Makes room for `count` load points (steps) wherever there is one entry for each.
void grow_load_points(Case& input, std::size_t count);

/// Broadcasts: one number serves all load points. Lengths were checked before (case_checks.cpp).
template <class Set>
void set_per_load_point(Case& input, const KeyValue& value, const Set& set) {
  const auto& numbers = std::get<Numbers>(value);
  grow_load_points(input, numbers.size());
  for (std::size_t k = 0; k < input.rolling.creepages.size(); ++k)
    set(input, k, numbers.size() == 1 ? numbers.front() : numbers.at(k));
}

/// A word that stands for an enumerator of a member.
template <class Enumeration>
Key word_key(const std::string& section, const std::string& name, const Words& words,
             const std::string& sentence, Enumeration& (*member)(Case&)) {
  Key key;
  key.section = section;
  key.name = name;
  key.kind = KeyKind::word;
  key.words = words;
  key.sentence = sentence;
  key.get = [words, member](const Case& c) -> KeyValue {
    return words.at(static_cast<std::size_t>(member(const_cast<Case&>(c))));
  };
  key.set = [words, member](Case& c, const KeyValue& v) {
    member(c) = enumerator<Enumeration>(v, words);
  };
  return key;
}

/// A whole number of a member.
Key count_key(const std::string& section, const std::string& name, Bounds bounds,
              const std::string& sentence, int& (*member)(Case&));

/// The name of a file of points, whose lattice the reader fills in.
Key file_key(const std::string& section, const std::string& name, const std::string& when_absent,
             const std::string& sentence, std::optional<Lattice>& (*member)(Case&));

/// The declarations, by part.
std::vector<Key> accuracy_keys();  ///< accuracy, accuracy_of
std::vector<Key> halfspace_keys();
std::vector<Key> problem_keys();     ///< [rolling] problem, forces
std::vector<Key> history_keys();     ///< [history]
std::vector<Key> surface_keys();     ///< [undeformed_distance], [given_pressure]
std::vector<Key> theory_keys();      ///< [fastsim], [strip], [carter]
std::vector<Key> subsurface_keys();  ///< [[subsurface.*]]
std::vector<Key> output_keys();      ///< [output]
std::vector<Key> mesh_keys();        ///< meshes of [wheel], [rail] and [fem]
std::vector<Key> profile_keys();   ///< profile of [wheel], [rail]; [wheel_profile], [rail_profile]
std::vector<Key> track_keys();     ///< [track], vertical_force
std::vector<Key> wheelset_keys();  ///< [wheelset]

}  // namespace rollfem::contact
