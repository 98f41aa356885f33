// SPDX-License-Identifier: LGPL-2.1-or-later
// The scalars of a load point, each declared once. Files, checkpoints, `accuracy_of`, comparisons,
// figures and docs/results.md take them from here; how to add one: docs/developing.md.
#pragma once

#include "contact/result/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rollfem::contact {

/// What errors of a quantity, and differences between two models, are parts of wherever they are
/// given as parts or percent: in messages, tables and figures, `accuracy`, comparisons and studies.
enum class ErrorScale {
  none,      ///< is given, counted or a place
  value,     ///< the value
  friction,  ///< these of what full sliding gives: mu
  force,     ///< mu F_z
  moment,    ///< mu F_z sqrt(a b)
  traction,  ///< mu p_0
};

/// What a quantity is used for; each includes those before.
enum class QuantityUse {
  stored,    ///< in every file
  compared,  ///< models are held against each other by it
  accuracy,  ///< a case may ask for its accuracy: every model with error estimates must give one
};

enum class QuantityKind { number, count, truth };

/// How a quantity is reached in a load point.
struct QuantityMember {
  QuantityKind kind;
  bool may_be_absent;
  std::optional<double> (*get)(const PointResult&);
  void (*set)(PointResult&, double);
};

struct Quantity {
  const char* name;     ///< in every file
  const char* title;    ///< for headings and sentences
  const char* symbol;   ///< "F_x", "xi"; empty where there is none
  const char* unit;     ///< "-" when it has none
  const char* meaning;  ///< one sentence with the sign
  ErrorScale scale;
  QuantityUse use;
  QuantityMember member;
  const char* no_bar = "";  ///< why it never has an error estimate (bars.hpp); empty: it may have

  /// None where the model does not give it, of those that may be absent.
  std::optional<double> value(const PointResult& point) const { return member.get(point); }
  /// Is measured by full sliding.
  bool of_friction() const { return scale > ErrorScale::value; }
};

/// In the order of the files.
const std::vector<Quantity>& quantities();

/// By name; null where there is none.
const Quantity* find_quantity(const std::string& name);

/// By name; std::logic_error for one that is not there.
const Quantity& quantity_named(const std::string& name);

/// Value by name; std::logic_error where it is absent.
double quantity(const PointResult& point, const std::string& name);

/// What full sliding gives of a quantity of friction at this load point; else 0.
double full_sliding(const Quantity& quantity, const PointResult& point,
                    double friction_coefficient);

/// What 1, or 100 %, of a quantity is at this load point: full sliding, else the size of the value.
/// 0 where nothing can be told as a part of it (ErrorScale::none, or a value of 0).
double whole_of(const Quantity& quantity, const PointResult& point, double friction_coefficient);

/// "mu F_z"; empty for none.
const char* text_of(ErrorScale scale);

/// Percent of it with two digits: "0.3 %" of a value, "0.3 % of mu F_z". `part` is relative.
std::string percent_text(ErrorScale scale, double part);

/// The table for docs/results.md.
std::string quantities_markdown();

}  // namespace rollfem::contact
