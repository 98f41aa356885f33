// SPDX-License-Identifier: LGPL-2.1-or-later
// A key is one row: name, member of the case that it sets, what else belongs to it, a sentence.
//
//   Keys<Load> keys("load", "Load that presses the bodies together", &Case::load);
//   keys.add("normal_force", &Load::normal_force, symbol("F_z"), unit("N"), between(1e-6, 1e12),
//            "Force that presses the wheel on the rail.");
//
// The files of case/keys each declare the sections of one subject; a model with options declares
// their section where it is registered, and adds it by add_section.
#pragma once

#include "case/keys/case_keys.hpp"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <type_traits>
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

/// Type of the value of an optional member; of other members the type itself.
template <class Member>
struct Held {
  using Value = Member;
};
template <class Member>
struct Held<std::optional<Member>> {
  using Value = Member;
};
template <class Member>
constexpr bool is_optional = !std::is_same_v<Member, typename Held<Member>::Value>;

template <class Member>
inline constexpr std::size_t array_size = 0;
template <class Number, std::size_t count>
inline constexpr std::size_t array_size<std::array<Number, count>> = count;

/// The kind of the keys of a member.
template <class Member>
constexpr KeyKind kind_of() {
  using Value = typename Held<Member>::Value;
  if constexpr (std::is_same_v<Value, bool>) return KeyKind::boolean;
  if constexpr (std::is_same_v<Value, int>) return KeyKind::integer;
  if constexpr (std::is_same_v<Value, double>) return KeyKind::number;
  if constexpr (std::is_same_v<Value, Numbers>) return KeyKind::numbers;
  if constexpr (std::is_same_v<Value, Words>) return KeyKind::words;
  if constexpr (array_size<Value> == 2) return KeyKind::pair;
  if constexpr (array_size<Value> == 3) return KeyKind::triple;
  return KeyKind::text;
}

/// The value that a member has as a key.
template <class Member>
KeyValue value_of(const Member& member) {
  if constexpr (is_optional<Member>)
    return member ? value_of(*member) : KeyValue();
  else if constexpr (std::is_same_v<Member, int>)
    return static_cast<double>(member);
  else if constexpr (std::is_same_v<Member, Lattice>)
    return member.file;
  else if constexpr (array_size<Member> > 0)
    return Numbers(member.begin(), member.end());
  else if constexpr (std::is_same_v<Member, std::string> || std::is_same_v<Member, Numbers>)
    return member.empty() ? KeyValue() : KeyValue(member);
  else
    return member;
}

/// nan, where it is allowed, means no number. The reader fills in the values of a file of points.
template <class Member>
void assign(Member& member, const KeyValue& value) {
  if constexpr (std::is_same_v<Member, std::optional<double>>) {
    const double number = std::get<double>(value);
    member = std::isnan(number) ? std::nullopt : std::optional(number);
  } else if constexpr (is_optional<Member>) {
    assign(member.emplace(), value);
  } else if constexpr (std::is_same_v<Member, int>) {
    member = static_cast<int>(std::get<double>(value));
  } else if constexpr (std::is_same_v<Member, Lattice>) {
    member.file = std::get<std::string>(value);
  } else if constexpr (array_size<Member> > 0) {
    const auto& numbers = std::get<Numbers>(value);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      member.at(i) = static_cast<typename Member::value_type>(numbers[i]);
  } else {
    member = std::get<Member>(value);
  }
}

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

/// The options of a model.
template <class Options>
Place<Options> place_of_options() {
  return {[](const Case& c) { return &c.options.of<Options>(); },
          [](Case& c) -> Options& { return c.options.set<Options>(); }};
}

inline Place<Case> whole_case() {
  return {[](const Case& c) { return &c; }, [](Case& c) -> Case& { return c; }};
}

// What belongs to a key besides its name, member and sentence.

template <class Value>
struct Trait {
  Value Key::*member;
  Value value;
};

/// Makes traits of one kind: symbol("F_z").
template <class Value>
struct TraitOf {
  Value Key::*member;
  Trait<Value> operator()(Value value) const { return {member, std::move(value)}; }
};

