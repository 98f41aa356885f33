// SPDX-License-Identifier: LGPL-2.1-or-later
// The keys of the case file: section, kind, unit, symbol, bounds, default and a sentence, declared
// once in case/keys/keys_*.cpp, those of a model's options where it is registered. Reading, bounds
// checks, `check`, `new-case` and docs/case-file.md are all derived from these declarations.
#pragma once

#include "case/case.hpp"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace rollfem::contact {

enum class KeyKind {
  text,     ///< any string
  word,     ///< one of `words`
  words,    ///< a list of different `words` or `names`
  number,   ///< a float or integer within `bounds`
  integer,  ///< a whole number within `bounds`
  boolean,
  pair,     ///< a list of two numbers, each within `bounds`
  triple,   ///< a list of three numbers, each within `bounds`
  numbers,  ///< a number or a list of numbers, each within `bounds`
  lean,     ///< one of `words`, a ratio "1:40", or an angle in rad within `bounds`
};

/// Range of a number. NaN and -inf are never inside, inf only with `infinite`.
struct Bounds {
  double lower = -infinity;
  double upper = infinity;
  bool upper_open = false;  ///< the upper bound itself is outside
  bool magnitude = false;   ///< bounds apply to the absolute value
  bool infinite = false;    ///< inf is allowed
  bool zero = false;        ///< 0 is allowed, although it is below the lower bound
  bool none = false;        ///< nan is allowed, for no number
  bool contains(double value) const;
};

/// Value of a key; integers are kept as double, a single number of KeyKind::numbers as a list of
/// one, a missing value as monostate.
using KeyValue = std::variant<std::monostate, bool, double, std::string, std::vector<double>,
                              std::vector<std::string>>;

/// Names that the keys do not declare, because what bears them lies above the case.
struct KnownNames {
  std::vector<std::string> models;          ///< empty: any name is accepted
  std::vector<std::string> default_models;  ///< if the case names none
  std::vector<std::string> quantities;      ///< whose accuracy may be asked for; empty: any
};

struct Key {
  std::string section;  ///< empty for the keys before the first section
  std::string name;
  KeyKind kind = KeyKind::number;
  std::string symbol;  ///< as in the papers; may be empty
  std::string unit;    ///< empty when it has none
  Bounds bounds;
  std::vector<std::string> words;
  std::vector<std::string> KnownNames::*names = nullptr;  ///< of words: these instead of `words`
  bool required = false;
  bool empty = false;       ///< of words: [] is allowed
  std::string when_absent;  ///< behaviour if missing, for keys without default value
  std::string example;      ///< TOML text for `new-case`; empty: the default, or left commented out
  std::string sentence;
  std::string per;          ///< lists of the same `per` have one length: "load points", "positions"
  bool counts = false;      ///< the list (number) says how many of them there are
  bool ascending = false;   ///< the numbers of the list ascend
  bool names_file = false;  ///< the text may name a file, relative to the case file
  std::function<KeyValue(const Case&)> get;
  std::function<void(Case&, const KeyValue&)> set;

  /// The words to choose from; empty: any.
  const std::vector<std::string>& choices(const KnownNames& known) const {
    return names != nullptr ? known.*names : words;
  }
  /// "wheel.rolling_radius"
  std::string path() const { return section.empty() ? name : section + "." + name; }
};

struct GivenCase;

struct Section {
  std::string name;
  std::string sentence;
  bool repeated = false;        ///< [[name]], any number of times; keys get and set in the last one
  bool alternatives = false;    ///< `check` omits the key if it is not given
  bool of_profiles = false;     ///< meaningful only if wheel and rail have profiles
  std::optional<bool> on_rail;  ///< only for a wheel placed on a rail; false: on a track
  int position = 100;           ///< among the sections of models, smallest first
  /// Of a model: fills in what follows from its keys, and checks them together with others.
  void (*complete)(const GivenCase&, Case&) = nullptr;
  bool applies_to(const Case& input) const {
    return (!of_profiles || input.has_profiles()) &&
           (!on_rail || *on_rail == input.wheelset.on_rail);
  }

  const Key* begin() const { return first; }
  const Key* end() const { return last; }
  const Key* first = nullptr;
  const Key* last = nullptr;
};

/// Adds an empty entry of a repeated section, which the setters of its keys then fill.
void begin_entry(Case& input, const std::string& section);

/// Sections and keys in the order of the reference page.
const std::vector<Section>& case_sections();
const std::vector<Key>& case_keys();

/// The key with this section and name, nullptr if unknown.
const Key* find_key(const std::string& section, const std::string& name);
/// The same by Key::path.
const Key* find_key(const std::string& path);

}  // namespace rollfem::contact
