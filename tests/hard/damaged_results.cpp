// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged results and records: none of them is used. ROLLFEM_DAMAGED=10000 tries as many of each.
#include "base/errors.hpp"
#include "halfspace/model/halfspace_model.hpp"
#include "result/files/checkpoint_folder.hpp"
#include "result/files/seal.hpp"
#include "result/write/output.hpp"
#include "scene/scene.hpp"
#include "tables/files/table_files.hpp"

#include "support/damage.hpp"
#include "support/records_in_memory.hpp"
#include "support/shifted_table.hpp"
#include "support/small_run.hpp"
#include "support/temporary_folder.hpp"
#include "support/thesis_cases.hpp"
#include <chrono>
#include <thread>

namespace {

namespace fs = std::filesystem;

TEST(DamagedResults, AreRefusedBeforeHdf5SeesThem) {
  const TemporaryFolder folder;
  const std::string sound = result::results_hdf5(small_run());
  ASSERT_TRUE(result::hdf5_seal_is_intact(folder.file("sound.h5", sound), ""));
  for (int k = 0, files = damaged_files(500); k < files; ++k) {
    Damage damage(static_cast<unsigned long long>(k));
    fs::remove(folder.path("r.h5"));
    const std::string path = folder.file("r.h5", damage.of(sound));
    bool intact = false;
    const std::string said = refusal<contact::InputError>(
        [&] { intact = result::hdf5_seal_is_intact(path, "name another"); });
    EXPECT_FALSE(intact && said.empty()) << k;
  }
}

TEST(DamagedResults, TablesAreRefusedWithOrWithoutTheirHead) {
  const TemporaryFolder folder;
  const std::string sound = tables::table_hdf5(table_of_shifts(2));
  EXPECT_EQ(tables::read_table(folder.file("sound.h5", sound)).title, "shifts");
  for (int k = 0, files = damaged_files(500); k < files; ++k) {
    Damage damage(static_cast<unsigned long long>(k));
    const std::string bytes = k == 0 ? sound : damage.of(sound);
    fs::remove(folder.path("t.h5"));
    const std::size_t begin = k % 2 == 0 ? result::seal_size : 0;
    const std::string path = folder.file("t.h5", bytes.substr(std::min(begin, bytes.size())));
    const std::string said = refusal<contact::InputError>([&] { tables::read_table(path); });
    EXPECT_NE(said.find("do: "), std::string::npos) << k << ": " << said;
  }
}

/// A folder of records of a case.
result::CheckpointFolder kept_of(const TemporaryFolder& folder, const std::string& name,
                                 const std::string& case_text, bool resume, int& warnings) {
  contact::Case input;
  input.text = case_text;
  return {folder.path(name), input, "test", resume, [&](const std::string&) { ++warnings; }};
}

TEST(DamagedResults, RecordsOfAnotherPlaceOrDamagedOnesAreNotTakenUp) {
  const TemporaryFolder folder;
  int warnings = 0;
  const std::string content(3000, 'r');
  for (const char* name : {"one", "other"}) {
    auto kept = kept_of(folder, name, name, false, warnings);
    std::this_thread::sleep_for(std::chrono::milliseconds(550));  // earlier it is held back
    kept.keep("halfspace-0001", content);
    kept.keep("halfspace-0002", content);
  }
  const fs::path one = folder.path("one.unfinished"), other = folder.path("other.unfinished");
  const auto found = [&](const std::string& record) {
    return kept_of(folder, "one", "one", true, warnings).find(record).has_value();
  };
  EXPECT_TRUE(found("halfspace-0001"));
  EXPECT_EQ(warnings, 0);
  const std::string sound = contents(one / "halfspace-0001.point");
  for (const fs::path& foreign : {one / "halfspace-0002.point", other / "halfspace-0001.point"}) {
    fs::copy_file(foreign, one / "halfspace-0001.point", fs::copy_options::overwrite_existing);
    EXPECT_FALSE(found("halfspace-0001")) << foreign;
  }
  EXPECT_EQ(warnings, 2);
  const int files = damaged_files(500);
  for (int k = 0; k < files; ++k) {
    Damage damage(static_cast<unsigned long long>(k));
    fs::remove(one / "halfspace-0001.point");
    folder.file("one.unfinished/halfspace-0001.point", damage.of(sound));
    EXPECT_FALSE(found("halfspace-0001")) << k;
  }
  EXPECT_EQ(warnings, 2 + files);
}

/// Steps of a history, each of which starts from the state that the record before it holds.
contact::Scene steps() {
  contact::Case input = thesis_case('a', 8);
  roll_on(input, 3, 1.0, {0.002, 0.0, 0.0});
  return contact::Scene(input);
}

TEST(DamagedResults, RecordsThatAreSealedButDamagedAreComputedAgain) {
  const contact::Scene scene = steps();
  RecordsInMemory sound;
  const contact::ModelResult whole = halfspace::run_halfspace(scene, {}, &sound);
  ASSERT_EQ(sound.records.size(), 3U);
  int refused = 0;
  const int files = damaged_files(300);
  for (int k = 0; k < files; ++k) {
    Damage damage(static_cast<unsigned long long>(k));
    RecordsInMemory damaged = sound;
    auto record = damaged.records.begin();
    std::advance(record, k % 3);
    record->second = damage.of(record->second);
    try {
      const contact::ModelResult again = halfspace::run_halfspace(scene, {}, &damaged);
      EXPECT_EQ(again.points.size(), 3U);
      if (damaged.refused > 0) {
        EXPECT_EQ(again.points.back().max_pressure, whole.points.back().max_pressure) << k;
      }
    } catch (const contact::Failure&) {
      // From numbers that are wrong, but of the right count, no solution need exist.
    }
    refused += damaged.refused > 0 ? 1 : 0;
  }
  EXPECT_GT(refused, files / 4);
}

}  // namespace