inline constexpr TraitOf<std::string> symbol{&Key::symbol};
inline constexpr TraitOf<std::string> unit{&Key::unit};
inline constexpr TraitOf<std::string> example{&Key::example};
/// Behaviour without the key, if there is no default value.
inline constexpr TraitOf<std::string> otherwise{&Key::when_absent};
inline constexpr TraitOf<Words> among{&Key::words};
inline constexpr TraitOf<Words KnownNames::*> among_known{&Key::names};
/// Lists with the same `per` have equal length: that of the list that `counts` them, if it is
/// given. A single number in another list applies to all entries.
inline constexpr TraitOf<std::string> per{&Key::per};
inline constexpr Trait<bool> counts{&Key::counts, true};
inline constexpr Trait<bool> ascending{&Key::ascending, true};
inline constexpr Trait<bool> names_file{&Key::names_file, true};
inline constexpr Trait<bool> or_empty{&Key::empty, true};
/// `check` omits the key if its member has the value that it has without the key.
struct Silent {};
inline constexpr Silent silent_default;

/// The key must be given; `new-case` writes the example.
struct Required {
  const char* example;
};

inline Bounds between(double lower, double upper) {
  return {lower, upper};
}
inline Bounds positive() {
  return between(smallest, largest);
}
/// Lengths, velocities and densities that may be 0 but not nearly 0, because the work grows with
/// their inverse.
inline Bounds zero_or(double lower, double upper) {
  return {lower, upper, false, false, false, true};
}
/// Bounds of the absolute value.
inline Bounds sized(double lower, double upper) {
  return {lower, upper, false, true};
}
inline Bounds within(double limit) {
  return sized(0.0, limit);
}
/// The upper bound itself is outside.
inline Bounds upper_open(Bounds bounds) {
  bounds.upper_open = true;
  return bounds;
}
inline Bounds or_inf(Bounds bounds) {
  bounds.infinite = true;
  return bounds;
}
inline Bounds or_nan(Bounds bounds) {
  bounds.none = true;
  return bounds;
}

template <class Value>
void add_to(Key& key, const Trait<Value>& trait) {
  key.*trait.member = trait.value;
}
inline void add_to(Key& key, const Bounds& bounds) {
  key.bounds = bounds;
}
inline void add_to(Key& key, const Required& required) {
  key.required = true;
  key.example = required.example;
}
inline void add_to(Key& key, const std::string& sentence) {
  key.sentence = sentence;
}

inline void add_to(Key&, const Silent&) {}

// How a key reads and sets its member.

template <class Part>
struct Access {
  std::function<KeyValue(const Part&)> get;
  std::function<void(Part&, const KeyValue&)> set;
};

/// `path`: pointer to a member, or a function of the part.
template <class Part, class Path>
Access<Part> access_to(Path path) {
  return {[path](const Part& part) { return value_of(std::invoke(path, part)); },
          [path](Part& part, const KeyValue& value) { assign(std::invoke(path, part), value); }};
}

/// What a key of a part is a member of: the part, or the case, which a pointer to its member says.
template <class Part, class Path>
Part whole_of(Path);
template <class Part, class Member>
Case whole_of(Member Case::*);
template <class Part, class Path>
using WholeOf = decltype(whole_of<Part>(std::declval<Path>()));

template <class Part, class Path>
using MemberOf = std::decay_t<std::invoke_result_t<Path, WholeOf<Part, Path>&>>;

/// A member of a member.
template <class Part, class Whole, class Member>
auto inside(Whole Part::*whole, Member Whole::*member) {
  return [whole, member](auto& part) -> decltype(auto) { return (part.*whole.*member); };
}

/// One number for each load point, in the entries of a list, which are created if missing.
template <class Part, class Entry>
struct Each {
  std::vector<Entry> Part::*list;
  Access<Entry> entry;
};
template <class Part, class Entry, class Path>
Each<Part, Entry> of_each(std::vector<Entry> Part::*list, Path path) {
  return {list, access_to<Entry>(path)};
}
template <class Part>
Each<Part, double> of_each(std::vector<double> Part::*list) {
  return {list, access_to<double>([](auto& entry) -> decltype(auto) { return (entry); })};
}

struct SectionWithKeys {
  Section section;
  std::vector<Key> keys;
};
using Sections = std::vector<SectionWithKeys>;

/// A section being declared: one call for each of its keys.
template <class Part>
class Keys {
 public:
  Keys(const std::string& name, const std::string& sentence,
       Place<Part> place = place_of_options<Part>())
      : place_(std::move(place)) {
    declared_.section.name = name;
    declared_.section.sentence = sentence;
  }

