// SPDX-License-Identifier: LGPL-2.1-or-later
// How often the error bars of the model halfspace hold, compared with a grid four times finer.
// Prints the tables of docs/counts.md, and to stderr every scene without a result.
//
// benchmark_bar_coverage [rows] [FRICTION] SEED FIRST NUMBER [ACROSS ...]   e.g. 8 0 1000 12 16 20
//   random scenes (tests/support/random_scenes.hpp) on 12 to 32 elements across the patch;
//   FRICTION: `falling`, a layer that is `yielding`, or `varying` across the patch
// benchmark_bar_coverage [rows] worn SEED FIRST NUMBER [CELL ...]     e.g. worn 31 0 60 0.1 0.2
//   worn wheels on worn rails (tests/support/worn_pairs.hpp) on cells of these sizes, mm
// benchmark_bar_coverage [rows] case FILE CELL ...                    e.g. case pair.toml 0.2
//   all patches of a case with profiles
//
// With `rows`, prints every number (error, bar, bar on the fine grid) instead of the table.
#include "tests/support/bar_coverage.hpp"

#include "case/reading/case_reader.hpp"

#include <fmt/format.h>

#include "tests/support/half_space_models.hpp"
#include "tests/support/worn_pairs.hpp"
#include <cctype>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace rollfem;

namespace {

void print_table(const testing::BarSamples& samples) {
  fmt::print(
      "| quantity | numbers | held, % | median of bar / error | median of bar on the fine grid / "
      "bar |\n|---|---|---|---|---|\n");
  for (const auto& [name, of_name] : samples) {
    const testing::BarRow row(of_name);
    fmt::print("| `{}` | {} | {:.1f} | {:.1f} | {:.2f} |\n", name, row.count, 100.0 * row.covered,
               row.bar_over_error, row.fine_bar_over_bar);
  }
}

void print_rows(const testing::BarSamples& samples, const std::string& scene) {
  for (const auto& [name, of_name] : samples)
    for (const testing::BarSample& sample : of_name)
      fmt::print("{} {} {:.6g} {:.6g} {:.6g}\n", scene, name, sample.error, sample.bar,
                 sample.fine_bar);
  std::fflush(stdout);
}

/// A scene on one grid: its name and a function that adds its numbers.
struct Scene {
  std::string name;
  std::function<void(testing::BarSamples&)> add;
};

unsigned whole(const std::string& word) {
  return static_cast<unsigned>(std::atoi(word.c_str()));
}

template <class Value>
std::vector<Value> numbers_from(const std::vector<std::string>& words, std::size_t first) {
  std::vector<Value> values;
  for (std::size_t k = first; k < words.size(); ++k)
    values.push_back(static_cast<Value>(std::atof(words[k].c_str())));
  return values;
}

using Change = void (testing::RandomScenes::*)(testing::RandomScene&);
const std::map<std::string, Change> changes{{"falling", &testing::RandomScenes::let_fall},
                                            {"yielding", &testing::RandomScenes::let_yield},
                                            {"varying", &testing::RandomScenes::let_vary}};

/// `change`: of the friction; may be null.
std::vector<Scene> random_scenes(const std::vector<std::string>& words, Change change) {
  std::vector<int> sizes = numbers_from<int>(words, 3);
  if (sizes.empty()) sizes = {12, 12, 16, 16, 20, 20, 24, 24, 32};
  std::vector<Scene> scenes;
  for (unsigned number = whole(words[1]); number < whole(words[1]) + whole(words[2]); ++number)
    scenes.push_back({std::to_string(number), [=](testing::BarSamples& samples) {
                        testing::RandomScenes all(whole(words[0]));
                        testing::RandomScene random = all.scene(number);
                        if (change != nullptr) (all.*change)(random);
                        const int across = all.choose(sizes);
                        // Stresses on the finest grids take far longer than the contact.
                        testing::add_scene(random, across, number % 6 == 0 && across <= 20,
                                           samples);
                      }});
  return scenes;
}

std::vector<Scene> worn_pairs(const std::vector<std::string>& words) {
  std::vector<double> cells = numbers_from<double>(words, 4);
  if (cells.empty()) cells = {0.2};
  std::vector<Scene> scenes;
  for (unsigned number = whole(words[2]); number < whole(words[2]) + whole(words[3]); ++number)
    for (const double cell : cells)
      scenes.push_back({fmt::format("{} {}", number, cell), [=](testing::BarSamples& samples) {
                          testing::WornPairs pairs(whole(words[1]));
                          testing::add_on_cells(pairs.scene(number), cell, samples);
                        }});
  return scenes;
}

std::vector<Scene> patches_of_case(const std::vector<std::string>& words) {
  static_cast<void>(testing::half_space_models());  // whose keys the case may have
  std::vector<Scene> scenes;
  for (const track::PlacedScene& placed : track::make_scenes(contact::read_case(words[1])))
    for (const double cell : numbers_from<double>(words, 2))
      scenes.push_back({fmt::format("{} {}", placed.scene.place->label(), cell),
                        [scene = placed.scene, cell](testing::BarSamples& samples) {
                          testing::add_on_cells(scene, cell, samples);
                        }});
  return scenes;
}

std::vector<Scene> scenes_of(const std::vector<std::string>& words) {
  if (words.size() >= 3 && words[0] == "case") return patches_of_case(words);
  if (words.size() >= 4 && words[0] == "worn") return worn_pairs(words);
  const auto change = words.empty() ? changes.end() : changes.find(words[0]);
  if (words.size() >= 4 && change != changes.end())
    return random_scenes({words.begin() + 1, words.end()}, change->second);
  if (words.size() >= 3 && std::isdigit(words[0][0])) return random_scenes(words, nullptr);
  return {};
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  const bool rows = !words.empty() && words[0] == "rows";
  if (rows) words.erase(words.begin());
  const std::vector<Scene> scenes = scenes_of(words);
  if (scenes.empty()) {
    fmt::print(
        stderr,
        "call: benchmark_bar_coverage [rows] [falling, yielding or varying] SEED FIRST NUMBER "
        "[ACROSS ...], worn SEED FIRST NUMBER [CELL ...] or case FILE CELL ...\n");
    return 2;
  }
  testing::BarSamples samples;
  int solved = 0;
  for (const Scene& scene : scenes) {
    try {
      testing::BarSamples of_scene;
      scene.add(of_scene);
      if (rows) print_rows(of_scene, scene.name);
      for (const auto& [name, of_name] : of_scene)
        samples[name].insert(samples[name].end(), of_name.begin(), of_name.end());
      ++solved;
    } catch (const std::exception& error) {
      fmt::print(stderr, "scene {}: {}\n", scene.name, error.what());
    }
  }
  if (rows) return 0;
  for (const std::string& word : words) fmt::print("{} ", word);
  fmt::print(": {} of {} scenes solved\n\n", solved, scenes.size());
  print_table(samples);
  return 0;
}
