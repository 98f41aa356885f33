// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/caches/machine_speed.hpp"

#include "contact/result/record.hpp"
#include "models/caches/correction_cache.hpp"
#include "models/program/provenance.hpp"
#include "postprocess/files/files_together.hpp"
#include "postprocess/files/seal.hpp"

#include <filesystem>

namespace rollfem::modelling {

namespace fs = std::filesystem;

fs::path machine_speed_file() {
  const CorrectionCache cache;
  return cache.off() ? fs::path() : cache.folder() / ("bench_" + host_name());
}

std::optional<MachineSpeed> machine_speed() {
  const fs::path path = machine_speed_file();
  std::error_code error;
  if (path.empty() || !fs::exists(path, error)) return {};
  const auto bytes = postprocess::opened_record(version(), postprocess::contents_of(path));
  if (!bytes) return {};
  MachineSpeed speed;
  contact::Record(*bytes).values(speed.times, speed.made);
  if (!(speed.times > 0.0)) return {};
  return speed;
}

void keep_machine_speed(const fs::path& file, MachineSpeed speed) {
  postprocess::replace_file(
      file, postprocess::sealed_record(version(), contact::record_of(speed.times, speed.made)));
}

}  // namespace rollfem::modelling
