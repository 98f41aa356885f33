// SPDX-License-Identifier: LGPL-2.1-or-later
// The verdict on a body that yields: over a cycle of load points that alternate, and over passes
// that are all alike.
#include "fem/plasticity/pass_results.hpp"
#include "result/record.hpp"

#include <fmt/format.h>

#include "support/fem_plane_strain.hpp"

namespace {

using contact::YieldedSection;
using contact::YieldVerdict;

constexpr double shear_yield = 300.0;

/// Passes over a slab of linear hardening (MPa) at `load` times k, whose friction alternates
/// between `friction` and `back`; judged over cycles of these lengths.
std::vector<std::vector<YieldedSection>> judged(double friction, double back, int passes,
                                                const std::vector<int>& cycles,
                                                double hardening = 20e3, double load = 4.6) {
  SlabOptions options;
  options.per_half_width = 3;
  const auto slab = rolled_slab(options);
  Passes forward(*slab, plain_steel(shear_yield, hardening), load * shear_yield, friction),
      backward(*slab, plain_steel(shear_yield, hardening), load * shear_yield, back);
  const auto fresh = [&](int cycle) {
    return std::make_unique<fem::PassResults>(*slab->body, forward.law, slab->lines, cycle, false);
  };
  std::vector<std::unique_ptr<fem::PassResults>> results;
  for (const int cycle : cycles) results.push_back(fresh(cycle));
  std::vector<std::vector<YieldedSection>> sections(cycles.size());
  fem::YieldedBody state = forward.state;
  for (int pass = 0; pass < passes; ++pass) {
    Passes& now = pass % 2 == 0 ? forward : backward;
    const fem::YieldedBody before = state;
    now.state = std::move(state);
    now.next();
    state = now.state;
    for (std::size_t k = 0; k < cycles.size(); ++k) {
      sections[k].push_back(results[k]->after_pass(now.report, before, state));
      // As in a run that is resumed after this pass.
      contact::Record record;
      results[k]->exchange(record);
      contact::Record back_again(record.bytes());
      results[k] = fresh(cycles[k]);
      results[k]->exchange(back_again);
    }
  }
  return sections;
}

// Braking and driving shear the surface forth and back: each pass leaves strain, both together
// none. Judged pass by pass, the last strain always lasts.
TEST(PassResults, AlternatingFrictionIsPlasticShakedownOverItsCycle) {
  const auto sections = judged(0.3, -0.3, 6, {2, 1});
  const std::array<YieldVerdict, 6> verdicts{
      YieldVerdict::settling,          YieldVerdict::settling,
      YieldVerdict::settling,          YieldVerdict::plastic_shakedown,
      YieldVerdict::plastic_shakedown, YieldVerdict::plastic_shakedown};
  for (std::size_t pass = 0; pass < verdicts.size(); ++pass) {
    SCOPED_TRACE(pass + 1);
    const YieldedSection &of_two = sections[0][pass], &of_one = sections[1][pass];
    EXPECT_EQ(of_two.verdict, verdicts[pass]);
    EXPECT_EQ(of_two.from_pass, pass < 3 ? 1 : 4);
    EXPECT_EQ(of_one.verdict, YieldVerdict::settling);
    EXPECT_EQ(of_one.cycle_increment, of_one.increment);
    EXPECT_EQ(of_one.cycle_net_increment, of_one.net_increment);
    EXPECT_EQ(of_two.increment, of_one.increment);
    EXPECT_EQ(of_two.net_increment, of_one.net_increment);
    EXPECT_GT(of_one.net_increment, 0.3 * of_one.increment);
  }
  const YieldedSection &middle = sections[0][4], &last = sections[0][5];
  EXPECT_EQ(middle.cycle_increment, sections[0][3].cycle_increment);
  // The points that yield most differ between the two.
  EXPECT_LE(last.cycle_increment, middle.increment + last.increment);
  EXPECT_GT(last.cycle_increment, std::max(middle.increment, last.increment));
  EXPECT_LT(last.cycle_net_increment, 0.03 * last.net_increment);
  EXPECT_EQ(
      fem::verdict_note(last, 6),
      fmt::format("the rail after 6 passes: plastic shakedown since pass 4, at most {:.2g} of "
                  "lasting plastic strain a cycle of 2 points",
                  last.cycle_net_increment));
  EXPECT_EQ(fem::verdict_note(sections[1][0], 1).substr(0, 32), "the rail after 1 pass: settling,");
}

// Of load points that are alike, a cycle of two is twice a pass, and has its verdict.
TEST(PassResults, CyclesOfEqualPassesHaveTheVerdictOfEach) {
  const auto sections = judged(0.3, 0.3, 4, {2, 1});
  const YieldedSection &of_two = sections[0][3], &of_one = sections[1][3];
  EXPECT_EQ(of_one.verdict, YieldVerdict::plastic_shakedown);
  EXPECT_EQ(of_two.verdict, of_one.verdict);
  EXPECT_NEAR(of_two.cycle_increment / of_one.increment, 2.0, 0.02);
  // A tenth of the strain of the second pass lasts, and half as much of the third.
  EXPECT_EQ(sections[1][1].verdict, YieldVerdict::settling);
}

// Steel that does not harden flows on by about the same strain above the limit of shakedown.
TEST(PassResults, SteadyFlowIsRatchettingAndItsRateIsTold) {
  const auto passes = judged(0.2, 0.2, 7, {1}, 0.0, 4.0).front();
  const YieldedSection &before = passes[5], &last = passes[6];
  EXPECT_EQ(passes[1].verdict, YieldVerdict::settling);
  EXPECT_EQ(last.verdict, YieldVerdict::ratchetting);
  EXPECT_NEAR(last.net_increment / before.net_increment, 1.0, 0.1);
  EXPECT_TRUE(says(fem::verdict_note(last, 7),
                   fmt::format("{:.2g} of lasting plastic strain a pass", last.net_increment)));
}

}  // namespace
