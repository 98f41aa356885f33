// SPDX-License-Identifier: LGPL-2.1-or-later
// Figures and report are made from a written result by Debian's Python, whatever the result holds.
#include "support/drawn_pages.hpp"
#include "support/output_synthetic_run.hpp"

namespace fs = std::filesystem;

namespace rollfem::postprocess {
namespace {

class FiguresTest : public DrawnPages {};

TEST_F(FiguresTest, AreAllDrawnAndTheReportHoldsThemWithoutTheNetwork) {
  const fs::path folder = draw(synthetic_run());
  for (const char* name :
       {"creep_curve", "path_x", "path_y", "path_lateral", "outlines", "contact_area",
        "strip_force", "oblique_px_halfspace", "oblique_px_fem"}) {
    const fs::path figure = folder / "figures" / (std::string(name) + ".svg");
    ASSERT_TRUE(fs::exists(figure)) << name;
    EXPECT_TRUE(says(contents(figure), "</svg>")) << name;
    EXPECT_LT(fs::file_size(figure), 1500000U) << name;
  }
  // A frictionless model has no tangential tractions to draw, but a pressure.
  EXPECT_TRUE(fs::exists(folder / "figures/oblique_pn_hertz.svg"));
  EXPECT_FALSE(fs::exists(folder / "figures/oblique_px_hertz.svg"));

  const std::string report = contents(folder / "report.html");
  expect_self_contained(report);
  EXPECT_EQ(count(report, "<figure>"), 10U);
  EXPECT_TRUE(says(report, "thesis case a: conforming plane", "578.7", "0.51136", "half-space",
                   "FEM", "446 000", "symmetry plane y = 0 used", "normal_force = 50e3",
                   // headings from what the file says of its scalars
                   "<th scope=row>largest pressure p<sub>0</sub> [MPa]",
                   "<th scope=col>−F<sub>x</sub>/F<sub>z</sub></th>",
                   "<th scope=col>|p<sub>t</sub>| [MPa]</th>", "<th scope=row>contact area [mm²]"));
  EXPECT_EQ(count(report, "not converged"), 0U);
}

/// A patch that lies 8 mm beside the contact point, as between tread and flange.
TEST_F(FiguresTest, LinesGoThroughTheLargestPressureAndObliqueViewsHaveRoomForIt) {
  RunRecord run = synthetic_run();
  for (contact::ModelResult& model : run.models) model.grid.y_first += 8.0;
  EXPECT_EQ(said(R"(
from rollfem.figures import curves, load_points, maps
from rollfem.reader import read_result
result = read_result(sys.argv[1])
models = load_points.with_pressure(result)
at = curves.line_place(models, 'x')
assert abs(at - 8) < models[0].dy and curves.line_place(models, 'y') == 0
for model in models:
    pressure = model.points[0].fields['pressure']
    assert np.nanmax(curves.line_of('x', at)(model, model.points[0], 'pressure')[1]) > 0.98 * pressure.max()
    assert model.line(pressure, 'x').max() < 0.9 * pressure.max()
assert 'at <tspan class="it">y</tspan> = 8' in curves.path(result, 'x').svg(), curves.path(result, 'x').svg()
model = models[-1]
pressure = model.points[0].fields['pressure']
view = maps._Oblique(model, pressure)
panel = maps.oblique(result, model).panels[0]
assert panel.y.limits[1] > view(0, model.y[:, None], pressure)[..., 1].max()
)",
                 draw(run).string()),
            "");
}

TEST_F(FiguresTest, HertzAloneHasNoCreepCurveAndBreaksNothing) {
  RunRecord run = synthetic_run();
  run.models.resize(1);
  const fs::path folder = draw(run);
  for (const char* drawn : {"path_x", "outlines"})
    EXPECT_TRUE(fs::exists(folder / "figures" / (std::string(drawn) + ".svg"))) << drawn;
  for (const char* not_drawn : {"creep_curve", "path_lateral", "contact_area"})
    EXPECT_FALSE(fs::exists(folder / "figures" / (std::string(not_drawn) + ".svg"))) << not_drawn;
  EXPECT_FALSE(says(contents(folder / "report.html"), "Traction coefficient"));
}

TEST_F(FiguresTest, OnePointWithoutFieldsBreaksNothing) {
  RunRecord run = synthetic_run();
  run.models = {run.models[1]};
  run.models[0].points.resize(2);
  for (contact::PointResult& point : run.models[0].points) point.fields = {};
  EXPECT_TRUE(fs::exists(draw(run) / "report.html"));
  run.models[0].points.resize(1);
  EXPECT_TRUE(fs::exists(draw(run) / "report.html"));
  run.models[0].points.clear();
  EXPECT_TRUE(fs::exists(draw(run) / "report.html"));
  run.models.clear();
  EXPECT_TRUE(fs::exists(draw(run) / "report.html"));
}

/// Uniaxial tension that grows along a line, and the largest stresses.
contact::SubsurfaceField tension_along(contact::SubsurfaceRequest::Kind kind, bool wheel) {
  contact::SubsurfaceField field;
  field.request.kind = kind;
  field.request.wheel = wheel;
  field.request.points = {5, 1};
  for (int k = 0; k < 5; ++k) {
    field.points.push_back({0.0, 0.0, wheel ? 0.5 * k : -0.5 * k});
    field.displacement.push_back({});
    field.stress.push_back({100.0 * k, 0.0, 0.0, 0.0, 30.0, 40.0});
  }
  return field;
}

TEST_F(FiguresTest, StressAlongLinesIsDrawnAndTheLargestIsTabulated) {
  using Kind = contact::SubsurfaceRequest::Kind;
  RunRecord run = synthetic_run();
  for (contact::ModelResult& model : run.models)
    for (contact::PointResult& point : model.points) {
      if (model.name == "hertz") continue;
      point.subsurface = {tension_along(Kind::line, true), tension_along(Kind::plane, true),
                          tension_along(Kind::surface, false)};
      point.stress_maxima = {{"wheel", "von_mises", 345.6, {0.0, 0.0, 1.25}},
                             {"rail", "tresca", 234.5, {-0.5, 0.0, -1.5}}};
      point.error_estimate["max_von_mises_wheel"] = 4.0;
    }
  run.models[2].points[4].stress_maxima[0].value = 456.7;  // at 0.3 %
  const fs::path folder = draw(run);
  EXPECT_TRUE(fs::exists(folder / "figures/stress_1.svg"));
  EXPECT_FALSE(fs::exists(folder / "figures/stress_2.svg"));  // a plane is no line
  EXPECT_TRUE(fs::exists(folder / "figures/stress_3.svg"));
  const std::string report = contents(folder / "report.html");
  EXPECT_TRUE(says(report, "Stress in the bodies", "wheel: von Mises", "345.6",
                   "456.7&nbsp;<span class=e>±", "at (0, 0, 1.25) mm, ξ = 0.3 %", "rail: Tresca",
                   "On the surface of the rail"));
  // The measures of the figures are those of the result, the others by hand: uniaxial 400 MPa with
  // a shear of 50 MPa beside it.
  EXPECT_EQ(said(R"(
from rollfem.reader import read_result
from rollfem.stresses import stress_measures as measures
point = read_result(sys.argv[1])['fem'].points[4]
part = point.subsurface[0]
got = measures(part['stress'])
assert np.allclose(got['von_mises'], part['von_mises'])
assert np.allclose(got['orthogonal_shear'], 50)
assert np.allclose(got['hydrostatic'][4], 400 / 3)
roots = np.roots([1, -400, -2500, 900 * 400])
assert np.isclose(got['tresca'][4], max(roots) - min(roots))
first = point.stress_maxima[0]
assert (first['body'], first['measure']) == ('wheel', 'von_mises')
assert first['value'] == 456.7 and first['place'][2] == 1.25
)",
                 folder.string()),
            "");
}

