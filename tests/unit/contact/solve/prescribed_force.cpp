// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for the creepage of a force, on force laws that are known in closed form.
#include "contact/solve/prescribed_force.hpp"

#include "base/errors.hpp"

#include "support/temporary_folder.hpp"

namespace rollfem::contact {
namespace {

using Eigen::Vector2d;

constexpr double bound = 1000.0;

/// Carter's law, saturated beyond |c| = 1, along the creepage; `offset` moves the point of no
/// force.
ForceLaw carter_law(const Vector2d& offset = {0.0, 0.0}) {
  return [offset](const Vector2d& creepage) {
    const Vector2d c = creepage - offset;
    const double size = c.norm();
    const double part = size < 1.0 ? size * (2.0 - size) : 1.0;
    return TransmittedForce{size > 0.0 ? Vector2d(-bound * part / size * c) : Vector2d(0.0, 0.0),
                            bound};
  };
}

ForceSearch search(double stiffness_error = 1.0) {
  ForceSearch s;
  s.start = {0.0, 0.0};
  s.stiffness = Vector2d::Constant(2.0 * bound * stiffness_error);
  return s;
}

TEST(PrescribedForce, OneComponentUpToSaturation) {
  for (const double part : {1e-6, 0.1, 0.5, 0.9, 0.99, 0.999, 0.99999})
    for (const double sign : {1.0, -1.0}) {
      const FoundCreepage found = find_creepage(carter_law(), {sign * part * bound, {}}, search());
      EXPECT_NEAR(found.transmitted.force.x(), sign * part * bound, 1e-6 * bound);
      // 1 - (1 - c)^2 = part
      EXPECT_NEAR(found.creepage.x(), -sign * (1.0 - std::sqrt(1.0 - part)), 2e-3) << part;
      EXPECT_LE(found.evaluations, part < 0.9999 ? 14 : 20) << part;
    }
}

TEST(PrescribedForce, FindsItsWayOutOfFullSlip) {
  ForceSearch from_sliding = search();
  from_sliding.start = {50.0, 0.0};
  const FoundCreepage found = find_creepage(carter_law(), {-0.3 * bound, {}}, from_sliding);
  EXPECT_NEAR(found.transmitted.force.x(), -0.3 * bound, 1e-6 * bound);
  const FoundCreepage both = find_creepage(carter_law(), {-0.3 * bound, 0.5 * bound}, from_sliding);
  EXPECT_NEAR(both.transmitted.force.y(), 0.5 * bound, 2e-6 * bound);
}

TEST(PrescribedForce, WrongStiffnessAndAnOffsetCostStepsOnly) {
  for (const double wrong : {0.01, 100.0}) {
    const FoundCreepage one =
        find_creepage(carter_law({0.4, 0.0}), {0.6 * bound, {}}, search(wrong));
    EXPECT_NEAR(one.creepage.x(), 0.4 - (1.0 - std::sqrt(0.4)), 1e-5);
    const FoundCreepage two =
        find_creepage(carter_law({0.2, -0.3}), {0.3 * bound, -0.4 * bound}, search(wrong));
    EXPECT_NEAR(two.transmitted.force.x(), 0.3 * bound, 2e-6 * bound);
    EXPECT_NEAR(two.transmitted.force.y(), -0.4 * bound, 2e-6 * bound);
  }
}

TEST(PrescribedForce, TwoComponentsNearSaturation) {
  for (const double part : {0.5, 0.99, 0.999, 0.9999}) {
    const double each = part * bound * std::sqrt(0.5);
    const FoundCreepage found = find_creepage(carter_law(), {-each, each}, search());
    EXPECT_NEAR(found.creepage.x(), std::sqrt(0.5) * (1.0 - std::sqrt(1.0 - part)), 1e-2);
    EXPECT_NEAR(found.creepage.y(), -std::sqrt(0.5) * (1.0 - std::sqrt(1.0 - part)), 1e-2);
  }
}

/// 3/4 of the bound at most, at |c| = 1, and less beyond: 3 c/(2 (1 + c^2)).
TransmittedForce falling(const Vector2d& c) {
  return {Vector2d(-1.5 * bound / (1.0 + c.squaredNorm()) * c), bound};
}

TEST(PrescribedForce, NearThePeakOfAFallingCurveIsOnTheRisingBranch) {
  for (const double part : {0.1, 0.6, 0.74, 0.7499})
    for (const double sign : {1.0, -1.0})
      for (const double start : {0.0, 0.3, 5.0}) {
        ForceSearch from = search();
        from.has_peak = true;
        from.start = {-sign * start, 0.0};
        const FoundCreepage found = find_creepage(falling, {sign * part * bound, {}}, from);
        EXPECT_NEAR(found.transmitted.force.x(), sign * part * bound, 1e-6 * bound);
        const double root = 0.75 / part;  // part (1 + c^2) = 3/2 c
        EXPECT_NEAR(found.creepage.x(), -sign * (root - std::sqrt(root * root - 1.0)), 1e-3)
            << part << ", from " << start;
      }
}

TEST(PrescribedForce, AboveThePeakTheMessageNamesThePeak) {
  for (const double start : {0.0, -0.3, -5.0}) {
    ForceSearch from = search();
    from.has_peak = true;
    from.start = {start, 0.0};
    const std::string message = refusal<SolveError>([&] {
      find_creepage(falling, {0.8 * bound, {}}, from);
    });
    EXPECT_TRUE(says(message, "at most about 750 N, at creepage -")) << message;
    EXPECT_TRUE(says(message, "beyond the peak")) << message;
  }
}

TEST(PrescribedForce, BeyondFrictionIsAnErrorThatSaysSo) {
  EXPECT_TRUE(says(refusal<SolveError>([] {
                     find_creepage(carter_law(), {1.001 * bound, {}}, search());
                   }),
                   "mu F_z = 1000 N"));
  EXPECT_THROW(find_creepage(carter_law(), {0.8 * bound, 0.8 * bound}, search()), SolveError);
}

TEST(PrescribedForce, AForceThatNoCreepageGivesIsAnError) {
  const ForceLaw stubborn = [](const Vector2d&) { return TransmittedForce{{-100.0, 0.0}, bound}; };
  EXPECT_THROW(find_creepage(stubborn, {500.0, {}}, search()), SolveError);
  const ForceLaw jump = [](const Vector2d& c) {
    return TransmittedForce{{c.x() > 0.123 ? -900.0 : 900.0, 0.0}, bound};
  };
  EXPECT_THROW(find_creepage(jump, {0.0, {}}, search()), SolveError);
}

}  // namespace
}  // namespace rollfem::contact
