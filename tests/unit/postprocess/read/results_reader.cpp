// SPDX-License-Identifier: LGPL-2.1-or-later
// results.h5 read back in C++: every scalar and field to the last bit, and one clear message for
// each kind of incomplete file.
#include "postprocess/read/results_reader.hpp"

#include "contact/base/errors.hpp"
#include "contact/result/quantities.hpp"
#include "postprocess/files/seal.hpp"
#include "postprocess/write/output.hpp"

#include "support/output_python.hpp"
#include "support/output_synthetic_run.hpp"
#include "support/places.hpp"

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

class ResultsReaderTest : public ::testing::Test {
 protected:
  std::string file(const std::string& content) {
    return folder_.file("reader_" + std::to_string(made_++) + ".h5", content);
  }
  /// A model with all that is stored of it.
  static contact::ModelResult whole(const ResultsFile& read, const StoredModel& model) {
    contact::ModelResult result = read.read(model);
    for (const std::size_t k : model.points_with_bodies) read.read_bodies(model, k, result);
    return result;
  }
  /// What the reader says about a file.
  static std::string refusal(const std::string& path) {
    return rollfem::testing::refusal<InputError>([&] {
      const ResultsFile read(path);
      for (const StoredModel& model : read.models()) whole(read, model);
    });
  }

 private:
  const TemporaryFolder folder_;
  int made_ = 0;
};

RunRecord full_run() {
  RunRecord run = synthetic_run();
  run.input.wheel.material = {207e3, 0.28};
  run.input.rail.material = {211e3, 0.29};
  PointResult& point = run.models[1].points[3];
  point.step = 4;
  point.spin_moment = 123.25;
  point.lateral_shift = 0.125;
  point.spin_shift = 1e-3;
  point.distance = 2.5;
  point.creepage = {0.002, -0.001, 3e-4};
  point.richardson = {{"max_pressure", 578.9}};
  point.elastic_energy = 946.0;
  point.stress_maxima = {{"rail", "von_mises", 344.5, {0.1, -0.2, -3.0}},
                         {"wheel", "tresca", 380.5, {0.0, 0.0, 2.5}}};
  return run;
}

void expect_same(const contact::ModelResult& found, const contact::ModelResult& written) {
  EXPECT_EQ(found.name, written.name);
  EXPECT_EQ(found.label, written.label);
  EXPECT_EQ(found.key(), written.key());
  EXPECT_EQ(found.unknowns, written.unknowns);
  EXPECT_EQ(found.seconds, written.seconds);
  EXPECT_EQ(found.notes, written.notes);
  EXPECT_EQ(found.model_error_source, written.model_error_source);
  EXPECT_EQ(found.grid.nx, written.grid.nx);
  EXPECT_EQ(found.grid.dy, written.grid.dy);
  EXPECT_EQ(found.grid.x(found.grid.nx - 1), written.grid.x(found.grid.nx - 1));
  ASSERT_EQ(found.points.size(), written.points.size());
  for (std::size_t k = 0; k < found.points.size(); ++k) {
    const PointResult& a = found.points[k];
    const PointResult& b = written.points[k];
    for (const contact::Quantity& quantity : contact::quantities())
      EXPECT_EQ(quantity.value(a), quantity.value(b)) << quantity.name;
    EXPECT_EQ(a.error_estimate, b.error_estimate);
    EXPECT_EQ(a.no_bar, b.no_bar);
    EXPECT_EQ(a.model_error, b.model_error);
    EXPECT_EQ(a.richardson, b.richardson);
    for (const contact::PointField& field : contact::point_fields()) {
      const contact::Field& values = field.value(a.fields);
      ASSERT_EQ(values.size(), field.value(b.fields).size()) << field.name;
      EXPECT_TRUE(values == field.value(b.fields)) << field.name;
    }
    EXPECT_EQ(a.fields.state, b.fields.state);
    ASSERT_EQ(a.stress_maxima.size(), b.stress_maxima.size());
    for (std::size_t m = 0; m < a.stress_maxima.size(); ++m) {
      EXPECT_EQ(a.stress_maxima[m].body, b.stress_maxima[m].body);
      EXPECT_EQ(a.stress_maxima[m].measure, b.stress_maxima[m].measure);
      EXPECT_EQ(a.stress_maxima[m].value, b.stress_maxima[m].value);
      EXPECT_EQ(a.stress_maxima[m].place, b.stress_maxima[m].place);
    }
    ASSERT_EQ(a.bodies.size(), b.bodies.size()) << k;
    for (std::size_t body = 0; body < a.bodies.size(); ++body) {
      EXPECT_EQ(a.bodies[body].displacement, b.bodies[body].displacement) << k;
      EXPECT_EQ(a.bodies[body].stress, b.bodies[body].stress) << k;
    }
  }
  ASSERT_EQ(found.bodies.size(), written.bodies.size());
  for (std::size_t k = 0; k < found.bodies.size(); ++k) {
    EXPECT_EQ(found.bodies[k].name, written.bodies[k].name);
    EXPECT_EQ(found.bodies[k].points, written.bodies[k].points);
    EXPECT_EQ(found.bodies[k].cells, written.bodies[k].cells);
  }
}