  /// The kind of the key is that of the member.
  template <class Path, class... Traits>
  void add(const std::string& name, const Path& path, const Traits&... traits) {
    add(kind_of<MemberOf<Part, Path>>(), name, access_to<WholeOf<Part, Path>>(path), traits...);
  }
  template <class Entry, class... Traits>
  void add(const std::string& name, const Each<Part, Entry>& each, const Traits&... traits) {
    bind(declare(KeyKind::numbers, name, per("load points"), traits...), each);
  }
  /// Words that stand for values of the member.
  template <class Path, class... Traits>
  void add(const std::string& name, const Path& path,
           const Choices<typename Held<MemberOf<Part, Path>>::Value>& choices,
           const Traits&... traits) {
    Words words;
    for (const auto& [word, value] : choices) words.emplace_back(word);
    using Whole = WholeOf<Part, Path>;
    const auto word_of_member = [path, choices](const Whole& part) -> KeyValue {
      for (const auto& [word, value] : choices)
        if (std::invoke(path, part) == value) return std::string(word);
      return {};
    };
    const auto set_member = [path, choices](Whole& part, const KeyValue& given) {
      for (const auto& [word, value] : choices)
        if (std::get<std::string>(given) == word) std::invoke(path, part) = value;
    };
    add(KeyKind::word, name, Access<Whole>{word_of_member, set_member}, among(words), traits...);
  }
  /// For anything other than a member.
  template <class Whole, class... Traits>
  void add(KeyKind kind, const std::string& name, Access<Whole> access, const Traits&... traits) {
    if constexpr ((std::is_same_v<Traits, Silent> || ...))
      access.get = [get = access.get](const Whole& part) {
        const KeyValue value = get(part);
        return value == get(Whole()) ? KeyValue() : value;
      };
    bind(declare(kind, name, traits...), access);
  }

  Section& section() { return declared_.section; }
  operator SectionWithKeys() { return std::move(declared_); }

 private:
  template <class... Traits>
  Key& declare(KeyKind kind, const std::string& name, const Traits&... traits) {
    Key& key = declared_.keys.emplace_back();
    key.section = declared_.section.name;
    key.name = name;
    key.kind = kind;
    (add_to(key, traits), ...);
    return key;
  }
  template <class Whole>
  Place<Whole> place_of() const {
    if constexpr (std::is_same_v<Whole, Part>)
      return place_;
    else
      return whole_case();
  }
  template <class Whole>
  void bind(Key& key, const Access<Whole>& access) {
    const Place<Whole> place = place_of<Whole>();
    const bool listed = !key.per.empty() && !key.counts;
    key.get = [find = place.find, get = access.get, listed](const Case& c) {
      const Whole* part = find(c);
      const KeyValue value = part == nullptr ? KeyValue() : get(*part);
      const auto* numbers = std::get_if<Numbers>(&value);
      return listed && numbers != nullptr ? shortened(*numbers) : value;
    };
    key.set = [make = place.make, set = access.set](Case& c, const KeyValue& value) {
      set(make(c), value);
    };
  }
  template <class Entry>
  void bind(Key& key, const Each<Part, Entry>& each) {
    key.get = [find = place_.find, each](const Case& c) {
      Numbers numbers;
      for (const Entry& entry : find(c)->*each.list) {
        const KeyValue value = each.entry.get(entry);
        const auto* number = std::get_if<double>(&value);
        numbers.push_back(number != nullptr ? *number : std::nan(""));
      }
      return shortened(numbers);
    };
    key.set = [make = place_.make, each](Case& c, const KeyValue& value) {
      const auto& numbers = std::get<Numbers>(value);
      auto& entries = make(c).*each.list;
      entries.resize(c.rolling.creepages.size());
      grow_load_points(c, numbers.size());
      for (std::size_t k = 0; k < entries.size(); ++k)
        each.entry.set(entries[k], numbers.size() == 1 ? numbers.front() : numbers.at(k));
    };
  }

  SectionWithKeys declared_;
  Place<Part> place_;
};

/// Makes the section of a model's options known to all case files, once. Not while another thread
/// reads a case.
void add_section(SectionWithKeys added);

// The other sections, one function a file, in the order of the reference page.
Sections load_sections();
Sections friction_sections();
Sections body_sections();
Sections track_sections();
Sections rolling_sections();
Sections contact_sections();
Sections output_sections();

}  // namespace rollfem::contact
