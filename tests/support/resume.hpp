// SPDX-License-Identifier: LGPL-2.1-or-later
// Common parts of the tests of --resume: a run killed at a chosen moment, and the comparison of two
// results.
#pragma once

#include "support/program.hpp"

namespace rollfem::testing {

/// Runs a command and ends it by SIGKILL as soon as `moment` has come, which it must outlast.
inline void kill_when(const Folder& folder, const std::vector<std::string>& command,
                      const std::function<bool()>& moment,
                      const std::vector<std::string>& environment = {}) {
  const Outcome outcome =
      folder.execute(command, environment, [&] { return moment() ? SIGKILL : 0; });
  EXPECT_EQ(outcome.status, 128 + SIGKILL) << outcome.err;
}

/// Number of records whose name is one of those.
inline int records(const std::filesystem::path& unfinished,
                   const std::function<bool(const std::string& name)>& counts) {
  std::error_code error;
  int count = 0;
  for (std::filesystem::directory_iterator entry(unfinished, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->path().extension() == ".point" && counts(name)) ++count;
  }
  return count;
}

/// Number of records whose name begins with a prefix.
inline int records(const std::filesystem::path& unfinished, const std::string& begin = "") {
  return records(unfinished, [&](const std::string& name) { return name.rfind(begin, 0) == 0; });
}

/// A JSON file of a result without times and without data that identify the call.
inline nlohmann::json timeless(const std::filesystem::path& file) {
  const std::function<void(nlohmann::json&)> strip = [&](nlohmann::json& value) {
    if (value.is_object())
      for (const char* name : {"seconds", "started", "command", "case_file", "checksum", "choice"})
        value.erase(name);
    if (value.is_structured())
      for (nlohmann::json& entry : value) strip(entry);
  };
  nlohmann::json all = nlohmann::json::parse(contents(file));
  strip(all);
  return all;
}

/// Names of the datasets that are not the same to the last bit; "" when all are.
inline std::string different_fields(const Folder& folder, const std::filesystem::path& one,
                                    const std::filesystem::path& other) {
  const std::string script =
      "import h5py, sys\n"
      "a, b = (h5py.File(f + '/results.h5', 'r') for f in sys.argv[1:3])\n"
      "names = []\n"
      "a.visititems(lambda n, o: names.append(n) if isinstance(o, h5py.Dataset) else None)\n"
      "fields = 0\n"
      "for n in names:\n"
      "    if n.startswith('provenance') or 'seconds' in n: continue\n"
      "    fields += 1\n"
      "    x, y = a[n][()], b[n][()] if n in b else None\n"
      "    bits = lambda v: v.tobytes() if getattr(v, 'dtype', object) != object else list(v)\n"
      "    if y is None or bits(x) != bits(y): print(n)\n"
      "if fields < 10: print('only', fields, 'fields')\n";
  const Outcome outcome =
      folder.execute({"/usr/bin/python3", "-c", script, one.string(), other.string()});
  return outcome.out + outcome.err;
}

inline void expect_same_results(const Folder& folder, const std::filesystem::path& one,
                                const std::filesystem::path& other) {
  const auto difference =
      nlohmann::json::diff(timeless(one / "summary.json"), timeless(other / "summary.json"));
  EXPECT_TRUE(difference.empty()) << difference.dump().substr(0, 1000);
  EXPECT_EQ(different_fields(folder, one, other), "");
}

}  // namespace rollfem::testing
