// SPDX-License-Identifier: LGPL-2.1-or-later
// How often the error bars of finite elements and of the hybrid hold, for random wheels on random
// rails (tests/support/random_wheel_rail.hpp). Finite elements with cells of 1/PARTS of the smaller
// semi-axis against cells of 1/FINER; the hybrid with 16 elements across against 64 and a
// correction by finer cells. Prints the tables of docs/counts.md, and to stderr every contact
// without a result. Levels of finite elements are stored in a folder and reused. Call:
// benchmark_fem_bars fem FOLDER PARTS FINER SEED FIRST NUMBER [rows], e.g. fem levels 4 16 1 0 40,
// or benchmark_fem_bars hybrid SEED FIRST NUMBER [rows]. With `rows`, also prints every number
// (error, bar).
#include "fem/elasticity/fem_model.hpp"
#include "fem/elasticity/run_level.hpp"
#include "fem/fem_options.hpp"
#include "halfspace/closed_forms/hertz.hpp"
#include "hybrid/correction/smooth_parts.hpp"
#include "hybrid/hybrid_model.hpp"

#include <deal.II/base/mpi.h>
#include <fmt/format.h>

#include "tests/support/bar_coverage.hpp"
#include "tests/support/random_wheel_rail.hpp"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace rollfem;

namespace {

/// Records of the levels of one contact.
class Records : public contact::Checkpoint {
 public:
  explicit Records(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::filesystem::create_directories(folder_);
  }
  std::optional<std::string> find(const std::string& name) override {
    std::ifstream file(folder_ / name, std::ios::binary);
    if (!file) return {};
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  void keep(const std::string& name, const std::string& record) override {
    const std::filesystem::path whole = folder_ / name, part = whole.string() + ".part";
    std::ofstream(part, std::ios::binary) << record;
    std::filesystem::rename(part, whole);
  }

 private:
  std::filesystem::path folder_;
};

/// Options for printing and solving.
struct Call {
  std::string model;
  std::string folder;
  double parts = 0.0, finer = 0.0;  ///< cells in the smaller semi-axis
  unsigned seed = 0, first = 0, number = 0;
  bool rows = false;
};

void add_finite_elements(const Call& call, unsigned number, contact::Case input,
                         testing::BarSamples& samples) {
  constexpr double reach = 3.0;
  const halfspace::HertzContact hertz = halfspace::hertz_of_scene(contact::Scene(input));
  const double cell = std::min(hertz.semi_axis_x, hertz.semi_axis_y) / call.parts;
  input.options.set<fem::FemOptions>().cell_size = cell;
  input.body_extent = reach * std::max(hertz.semi_axis_x, hertz.semi_axis_y);
  input.subsurface = testing::points_below(hertz.semi_axis_x, hertz.semi_axis_y);
  const contact::Scene scene(input);
  Records records(fmt::format("{}/{}_{}", call.folder, call.seed, number));
  const contact::ModelResult result = fem::run_fem(scene, {}, &records);
  const contact::ModelResult fine =
      fem::run_level(scene, {cell * call.parts / call.finer, "", false, &records}, {});
  contact::PointResult point = result.points.front();
  // The error of finite segments in the approach is the same for all cells.
  contact::PointResult level =
      fem::run_level(scene, {cell, "", false, &records}, {}).points.front();
  point.error_estimate["approach"] -= level.error_estimate["approach"];
  testing::add_samples(point, fine.points.front(), scene.friction_coefficient(), samples);
}

void add_hybrid(contact::Case input, testing::BarSamples& samples) {
  constexpr int across = 16;
  constexpr double finer_cells = 5.0;
  const auto run = [&](int elements, const hybrid::FindParts& find) {
    input.contact_grid.elements_across = elements;
    return hybrid::run_hybrid(contact::Scene(input), {}, nullptr, find).points.front();
  };
  const contact::PointResult point =
      run(across, [](const contact::Scene& scene, const contact::Progress& progress) {
        return hybrid::find_smooth_parts(scene, progress);
      });
  const contact::PointResult fine =
      run(4 * across, [&](const contact::Scene& scene, const contact::Progress& progress) {
        return hybrid::find_smooth_parts_with(finer_cells, scene, progress);
      });
  testing::add_samples(point, fine, input.friction_coefficient, samples);
}

void print_rows(const testing::BarSamples& samples, unsigned number) {
  for (const auto& [name, of_name] : samples)
    for (const testing::BarSample& sample : of_name)
      fmt::print("{} {} {:.6g} {:.6g}\n", number, name, sample.error, sample.bar);
}

void print_table(const testing::BarSamples& samples) {
  fmt::print("| quantity | numbers | held, % | median of bar / error |\n|---|---|---|---|\n");
  for (const auto& [name, of_name] : samples) {
    const testing::BarRow row(of_name);
    fmt::print("| `{}` | {} | {:.1f} | {:.1f} |\n", name, row.count, 100.0 * row.covered,
               row.bar_over_error);
  }
}

void count_coverage(const Call& call) {
  testing::RandomWheelRail contacts(call.seed);
  testing::BarSamples samples;
  int solved = 0;
  for (unsigned number = call.first; number < call.first + call.number; ++number) {
    try {
      testing::BarSamples of_contact;
      const contact::Case input = contacts.contact(number);
      if (call.model == "fem")
        add_finite_elements(call, number, input, of_contact);
      else
        add_hybrid(input, of_contact);
      if (call.rows) print_rows(of_contact, number);
      std::fflush(stdout);
      for (const auto& [name, of_name] : of_contact)
        samples[name].insert(samples[name].end(), of_name.begin(), of_name.end());
      ++solved;
    } catch (const std::exception& error) {
      fmt::print(stderr, "contact {}: {}\n", number, error.what());
    }
  }
  fmt::print("{}, seed {}, contacts {} to {}, {} solved\n\n", call.model, call.seed, call.first,
             call.first + call.number - 1, solved);
  print_table(samples);
}

}  // namespace

int main(int count, char** words) {
  Call call;
  std::vector<std::string> given(words + 1, words + count);
  if (!given.empty() && given.back() == "rows") {
    call.rows = true;
    given.pop_back();
  }
  const bool finite = given.size() == 7 && given[0] == "fem";
  if (!finite && !(given.size() == 4 && given[0] == "hybrid")) {
    fmt::print(stderr,
               "call: benchmark_fem_bars fem FOLDER PARTS FINER SEED FIRST NUMBER [rows]\n"
               "      benchmark_fem_bars hybrid SEED FIRST NUMBER [rows]\n");
    return 2;
  }
  call.model = given[0];
  if (finite) {
    call.folder = given[1];
    call.parts = std::atof(given[2].c_str());
    call.finer = std::atof(given[3].c_str());
  }
  const auto whole = [&](std::size_t from_end) {
    return static_cast<unsigned>(std::atoi(given[given.size() - from_end].c_str()));
  };
  call.seed = whole(3);
  call.first = whole(2);
  call.number = whole(1);
  int no_words = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize session(no_words, words, 1);
  count_coverage(call);
  return 0;
}
