// SPDX-License-Identifier: LGPL-2.1-or-later
// The command `rollfem cache`: the stored corrections of the model hybrid.
#include "app/frame/commands.hpp"
#include "base/errors.hpp"
#include "modelling/caches/correction_cache.hpp"

#include <fmt/format.h>

#include <iostream>
#include <vector>

namespace rollfem::app {

namespace {

std::string total_of(const std::vector<modelling::CorrectionCache::Entry>& entries) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : entries) bytes += entry.bytes;
  return fmt::format("{} corrections, {:.1f} kB", entries.size(),
                     1e-3 * static_cast<double>(bytes));
}

void list(const std::vector<modelling::CorrectionCache::Entry>& entries) {
  if (!entries.empty())
    std::cout << fmt::format("{:<20} {:>9} {:>9} {:>8}  bodies\n", "made", "kB", "unknowns",
                             "seconds");
  for (const auto& entry : entries)
    std::cout << fmt::format(
        "{:<20} {:>9.1f} {:>9} {:>8.1f}  {}\n", entry.made.empty() ? "-" : entry.made,
        1e-3 * static_cast<double>(entry.bytes), entry.unknowns, entry.seconds,
        entry.words.empty()
            ? entry.file.filename().string() + " is damaged and will be recomputed when needed"
            : entry.words);
}

/// Lists the stored corrections, or removes them (`action` "clear") and prints the freed space.
void cache(const std::string& action) {
  const modelling::CorrectionCache corrections;
  if (corrections.off()) {
    std::cout << "no cache: ROLLFEM_CACHE is empty, or there is no home folder\n";
    return;
  }
  const auto entries = corrections.entries();
  if (action == "clear") {
    const auto left = corrections.clear();
    if (!left.empty())
      throw contact::InputError(
          fmt::format("cache clear: {}; do: check who may write there", fmt::join(left, "; ")));
    std::cout << fmt::format("{}: removed {}\n", corrections.folder().string(), total_of(entries));
    return;
  }
  list(entries);
  std::cout << fmt::format("{}: {}\n", corrections.folder().string(), total_of(entries));
}

}  // namespace

void add_cache(CLI::App& program, Call& /*call*/) {
  const auto action = std::make_shared<std::string>("list");
  CLI::App* stored =
      program.add_subcommand("cache",
                             "list or clear the corrections that the model hybrid stores for later "
                             "runs on the same bodies, in $ROLLFEM_CACHE or ~/.cache/rollfem");
  stored->add_option("action", *action, "list (default) or clear")
      ->check(one_of({"list", "clear"}));
  stored->footer("example: rollfem cache clear\nAn empty ROLLFEM_CACHE switches the cache off.");
  stored->callback([action] { cache(*action); });
}

}  // namespace rollfem::app