TEST_F(FiguresTest, LateralCreepageSpinAndAnUnknownModelAreDrawn) {
  RunRecord run = synthetic_run();
  run.models = {run.models[1]};
  run.models[0].name = "some-new-model";
  run.input.title = "<b>markup</b> & \"quotes\"";
  double eta = 0.0;
  for (contact::PointResult& point : run.models[0].points) {
    std::swap(point.fields.traction.x, point.fields.traction.y);
    std::swap(point.longitudinal_force, point.lateral_force);
    point.creepage = {0.0, eta, 1e-4};
    eta += 0.0005;
  }
  const fs::path folder = draw(run);
  EXPECT_TRUE(fs::exists(folder / "figures/creep_curve.svg"));
  const std::string report = contents(folder / "report.html");
  EXPECT_TRUE(says(report, "Lateral force"));
  EXPECT_FALSE(says(report, "<b>markup"));
}

/// The rise is Vermeulen and Johnson's with the slope 0.55 * 300, the summit a parabola's.
TEST_F(FiguresTest, AFallingLawIsDrawnWithInitialSlopeAndPeakOfTheCreepCurve) {
  RunRecord run = synthetic_run();
  run.models.pop_back();
  run.input.friction_fall.shape = contact::FallShape::exponential;
  run.input.friction_fall.kinetic_coefficient = 0.2;
  run.input.friction_fall.half_velocity = 1000.0;
  run.input.friction_fall.memory_distance = 0.003;
  run.input.rolling.speed = 10e3;
  for (contact::PointResult& point : run.models[1].points) {
    const double xi = point.creepage.longitudinal;
    const double tau = 300.0 * xi;
    point.traction_coefficient = xi < 0.0025
                                     ? 0.55 * (tau - tau * tau / 3.0 + tau * tau * tau / 27.0)
                                     : 0.5 - 2000.0 * (xi - 0.0042) * (xi - 0.0042);
    point.longitudinal_force = -point.traction_coefficient * point.normal_force;
  }
  const fs::path folder = draw(run);
  EXPECT_TRUE(says(contents(folder / "figures/friction_law.svg"), "at rest: 0.55", "kinetic: 0.2",
                   "memory: 3 µm"));
  EXPECT_TRUE(says(contents(folder / "figures/creep_curve.svg"), "0.5 at 0.42 %"));
  EXPECT_TRUE(says(contents(folder / "report.html"),
                   "0.55 at rest, falling (exponential) by 0.35 to 0.2", "memory 0.003 mm",
                   "<td>165</td><td>0.500</td><td>90.9 %</td><td>0.420</td>"));
  EXPECT_EQ(said(R"(
from rollfem.reader import read_result
law = read_result(sys.argv[1]).friction_law
assert np.allclose(np.interp([0, 1000, 1e9], *law.T), [0.55, 0.375, 0.2], rtol=1e-12)
)",
                 folder.string()),
            "");
}

