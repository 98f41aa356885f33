// SPDX-License-Identifier: LGPL-2.1-or-later
// VTU files decoded by hand (base64, zlib blocks) and, where it is installed, by VTK's own reader.
#include "result/write/output.hpp"
#include "result/write/vtu.hpp"

#include "support/output_python.hpp"
#include "support/output_synthetic_run.hpp"
#include <cstdio>

namespace rollfem::result {
namespace {

/// Prints every array as "name components count sum", decoded with Python's standard library.
const char* const decode = R"(
import sys, base64, zlib, struct, xml.etree.ElementTree as E
code = {'Float64': 'd', 'Float32': 'f', 'Int32': 'i', 'Int64': 'q', 'UInt8': 'B'}
root = E.parse(sys.argv[1]).getroot()
print(root.find('.//Piece').attrib)
for a in root.iter('DataArray'):
    t = a.text.strip()
    n = struct.unpack('<Q', base64.b64decode(t[:12])[:8])[0]
    length = (8 * (3 + n) + 2) // 3 * 4
    head = struct.unpack('<%dQ' % (3 + n), base64.b64decode(t[:length]))
    data, out = base64.b64decode(t[length:]), b''
    for size in head[3:]:
        block = zlib.decompress(data[:size]); data = data[size:]; out += block
    assert len(out) == (n - (head[2] > 0)) * head[1] + head[2]
    kind = code[a.get('type')]
    values = struct.unpack('<%d%s' % (len(out) // struct.calcsize(kind), kind), out)
    print(a.get('Name'), a.get('NumberOfComponents', '1'), len(values), repr(float(sum(values))))
)";

const char* const vtk_reading = R"(
import sys
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
r = Reader(); r.SetFileName(sys.argv[1]); r.Update(); g = r.GetOutput()
d = g.GetPointData() if g.GetPointData().GetNumberOfArrays() else g.GetCellData()
print(g.GetNumberOfPoints(), g.GetNumberOfCells(), g.GetCell(0).GetClassName())
for k in range(d.GetNumberOfArrays()):
    a = d.GetArray(k); print(a.GetName(), a.GetNumberOfComponents(), a.GetRange(-1 if a.GetNumberOfComponents() > 1 else 0))
if g.GetCell(0).GetClassName() == 'vtkHexahedron':
    q = vtkMeshQuality(); q.SetInputData(g); q.SetHexQualityMeasureToVolume(); q.Update()
    v = q.GetOutput().GetCellData().GetArray('Quality'); print('volumes', v.GetRange())
)";

std::string rail_vtu() {
  const contact::BodyValues values = synthetic_values();
  return BodyVtu(synthetic_body("rail")).text(&values);
}

TEST(BodyVtu, DecodesToTheSameNumbers) {
  if (!python_can_import("zlib")) GTEST_SKIP() << "needs /usr/bin/python3";
  const std::string printed = python_on(decode, "body.vtu", rail_vtu());
  EXPECT_TRUE(says(printed, "'NumberOfPoints': '12', 'NumberOfCells': '2'", "Points 3 36 0.0\n",
                   "displacement [mm] 3 36 0.09375", "stress [MPa] 6 72 -852.0\n",
                   "connectivity 1 16 88.0\n", "types 1 2 24.0\n"));
}

TEST(ContactVtu, DecodesToTheSameNumbersOverManyBlocks) {
  if (!python_can_import("zlib")) GTEST_SKIP() << "needs /usr/bin/python3";
  const contact::ModelResult model = synthetic_model("halfspace", {}, 201, 301, {0.002});
  const contact::PointResult& point = model.points[0];
  const std::string printed = python_on(decode, "contact.vtu", contact_vtu(model.grid, point));
  double sum = 0.0;
  const std::size_t at = printed.find("pressure [MPa] 1 60501 ");
  ASSERT_NE(at, std::string::npos) << printed;
  ASSERT_EQ(std::sscanf(printed.c_str() + at, "pressure [MPa] 1 60501 %lf", &sum), 1);
  EXPECT_NEAR(sum * model.grid.element_area(), point.normal_force, 1e-9 * point.normal_force);
}

TEST(Vtu, IsReadByVtk) {
  if (!python_can_import("vtkmodules.vtkIOXML, vtkmodules.vtkFiltersVerdict"))
    GTEST_SKIP() << "VTK's Python module is not installed (apt install python3-vtk9)";
  std::string printed = python_on(vtk_reading, "body.vtu", rail_vtu());
  EXPECT_TRUE(says(printed, "12 2 vtkHexahedron", "stress [MPa] 6", "volumes (1.0, 1.0)"));
  const contact::ModelResult model = synthetic_model("halfspace", {}, 21, 31, {0.002});
  printed = python_on(vtk_reading, "contact.vtu", contact_vtu(model.grid, model.points[0]));
  EXPECT_TRUE(says(printed, "704 651 vtkQuad",
                   "state (0 exterior, 1 adhesion, 2 slip, 3 plastic) 1 (0.0, 2.0)"));
}

const char* const series_reading = R"(
import os, sys, xml.etree.ElementTree as E
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
root = E.parse(sys.argv[1]).getroot()
assert root.tag == 'VTKFile' and root.get('type') == 'Collection'
for d in root.iter('DataSet'):
    r = Reader(); r.SetFileName(os.path.join(os.path.dirname(sys.argv[1]), d.get('file'))); r.Update()
    c = r.GetOutput().GetCellData()
    names = [c.GetArrayName(k) for k in range(c.GetNumberOfArrays())]
    for part in ('pressure', 'tangential traction', 'gap', 'slip', 'state'):
        assert any(n.startswith(part) for n in names), names
    t = c.GetArray('tangential traction on the wheel [MPa]')
    print(float(d.get('timestep')), round(sum(t.GetTuple(k)[0] for k in range(t.GetNumberOfTuples())), 6))
)";

TEST(Series, OfAllLoadPointsIsReadByVtk) {
  if (!python_can_import("vtkmodules.vtkIOXML"))
    GTEST_SKIP() << "VTK's Python module is not installed (apt install python3-vtk9)";
  const RunRecord run = synthetic_run();
  const TemporaryFolder folder;
  write_results(folder.path("result"), run);
  const std::string printed =
      python(series_reading, folder.path("result") + "/fields/halfspace_contact.pvd");
  std::istringstream lines(printed);
  const contact::ModelResult& model = run.models[1];
  for (const contact::PointResult& point : model.points) {
    double time = -1.0;
    double sum = 0.0;
    ASSERT_TRUE(lines >> time >> sum) << printed;
    EXPECT_EQ(time, point.creepage.longitudinal);
    EXPECT_NEAR(sum * model.grid.element_area(), point.longitudinal_force, 1e-5 * 50e3);
  }
  std::string rest;
  EXPECT_FALSE(lines >> rest) << printed;
}

const char* const bodies_reading = R"(
import math, os, sys, xml.etree.ElementTree as E
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
root = E.parse(sys.argv[1]).getroot()
assert root.tag == 'VTKFile' and root.get('type') == 'Collection'
for d in root.iter('DataSet'):
    r = Reader(); r.SetFileName(os.path.join(os.path.dirname(sys.argv[1]), d.get('file'))); r.Update()
    g = r.GetOutput(); p = g.GetPointData()
    s, u, m = (p.GetArray(n) for n in ('stress [MPa]', 'displacement [mm]', 'von Mises stress [MPa]'))
    assert [s.GetComponentName(k) for k in range(6)] == ['XX', 'YY', 'ZZ', 'XY', 'YZ', 'XZ']
    assert u.GetNumberOfComponents() == 3 and u.GetTuple(8)[2] == 0.015625
    for k in range(g.GetNumberOfPoints()):
        a, b, c, d1, e, f = s.GetTuple(k)
        v = math.sqrt(0.5*((a-b)**2 + (b-c)**2 + (c-a)**2) + 3*(d1*d1 + e*e + f*f))
        assert abs(m.GetValue(k) - v) < 1e-6 * v, (k, m.GetValue(k), v)
    print(float(d.get('timestep')), d.get('part'), s.GetTuple(0)[5])
)";

