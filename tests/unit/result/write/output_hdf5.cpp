// SPDX-License-Identifier: LGPL-2.1-or-later
// results.h5 read back with h5py, as users do: fields bit by bit, scalars, units, completeness.
#include "result/write/output.hpp"

#include "support/output_python.hpp"
#include "support/output_synthetic_run.hpp"
#include <cstdio>

namespace rollfem::result {
namespace {

const char* const reading = R"(
import sys, h5py, numpy
f = h5py.File(sys.argv[1])
m = f['models/halfspace']; p = m['points/0003']; g = m['grid']
area = g.attrs['dx'] * g.attrs['dy']
print(f.attrs['format'], f.attrs['format_version'], f.attrs['complete'])
print(p['pressure'].shape == (len(g['y']), len(g['x'])), p['pressure'].attrs['unit'])
print(repr(float(p['pressure'][60, 20])), repr(float(p['slip_x'][60, 3])), p['state'][60, 20])
print(abs(area * p['traction_x'][:].sum() - p.attrs['longitudinal_force']) < 1e-6)
print(abs(area * p['pressure'][:].sum() - p.attrs['normal_force']) < 1e-6)
print(repr(float(p.attrs['residual'])), p.attrs['converged'], p['error_estimate'].attrs['max_pressure'])
print(sorted(f['models/hertz/points/0000'].keys()))
print(f['case/text'][()].decode().splitlines()[0], '|', f['case/keys'].attrs['rail.transverse_radius'])
print(*(column[0].decode() for column in f['models/fem/notes'].values()))
b = f['models/fem/bodies']
print(f.attrs['format_minor'], b.attrs['load_point'], b['rail/points'].shape, b['wheel/cells'].shape,
      b['rail/displacement'].attrs['unit'], b['rail/stress'].attrs['unit'], b['rail/stress'][:, 2].min())
for k in range(7):  # xz tells the load points apart
    v = f['models/fem/points/%04d/bodies' % k]
    print('xz', v['wheel/stress'][0, 5], v['rail/stress'][11, 5], v['rail/stress'].attrs['unit'], v['rail/stress'].dtype)
assert b['rail/stress'] == f['models/fem/points/0006/bodies/rail/stress'], 'Error: stored twice'
def dress(name, o):
    if isinstance(o, h5py.Dataset) and name.startswith('models') and not '/notes/' in name:
        assert {'unit', 'description'} <= set(o.attrs), name
f.visititems(dress)
def comment(name, o):
    assert f['/'].id.get_comment(name.encode()), 'Error: no comment: ' + name
f.visititems(comment)
)";

TEST(ResultsHdf5, ReadBackGivesFieldsScalarsUnitsAndProvenance) {
  if (!python_can_import("h5py, numpy"))
    GTEST_SKIP() << "needs /usr/bin/python3 with h5py (apt install python3-h5py)";
  const RunRecord run = synthetic_run();
  const TemporaryFolder folder;
  const std::string path = folder.file("results.h5", results_hdf5(run));
  const contact::ModelResult& model = run.models[1];
  const contact::PointResult& point = model.points[3];
  const int k = model.grid.index(20, 60);
  const std::string printed = python(reading, path);
  EXPECT_TRUE(says(printed, "rollfem results 3 1\nTrue MPa\n", "True\nTrue\n", " 1 1.25\n",
                   "['error_estimate', 'model_error', 'no_bar', 'pressure']",
                   "title = \"thesis case a: conforming plane\" | 2000.0",
                   "mesh remark Segments reach", "3 6 (12, 3) (2, 8) mm MPa -102.0\n",
                   "\nxz 90.0 390.0 MPa float32\n", "\nxz 210.0 510.0 MPa float32\n"));
  EXPECT_FALSE(says(printed, "Error"));

  double pressure = 0.0;
  double slip = 0.0;
  int state = -1;
  const std::size_t line = printed.find("MPa\n") + 4;
  ASSERT_EQ(std::sscanf(printed.c_str() + line, "%lf %lf %d", &pressure, &slip, &state), 3);
  EXPECT_EQ(pressure, point.fields.traction.n[k]);
  EXPECT_EQ(slip, point.fields.slip.x[model.grid.index(3, 60)]);
  EXPECT_EQ(state, static_cast<int>(point.fields.state[static_cast<std::size_t>(k)]));
}

TEST(ResultsHdf5, TheSameRunGivesTheSameBytes) {
  EXPECT_EQ(results_hdf5(synthetic_run()), results_hdf5(synthetic_run()));
}

TEST(ResultsHdf5, TakesARunWithoutModelsPointsOrFields) {
  RunRecord run;
  EXPECT_GT(results_hdf5(run).size(), 500U);
  run.models.resize(1);
  run.models[0].name = "empty";
  EXPECT_GT(results_hdf5(run).size(), 500U);
  run.models[0].points.resize(1);
  EXPECT_GT(results_hdf5(run).size(), 500U);
}

}  // namespace
}  // namespace rollfem::result
