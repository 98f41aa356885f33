// SPDX-License-Identifier: LGPL-2.1-or-later
// Random contacts of half-spaces (support/random_contact.hpp): the tangential solver has to solve
// them all, in few steps. benchmarks/random_contacts.cpp runs thousands.
#include "support/random_contact.hpp"
#include "support/test.hpp"

namespace {

constexpr unsigned seed = 20;

RandomOutcome solve(const RandomContact& contact) {
  return run_random(contact, RandomStart::nested);
}

void expect_solved(const RandomContact& contact) {
  const RandomOutcome outcome = solve(contact);
  EXPECT_TRUE(outcome.solved) << outcome.message;
}

/// Newton steps of contacts first .. first + count - 1, sorted; every one has to be solved.
template <class Make>
std::vector<int> steps_of(unsigned first, unsigned count, const Make& make) {
  std::vector<int> steps;
  for (unsigned k = first; k < first + count; ++k) {
    const RandomContact contact = make(k);
    const RandomOutcome outcome = solve(contact);
    EXPECT_TRUE(outcome.solved) << "contact " << k << " at " << contact.across << " across, "
                                << name_of(contact.kind) << ": " << outcome.message;
    steps.push_back(outcome.newton_steps);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

TEST(RandomContacts, AreAllSolvedInFewSteps) {
  RandomContacts contacts(seed);
  const auto across = [&](int elements) {
    return [&contacts, elements](unsigned k) { return contacts.contact(k, elements); };
  };
  const std::vector<int> coarse = steps_of(0, 240, across(20));
  EXPECT_LE(coarse.back(), 12);
  EXPECT_LE(coarse[coarse.size() / 2], 4);
  const std::vector<int> middle = steps_of(240, 54, across(40));
  EXPECT_LE(middle.back(), 12);
  EXPECT_LE(middle[middle.size() / 2], 4);
  EXPECT_LE(steps_of(294, 6, across(80)).back(), 12);
}

TEST(RandomContacts, FallingFrictionAndLayersAreAllSolved) {
  RandomContacts contacts(31);
  for (const bool remembers : {true, false}) {
    SCOPED_TRACE(remembers ? "with memory" : "without memory");
    const std::vector<int> steps =
        steps_of(0, 100, [&](unsigned k) { return contacts.falling_contact(k, 20, remembers); });
    EXPECT_LE(steps[50], 4);
    EXPECT_LE(steps.back(), 100);
  }
  // Bounds that all move one way, through several hundred Newton steps.
  expect_solved(contacts.falling_contact(112, 20, false));
}

TEST(RandomContacts, WhereNoStateStaysTheMessageSaysWhatToDo) {
  const RandomOutcome outcome = solve(RandomContacts(1).falling_contact(30, 20, false));
  EXPECT_FALSE(outcome.solved);
  EXPECT_TRUE(outcome.chatters) << outcome.message;
  EXPECT_NE(outcome.message.find("no stable steady state"), std::string::npos) << outcome.message;
  EXPECT_NE(outcome.message.find("do: give friction.memory_distance"), std::string::npos)
      << outcome.message;
}

TEST(RandomContacts, LayersThatYieldAreAllSolved) {
  RandomContacts contacts(41);
  const std::vector<int> steps =
      steps_of(0, 200, [&](unsigned k) { return contacts.yielding_contact(k, 20); });
  EXPECT_LE(steps[100], 5);
}

/// Pressure and friction feed each other by mu K/(1 - nu).
double gain(const RandomContact& contact) {
  const contact::CombinedMaterial material = contact.material();
  return contact.friction * std::abs(material.difference) / (1.0 - material.poisson_ratio);
}

TEST(RandomContacts, UnlikeMaterialsUnderMuchFriction) {
  // Plain steps of more than 2/(1 + gain^2) cycle for ever here, and so did Anderson's.
  const RandomContact strong = RandomContacts(2).contact(5689, 40);
  EXPECT_GT(gain(strong), 3.0);
  const RandomOutcome outcome = solve(strong);
  EXPECT_TRUE(outcome.solved) << outcome.message;
  EXPECT_LE(outcome.outer_iterations, 150);
  // Friction carries the patch out of the grid that the pressure alone needs.
  const RandomContact shifted = RandomContacts(3).contact(2667, 40);
  EXPECT_GT(gain(shifted), 1.0);
  expect_solved(shifted);
  // Both forces prescribed, to 1e-6 of mu F_z.
  expect_solved(RandomContacts(2).contact(3737, 20));
}

TEST(RandomContacts, NearlySlidingOnAFineGrid) {
  // The part of the preconditioner across the slip brings GMRES to a standstill here; with 80
  // elements across it does not.
  expect_solved(RandomContacts(2).contact(6084, 100));
}

TEST(RandomContacts, AreMadeAgainFromSeedAndNumber) {
  RandomContacts one(seed);
  RandomContacts two(seed);
  two.contact(4, 20);
  const RandomContact a = one.contact(7, 20);
  const RandomContact b = two.contact(7, 40);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.friction, b.friction);
  EXPECT_EQ(a.creepage.spin, b.creepage.spin);
  EXPECT_NE(a.friction, one.contact(8, 20).friction);
  EXPECT_NE(a.friction, RandomContacts(seed + 1).contact(7, 20).friction);
}

}  // namespace
