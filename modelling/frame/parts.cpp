// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/frame/parts.hpp"

#include "base/errors.hpp"
#include "base/text_fields.hpp"
#include "modelling/frame/command_frame.hpp"
#include "modelling/program/provenance.hpp"
#include "result/files/checkpoint_folder.hpp"
#include "result/files/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace rollfem::modelling {

namespace fs = std::filesystem;

std::string part_directory(const fs::path& directory, contact::RunPart own) {
  if (own.whole()) return directory.string();
  return fmt::format("{}.part-{}-of-{}", result::resolved_folder(directory).string(), own.part + 1,
                     own.of);
}

contact::RunPart parse_part(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const int part = contact::whole_number_of(text.substr(0, slash)).value_or(0);
  const int of =
      contact::whole_number_of(text.substr(std::min(slash + 1, text.size()))).value_or(0);
  if (part < 1 || of < 2 || part > of)
    throw contact::InputError(fmt::format(
        "--part {}: allowed: K/N with whole numbers, K from 1 to N, N at least 2; do: write for "
        "instance --part 3/8",
        text));
  return {part - 1, of};
}

void check_division(const Computing& request, std::size_t items, const std::string& kind) {
  const char* const key = request.merge > 0 ? "--merge" : "--part";
  if (request.merge == 0 && request.own.whole()) return;
  if (request.merge > 0 && !request.own.whole())
    throw contact::InputError(
        "--part with --merge: allowed: one of them; do: run all parts, then merge");
  if (items > 1) return;
  throw contact::InputError(fmt::format(
      "{}: this case has nothing to divide: {} of {}; do: leave {} out", key, items, kind, key));
}

namespace {

void wait_for_parts(const fs::path& directory, int parts) {
  for (int part = 0; part < parts; ++part)
    while (
        !result::CheckpointFolder::is_marked(part_directory(directory, {part, parts}), part_done))
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace

void in_parts(Computing& request, bool divisible, const fs::path& directory,
              const std::function<void()>& work) {
  const Processes all = processes();
  if (!divisible || all.count < 2 || !request.own.whole() || request.merge > 0) return work();
  const bool quiet = request.quiet;
  request.own = {all.rank, all.count};
  request.quiet = quiet || !all.first();
  work();
  if (!all.first()) return;
  wait_for_parts(directory, all.count);
  request.own = {};
  request.merge = all.count;
  work();
}

}  // namespace rollfem::modelling
