// SPDX-License-Identifier: LGPL-2.1-or-later
// Declaration of a key in named parts, ending with the member of the case that it sets:
//
//   Keys<Load> keys("load", "Load that presses the bodies together", &Case::load);
//   keys.real("normal_force").symbol("F_z").unit("N").between(1e-6, 1e12)
//       .says("Force that presses the wheel on the rail.").into(&Load::normal_force);
//
// Private to contact/case/keys_*.cpp; each of these files declares one section, or sections that
// share their keys.
#pragma once

#include "contact/case/keys/case_keys.hpp"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>

namespace rollfem::contact {

using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

// Radii, forces and moduli have bounds far outside practical values, only to prevent overflow and
// underflow.
inline constexpr double smallest = 1e-6;
inline constexpr double smallest_radius = 1e-3;  // mm: wheels, rails and arcs of profiles
inline constexpr double largest = 1e9;
inline constexpr double largest_force = 1e12;

/// Values of the words of a key.
template <class Value>
using Choices = std::vector<std::pair<const char*, Value>>;

/// Of members of an enumeration that have words.
template <class Value>
Choices<Value> words_of(std::initializer_list<Value> members) {
  Choices<Value> choices;
  for (const Value member : members) choices.emplace_back(word_of(member), member);
  return choices;
}

// Conversion between members of a case and values of keys.

inline KeyValue value_of(bool member) {
  return member;
}
inline KeyValue value_of(double member) {
  return member;
}
inline KeyValue value_of(int member) {
  return static_cast<double>(member);
}
inline KeyValue value_of(const std::string& member) {
  return member.empty() ? KeyValue() : KeyValue(member);
}
inline KeyValue value_of(const Words& member) {
  return member;
}
inline KeyValue value_of(const Numbers& member) {
  return member.empty() ? KeyValue() : KeyValue(member);
}
inline KeyValue value_of(const Lattice& member) {
  return member.file;
}
template <class Number, std::size_t count>
KeyValue value_of(const std::array<Number, count>& member) {
  return Numbers(member.begin(), member.end());
}
template <class Member>
KeyValue value_of(const std::optional<Member>& member) {
  return member ? value_of(*member) : KeyValue();
}

inline void assign(bool& member, const KeyValue& value) {
  member = std::get<bool>(value);
}
inline void assign(double& member, const KeyValue& value) {
  member = std::get<double>(value);
}
inline void assign(int& member, const KeyValue& value) {
  member = static_cast<int>(std::get<double>(value));
}
inline void assign(std::string& member, const KeyValue& value) {
  member = std::get<std::string>(value);
}
inline void assign(Words& member, const KeyValue& value) {
  member = std::get<Words>(value);
}
inline void assign(Numbers& member, const KeyValue& value) {
  member = std::get<Numbers>(value);
}
/// A file of points: the reader fills in the rest.
inline void assign(Lattice& member, const KeyValue& value) {
  member.file = std::get<std::string>(value);
}
template <class Number, std::size_t count>
void assign(std::array<Number, count>& member, const KeyValue& value) {
  const auto& numbers = std::get<Numbers>(value);
  for (std::size_t i = 0; i < numbers.size(); ++i) member.at(i) = static_cast<Number>(numbers[i]);
}
template <class Member>
void assign(std::optional<Member>& member, const KeyValue& value) {
  assign(member.emplace(), value);
}
/// nan, where it is allowed, stands for no number.
inline void assign(std::optional<double>& member, const KeyValue& value) {
  const double number = std::get<double>(value);
  member = std::isnan(number) ? std::nullopt : std::optional(number);
}

/// The value of a word, for a member that may be absent.
template <class Member>
struct Chosen {
  using Value = Member;
};
template <class Member>
struct Chosen<std::optional<Member>> {
  using Value = Member;
};

/// A single number when all entries are the same; nothing when all are nan.
KeyValue shortened(Numbers values);

/// Resizes all lists over load points (steps) to `count`.
void grow_load_points(Case& input, std::size_t count);

/// The part of a case that a section describes.
template <class Part>
struct Place {
  std::function<const Part*(const Case&)> find;  ///< nullptr: this case has none
  std::function<Part&(Case&)> make;              ///< created if missing

