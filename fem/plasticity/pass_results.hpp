// SPDX-License-Identifier: LGPL-2.1-or-later
// What a pass leaves in a body: the section behind the load, residual stress, groove and flow, and
// what becomes of the body with further passes. Internal to fem/plasticity.
#pragma once

#include "fem/discretisation/body_points.hpp"
#include "fem/plasticity/steady_pass.hpp"
#include "fem/stress/stress_recovery.hpp"
#include "result/record.hpp"
#include "result/result.hpp"

#include <optional>

namespace rollfem::fem {

/// Deviatoric strain of the residual stress before the first pass at a depth (mm).
Deviator initial_strain(const PlasticLaw& law, double depth);

class PassResults {
 public:
  /// `cycle`: load points after which they repeat; `pressed`: they are steps without rolling. Other
  /// arguments must outlive this object. Collective.
  PassResults(const Body& body, const PlasticLaw& law, const Streamlines& streamlines, int cycle,
              bool pressed);
  /// Collective.
  contact::YieldedSection after_pass(const PassReport& report, const YieldedBody& before,
                                     const YieldedBody& after);
  bool cycle_ended() const { return passes_ % cycle_ == 0; }
  /// The history on which a verdict depends.
  void exchange(contact::Record& record) {
    record.values(passes_, increment_, net_increment_, verdict_, from_pass_, cycle_start_);
  }
  /// Of the last pass, see YieldingBodies.
  const YieldedFields& fields() const { return fields_; }

 private:
  void fill_section(const YieldedBody& after, contact::YieldedSection& section);
  void judge(const YieldedBody& after, contact::YieldedSection& section);

  const Body& body_;
  const PlasticLaw& law_;
  const Streamlines& streamlines_;
  std::size_t station_;  ///< of the section
  StressRecovery recovery_;
  BodyPoints places_;   ///< of the section's streamlines
  BodyPoints surface_;  ///< above them
  YieldedFields fields_;
  int passes_ = 0;
  int cycle_;
  std::vector<PlasticState> cycle_start_;  ///< streamlines before the cycle
  double increment_ = 0.0;                 ///< of the last cycle
  double net_increment_ = 0.0;
  std::optional<contact::YieldVerdict> verdict_;  ///< none before the first pass
  int from_pass_ = 0;
};

/// The scalars of a load point from its bodies.
void sum_up(contact::PointResult& point);

/// The load over the limit of shakedown of steel that does not harden, from the deviatoric strain
/// of elastic bodies at all points, which may include one along and across that is the same along a
/// streamline. Steady residual stress balances everything but xz, whose limit
/// is k, and changes no difference between two instants, whose von Mises stress may be 2 sqrt(3) k
/// (Melan).
double shakedown_load(const PlasticLaw& law, const Streamlines& streamlines,
                      const std::vector<Deviator>& elastic);

/// The verdict with its evidence after so many passes; `coarse`: of cells of twice the size, null
/// without them.
std::string finding(const contact::YieldedSection& section, const contact::YieldedSection* coarse,
                    int passes);

/// The finding with what it is of: "the rail after 6 passes: ...".
std::string verdict_note(const contact::YieldedSection& section, int passes);

/// Sets evidence and finding of the bodies of all passes by those of the coarser mesh; with
/// `thick_rows` neither mesh resolves the strain at the surface.
void compare_verdicts(const std::vector<contact::PointResult>& coarse,
                      std::vector<contact::PointResult>& fine, bool thick_rows);

}  // namespace rollfem::fem
