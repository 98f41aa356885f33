// SPDX-License-Identifier: LGPL-2.1-or-later
#include "case/checks/history_checks.hpp"

#include "case/keys/case_text.hpp"
#include "case/keys/key_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rollfem::contact {

namespace {

/// Steps of a transient from the time or the position along the track at their ends; the first is
/// as long as the second.
void find_step_lengths(const GivenCase& given, Case& input) {
  const std::vector<double>& places = input.wheelset.track_position;
  const bool by_time = given.find("history", "time") != nullptr;
  if (input.rolling.problem != Problem::transient ||
      given.find("history", "step_length") != nullptr)
    return;
  const char* const key = by_time                  ? "history.time"
                          : input.wheelset.on_rail ? "placement.track_position"
                                                   : "wheelset.track_position";
  if (!by_time && places.size() < 2)
    fail_at(given, key, "is one number, and history.step_length is missing",
            "a list, whose differences are the steps, or step_length",
            "add `step_length = 0.1` under [history]");
  for (std::size_t k = 1; k < input.history.size(); ++k) {
    HistoryStep& step = input.history[k];
    step.step_length = by_time ? (*step.time - *input.history[k - 1].time) * input.rolling.speed
                               : places.at(k) - places[k - 1];
    if (!(step.step_length > 0.0))
      fail_at(given, key, fmt::format("falls or stays equal at step {}", k + 1),
              "numbers that ascend, because the wheel rolls forward", "sort the steps");
  }
  if (input.history.size() > 1) input.history.front().step_length = input.history[1].step_length;
}

/// Positions of a wheel in a history are its steps: lists over both have one length.
void follow_positions(const GivenCase& given, Case& input) {
  Wheelset& wheelset = input.wheelset;
  const std::size_t steps = input.rolling.creepages.size(), positions = wheelset.positions();
  const GivenValue* loads = given.find("history", "vertical_force");
  const bool loads_differ = loads != nullptr && length_of(loads->value) > 1;
  const bool free = wheelset.free_rolling != FreeRolling::none;
  if (positions == 1 && !loads_differ && !free) return;
  if (std::max(steps, positions) == 1)
    fail_at(given, wheelset.on_rail ? "placement.free_rolling" : "wheelset.free_rolling",
            "seeks a rotation in each step of a history, and there is only one",
            "several positions, or lists over the steps", "give several steps, or remove it");
  if (positions > 1 && steps > 1 && positions != steps)
    for (const auto& [key, value] : given.values)
      if (key->per == "positions" && length_of(value.value) > 1)
        fail_at(given, key->path(),
                fmt::format("has {} positions, but the history has {} steps: in a history the "
                            "positions follow each other",
                            positions, steps),
                "one position for each step, or a single number for all",
                "make the lists equally long");
  const std::size_t count = std::max(steps, positions);
  grow_load_points(input, count);
  for (auto* list : {&wheelset.lateral_shift, &wheelset.yaw, &wheelset.roll, &wheelset.height,
                     &wheelset.track_position, &wheelset.wheel_angle})
    if (!list->empty()) list->resize(count, list->front());
  for (const auto& [section, name] : {std::pair("", "accuracy"),
                                      {"contact_grid", "extent"},
                                      {"contact_grid", "middle"},
                                      {"halfspace", "model_error"}})
    if (given.find(section, name) != nullptr)
      fail_at(given, find_key(section, name)->path(),
              "is not possible where the positions of a wheel are the steps of a history, whose "
              "elements lie on one lattice",
              "contact_grid.elements_across or cell_size", "remove it, or give one position");
}

}  // namespace

void complete_history(const GivenCase& given, Case& input) {
  if (input.history.empty()) return;
  if (input.has_profiles()) follow_positions(given, input);
  find_step_lengths(given, input);
}

}  // namespace rollfem::contact