  Place(Part Case::*part)
      : find([part](const Case& c) { return &(c.*part); }),
        make([part](Case& c) -> Part& { return c.*part; }) {}
  Place(std::optional<Part> Case::*part)
      : find([part](const Case& c) { return c.*part ? &*(c.*part) : nullptr; }),
        make([part](Case& c) -> Part& { return c.*part ? *(c.*part) : (c.*part).emplace(); }) {}
  Place(std::function<const Part*(const Case&)> finder, std::function<Part&(Case&)> maker)
      : find(std::move(finder)), make(std::move(maker)) {}
};

inline Place<Case> whole_case() {
  return {[](const Case& c) { return &c; }, [](Case& c) -> Case& { return c; }};
}

/// The member at the end of a path of pointers to members, or of functions.
template <class Part>
Part& follow(Part& part) {
  return part;
}
template <class Part, class First, class... Rest>
auto& follow(Part& part, const First& first, const Rest&... rest) {
  return follow(std::invoke(first, part), rest...);
}

/// One key being declared: a chain of calls that ends with `into` or `by`.
template <class Part>
class KeyBuilder {
 public:
  KeyBuilder(Key& key, Place<Part> place) : key_(key), place_(std::move(place)) {}

  KeyBuilder& symbol(const std::string& text) { return put(key_.symbol, text); }
  KeyBuilder& unit(const std::string& text) { return put(key_.unit, text); }
  KeyBuilder& says(const std::string& sentence) { return put(key_.sentence, sentence); }
  KeyBuilder& example(const std::string& toml) { return put(key_.example, toml); }
  /// Behaviour without the key, if there is no default value.
  KeyBuilder& otherwise(const std::string& text) { return put(key_.when_absent, text); }
  KeyBuilder& among(const Words& words) { return put(key_.words, words); }
  KeyBuilder& or_empty() { return put(key_.empty, true); }
  /// Lists with the same `per` have equal length; a single number applies to all entries.
  KeyBuilder& per(const std::string& what) { return put(key_.per, what); }
  KeyBuilder& required(const std::string& toml) {
    key_.required = true;
    return example(toml);
  }

  KeyBuilder& between(double lower, double upper) { return put(key_.bounds, {lower, upper}); }
  KeyBuilder& positive() { return between(smallest, largest); }
  /// Lengths, velocities and densities that may vanish, but not almost: work grows as their
  /// inverse.
  KeyBuilder& zero_or(double lower, double upper) {
    return put(key_.bounds, {lower, upper, false, false, false, true});
  }
  /// Bounds of the absolute value.
  KeyBuilder& sized(double lower, double upper) {
    return put(key_.bounds, {lower, upper, false, true});
  }
  KeyBuilder& within(double limit) { return sized(0.0, limit); }
  /// The upper bound itself is outside.
  KeyBuilder& upper_open() { return put(key_.bounds.upper_open, true); }
  KeyBuilder& or_inf() { return put(key_.bounds.infinite, true); }
  KeyBuilder& or_nan() { return put(key_.bounds.none, true); }

  /// The member set by the key, at the end of a path from the section's part.
  template <class... Path>
  void into(Path... path) {
    const bool listed = !key_.per.empty();
    by(
        [listed, path...](const Part& part) {
          const KeyValue value = value_of(follow(part, path...));
          const auto* numbers = std::get_if<Numbers>(&value);
          return listed && numbers != nullptr ? shortened(*numbers) : value;
        },
        [path...](Part& part, const KeyValue& value) { assign(follow(part, path...), value); });
  }

  /// The same for a word with a value.
  template <class Member>
  void into(Member Part::*member, const Choices<typename Chosen<Member>::Value>& choices) {
    into_chosen(
        [member](auto& part) -> auto& { return part.*member; }, choices);
  }
  template <class Whole, class Member>
  void into(Whole Part::*whole, Member Whole::*member, const Choices<Member>& choices) {
    into_chosen(
        [ whole, member ](auto& part) -> auto& { return part.*whole.*member; }, choices);
  }

  /// One number for each load point, in the entries of a list, which are created if missing.
  template <class Entry, class... Path>
  void into_each(std::vector<Entry> Part::*list, Path... path) {
    per("load points");
    key_.get = [find = place_.find, list, path...](const Case& c) {
      Numbers numbers;
      for (const Entry& entry : find(c)->*list) {
        const KeyValue value = value_of(follow(entry, path...));
        const auto* number = std::get_if<double>(&value);
        numbers.push_back(number != nullptr ? *number : std::nan(""));
      }
      return shortened(numbers);
    };
    key_.set = [make = place_.make, list, path...](Case& c, const KeyValue& value) {
      const auto& numbers = std::get<Numbers>(value);
      auto& entries = make(c).*list;
      entries.resize(c.rolling.creepages.size());
      grow_load_points(c, numbers.size());
      for (std::size_t k = 0; k < entries.size(); ++k)
        assign(follow(entries[k], path...), numbers.size() == 1 ? numbers.front() : numbers.at(k));
    };
  }

