// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/solving/history_run.hpp"

#include "base/errors.hpp"
#include "base/threads.hpp"
#include "track/history/wheel_history.hpp"
#include "track/motion/placed_scenes.hpp"

#include <array>
#include <iterator>
#include <optional>
#include <utility>

namespace rollfem::modelling {

using contact::Case;
using contact::FreeRolling;
using contact::ModelResult;
using contact::Scene;

namespace {

/// One wheel through all steps.
struct Wheel {
  std::vector<Scene> scenes;                     ///< of all steps
  std::optional<track::WheelHistory> history{};  ///< none: the wheel never touches its rail
  std::size_t next = 0;                          ///< the first scene of the steps to come
  double rotation = 0.0;

  bool touches(std::size_t k) const {
    return next < scenes.size() && scenes[next].place->position == static_cast<int>(k) + 1;
  }
  void begin(std::size_t k, const Case& here, const track::PlacedWheels& placed) {
    std::vector<Scene> contacts;
    for (; touches(k); ++next) contacts.push_back(scenes[next]);
    history->begin(here, std::move(contacts), placed);
  }
};

}  // namespace

std::vector<ModelResult> solve_history(const Case& input, const track::PlacedWheels& placed,
                                       const std::string& model, const Scenes& scenes,
                                       const Solving& how) {
  if (!how.models->at(model).joins_planes)
    throw contact::InputError(
        {input.file},
        "model {}: the positions of this wheel are the steps of a history, in which the contact "
        "moves; allowed: halfspace; do: run with --model halfspace, or give one position",
        model);
  auto notes = scenes.notes;
  notes.push_back({"steps",
                   "the positions of this wheel follow each other; elements lie on one lattice in "
                   "the material of the rail"});
  std::array<Wheel, 2> wheels;
  for (const Scene& scene : scenes.list) wheels[scene.place->left ? 0 : 1].scenes.push_back(scene);
  const auto solve = [&](const Scene& scene, const std::vector<contact::Note>& of_step,
                         contact::Checkpoint* checkpoint) {
    Solving kept = how;
    kept.checkpoint = checkpoint;
    return solve_scene(model, scene, of_step, kept);
  };
  for (Wheel& wheel : wheels)
    if (!wheel.scenes.empty())
      wheel.history.emplace(track::cells_of_levels(input, wheel.scenes), notes, solve,
                            how.checkpoint);
  const FreeRolling free = input.wheelset.free_rolling;
  std::vector<ModelResult> all;
  for (std::size_t k = 0; k < input.history.size(); ++k) {
    const Case here = track::case_at(input, k);
    std::vector<Wheel*> touching;
    std::vector<track::WheelHistory*> together;
    for (Wheel& wheel : wheels) {
      if (!wheel.history) continue;
      if (!wheel.touches(k)) {
        wheel.history->miss(here.history.front().step_length);
        continue;
      }
      touching.push_back(&wheel);
      together.push_back(&*wheel.history);
      wheel.begin(k, here, placed);
    }
    if (free == FreeRolling::torque && !touching.empty())
      wheels[0].rotation = track::find_rotation(together, wheels[0].rotation);
    std::vector<std::vector<ModelResult>> results(touching.size());
    contact::for_each_index(touching.size(), [&](std::size_t t) {
      Wheel& wheel = *touching[t];
      if (free == FreeRolling::force)
        wheel.rotation = track::find_rotation({&*wheel.history}, wheel.rotation);
      if (input.track.rail_stiffness) wheel.history->settle();
      results[t] = wheel.history->solve();
      wheel.history->end(results[t]);
    });
    for (std::vector<ModelResult>& found : results)
      std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace rollfem::modelling
