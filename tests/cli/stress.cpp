// SPDX-License-Identifier: LGPL-2.1-or-later
// The command stress on stored results: closed forms and CONTACT's values from the file of a run,
// interpolation in stored bodies, patches, wrong calls.
#include "postprocess/write/output.hpp"

#include "support/case_examples.hpp"
#include "support/contact_of_case_a.hpp"
#include "support/csv_rows.hpp"
#include "support/output_synthetic_run.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;

/// Columns of stress.csv without their units, of one set and body of the first model that has it.
using Columns = std::map<std::string, std::vector<double>>;
std::string point_at(const std::string& place, const char* body) {
  return "[[subsurface.point]]\nat = [" + place + "]\nbody = \"" + body + "\"\n";
}
std::string line_at(const std::string& from, const std::string& to, int points, const char* body) {
  return "[[subsurface.line]]\nfrom = [" + from + "]\nto = [" + to +
         "]\npoints = " + std::to_string(points) + "\nbody = \"" + body + "\"\n";
}
std::string plane_at(const std::string& from, const std::string& to, const std::string& across,
                     const std::string& points) {
  return "[[subsurface.plane]]\nfrom = [" + from + "]\nto = [" + to + "]\nacross = [" + across +
         "]\npoints = [" + points + "]\nbody = \"rail\"\n";
}

/// Results of the program itself, the half-space on case a or on a rail of another radius, or of a
/// file that was made.
class StressTest : public ProgramTest {
 protected:
  void compute(const std::string& rail_radius, int across, const std::string& creepages = "[0.0]") {
    const std::string text =
        "models = [\"halfspace\"]\n" + rolling(creepages, across, with("2000.0", rail_radius));
    done({"run", folder.file("case.toml", text), "-o", "r", "-q", "--no-report"});
  }
  void keep(const std::string& bytes) const { folder.file("work/r/results.h5", bytes); }
  Outcome stress(const std::vector<std::string>& arguments) const {
    return call(joined({"stress", "r", "--no-figures"}, arguments));
  }
  /// At the places of a file with this text.
  Outcome stress_at(const std::string& places, const std::vector<std::string>& more = {}) const {
    return stress(joined({"--places", folder.file("places.toml", places)}, more));
  }
  Columns columns(const std::string& set, const std::string& body) const {
    const auto rows = csv_rows(folder.text("r_stress/stress.csv"));
    Columns found;
    for (const std::vector<std::string>& row : rows)
      if (row.at(2) == set && row.at(3) == body)
        for (std::size_t k = 4; k < row.size(); ++k)
          found[rows[0].at(k).substr(0, rows[0][k].find(" ["))].push_back(std::stod(row[k]));
    return found;
  }
  json report() const { return folder.json("r_stress/stress.json"); }
};

TEST_F(StressTest, AxisOfTheCircleIsThatOfHertz) {
  // Both bodies 405 mm: a circle. Johnson 1985, section 3.4: stresses on the axis; largest shear
  // 0.3100 p0 at 0.481 a for nu = 0.3.
  compute("405.0", 80);
  checked(stress({"--depth-profile"}));
  const double modulus = 210e3 / (2.0 * (1.0 - 0.09));
  const double a = std::cbrt(0.75 * 50e3 * 405.0 / modulus);
  const double p0 = 1.5 * 50e3 / (M_PI * a * a);
  const json data = report();
  ASSERT_EQ(data["models"].size(), 1U);
  EXPECT_NEAR(data["models"][0]["max_pressure"].get<double>(), p0, 2e-3 * p0);
  for (const char* body : {"wheel", "rail"}) {
    const Columns axis = columns("depth_centre", body);
    ASSERT_EQ(axis.at("z").size(), 121U);
    double largest = 0.0;
    double depth_of_largest = 0.0;
    for (std::size_t k = 0; k < 121; ++k) {
      const double z = std::abs(axis.at("z")[k]) / a;
      EXPECT_NEAR(axis.at("distance")[k], z * a, 1e-12);
      const double radial =
          k == 0 ? -(0.5 + 0.3) : -(1.3 * (1.0 - z * std::atan(1.0 / z)) - 0.5 / (1.0 + z * z));
      EXPECT_NEAR(axis.at("xx")[k], radial * p0, 2e-3 * p0) << body << " at depth " << z;
      EXPECT_NEAR(axis.at("yy")[k], radial * p0, 2e-3 * p0) << body << " at depth " << z;
      EXPECT_NEAR(axis.at("zz")[k], -p0 / (1.0 + z * z), 2e-3 * p0) << body << " at depth " << z;
      EXPECT_NEAR(axis.at("xz")[k], 0.0, 1e-3 * p0);
      if (axis.at("tresca")[k] > 2.0 * largest) {
        largest = 0.5 * axis.at("tresca")[k];
        depth_of_largest = z;
      }
    }
    EXPECT_NEAR(largest, 0.3100 * p0, 1e-3 * p0);
    EXPECT_NEAR(depth_of_largest, 0.481, 0.015);  // points are 0.025 a apart
  }
  // The largest of the bodies are found between the points, too.
  for (const json& maximum : data["models"][0]["maxima"]) {
    const double depth = std::abs(maximum["place"][2].get<double>()) / a;
    if (maximum["measure"] == "tresca") {
      EXPECT_NEAR(maximum["value"].get<double>(), 0.6200 * p0, 2e-3 * p0);
      EXPECT_NEAR(depth, 0.481, 0.01);
    }
    if (maximum["measure"] == "orthogonal_shear") {
      EXPECT_NEAR(maximum["value"].get<double>(), 0.2137 * p0, 2e-3 * p0);
    }
    if (maximum["measure"] == "xz_range") {
      EXPECT_NEAR(maximum["value"].get<double>(), 0.4274 * p0, 2e-3 * p0);
    }
  }
}