TEST_F(ResultsReaderTest, ReadsBackWhatWasWritten) {
  const RunRecord run = full_run();
  const ResultsFile read(file(results_hdf5(run)));
  EXPECT_EQ(read.input().title, run.input.title);
  EXPECT_EQ(read.input().text, run.input.text);
  EXPECT_EQ(read.input().wheel.material.young_modulus, 207e3);
  EXPECT_EQ(read.input().rail.material.poisson_ratio, 0.29);
  EXPECT_EQ(read.input().rail.transverse_radius, 2000.0);
  EXPECT_EQ(read.input().wheel.transverse_radius, contact::infinity);
  ASSERT_EQ(read.models().size(), run.models.size());
  for (std::size_t k = 0; k < run.models.size(); ++k) {
    EXPECT_EQ(read.models()[k].points, static_cast<int>(run.models[k].points.size()));
    EXPECT_EQ(read.models()[k].points_with_bodies, run.models[k].points_with_bodies());
    expect_same(whole(read, read.models()[k]), run.models[k]);
  }
}

TEST_F(ResultsReaderTest, TellsPatchesApart) {
  RunRecord run = full_run();
  run.models.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    run.models[k].name = "halfspace";
    run.models[k].place.emplace();
    run.models[k].place->left = k == 0;
    run.models[k].place->patch = 3;
    run.models[k].place->position = 7;
  }
  const ResultsFile read(file(results_hdf5(run)));
  ASSERT_EQ(read.models().size(), 2U);
  const StoredModel& second = read.models()[1];
  EXPECT_EQ(second.key, "halfspace_right_7_3");
  EXPECT_EQ(second.name, "halfspace");
  ASSERT_TRUE(second.place);
  EXPECT_FALSE(second.place->left);
  EXPECT_EQ(second.place->position, 7);
  EXPECT_EQ(second.place->patch, 3);
  EXPECT_EQ(read.read(second).key(), second.key);
}

TEST_F(ResultsReaderTest, RefusesIncompleteResults) {
  const std::string whole = results_hdf5(full_run());
  EXPECT_EQ(refusal(file(whole)), "");
  EXPECT_TRUE(says(refusal("no/such/folder"), "no/such/folder: there is no such file"));
  EXPECT_TRUE(says(refusal("/dev/null"), "is not a regular file"));
  EXPECT_TRUE(says(refusal(::testing::TempDir()), "results.h5: there is no such file"));
  EXPECT_TRUE(says(refusal(file("title = \"a case\"")), "not a result of rollfem"));
  EXPECT_TRUE(says(refusal(file("")), "not a result of rollfem"));
  // Killed while it was written, at many places.
  for (int part = 1; part < 40; ++part) {
    const std::string said = refusal(file(whole.substr(0, whole.size() * part / 40)));
    EXPECT_TRUE(says(said, "truncated or damaged")) << part;
    EXPECT_TRUE(says(said, "do: "));
  }
}

/// Gives a file that was changed on purpose the checksum of what it is now.
void seal_again(const std::string& path) {
  const std::string data = contents(path).substr(seal_size);
  std::ofstream(path, std::ios::binary) << hdf5_seal(data) << data;
}

TEST_F(ResultsReaderTest, AFileThatWasChangedNoLongerFitsItsChecksum) {
  const std::string whole = results_hdf5(full_run());
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 60) {
    std::string damaged = whole;
    damaged[at] ^= static_cast<char>(1U << (at % 8));
    const std::string said = refusal(file(damaged));
    ASSERT_TRUE(says(said, "do: ")) << at;
  }
  EXPECT_TRUE(says(refusal(file(whole + "x")), "its checksum is missing or does not match"));
}

TEST_F(ResultsReaderTest, AFileWithoutAChecksumIsRefused) {
  const std::string said = refusal(file(results_hdf5(full_run()).substr(seal_size)));
  EXPECT_TRUE(says(said, "its checksum is missing"));
}

