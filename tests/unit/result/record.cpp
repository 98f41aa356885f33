// SPDX-License-Identifier: LGPL-2.1-or-later
// Results as bytes and back: everything that results.h5 and summary.json show comes out the same,
// and a record that is cut short is an error, not a crash.
#include "result/record.hpp"

#include "result/quantities.hpp"
#include "result/write/output.hpp"

#include "support/small_run.hpp"
#include "support/temporary_folder.hpp"

namespace {

contact::PointResult full_point() {
  contact::PointResult point = small_run().models[1].points[1];
  point.step = 2;
  point.longitudinal_shift = 0.1;
  point.lateral_shift = 0.2;
  point.spin_shift = 0.3;
  point.distance = 0.4;
  point.richardson = {{"max_pressure", 580.0}};
  point.elastic_energy = 957.0;
  point.frictional_work = 3.0;
  contact::SubsurfaceField below;
  below.request.points = {2, 1};
  below.points = {{0, 0, 1}, {0, 0, 2}};
  below.displacement = {{1e-3, 0, 2e-3}, {1e-3, 0, 1e-3}};
  below.stress = {{1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1}};
  point.subsurface = {below};
  point.stress_maxima = {{"rail", "tresca", 300.0, {0.0, 1.0, -2.0}}};
  contact::YieldedSection rail;
  rail.body = "rail";
  rail.verdict = contact::YieldVerdict::ratchetting;
  rail.increment = 1e-3;
  rail.across = 1;
  rail.down = 2;
  rail.y = {0.0, 0.0};
  rail.depth = {1.0, 2.0};
  rail.strain = rail.stress = {{1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1}};
  rail.accumulated = {0.25F, 0.5F};
  rail.surface_y = {0.0};
  rail.groove = {-1e-3};
  rail.forward_flow = {2e-3};
  point.yielded = {rail};
  return point;
}

std::string bytes_of(contact::PointResult point) {
  contact::Record record;
  record.value(point);
  return record.bytes();
}

TEST(Record, APointComesBackToTheLastBit) {
  result::RunRecord run = small_run();
  run.input.subsurface = {full_point().subsurface.front().request};
  auto& point = run.models[1].points[1];
  point = full_point();
  const std::string summary = result::summary_json(run);
  const std::string fields = result::results_hdf5(run);
  contact::Record record(bytes_of(point));
  point = {};
  record.value(point);
  EXPECT_TRUE(record.exhausted());
  EXPECT_EQ(result::summary_json(run), summary);
  EXPECT_TRUE(result::results_hdf5(run) == fields);
}

TEST(Record, TheSummaryListsWhatAPointHasSeveralOf) {
  result::RunRecord run = small_run();
  run.models[1].points[1] = full_point();
  std::string summary = result::summary_json(run);
  summary.erase(std::remove_if(summary.begin(), summary.end(),
                               [](unsigned char c) { return std::isspace(c) != 0; }),
                summary.end());
  EXPECT_TRUE(says(
      summary,
      R"("stress_maxima":[{"body":"rail","measure":"tresca","value":300.0,"place":[0.0,1.0,-2.0]}])",
      R"("yielded":[{"body":"rail","verdict":"ratchetting",)"));
  // Arrays are in results.h5.
  EXPECT_EQ(summary.find("groove"), summary.npos);
  EXPECT_EQ(summary.find("subsurface"), summary.npos);
}

TEST(Record, EveryQuantityComesBack) {
  contact::PointResult all, none;
  double number = 0.25;
  for (const Quantity& quantity : quantities()) {
    const bool whole = quantity.member.kind != contact::QuantityKind::number;
    number += 1.0;
    quantity.member.set(all, whole ? std::floor(number) : number);
  }
  for (const contact::PointResult& point : {all, none}) {
    contact::PointResult read;
    contact::Record record(bytes_of(point));
    record.value(read);
    EXPECT_TRUE(record.exhausted());
    for (const Quantity& quantity : quantities())
      EXPECT_EQ(quantity.value(read), quantity.value(point)) << quantity.name;
  }
}

TEST(Record, APointWithoutASolutionStaysEmpty) {
  contact::PointResult point;
  point.creepage.longitudinal = 0.01;
  point.vertical_force = 7.0;
  point.fields.gap = contact::Field::Ones(4);
  EXPECT_TRUE(contact::is_solved(point));
  contact::leave_empty(point);
  contact::PointResult back;
  contact::Record record(bytes_of(point));
  record.value(back);
  for (const contact::PointResult& each : {point, back}) {
    EXPECT_FALSE(contact::is_solved(each));
    EXPECT_EQ(each.creepage.longitudinal, 0.01);
    EXPECT_EQ(each.fields.gap.size(), 0);
    for (const char* name : {"normal_force", "max_pressure", "traction_coefficient", "approach",
                             "residual", "vertical_force"})
      EXPECT_FALSE(contact::find_quantity(name)->value(each)) << name;
    EXPECT_FALSE(each.converged);
  }
}

TEST(Record, CutShortAnywhereItIsAnError) {
  const std::string bytes = bytes_of(full_point());
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300) {
    contact::Record record(bytes.substr(0, size));
    contact::PointResult point;
    EXPECT_THROW(record.value(point), std::runtime_error) << size;
  }
}

TEST(Record, AnAbsurdLengthDoesNotAskForMemory) {
  std::string bytes(16, '\xff');
  contact::Record record(bytes);
  contact::Field field;
  EXPECT_THROW(record.value(field), std::runtime_error);
}

}  // namespace
