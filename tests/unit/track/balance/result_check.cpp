// SPDX-License-Identifier: LGPL-2.1-or-later
// Invalid results are refused: overlapping patches, a grid without its reference, shares that do
// not add up, an approach that parts the bodies.
#include "base/errors.hpp"
#include "track/balance/balance.hpp"

#include "support/temporary_folder.hpp"

namespace {

/// Two contacts of the left wheel, 6 mm wide each, at Y = 740 and 760 mm.
std::vector<contact::ModelResult> sound() {
  std::vector<contact::ModelResult> results;
  for (const double y : {740.0, 760.0}) {
    contact::ModelResult result;
    result.name = "halfspace";
    result.grid = contact::ContactGrid::centred(6, 16, 1.0, 1.0);
    result.place.emplace();
    result.place->y_track = -y;
    result.place->patch = static_cast<int>(results.size()) + 1;
    result.place->patches = 2;
    contact::PointResult point;
    point.approach = 0.05;
    point.vertical_force = 40e3;
    point.fields.traction.n = result.grid.sample(
        [](double x, double at) { return std::abs(x) < 2.0 && std::abs(at) < 3.0 ? 1000.0 : 0.0; });
    result.points = {point};
    results.push_back(result);
  }
  return results;
}

contact::Case load() {
  contact::Case input;
  input.load.vertical_force = 80e3;
  return input;
}

using Change = std::function<void(std::vector<contact::ModelResult>&)>;

void expect_refused(const Change& change, const std::string& text) {
  auto results = sound();
  change(results);
  EXPECT_TRUE(
      says(refusal<contact::SolveError>([&] { track::check_results(load(), results); }), text));
}

}  // namespace

TEST(ResultCheck, SoundResultsPass) {
  EXPECT_NO_THROW(track::check_results(load(), sound()));
  auto touching = sound();
  touching[1].place->y_track = -746.0;
  EXPECT_NO_THROW(track::check_results(load(), touching));
}

TEST(ResultCheck, PatchesThatOverlapAreRefused) {
  expect_refused([](auto& results) { results[1].place->y_track = -743.0; }, "overlaps");
}

TEST(ResultCheck, GridWithoutItsReferenceIsRefused) {
  expect_refused([](auto& results) { results[1].grid.y_first += 9.0; }, "reference");
}

TEST(ResultCheck, SharesThatDoNotAddUpAreRefused) {
  expect_refused([](auto& results) { *results[1].points[0].vertical_force += 8.0; }, "add up");
}

TEST(ResultCheck, NegativeApproachIsRefused) {
  expect_refused([](auto& results) { results[1].points[0].approach = -0.011; }, "approach");
}

TEST(ResultCheck, OtherModelsWheelsAndPositionsAreApart) {
  auto results = sound();
  auto others = sound();
  for (auto& result : others) result.name = "strip";
  results.insert(results.end(), others.begin(), others.end());
  for (auto& result : others) result.place->position = 2;
  results.insert(results.end(), others.begin(), others.end());
  EXPECT_NO_THROW(track::check_results(load(), results));
}