TEST_F(ResultsReaderTest, RefusesOtherFormatsAndIncompleteFiles) {
  if (!python_can_import("h5py"))
    GTEST_SKIP() << "needs /usr/bin/python3 with h5py (apt install python3-h5py)";
  const std::string whole = results_hdf5(full_run());
  const auto changed = [&](const std::string& change) {
    const std::string path = file(whole);
    EXPECT_EQ(python("import sys, h5py\nf = h5py.File(sys.argv[1], 'a')\n" + change, path), "");
    EXPECT_TRUE(says(refusal(path), "its checksum is missing or does not match"));
    seal_again(path);
    return refusal(path);
  };
  EXPECT_EQ(changed("f.attrs['note'] = 'more of it'"), "");
  EXPECT_EQ(changed("f.attrs['format_minor'] = 7"), "");
  EXPECT_EQ(changed("del f.attrs['format_minor']; del f['models/fem/bodies']\n"
                    "for p in f['models/fem/points'].values(): del p['bodies']"),
            "");
  const std::pair<const char*, const char*> changes[] = {
      {"f.attrs['format'] = 'something'", "but not a result of rollfem"},
      {"del f.attrs['format']", "but not a result of rollfem"},
      {"f.attrs['format_version'] = 1", "format version 1, this program reads 2"},
      {"f.attrs['format_version'] = 3", "format version 3, this program reads 2"},
      {"del f.attrs['complete']", "is incomplete, because writing it was interrupted"},
      {"f.attrs['complete'] = 0", "is incomplete, because writing it was interrupted"},
      {"del f['case']", "there is no group case"},
      {"del f['models/hertz/grid']", "there is no group grid"},
      {"del f['models/fem/points/0002'].attrs['approach']", "there is no attribute approach"},
      {"f['case'].attrs['title'] = 3.0", "not a string: attribute title"},
      {"f['models/fem/bodies/rail/cells'][1, 2] = 12", "names node 12 of 12"},
      {"del f['models/fem/points/0002/bodies/rail/stress']", "there is no dataset stress"},
      {"d = f['models/fem/points/0002/bodies/wheel']; x = d['stress'][1:]; del d['stress']; "
       "d['stress'] = x",
       "nodes and values of the wheel differ in number"},
      {"d = f['models/fem/points/0002']; del d['pressure']; d['pressure'] = [1.0]",
       "pressure has 1 values for a grid of 1007"},
  };
  for (const auto& [change, part] : changes) {
    const std::string said = changed(change);
    EXPECT_TRUE(says(said, part)) << change;
    EXPECT_TRUE(says(said, "do: "));
    EXPECT_FALSE(says(said, "\n"));
  }
}

TEST_F(ResultsReaderTest, RefusesDamagedFields) {
  if (!python_can_import("h5py"))
    GTEST_SKIP() << "needs /usr/bin/python3 with h5py (apt install python3-h5py)";
  // Bytes of a compressed field overwritten. (HDF5 does not guard its own structures like that.)
  const std::string path = file(results_hdf5(full_run()));
  EXPECT_EQ(python(R"(
import sys, h5py
with h5py.File(sys.argv[1]) as f:
    chunk = f['models/fem/points/0002/pressure'].id.get_chunk_info(0)
with open(sys.argv[1], 'r+b') as f:
    f.seek(chunk.byte_offset + chunk.size // 2)
    f.write(b'\xff' * 64)
)",
                   path),
            "");
  seal_again(path);
  const std::string said = refusal(path);
  EXPECT_TRUE(says(said, "damaged or truncated: dataset pressure"));
}

TEST_F(ResultsReaderTest, ReadsAFileWithoutBodies) {
  RunRecord run = full_run();
  run.models[2].bodies.clear();
  for (PointResult& point : run.models[2].points) point.bodies.clear();
  const ResultsFile read(file(results_hdf5(run)));
  EXPECT_TRUE(read.models()[2].points_with_bodies.empty());
  EXPECT_TRUE(read.read(read.models()[2]).bodies.empty());
}

TEST_F(ResultsReaderTest, ReadsBodiesOfOneLoadPointAlone) {
  RunRecord run = full_run();
  for (std::size_t k = 0; k + 1 < run.models[2].points.size(); ++k)
    run.models[2].points[k].bodies.clear();
  const ResultsFile read(file(results_hdf5(run)));
  EXPECT_EQ(read.models()[2].points_with_bodies, (std::vector<std::size_t>{6}));
  expect_same(whole(read, read.models()[2]), run.models[2]);
}

}  // namespace
}  // namespace rollfem::postprocess
