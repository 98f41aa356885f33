// SPDX-License-Identifier: LGPL-2.1-or-later
#include "models/caches/machine_speed.hpp"

#include "models/caches/correction_cache.hpp"
#include "models/program/provenance.hpp"
#include "postprocess/hdf5/named_values.hpp"

#include <filesystem>

namespace rollfem::modelling {

namespace fs = std::filesystem;

fs::path machine_speed_file() {
  const CorrectionCache cache;
  return cache.off() ? fs::path() : cache.folder() / ("bench_" + host_name() + ".h5");
}

std::optional<MachineSpeed> machine_speed() {
  const fs::path path = machine_speed_file();
  std::error_code error;
  if (path.empty() || !fs::exists(path, error)) return {};
  const auto values = postprocess::read_named_values(path);
  if (!values) return {};
  const auto times = values->numbers.find("times");
  const auto made = values->texts.find("made");
  const auto program = values->texts.find("version");
  if (times == values->numbers.end() || made == values->texts.end() ||
      program == values->texts.end() || program->second != version() || !(times->second > 0.0))
    return {};
  return MachineSpeed{times->second, made->second};
}

void keep_machine_speed(const fs::path& file, const MachineSpeed& speed) {
  postprocess::NamedValues values;
  values.numbers["times"] = speed.times;
  values.texts["made"] = speed.made;
  values.texts["version"] = version();
  postprocess::write_named_values(file, values);
}

}  // namespace rollfem::modelling