/// A run with stress maxima has their error bars; a single stored grid has none.
TEST_F(StressTest, LargestHaveTheBarsOfTheRun) {
  const auto maxima = [&](const std::string& output) {
    const std::string text = "models = [\"halfspace\"]\n" + small_case +
                             "[contact_grid]\nelements_across = 40\n" + output;
    done({"run", folder.file("case.toml", text), "-o", "r", "-q", "--no-report"});
    checked(stress_at(point_at("0, 0, -2", "rail")));
    const json model = report()["models"][0];
    EXPECT_EQ(model["sets"][0]["largest"][0]["no_bar"], "one grid");
    return model["maxima"][0];
  };
  const json barred = maxima("[output]\nstress_maxima = true\n");
  ASSERT_EQ(barred["measure"], "von_mises");
  EXPECT_GT(barred["error_estimate"].get<double>(), 0.0);
  EXPECT_LT(barred["error_estimate"].get<double>(), 0.02 * barred["value"].get<double>());
  EXPECT_EQ(maxima("")["no_bar"], "one grid");
}

TEST_F(StressTest, CaseAIsThatOfContact) {
  // To 1 % of p0 asked, 0.2 % reached.
  compute("2000.0", 60, "[0.0, 0.006]");
  std::string places;
  for (const case_a::Below& row : case_a::below)
    places += point_at("0, 0, " + std::to_string(row.z), "wheel") +
              point_at("0, 0, -" + std::to_string(row.z), "rail");
  checked(stress_at(places, {"--creepage", "0"}));
  int number = 0;
  for (const case_a::Below& row : case_a::below)
    for (const bool wheel : {true, false}) {
      const std::string name = "point_" + std::to_string(++number);
      const Columns at = columns(name, wheel ? "wheel" : "rail");
      ASSERT_EQ(at.at("zz").size(), 1U) << name;
      const double tolerance = 2e-3 * case_a::p0;
      EXPECT_NEAR(at.at("von_mises")[0], row.von_mises, tolerance) << row.z;
      EXPECT_NEAR(at.at("xx")[0], row.xx, tolerance) << row.z;
      EXPECT_NEAR(at.at("yy")[0], row.yy, tolerance) << row.z;
      EXPECT_NEAR(at.at("zz")[0], row.zz, tolerance) << row.z;
      EXPECT_NEAR(at.at("displacement_z")[0], (wheel ? 1.0 : -1.0) * row.uz, 5e-5);
    }
  // A place not requested in a body is absent.
  EXPECT_TRUE(columns("point_1", "rail").empty());
}