TEST_F(FiguresTest, AModelThatDidNotConvergeIsNamed) {
  RunRecord run = synthetic_run();
  run.models[1].points[3].converged = false;
  EXPECT_TRUE(says(contents(draw(run) / "report.html"), "half-space at ξ = 0.2 %"));
}

TEST_F(FiguresTest, AFileCutShortIsRecognisedAndSaid) {
  const fs::path folder = draw(synthetic_run());
  fs::resize_file(folder / "results.h5", fs::file_size(folder / "results.h5") / 2);
  const std::string message = make_report(folder.string(), scripts);
  EXPECT_TRUE(says(message, "is truncated or damaged", "run the case again"));
  EXPECT_FALSE(says(message, "Traceback"));
  fs::remove(folder / "results.h5");
  EXPECT_TRUE(says(make_report(folder.string(), scripts), "there is no"));
}

TEST_F(FiguresTest, ADefectOfThePlottingIsOneLineAndATextInAFile) {
  const fs::path folder = draw(synthetic_run());
  const fs::path scripts_here = base_ / "rollfem";
  fs::create_directory(scripts_here);
  std::ofstream(scripts_here / "__init__.py") << "";
  std::ofstream(scripts_here / "__main__.py") << "def f():\n    raise ValueError('odd')\nf()\n";
  const std::string message = make_report(folder.string(), base_.string());
  EXPECT_FALSE(says(message, "\n"));
  EXPECT_EQ(message.rfind("ValueError: odd (full text in ", 0), 0U) << message;
  EXPECT_TRUE(says(contents(folder / "report.log"), "Traceback"));
}

/// Modules and settings that lie in the user's folder are not the program's.
TEST_F(FiguresTest, TakeNothingFromTheCurrentFolder) {
  const fs::path before = fs::current_path();
  const fs::path hostile = base_ / "hostile";
  fs::create_directories(hostile / "h5py");
  const std::string trap = "open('" + (hostile / "ran").string() + "', 'a').write('x')\n";
  for (const char* name :
       {"numpy.py", "argparse.py", "h5py/__init__.py", "sitecustomize.py", "rollfem.py"})
    std::ofstream(hostile / name) << trap;
  // All modules are imported before a folder is looked at that is not there.
  const std::string message = make_report("/nowhere", scripts);
  EXPECT_TRUE(says(message, "/nowhere"));
  fs::current_path(hostile);
  // An empty entry of PYTHONPATH stands for the current folder, and comes by accident.
  for (const char* path : {"", ":/elsewhere", "."}) {
    ::setenv("PYTHONPATH", path, 1);
    EXPECT_EQ(make_report("/nowhere", scripts), message);
  }
  ::unsetenv("PYTHONPATH");
  // A Python that is named by a relative path is found from here all the same.
  fs::create_symlink("/usr/bin/python3", "python-here");
  ::setenv("ROLLFEM_PYTHON", "./python-here", 1);
  EXPECT_EQ(make_report("/nowhere", scripts), message);
  ::unsetenv("ROLLFEM_PYTHON");
  fs::current_path(before);
  EXPECT_FALSE(fs::exists(hostile / "ran"));
}

TEST_F(FiguresTest, AVirtualEnvironmentDrawsWithItsOwnPython) {
  const fs::path environment = base_ / "venv", package = "share/rollfem/rollfem";
  fs::create_directories(environment / package);
  fs::create_directory(environment / "bin");
  std::ofstream(environment / package / "__main__.py") << "raise SystemExit('another Python')\n";
  std::ofstream(environment / "bin" / "python3") << "#!/bin/sh\necho its own >&2\nexit 1\n";
  fs::permissions(environment / "bin" / "python3", fs::perms::owner_all);
  EXPECT_TRUE(says(make_report("/nowhere", environment / package), "another Python"));
  std::ofstream(environment / "pyvenv.cfg") << "";
  EXPECT_TRUE(says(make_report("/nowhere", environment / package), "its own"));
}

TEST(MakeReport, ReportsMissingProgramsAndScripts) {
  EXPECT_TRUE(says(make_report("/nowhere", "/nowhere"), "no Python package"));
  ::setenv("ROLLFEM_PYTHON", "/nowhere/python3", 1);
  EXPECT_TRUE(says(make_report("/nowhere", scripts), "cannot run /nowhere/python3"));
  ::unsetenv("ROLLFEM_PYTHON");
  EXPECT_NE(make_report("/nowhere", scripts + "/rollfem"), "");
}

}  // namespace
}  // namespace rollfem::postprocess
