// SPDX-License-Identifier: LGPL-2.1-or-later
// Long lists of load points store fields on the contact grid for a selection only.
#include "result/write/output.hpp"

#include "support/output_python.hpp"
#include "support/output_synthetic_run.hpp"
#include "support/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rollfem::result {
TEST(GridFields, ALongListKeepsTheFieldsOfSomeOfItsLoadPoints) {
  if (!python_can_import("h5py"))
    GTEST_SKIP() << "needs /usr/bin/python3 with h5py (apt install python3-h5py)";
  const TemporaryFolder folder;
  RunRecord run = synthetic_run();
  run.models = {synthetic_model("halfspace", {}, 12, 12, {0.0, 0.001, 0.002, 0.003})};
  run.models[0].points.assign(101, run.models[0].points[3]);
  const auto kept = [&](contact::GridFields which, std::size_t count) {
    run.input.output.grid_fields = which;
    run.models[0].points.resize(count);
    write_results((fs::path(folder.path()) / "long").string(), run);
    std::istringstream printed(python(R"(
import sys, h5py
points = h5py.File(sys.argv[1] + '/results.h5')['models/halfspace/points']
assert len({point.attrs['max_pressure'] for point in points.values()}) == 1
print(*(k for k, name in enumerate(sorted(points)) if 'pressure' in points[name]))
)",
                                      folder.path("long")));
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; printed >> k;) numbers.push_back(k);
    std::size_t files = 0;  // one for each, the last once more, and the series
    if (fs::exists(fs::path(folder.path()) / "long/fields"))
      for ([[maybe_unused]] const auto& entry :
           fs::directory_iterator(fs::path(folder.path()) / "long/fields"))
        ++files;
    EXPECT_EQ(files, numbers.empty() ? 0U : numbers.size() + 2);
    return numbers;
  };
  using contact::GridFields;
  const auto some = kept(GridFields::automatic, 101);
  ASSERT_EQ(some.size(), 25U);
  for (std::size_t j = 0; j < some.size(); ++j) EXPECT_EQ(some[j], j * 100 / 24);
  EXPECT_EQ(kept(GridFields::some, 26), [] {
    std::vector<std::size_t> all;  // of 26 one is left out
    for (std::size_t j = 0; j < 25; ++j) all.push_back(j * 25 / 24);
    return all;
  }());
  EXPECT_EQ(kept(GridFields::some, 7).size(), 7U);
  EXPECT_TRUE(kept(GridFields::none, 7).empty());
  run.models[0].points.assign(101, run.models[0].points[3]);
  EXPECT_EQ(kept(GridFields::all, 101).size(), 101U);
}
}  // namespace rollfem::result