  /// For anything other than a plain member: both functions receive the section's part.
  void by(std::function<KeyValue(const Part&)> get,
          std::function<void(Part&, const KeyValue&)> set) {
    key_.get = [find = place_.find, get = std::move(get)](const Case& c) {
      const Part* part = find(c);
      return part == nullptr ? KeyValue() : get(*part);
    };
    key_.set = [make = place_.make, set = std::move(set)](Case& c, const KeyValue& value) {
      set(make(c), value);
    };
  }

 private:
  template <class Find, class Choice>
  void into_chosen(Find find, const Choices<Choice>& choices) {
    for (const auto& [word, value] : choices) key_.words.emplace_back(word);
    by(
        [find, choices](const Part& part) -> KeyValue {
          for (const auto& [word, value] : choices)
            if (find(part) == value) return std::string(word);
          return {};
        },
        [find, choices](Part& part, const KeyValue& given) {
          for (const auto& [word, value] : choices)
            if (std::get<std::string>(given) == word) find(part) = value;
        });
  }

  template <class Member, class Value = Member>
  KeyBuilder& put(Member& member, Value value) {
    member = std::move(value);
    return *this;
  }

  Key& key_;
  Place<Part> place_;
};

struct SectionWithKeys {
  Section section;
  std::vector<Key> keys;
};

/// A section being declared.
template <class Part>
class Keys {
 public:
  Keys(const std::string& name, const std::string& sentence, Place<Part> place)
      : place_(std::move(place)) {
    declared_.section.name = name;
    declared_.section.sentence = sentence;
  }

  KeyBuilder<Part> text(const std::string& name) { return key(name, KeyKind::text); }
  KeyBuilder<Part> choice(const std::string& name) { return key(name, KeyKind::word); }
  KeyBuilder<Part> choices(const std::string& name) { return key(name, KeyKind::words); }
  KeyBuilder<Part> lean(const std::string& name) { return key(name, KeyKind::lean); }
  KeyBuilder<Part> real(const std::string& name) { return key(name, KeyKind::number); }
  KeyBuilder<Part> integer(const std::string& name) { return key(name, KeyKind::integer); }
  KeyBuilder<Part> toggle(const std::string& name) { return key(name, KeyKind::boolean); }
  KeyBuilder<Part> pair(const std::string& name) { return key(name, KeyKind::pair); }
  KeyBuilder<Part> triple(const std::string& name) { return key(name, KeyKind::triple); }
  KeyBuilder<Part> reals(const std::string& name) { return key(name, KeyKind::numbers); }

  Section& section() { return declared_.section; }
  operator SectionWithKeys() { return std::move(declared_); }

 private:
  KeyBuilder<Part> key(const std::string& name, KeyKind kind) {
    Key& added = declared_.keys.emplace_back();
    added.section = declared_.section.name;
    added.name = name;
    added.kind = kind;
    return {added, place_};
  }

  SectionWithKeys declared_;
  Place<Part> place_;
};

// The sections, in the order of the reference page.
SectionWithKeys general_section();
SectionWithKeys load_section();
SectionWithKeys friction_section();
SectionWithKeys layer_section();
SectionWithKeys wheel_section();
SectionWithKeys rail_section();
SectionWithKeys geometry_section();
SectionWithKeys wheel_profile_section();
SectionWithKeys rail_profile_section();
SectionWithKeys track_section();
SectionWithKeys wheelset_section();
SectionWithKeys rolling_section();
SectionWithKeys history_section();
SectionWithKeys undeformed_distance_section();
SectionWithKeys given_pressure_section();
SectionWithKeys contact_grid_section();
SectionWithKeys halfspace_section();
SectionWithKeys fastsim_section();
SectionWithKeys strip_section();
SectionWithKeys carter_section();
SectionWithKeys polach_section();
SectionWithKeys fem_section();
SectionWithKeys output_section();
SectionWithKeys table_section();
SectionWithKeys subsurface_point_section();
SectionWithKeys subsurface_line_section();
SectionWithKeys subsurface_plane_section();
SectionWithKeys subsurface_surface_section();

}  // namespace rollfem::contact
