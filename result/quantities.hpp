// SPDX-License-Identifier: LGPL-2.1-or-later
// The scalars and fields of a load point, each declared once. Files, checkpoints, `accuracy_of`,
// comparisons, figures and docs/results.md take them from here; how to add one: docs/developing.md.
#pragma once

#include "base/errors.hpp"
#include "result/result.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rollfem::contact {

/// Reference value of a quantity for relative errors and for differences between models: in
/// messages, tables and figures, `accuracy`, comparisons and studies.
enum class ErrorScale {
  none,      ///< prescribed, counted, or a position
  value,     ///< the value
  friction,  ///< value at full sliding: mu
  force,     ///< mu F_z
  moment,    ///< mu F_z sqrt(a b)
  traction,  ///< mu p_0
};

/// Use of a quantity; each level includes the previous ones.
enum class QuantityUse {
  stored,    ///< in every file
  compared,  ///< used to compare models
  accuracy,  ///< a case may request its accuracy: every model with error estimates must give one
};

enum class QuantityKind { number, count, truth };

/// Access to a quantity in a load point.
struct QuantityMember {
  QuantityKind kind;
  bool may_be_absent;
  std::optional<double> (*get)(const PointResult&);
  void (*set)(PointResult&, double);
  bool normal_problem = false;  ///< of the problem without friction
};

struct Quantity {
  const char* name;     ///< in every file
  const char* title;    ///< for headings and sentences
  const char* symbol;   ///< "F_x", "xi"; empty where there is none
  const char* unit;     ///< "-" if none
  const char* meaning;  ///< one sentence with the sign
  ErrorScale scale;
  QuantityUse use;
  QuantityMember member;
  std::optional<NoBar> no_bar = {};  ///< why it never has an error bar

  /// None for an optional quantity that the model does not give.
  std::optional<double> value(const PointResult& point) const { return member.get(point); }
  /// Whether full sliding is the reference value.
  bool of_friction() const { return scale > ErrorScale::value; }
};

/// In the order of the files.
const std::vector<Quantity>& quantities();

/// The names that `accuracy_of` may have.
std::vector<std::string> accuracy_words();

/// A field of a load point over the contact grid.
struct PointField {
  const char* name;
  const char* unit;
  const char* description;
  const char* sign;
  Field& (*member)(ContactFields&);
  /// Of size 0 where the model does not give it.
  const Field& value(const ContactFields& fields) const {
    return member(const_cast<ContactFields&>(fields));  // a member of it
  }
};

/// All fields of numbers; ContactFields::state is beside them.
const std::vector<PointField>& point_fields();

/// Of ContactFields::state.
inline constexpr const char* state_meaning =
    "state of the element: 0 exterior, 1 adhesion, 2 slip, 3 plastic";

/// By name; null if unknown.
const Quantity* find_quantity(const std::string& name);

/// By name; std::logic_error if unknown.
const Quantity& quantity_named(const std::string& name);

/// Value by name; std::logic_error if absent.
double quantity(const PointResult& point, const std::string& name);

/// Value of a friction quantity at full sliding at this load point; 0 for others.
double full_sliding(const Quantity& quantity, const PointResult& point,
                    double friction_coefficient);

/// Reference value (100 %) of a quantity at this load point: full sliding, otherwise the magnitude
/// of the value. 0 if there is no relative error (ErrorScale::none, or a value of 0).
double whole_of(const Quantity& quantity, const PointResult& point, double friction_coefficient);

/// "mu F_z"; empty for none.
const char* text_of(ErrorScale scale);

/// Percent of the reference value with two digits: "0.3 %" of a value, "0.3 % of mu F_z". `part` is
/// relative.
std::string percent_text(ErrorScale scale, double part);

/// The table for docs/results.md.
std::string quantities_markdown();

// Load points that have no solution beside others that do. They keep their place among the results,
// so that load points are numbered as in the case: empty in all files, without fields.

/// The load point with its motion alone; all other numbers become NaN, which Quantity::value takes
/// for absent.
void leave_empty(PointResult& point);

bool is_solved(const PointResult& point);

/// The load points of a run that have a solution, and why the others have none. Callers that need
/// all of them treat it as any other failure.
class PartlySolved : public SolveError {
 public:
  PartlySolved(const std::string& why, ModelResult solved)
      : SolveError(why), result(std::move(solved)) {}
  ModelResult result;
};

}  // namespace rollfem::contact