TEST_F(StressTest, OnTheSurfaceTheStressIsTheTraction) {
  compute("2000.0", 40, "[0.0, 0.002, 0.006]");
  checked(stress_at(plane_at("-3, 0, 0", "3, 0, 0", "-3, 0, -4", "31, 5")));
  const double friction = 0.55;
  const Columns plane = columns("plane_1", "rail");
  ASSERT_EQ(plane.at("z").size(), 155U);
  for (std::size_t k = 0; k < 31; ++k) {
    const double x = plane.at("x")[k] / 3.79236;
    const double pressure = 578.97 * std::sqrt(1.0 - x * x);
    EXPECT_EQ(plane.at("z")[k], 0.0);
    EXPECT_NEAR(plane.at("zz")[k], -pressure, 6.0) << x;
    // xi > 0 brakes: p_x = -mu p on the wheel, xz = -p_x in both bodies.
    EXPECT_NEAR(plane.at("xz")[k], friction * pressure, 4.0) << x;
  }
  EXPECT_NEAR(plane.at("z")[154], -4.0, 1e-12);
  EXPECT_NEAR(plane.at("x")[154], 3.0, 1e-12);
  // The surface itself, in either body.
  checked(stress_at(line_at("-3, 0.1, 0", "3, 0.1, 0", 7, "wheel") +
                    "[[subsurface.surface]]\nfrom = [-3, 0.1]\nto = [3, 0.1]\npoints = 7\n"
                    "body = \"rail\"\n"));
  for (const char* body : {"wheel", "rail"}) {
    const Columns line = columns(body == std::string("wheel") ? "line_1" : "surface_1", body);
    ASSERT_EQ(line.at("zz").size(), 7U) << body;
    EXPECT_NEAR(line.at("zz")[3], -578.97, 4.0);
  }
  EXPECT_TRUE(columns("plane_1", "rail").empty()) << "left from the call before";
}

