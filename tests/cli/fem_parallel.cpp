// The finite-element model through the program: several processes and another linear solver give
// the same numbers, and errors keep their exit status under mpirun.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/places.hpp"
#include "support/program.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace rollfem::testing;
using Json = nlohmann::json;

/// Case a on a coarse mesh with lateral creepage, so that whole bodies are modelled.
std::string coarse_stress_case(const std::string& solver) {
  return "title = \"coarse\"\nmodels = [\"fem\"]\n"
         "[load]\nnormal_force = 50e3\n[friction]\ncoefficient = 0.55\n"
         "[wheel]\nrolling_radius = 405.0\ntransverse_radius = inf\n"
         "[rail]\ntransverse_radius = 500.0\n"
         "[rolling]\nlongitudinal_creepage = 0.001\nlateral_creepage = 0.0005\n"
         "[fem]\ncell_size = 1.4\nlinear_solver = \"" +
         solver +
         "\"\n[output]\nstress_maxima = true\nbody_fields = \"all\"\n"
         "[[subsurface.line]]\nfrom = [-3, -2, 0.4]\nto = [3, 2, "
         "6]\npoints = 9\n[[subsurface.surface]]\nbody = \"rail\"\nfrom = [1, -5]\nto = [1, "
         "5]\npoints = 9\n";
}

Json point_of(const std::filesystem::path& folder) {
  return Json::parse(contents(folder / "summary.json"))["models"][0]["points"][0];
}

void expect_same_numbers(const Json& one, const Json& other, double tolerance) {
  for (const char* name : {"longitudinal_force", "lateral_force", "spin_moment", "max_pressure",
                           "max_traction", "approach", "semi_axis_x", "semi_axis_y"}) {
    const double a = one[name];
    const double b = other[name];
    EXPECT_NEAR(a, b, tolerance * std::abs(a)) << name;
  }
}

/// Largest stresses, and displacement and stress at the points that the case asks for.
void expect_same_stresses(const std::filesystem::path& one, const std::filesystem::path& other,
                          double tolerance) {
  const double scale = point_of(one)["max_pressure"];
  const Json a = point_of(one)["stress_maxima"];
  const Json b = point_of(other)["stress_maxima"];
  ASSERT_EQ(a.size(), 8u);
  ASSERT_EQ(b.size(), 8u);
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k]["value"], b[k]["value"], tolerance * scale) << a[k]["measure"];
  const auto numbers = [](const std::filesystem::path& folder) {
    std::string text = contents(folder / "subsurface.csv");
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream words(text.substr(text.find('\n')));
    std::vector<double> values;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end == '\0') values.push_back(value);
    }
    return values;
  };
  const auto first = numbers(one);
  const auto second = numbers(other);
  ASSERT_GT(first.size(), 18u * 20u);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t k = 0; k < first.size(); ++k)
    EXPECT_NEAR(first[k], second[k], tolerance * scale) << k;
}

/// Nodes, cells, displacement and stress of the bodies in both files: "" when they are the same but
/// for rounding to single precision.
std::string different_bodies(const Folder& folder, const std::filesystem::path& one,
                             const std::filesystem::path& other) {
  const std::string script =
      "import h5py, numpy, sys\n"
      "a, b = (h5py.File(f + '/results.h5', 'r')['models/fem'] for f in sys.argv[1:3])\n"
      "p0 = a['points/0000'].attrs['max_pressure']\n"
      "for body in ('wheel', 'rail'):\n"
      "    for name, bound in (('points', 1e-11), ('cells', 0), ('displacement', 1e-9),\n"
      "                        ('stress', 1e-6 * p0)):\n"
      "        x, y = (f['bodies'][body][name][()] for f in (a, b))\n"
      "        if x.shape != y.shape or not x.size or abs(x - y).max() > bound:\n"
      "            print(body, name, x.shape, y.shape, abs(x - y).max())\n";
  const Outcome outcome =
      execute(folder, {"/usr/bin/python3", "-c", script, one.string(), other.string()});
  return outcome.out + outcome.err;
}

std::vector<std::string> mpirun(int processes, std::vector<std::string> arguments) {
  std::vector<std::string> all{"mpirun", "--allow-run-as-root",     "--oversubscribe",
                               "-n",     std::to_string(processes), ROLLFEM_PROGRAM};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

}  // namespace

TEST(FemProgram, TwoProcessesGiveTheNumbersOfOne) {
  const Folder folder;
  const std::string input = folder.file("coarse.toml", coarse_stress_case("multigrid"));
  const auto one = folder.output("one");
  const auto two = folder.output("two");
  const Outcome serial = call(folder, {"run", input, "-o", one.string(), "--quiet", "--no-report"});
  ASSERT_EQ(serial.status, 0) << serial.err;
  const Outcome parallel =
      execute(folder, mpirun(2, {"run", input, "-o", two.string(), "--quiet", "--no-report"}));
  ASSERT_EQ(parallel.status, 0) << parallel.err;
  expect_same_numbers(point_of(one), point_of(two), 1e-8);
  expect_same_stresses(one, two, 1e-8);
  EXPECT_EQ(different_bodies(folder, one, two), "");
}

TEST(FemProgram, FactorisationAndMultigridGiveTheSameNumbers) {
  const Folder folder;
  std::vector<Json> points;
  for (const char* solver : {"factorisation", "multigrid"}) {
    const std::string input =
        folder.file(std::string(solver) + ".toml", coarse_stress_case(solver));
    const auto output = folder.output(solver);
    const Outcome outcome =
        call(folder, {"run", input, "-o", output.string(), "--quiet", "--no-report"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    points.push_back(point_of(output));
  }
  expect_same_numbers(points[0], points[1], 1e-8);
}

TEST(FemProgram, AFactorisationOnTwoProcessesIsRefusedOnceWithStatusTwo) {
  const Folder folder;
  const std::string input = folder.file("coarse.toml", coarse_stress_case("factorisation"));
  const auto output = folder.output("out");
  const Outcome outcome =
      execute(folder, mpirun(2, {"run", input, "-o", output.string(), "--no-report"}));
  EXPECT_EQ(outcome.status, 2);
  const std::size_t first = outcome.err.find("linear_solver");
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("one process only", outcome.err.find("one process only") + 1),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(output));
}
