// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that falls steeply without memory has several states: rollers at 45 m/s, of which
// CONTACT finds three by different first guesses (E. A. H. Vollebregt & H. M. Schuttelaars, J.
// Sound Vib. 331 (2012), 2141; example veldep_fric of the open version r2707, cases 1, 2 and 4), on
// CONTACT's elements with its difference (its steps from fast sliding: the book).
#include "contact/iteration/tangential.hpp"
#include "contact/solve/contact_problem.hpp"
#include "contact/solve/contact_run.hpp"
#include "contact/solve/point_motion.hpp"
#include "halfspace/elasticity/halfspace_compliance.hpp"

#include "support/test.hpp"

namespace {

constexpr double static_friction = 0.3, normal_force = 622216.0, speed = 45e3;
constexpr double sliding_force = static_friction * normal_force;
constexpr double within = 1e-3;  // of it; CONTACT prints four digits

class Rollers {
 public:
  /// `memory`: d_c in mm, 0 for none. `corrected`: as if the elasticity had to be corrected.
  explicit Rollers(double memory = 0.0, bool corrected = false)
      : grid_(elements()), whole_(grid_, material()), same_(grid_, material()) {
    std::optional<contact::FrictionMemory> remembered;
    if (memory > 0.0) remembered = contact::FrictionMemory{memory, 1.0 / speed};
    law_ = std::make_shared<contact::FallingFriction>(
        contact::FallShape::exponential, 0.18,
        std::array<contact::FallingFriction::Part, 2>{{{0.12, 100.0 / speed}, {0.0, 1.0}}},
        remembered);
    contact::ContactConditions conditions;
    conditions.friction = law_;
    conditions.upwind_order = contact::UpwindOrder::first;
    conditions.coupled_halfspace = corrected ? &same_ : nullptr;
    conditions.undeformed_distance =
        grid_.sample([](double x, double) { return x * x / (2.0 * 460.0); });
    problem_ = std::make_unique<contact::ContactProblem>(corrected ? same_ : whole_, whole_,
                                                         std::move(conditions));
    load_.force = normal_force;
  }

  contact::ContactState steady(double creepage) {
    contact::TangentialMotion motion;
    motion.rigid_slip = slip(creepage);
    return solved(motion);
  }

  /// A step of one element that rolls on from a state.
  contact::TangentialMotion step_from(const contact::ContactState& before, double creepage) const {
    contact::History history(grid_, contact::UpwindOrder::first);
    history.advance({before.displacement.x, before.displacement.y}, 0.0);
    return history.rolling_step(slip(creepage), grid_.dx);
  }

  contact::ContactState solved(const contact::TangentialMotion& motion) {
    contact::ContactState state = problem_->solve(load_, motion);
    states_ = problem_->count_states(state, motion);
    return state;
  }

  /// The state with the least friction, to which the rollers come from fast sliding.
  contact::TangentialSolution from_above(const contact::ContactState& before, double creepage) {
    const contact::TangentialMotion motion = step_from(before, creepage);
    contact::TangentialOptions options;
    options.other_branch = true;
    return contact::solve_tangential(whole_.shift(), {before.normal.pressure, motion, law_},
                                     options);
  }

  /// Tractions in a step from `before`, with bounds that follow the slip for some rounds, and the
  /// change of the bounds in the last.
  contact::TangentialField followed(const contact::ContactState& before, double creepage,
                                    contact::Field bound, int rounds, double& change) const {
    const contact::TangentialMotion motion = step_from(before, creepage);
    contact::TangentialSolution solution;
    for (int round = 0; round < rounds; ++round) {
      solution = contact::solve_tangential(whole_.shift(),
                                           {bound, {motion.rigid_slip}, contact::coulomb(1.0)}, {},
                                           solution.traction);
      const contact::Field held = bound;
      for (int k = 0; k < grid_.size(); ++k)
        bound[k] =
            before.normal.pressure[k] *
            law_->at(motion.slip_factor * std::hypot(solution.slip.x[k], solution.slip.y[k])).value;
      change = (bound - held).cwiseAbs().maxCoeff();
    }
    return solution.traction;
  }

  double force(const contact::TangentialField& traction) const {
    return traction.x.sum() * grid_.element_area();
  }

  /// States found by the last solution.
  int states() const { return states_; }

 private:
  static contact::ContactGrid elements() {
    contact::ContactGrid grid = contact::ContactGrid::centred(92, 1, 0.1, 200.0);
    grid.x_first = -4.6;
    return grid;
  }
  static contact::CombinedMaterial material() {
    const contact::Material steel{2.0 * 82000.0 * 1.28, 0.28};
    return contact::combine(steel, steel);
  }
  contact::TangentialField slip(double creepage) const {
    return contact::uniform_slip({creepage, 0.0, 0.0}, grid_);
  }