TEST_F(StressTest, ShakedownPointsFollowFromTheCurve) {
  compute("2000.0", 20, "[0.0, 0.002, 0.006]");
  const Outcome outcome = checked(stress({"--yield-strength", "520"}));
  EXPECT_TRUE(says(outcome.out, "shakedown map, k = 300.2 MPa"));
  const json data = report();
  const json& points = data["models"][0]["shakedown"];
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR(points[0]["load_factor"].get<double>(), 578.97 / 300.22, 0.01);
  EXPECT_NEAR(points[0]["tangential_coefficient"].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(points[0]["circle"]["region"], "elastic");
  EXPECT_NEAR(points[2]["tangential_coefficient"].get<double>(), 0.5495, 1e-3);
  EXPECT_EQ(points[2]["line"]["region"], "beyond shakedown");
  EXPECT_NEAR(points[2]["surface_fatigue_index"].get<double>(), 0.5495 - 300.22 / 578.97, 5e-3);
  EXPECT_NEAR(points[2]["max_traction_over_k"].get<double>(), 0.55 * 578.97 / 300.22, 0.01);
  EXPECT_EQ(data["shakedown_map"]["circle_shakedown"].size(), 61U);
  // One verdict, with the ellipse of case a: b/a = 10.873/3.792.
  EXPECT_NEAR(points[0]["ellipse"]["ratio"].get<double>(), 10.87295 / 3.79236, 0.01);
  EXPECT_LT(points[0]["ellipse"]["shakedown"], points[0]["circle"]["shakedown"]);
  EXPECT_GT(points[0]["ellipse"]["shakedown"], points[0]["line"]["shakedown"]);
  EXPECT_EQ(points[0]["verdict"], "elastic");
  EXPECT_EQ(points[2]["verdict"], "beyond shakedown");
  const double above =
      points[2]["load_factor"].get<double>() / points[2]["ellipse"]["shakedown"].get<double>();
  std::istringstream margin(points[2]["margin"].get<std::string>().substr(6));
  double percent = 0.0;
  margin >> percent;
  EXPECT_NEAR(percent, 100.0 * (above - 1.0), 0.05 * percent);
  EXPECT_TRUE(says(outcome.out, "beyond shakedown; p0 is ", "elastic; p0 is "));
  // Without a yield stress there is no map.
  checked(stress({}));
  EXPECT_FALSE(report().contains("shakedown_map"));
}

/// A file of a finite-element run whose stresses are linear functions of the place.
std::string synthetic_file(bool placed) {
  rollfem::postprocess::RunRecord run = synthetic_run();
  rollfem::contact::ModelResult& fem = run.models[2];
  for (std::size_t b = 0; b < fem.bodies.size(); ++b) {
    rollfem::contact::BodyField& body = fem.bodies[b];
    const double side = body.name == "wheel" ? -1.0 : 1.0;
    if (side < 0.0) {  // the example is a rail: turned over, with its cells
      for (auto& point : body.points) point = {point[0], point[1], -point[2]};
      for (auto& cell : body.cells)
        for (int k = 0; k < 4; ++k) std::swap(cell[k], cell[k + 4]);
    }
    for (std::size_t load = 0; load < fem.points.size(); ++load)
      for (std::size_t k = 0; k < body.points.size(); ++k) {
        const auto& p = body.points[k];
        const std::array<double, 6> stress{10.0 * p[0], -3.0 * p[1], 7.0 * p[2] - 50.0,
                                           p[0] + p[2], 2.0 + load,  p[1]};
        rollfem::contact::BodyValues& values = fem.points[load].bodies[b];
        std::copy(stress.begin(), stress.end(), values.stress[k].begin());
        values.displacement[k] = {static_cast<float>(p[0] + p[1]), 0.0F, 0.0F};
      }
  }
  for (std::size_t load = 0; load < fem.points.size(); ++load)
    if (load != 2 && load + 1 != fem.points.size()) fem.points[load].bodies.clear();
  if (placed)
    for (std::size_t k = 0; k < run.models.size(); ++k) {
      run.models[k].place.emplace();
      run.models[k].place->patch = k == 2 ? 2 : 1;
    }
  return rollfem::postprocess::results_hdf5(run);
}

TEST_F(StressTest, OfBodiesIsInterpolatedBetweenTheNodes) {
  keep(synthetic_file(false));
  checked(stress_at(point_at("0.3, 0.6, -1.7", "rail") + point_at("0.3, 0.6, 1.7", "wheel") +
                        line_at("0.5, 0.5, 0.2", "0.5, 0.5, -1", 5, "rail") +
                        "[[subsurface.surface]]\nfrom = [0.5, 0.5]\nto = [1.0, 0.5]\ndepth = 0.7\n"
                        "points = 3\nbody = \"rail\"\n",
                    {"-m", "fem"}));
  const Columns rail = columns("point_1", "rail");
  EXPECT_NEAR(rail.at("xx")[0], 3.0, 1e-12);
  EXPECT_NEAR(rail.at("zz")[0], 7.0 * -1.7 - 50.0, 1e-12);
  EXPECT_NEAR(rail.at("xy")[0], -1.4, 1e-12);
  EXPECT_NEAR(rail.at("xz")[0], 0.6, 1e-12);
  EXPECT_NEAR(rail.at("displacement_x")[0], 0.9, 1e-12);
  // A place beyond the surface is moved onto it and reported there.
  const Columns line = columns("line_1", "rail");
  EXPECT_NEAR(line.at("z")[0], 0.0, 1e-12);
  EXPECT_NEAR(line.at("zz")[0], -50.0, 1e-12);
  EXPECT_NEAR(line.at("z")[4], -1.0, 1e-12);
  EXPECT_NEAR(report()["models"][0]["sets"][2]["moved"].get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(columns("surface_1", "rail").at("z")[2], -0.7, 1e-7);
  EXPECT_NEAR(columns("point_2", "wheel").at("zz")[0], 7.0 * 1.7 - 50.0, 1e-12);
}

TEST_F(StressTest, OfBodiesIsThatOfTheLoadPointAskedFor) {
  keep(synthetic_file(false));
  const auto yz_at = [&](const std::vector<std::string>& which, const std::string& heading) {
    const Outcome outcome =
        checked(stress_at(point_at("0, 0, -1", "rail"), joined({"-m", "fem"}, which)));
    EXPECT_TRUE(says(outcome.out, heading));
    return columns("point_1", "rail").at("yz").at(0);
  };
  EXPECT_NEAR(yz_at({"--point", "3"}, "fem: load point 3, xi = 0.001"), 4.0, 1e-12);
  EXPECT_NEAR(yz_at({"--creepage", "0.001"}, "fem: load point 3, xi = 0.001"), 4.0, 1e-12);
  EXPECT_NEAR(
      yz_at({}, "fem: load point 7 (the last of 7; others: --point 1 to 7, --creepage), xi"), 8.0,
      1e-12);
  // Down from the surface at any of them.
  checked(stress({"-m", "fem", "--point", "3", "--depth", "1.5"}));
  const Columns down = columns("depth_centre", "rail");
  ASSERT_EQ(down.at("zz").size(), 121U);
  EXPECT_NEAR(down.at("zz").back(), 7.0 * -1.5 - 50.0, 1e-7);
  EXPECT_NEAR(down.at("yz").back(), 4.0, 1e-12);
}

TEST_F(StressTest, OfBodiesIsRefusedWhereALoadPointKeepsNone) {
  keep(synthetic_file(false));
  expect_refused(
      stress_at(point_at("0, 0, 0", "rail"), {"-m", "fem", "--point", "1"}),
      "load point 1: model fem stores its bodies only for these load points: 3, 7; do: ");
  const Outcome both = checked(stress_at(point_at("0, 0, -1", "rail"), {"--point", "1"}));
  EXPECT_TRUE(says(both.err, "warning: left out: load point 1: model fem"));
  EXPECT_EQ(report()["models"].size(), 1U);
  expect_refused(stress_at(point_at("0, 0, -9", "rail"), {"-m", "fem"}),
                 "places.toml: point_1: the point (0, 0, -9) mm is 7 mm outside the computed rail");
}

TEST_F(StressTest, OfPatchesIsThatOfThePatchNamed) {
  keep(synthetic_file(true));
  const auto of = [&](const std::vector<std::string>& more) {
    checked(stress_at(point_at("0.1, 0.1, -1", "rail"), more));
    return report()["models"][0]["key"].get<std::string>();
  };
  EXPECT_EQ(of({}), "halfspace_left_1_1");
  EXPECT_EQ(of({"-m", "hertz"}), "hertz_left_1_1");
  EXPECT_EQ(of({"--patch", "left,1,2"}), "fem_left_1_2");
  expect_refused(stress({"--patch", "right,1,1"}), "allowed: left,1,1, left,1,2; do: ");
}

TEST_F(StressTest, WrongCallsAreRefused) {
  compute("2000.0", 10, "[0.0, 0.001]");
  const std::pair<std::vector<std::string>, const char*> calls[] = {
      {{"--model", "fem"}, "--model fem: it is not in r; allowed: halfspace"},
      {{"--point", "3"}, "load points 1 to 2"},
      {{"--point", "0"}, "load points 1 to 2"},
      {{"--creepage", "0.002"}, "allowed: 0, 0.001"},
      {{"--point", "1", "--creepage", "0"}, "exclude each other"},
      {{"--places", "none.toml"}, "none.toml: there is no such file"},
      {{"--patch", "left,1,1"}, "without profiles"},
      {{"--yield-strength", "0"}, "a stress > 0"},
      {{"--yield-strength", "3", "--yield-shear-stress", "4"}, "exclude each other"},
      {{"--depth", "-1"}, "a depth > 0"},
      {{"-o", "r/results.h5/x"}, "cannot create the folder"},
  };
  const std::pair<std::string, const char*> places[] = {
      {"", "has no section [[subsurface.point]]"},
      {"[[subsurface.point]]\nat = [1, 2]\n", "subsurface.point.at"},
      {"[[subsurface.line]]\nfrom = [0, 0, 1]\npoints = 2\n", "subsurface.line.to: is missing"},
      {line_at("0, 0, 1", "0, 0, 1", 3, "wheel"), "two of its points coincide"},
      {line_at("0, 0, 0", "0, 0, -5", 1, "rail"), "subsurface.line.points = 1"},
      {plane_at("0, 0, 0", "1, 0, 0", "0, 0, -1", "2000, 2000"), "at most 1000000 points"},
      {line_at("0, 0, -1", "0, 0, 1", 3, "rail"), "is not in the rail of model halfspace"},
      {point_at("0, 0, 1", "sleeper"), "sleeper"}};
  folder.file("places.toml", "");
  const auto before = folder.made();
  for (const auto& [arguments, part] : calls) expect_refused(stress(arguments), part);
  for (const auto& [text, part] : places) expect_refused(stress_at(text), part);
  EXPECT_EQ(folder.made(), before);
}

TEST_F(StressTest, FilesThatAreNoResultsAreRefused) {
  compute("2000.0", 10);
  const std::string whole = folder.text("r/results.h5");
  refuses({"stress", "missing"}, "missing: there is no such file");
  refuses({"stress"}, "result is required");
  refuses({"stress", "r/summary.json"}, "not a result of rollfem");
  refuses({"stress", folder.file("cut.h5", whole.substr(0, whole.size() / 2))},
          "truncated or damaged");
  EXPECT_FALSE(folder.holds("r_stress"));
}

}  // namespace
