// SPDX-License-Identifier: LGPL-2.1-or-later
// Every row of the table of scalars is in every file, is read back from it, and is documented in
// docs/results.md. No quantity is named here, so new rows are tested automatically.
#include "result/quantities.hpp"
#include "result/record.hpp"
#include "result/write/csv.hpp"
#include "result/write/output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/csv_rows.hpp"
#include "support/output_python.hpp"
#include "support/output_synthetic_run.hpp"
#include "support/places.hpp"

namespace rollfem::result {
namespace {

/// Another number in every scalar of its first point; the second has none that may be absent.
RunRecord numbered_run() {
  RunRecord run = synthetic_run();
  run.models = {run.models[1]};
  run.models[0].points.resize(2);
  double number = 0.25;
  for (const Quantity& quantity : quantities()) {
    number += 1.0;
    const bool whole = quantity.member.kind != contact::QuantityKind::number;
    quantity.member.set(run.models[0].points[0], whole ? std::floor(number) : number);
  }
  return run;
}

void expect_same(const PointResult& found, const PointResult& written) {
  for (const Quantity& quantity : quantities())
    EXPECT_EQ(quantity.value(found), quantity.value(written)) << quantity.name;
}

TEST(EveryQuantity, IsInSummaryJsonAndComesBack) {
  const RunRecord run = numbered_run();
  const auto points = nlohmann::json::parse(summary_json(run))["models"][0]["points"];
  for (std::size_t k = 0; k < 2; ++k) {
    const PointResult& point = run.models[0].points[k];
    for (const Quantity& quantity : quantities()) {
      const std::optional<double> value = quantity.value(point);
      const nlohmann::json stored = points[k].value(quantity.name, nlohmann::json());
      const bool truth = quantity.member.kind == contact::QuantityKind::truth;
      EXPECT_EQ(points[k].contains(quantity.name), value.has_value()) << quantity.name;
      EXPECT_EQ(stored.is_boolean(), truth) << quantity.name;
      if (!value) continue;
      EXPECT_EQ(truth ? static_cast<double>(stored.get<bool>()) : stored.get<double>(), *value)
          << quantity.name;
    }
  }
}

TEST(EveryQuantity, IsInResultsHdf5WithUnitAndMeaningAndComesBack) {
  const RunRecord run = numbered_run();
  const TemporaryFolder folder;
  const std::string path = folder.file("quantities.h5", results_hdf5(run));
  if (!python_can_import("h5py"))
    GTEST_SKIP() << "needs /usr/bin/python3 with h5py (apt install python3-h5py)";
  const std::string printed = python(R"(
import sys, h5py
f = h5py.File(sys.argv[1])
points = f['models/halfspace/points']
columns = [f['quantities'][n].asstr()[()] for n in ('name', 'title', 'symbol', 'unit', 'meaning')]
for row in zip(*columns):
    values = [points[k].attrs.get(row[0]) for k in ('0000', '0001')]
    print(*('-' if value is None else '%.17g' % value for value in values), *row, sep='\t')
)",
                                     path);
  std::string expected;
  for (const Quantity& quantity : quantities()) {
    for (const PointResult& point : run.models[0].points) {
      const std::optional<double> value = quantity.value(point);
      expected += value ? fmt::format("{:.17g}\t", *value) : "-\t";
    }
    expected += fmt::format("{}\t{}\t{}\t{}\t{}\n", quantity.name, quantity.title, quantity.symbol,
                            quantity.unit, quantity.meaning);
  }
  EXPECT_EQ(printed, expected);
}

TEST(EveryQuantity, HasAColumnOfCreepCurveCsvWithItsUnit) {
  const RunRecord run = numbered_run();
  const auto rows = csv_rows(creep_curve_csv(run));
  const std::vector<std::string>& names = rows.at(0);
  ASSERT_GT(names.size(), 2 + quantities().size());  // model, point; bars behind
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < quantities().size(); ++c) {
      const Quantity& quantity = quantities()[c];
      EXPECT_EQ(names[c + 2], std::string(quantity.name) + " [" + quantity.unit + "]");
      const std::optional<double> value = quantity.value(run.models[0].points[k]);
      const std::string& cell = rows.at(k + 1).at(c + 2);
      EXPECT_EQ(cell.empty(), !value.has_value()) << quantity.name;
      if (value.has_value()) {
        EXPECT_EQ(std::strtod(cell.c_str(), nullptr), *value) << quantity.name;
      }
    }
}

TEST(EveryQuantity, HasItsBarInCreepCurveCsvOrTheWordInItsPlace) {
  RunRecord run = numbered_run();
  run.models[0].points[0].error_estimate = {{"max_pressure", 1.25}};
  run.models[0].points[0].no_bar = {{"approach", contact::NoBar::given}};
  run.models[0].points[0].model_error = {{"semi_axis_x", 0.5}};
  const auto row = csv_records(creep_curve_csv(run), false).at(0);
  EXPECT_EQ(row.at("error_estimate max_pressure [MPa]"), "1.25");
  EXPECT_EQ(row.at("error_estimate approach [mm]"), "given");
  EXPECT_EQ(row.at("error_estimate semi_axis_x [mm]"), "");
  EXPECT_EQ(row.at("model_error semi_axis_x [mm]"), "0.5");
  EXPECT_EQ(row.count("error_estimate seconds [s]"), 0U);
}

TEST(EveryQuantity, ComesBackFromACheckpoint) {
  const RunRecord run = numbered_run();
  for (PointResult point : run.models[0].points) {
    contact::Record written;
    written.value(point);
    contact::Record record(written.bytes());
    PointResult read;
    record.value(read);
    EXPECT_TRUE(record.exhausted());
    expect_same(read, point);
    EXPECT_EQ(read.error_estimate, point.error_estimate);
    EXPECT_EQ(read.no_bar, point.no_bar);
  }
}

TEST(EveryQuantity, StandsInTheDocumentation) {
  const auto page = std::filesystem::path(ROLLFEM_SOURCE_DIR) / "docs/results.md";
  EXPECT_TRUE(says(contents(page), "\n" + contact::quantities_markdown() + "\n"))
      << "docs/results.md does not hold the table; do: put there what `rollfem docs quantities` "
         "prints";
}

}  // namespace
}  // namespace rollfem::result