TEST(Series, OfTheBodiesIsReadByVtk) {
  if (!python_can_import("vtkmodules.vtkIOXML"))
    GTEST_SKIP() << "VTK's Python module is not installed (apt install python3-vtk9)";
  RunRecord run = synthetic_run();
  run.models[2].points[1].bodies.clear();  // what keeps none is not in the series
  const TemporaryFolder folder;
  write_results(folder.path("result"), run);
  const std::filesystem::path fields = folder.path("result") + "/fields";
  std::istringstream lines(python(bodies_reading, fields / "fem_bodies.pvd"));
  for (const int k : {0, 2, 3, 4, 5, 6})
    for (const int part : {0, 1}) {
      double time = -1.0;
      double shear = 0.0;
      int found = -1;
      ASSERT_TRUE(lines >> time >> found >> shear) << lines.str();
      EXPECT_EQ(time, run.models[2].points[static_cast<std::size_t>(k)].creepage.longitudinal);
      EXPECT_EQ(found, part);
      EXPECT_EQ(shear, 30.0 * (k + 10 * part + 1));
    }
  std::string rest;
  EXPECT_FALSE(lines >> rest) << lines.str();
  EXPECT_FALSE(std::filesystem::exists(fields / "fem_wheel_0001.vtu"));
  EXPECT_TRUE(std::filesystem::exists(fields / "fem_rail.vtu"));
  EXPECT_FALSE(std::filesystem::exists(fields / "halfspace_bodies.pvd"));
}

TEST(Series, IsOrderedByNumberWhereCreepagesRepeat) {
  std::vector<contact::PointResult> points(3);
  points[1].creepage.longitudinal = -0.001;
  points[2].creepage.longitudinal = 0.002;
  EXPECT_EQ(series_times(points), (std::vector<double>{0.0, -0.001, 0.002}));
  points[2].creepage.longitudinal = 0.0;
  points[2].creepage.lateral = 0.001;
  EXPECT_EQ(series_times(points), (std::vector<double>{0.0, 1.0, 2.0}));
}

}  // namespace
}  // namespace rollfem::result
