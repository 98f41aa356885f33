// SPDX-License-Identifier: LGPL-2.1-or-later
// A key is declared once: reader, checks of bounds, `check`, `new-case` and the reference page take
// it from there.
#include "base/errors.hpp"
#include "case/keys/case_text.hpp"
#include "case/keys/key_builder.hpp"
#include "case/reading/case_reader.hpp"
#include "case/reading/toml_reader.hpp"

#include "support/model_keys.hpp"
#include "support/temporary_folder.hpp"

namespace {

/// A value that each key of that kind takes and that is no default.
KeyValue other_value(const Key& key) {
  const KeyValue initial = key.get(Case());
  switch (key.kind) {
    case KeyKind::text:
      return std::string("other");
    case KeyKind::word:
      return initial == KeyValue(key.words.back()) ? key.words.front() : key.words.back();
    case KeyKind::lean:
      return std::string("1:30");
    case KeyKind::words:
      return Words{key.words.empty() ? "any" : key.words.back()};
    case KeyKind::boolean:
      return initial != KeyValue(true);
    case KeyKind::integer:
      return initial == KeyValue(key.bounds.upper) ? key.bounds.lower : key.bounds.upper;
    case KeyKind::number:
      return 0.5 * key.bounds.upper;
    default:
      break;
  }
  Numbers numbers{0.5 * key.bounds.upper, 0.25 * key.bounds.upper, 0.125 * key.bounds.upper};
  if (key.kind != KeyKind::triple) numbers.resize(2);
  return numbers;
}

std::string head_of(const Section& section) {
  if (section.name.empty()) return "";
  return section.repeated ? "[[" + section.name + "]]\n" : "[" + section.name + "]\n";
}

/// A constant of a friction law belongs to that law alone.
void choose_law(const Key& key, Case& input) {
  for (const FallShape& shape : fall_shapes())
    for (const FallShape::Constant& own : shape.constants)
      if (own.name != nullptr && key.path() == std::string("friction.") + own.name)
        input.friction_fall.shape = shape;
}

TEST(CaseDeclarations, AllowedValuesFillTheMember) {
  for (const Section& section : case_sections())
    for (const Key& key : section) {
      const KeyValue value = other_value(key);
      const std::string line = key.name + " = " + toml_text(value) + "\n";
      const GivenCase given = read_toml(head_of(section) + line, "case.toml");
      const auto& values = section.repeated ? given.entries.at(0).values : given.values;
      ASSERT_EQ(values.count(&key), 1u) << key.path();
      EXPECT_EQ(values.at(&key).value, value) << key.path();
      Case input;
      choose_law(key, input);
      key.set(input, value);
      EXPECT_EQ(key.get(input), value) << key.path();
    }
}

/// [placement] and [wheelset] say the same of a wheel in two ways. What a section brings with it,
/// or a key rules out, is there or not, but does not take the key's value.
TEST(CaseDeclarations, EachKeyHasAMemberOfItsOwn) {
  const Case initial;
  for (const Section& section : case_sections())
    for (const Key& key : section) {
      Case input = initial;
      key.set(input, other_value(key));
      for (const Section& other : case_sections())
        for (const Key& another : other)
          if (&another != &key && section.on_rail == other.on_rail) {
            const KeyValue before = another.get(initial), after = another.get(input);
            const bool whether = before.index() == 0 || after.index() == 0;
            EXPECT_TRUE(before == after || (whether && after != other_value(key)))
                << key.path() << ", " << another.path();
          }
    }
}

TEST(CaseDeclarations, ValuesOutOfBoundsAreRefusedWithTheAllowedRange) {
  int bounded = 0;
  for (const Section& section : case_sections())
    for (const Key& key : section) {
      const bool whole = key.kind == KeyKind::integer;
      if (!whole && key.kind != KeyKind::number && key.kind != KeyKind::numbers) continue;
      const std::string beyond = whole ? std::to_string(static_cast<long>(key.bounds.upper) + 1)
                                       : toml_text(KeyValue(2.0 * key.bounds.upper));
      const std::string text = refusal<InputError>(
          [&] { read_toml(head_of(section) + key.name + " = " + beyond + "\n", "case.toml"); });
      EXPECT_TRUE(says(text, key.path() + " = " + beyond +
                                 ": is out of bounds; allowed: " + allowed_values(key)));
      ++bounded;
    }
  EXPECT_GT(bounded, 60);
}

TEST(CaseDeclarations, AlmostNothingIsRefusedWhereNothingIsNegative) {
  // The work of some solvers grows as the inverse of a length or velocity.
  for (const Section& section : case_sections())
    for (const Key& key : section)
      if (!key.unit.empty() && !key.bounds.contains(-1e-3)) {
        EXPECT_FALSE(key.bounds.contains(1e-310)) << key.path();
        EXPECT_FALSE(key.bounds.contains(1e-30)) << key.path();
      }
}

TEST(CaseDeclarations, CheckTemplateAndReferenceNameEveryKey) {
  const std::string new_case = case_template();
  const std::string page = case_reference_markdown();
  for (const Section& section : case_sections())
    for (const Key& key : section) {
      Case input;
      input.wheel.profile.name = "S1002";  // without one, [track] and the like are not talked of
      input.wheelset.on_rail = section.on_rail.value_or(false);
      choose_law(key, input);
      key.set(input, other_value(key));
      const std::string said = toml_text(key.get(input)) + (key.unit.empty() ? "" : " " + key.unit);
      const bool title = key.path() == "title";
      const std::string check = head_of(section) + (title ? "other\n" : "");
      const std::string text = describe(input);
      EXPECT_TRUE(says(text, check)) << key.path();
      if (!title) {
        EXPECT_TRUE(says(text, key.name + std::string(23 - key.name.size(), ' ') + said + "\n"))
            << key.path();
      }
      EXPECT_TRUE(says(new_case, "# " + key.sentence + "\n# " + allowed_values(key))) << key.path();
      const std::string symbol = key.symbol.empty() ? "" : " " + key.symbol;
      EXPECT_TRUE(says(page, "| `" + key.name + "`" + symbol + " | ")) << key.path();
      if (!key.unit.empty()) {
        EXPECT_TRUE(says(allowed_values(key), " " + key.unit)) << key.path();
      }
      EXPECT_FALSE(key.sentence.empty()) << key.path();
      EXPECT_EQ(key.sentence.back(), '.') << key.path();
    }
}

TEST(CaseDeclarations, ReferenceHasUnitsAndRowsOfBothBodiesOnce) {
  EXPECT_TRUE(
      says(case_reference_markdown(), "| `rolling_radius` R | 0.001 to 1e+09 mm | required | ",
           "| `transverse_radius` R_ry | of magnitude 0.001 to 1e+09 mm, or inf | required | ",
           "As in [wheel]: `round_to`, `young_modulus`, `poisson_ratio`, `density`, `mesh`."));
}

enum class ToyKind { gmsh, box };
struct ToyOptions {
  std::optional<double> stiffness;
  std::optional<ToyKind> kind;
};

TEST(CaseDeclarations, PartsEndUpInTheKey) {
  Keys<ToyOptions> keys("toy", "A section of this test");
  keys.add("stiffness", &ToyOptions::stiffness, symbol("k"), unit("N/mm"),
           upper_open(between(1.0, 5.0)), otherwise("none"), "How stiff it is.");
  keys.add("kind", &ToyOptions::kind, {{"box", ToyKind::box}, {"gmsh", ToyKind::gmsh}},
           Required{"\"gmsh\""});
  const SectionWithKeys declared = keys;
  ASSERT_EQ(declared.keys.size(), 2u);
  const Key& stiffness = declared.keys[0];
  EXPECT_EQ(stiffness.path(), "toy.stiffness");
  EXPECT_EQ(allowed_values(stiffness), "a number from 1 to below 5 N/mm");
  Case input;
  EXPECT_EQ(stiffness.get(input), KeyValue());
  stiffness.set(input, 2.0);
  EXPECT_EQ(input.options.of<ToyOptions>().stiffness, 2.0);
  const Key& kind = declared.keys[1];
  EXPECT_TRUE(kind.required);
  EXPECT_EQ(allowed_values(kind), "one of box, gmsh");
  // The order of the words is not that of the enumerators.
  kind.set(input, std::string("gmsh"));
  EXPECT_EQ(input.options.of<ToyOptions>().kind, ToyKind::gmsh);
  EXPECT_EQ(kind.get(input), KeyValue(std::string("gmsh")));
}

}  // namespace
