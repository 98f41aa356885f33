// SPDX-License-Identifier: LGPL-2.1-or-later
// The verdict on a body that yields: over a cycle of load points that alternate, and over passes
// that are all alike.
#include "fem/elasticity/fem_error_bars.hpp"
#include "fem/plasticity/pass_results.hpp"
#include "result/record.hpp"

#include <fmt/format.h>

#include "support/fem_plane_strain.hpp"
#include <tuple>

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
  EXPECT_EQ(fem::finding(last, nullptr, 6),
            fmt::format(
                "plastic shakedown since pass 4, at most {:.2g} of lasting plastic strain a cycle "
                "of 2 points",
                last.cycle_net_increment));
  EXPECT_EQ(fem::finding(sections[1][0], nullptr, 1).substr(0, 9), "settling,");
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
  EXPECT_TRUE(says(fem::finding(last, nullptr, 7),
                   fmt::format("{:.2g} of lasting plastic strain a pass", last.net_increment)));
}

/// A pass with this verdict, strain, lasting strain and load over the limits of shakedown.
std::vector<contact::PointResult> one_pass(YieldVerdict verdict, double strain, double net,
                                           double load = 1.0, double elastic_load = 1.0) {
  contact::PointResult point;
  YieldedSection& section = point.yielded.emplace_back();
  section.verdict = verdict;
  section.from_pass = 1;
  section.forward_flow = {0.0};
  section.cycle_increment = strain;
  section.cycle_net_increment = net;
  section.shakedown_load = load;
  section.elastic_shakedown_load = elastic_load;
  return {point};
}

TEST(PassResults, AVerdictIsThatOfTheFinerMeshAsFarAsBothResolveIt) {
  const auto flows = YieldVerdict::ratchetting, settles = YieldVerdict::settling;
  const auto compared = [](auto coarse, auto fine, bool thick_rows = false) {
    fem::compare_verdicts(coarse, fine, thick_rows);
    return fine.front().yielded.front();
  };
  const YieldedSection same = compared(one_pass(flows, 3e-3, 2e-3), one_pass(flows, 4e-3, 2.1e-3));
  EXPECT_EQ(same.evidence, contact::YieldEvidence::both_meshes);
  EXPECT_EQ(same.finding, "ratchetting, 0.0021 of lasting plastic strain a pass");
  const YieldedSection grows = compared(one_pass(settles, 3e-3, 1e-3), one_pass(flows, 4e-3, 2e-3));
  EXPECT_EQ(grows.evidence, contact::YieldEvidence::not_resolved);
  EXPECT_EQ(grows.finding,
            "ratchetting, not resolved, at least 0.002 of lasting plastic strain a pass; on cells "
            "of twice the size settling, 0.003 and 0.001");
  const YieldedSection other = compared(one_pass(flows, 3e-3, 2e-3), one_pass(settles, 3e-3, 1e-3));
  EXPECT_EQ(other.evidence, contact::YieldEvidence::meshes_differ);
  EXPECT_TRUE(says(other.finding, "settling, ") && says(other.finding, "size ratchetting"));
  const YieldedSection thick =
      compared(one_pass(flows, 3e-3, 2e-3), one_pass(flows, 4e-3, 2.1e-3), true);
  EXPECT_EQ(thick.evidence, contact::YieldEvidence::not_resolved);
  EXPECT_TRUE(says(thick.finding, "ratchetting, not resolved, at least 0.0021 of lasting"));
}

TEST(PassResults, AVerdictNamesTheLimitOfShakedownThatContradictsIt) {
  const auto found = [](YieldVerdict verdict, double load, double elastic_load) {
    return fem::finding(one_pass(verdict, 1e-3, 1e-4, load, elastic_load)[0].yielded[0], nullptr,
                        1);
  };
  EXPECT_TRUE(says(found(YieldVerdict::settling, 0.94, 1.13),
                   "it settles because the groove conforms: the load falls from 113 to 94 %"));
  EXPECT_TRUE(says(found(YieldVerdict::settling, 1.84, 1.9), "yet the load is 184 %"));
  EXPECT_TRUE(says(found(YieldVerdict::ratchetting, 0.5, 0.6), "the load is 50 %"));
  EXPECT_FALSE(says(found(YieldVerdict::ratchetting, 1.2, 1.3), "shakedown"));
}

// Plane strain at 5 k, friction 0.39, steel that saturates: the third pass on cells of a/4, a/8 and
// a/16. The largest residual stress lies below the layer on the first two, in it on the third.
TEST(PassBars, AgreementByChanceDoesNotMakeThemSmall) {
  std::vector<contact::PointResult> coarse(1), fine(1);
  std::tie(coarse[0].plastic_strain, coarse[0].residual_stress) = std::tuple(0.1002, 271.8);
  std::tie(fine[0].plastic_strain, fine[0].residual_stress) = std::tuple(0.1274, 264.9);
  fine[0].semi_axis_x = fine[0].semi_axis_y = 1.0;
  fem::set_pass_bars(coarse, 1.0 / 8.0, true, fine);
  EXPECT_GT(fine[0].bar_of("residual_stress").value(), 328.8 - 264.9);
  EXPECT_LT(fine[0].bar_of("residual_stress").value(), 100.0);
  coarse[0].plastic_strain = 0.04;
  fem::set_pass_bars(coarse, 1.0 / 8.0, true, fine);
  EXPECT_EQ(fine[0].no_bar.at("residual_stress"), contact::NoBar::not_resolved);
}

// Cells of a third of a semi-axis average the strain below it over themselves, whatever cells of
// twice the size say; where the surface flows, its residual stress is known to the first order.
TEST(PassBars, CellsOfAPartOfThePatchBoundThemFromBelow) {
  std::vector<contact::PointResult> same(1);
  std::tie(same[0].plastic_strain, same[0].residual_stress) = std::tuple(0.02, 200.0);
  std::tie(same[0].semi_axis_x, same[0].semi_axis_y) = std::tuple(6.0, 4.5);
  auto fine = same;
  fem::set_pass_bars(same, 1.5, false, fine);
  EXPECT_NEAR(fine[0].bar_of("plastic_strain").value(), 1.25 * 1.5 * 0.02 / 9.0, 1e-12);
  EXPECT_NEAR(fine[0].bar_of("residual_stress").value(), 1.25 * 1.5 * 200.0 / 9.0, 1e-9);
  fem::set_pass_bars(same, 1.5, true, fine);
  EXPECT_NEAR(fine[0].bar_of("residual_stress").value(), 1.25 * 1.5 * 200.0 / 3.0, 1e-9);
}

}  // namespace