  contact::ContactGrid grid_;
  halfspace::HalfspaceCompliance whole_, same_;
  contact::Friction law_;
  std::unique_ptr<contact::ContactProblem> problem_;
  contact::NormalLoad load_;
  int states_ = 0;
};

TEST(SeveralStates, RollersHaveTheThreeOfContact) {
  Rollers rollers;
  const contact::ContactState steady = rollers.steady(-0.0009999);
  EXPECT_NEAR(rollers.force(steady.tangential.traction) / sliding_force, 0.5941, within);
  const contact::ContactState below = rollers.solved(rollers.step_from(steady, -0.001));
  EXPECT_NEAR(rollers.force(below.tangential.traction) / sliding_force, 0.5977, within);
  EXPECT_EQ(rollers.states(), 2);  // that one, and another that stays
  const contact::TangentialSolution above = rollers.from_above(steady, -0.001);
  EXPECT_NEAR(rollers.force(above.traction) / sliding_force, 0.5702, within);
  // The steady state is a third one of the step: between two that stay lies one that does not.
  EXPECT_LT(*below.tangential.feedback, 1.0);
  EXPECT_LT(*above.feedback, 1.0);
}

/// Bounds g that follow the slip of the solution with g held fixed, round by round.
TEST(SeveralStates, TheSteadyStateIsOneOfTheStepThatSmallChangesLeave) {
  Rollers rollers;
  constexpr double creepage = -0.0009999;
  const contact::ContactState steady = rollers.steady(creepage);
  const contact::Field bound = steady.tangential.bound;
  double change = 0.0;
  EXPECT_NEAR(rollers.force(rollers.followed(steady, creepage, bound, 1, change)) / sliding_force,
              0.5941, within);
  EXPECT_LT(change, 1e-5 * bound.maxCoeff());  // a state of the step
  const auto end = [&](double factor) {
    const double force =
        rollers.force(rollers.followed(steady, creepage, factor * bound, 60, change));
    EXPECT_LT(change, 1e-4 * bound.maxCoeff());
    return force / sliding_force;
  };
  EXPECT_NEAR(end(1.0 + 1e-3), 0.5977, within);
  EXPECT_NEAR(end(1.0 - 1e-3), 0.5702, within);
}

TEST(SeveralStates, AreCountedWithACorrectedElasticityToo) {
  Rollers rollers(0.0, true);
  rollers.solved(rollers.step_from(rollers.steady(-0.0009999), -0.001));
  EXPECT_EQ(rollers.states(), 2);
}

TEST(SeveralStates, RollersStickAndSlipFromStepToStepUnlessFrictionRemembers) {
  // CONTACT's forces over the bound go from 0.570 to 0.588 and back in its 50 steps.
  Rollers rollers;
  contact::ContactState state = rollers.steady(-0.001);
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (int step = 0; step < 50; ++step) {
    state = rollers.solved(rollers.step_from(state, -0.001));
    const double force = rollers.force(state.tangential.traction) / sliding_force;
    least = std::min(least, force);
    most = std::max(most, force);
  }
  EXPECT_GT(most - least, 0.01);
  EXPECT_LT(most, 0.62);
  EXPECT_GT(least, 0.55);
  Rollers remembering(1e-3);
  EXPECT_FALSE(remembering.steady(-0.001).tangential.feedback);
  EXPECT_EQ(remembering.states(), 1);
}

TEST(SeveralStates, ResultsSayThatThereAreSeveral) {
  contact::LevelResult level;
  level.points.resize(3);
  const auto law = std::make_shared<contact::FallingFriction>(
      contact::FallShape::linear, 0.1,
      std::array<contact::FallingFriction::Part, 2>{{{0.2, 1.0}, {0.0, 1.0}}});
  std::vector<contact::Note> notes;
  contact::warn_of_steep_friction(level, law, notes);
  EXPECT_TRUE(notes.empty());
  level.several = 2;
  contact::warn_of_steep_friction(level, law, notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].severity, contact::Note::warning);
  EXPECT_NE(notes[0].text.find("several states at 2 of 3 load points"), std::string::npos);
  EXPECT_NE(notes[0].text.find("friction.memory_distance"), std::string::npos);
  const auto softens = std::make_shared<contact::CoulombFriction>(0.3);
  softens->plasticity = contact::Plasticity{100.0, -1e3};
  contact::warn_of_steep_friction(level, softens, notes);
  const std::string& layer = notes.back().text;
  EXPECT_NE(layer.find("layer.hardening"), std::string::npos) << layer;
  EXPECT_EQ(layer.find("memory_distance"), std::string::npos) << layer;
}

}  // namespace
