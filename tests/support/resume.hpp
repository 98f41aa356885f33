// What the tests of --resume share: a run that is killed at a chosen moment, and the comparison of
// two results.
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include <functional>

namespace rollfem::testing {

/// Runs a command in the folder, `cache` being that of corrections (empty: none), and ends it by
/// SIGKILL as soon as `moment` has come. `killed` false: it ended before.
struct Killed {
  bool killed = false;
  std::string err;
};

inline Killed kill_when(const Folder& folder, const std::vector<std::string>& command,
                        const std::function<bool()>& moment, const std::string& cache = "") {
  const std::string err = folder.output("stderr_killed").string();
  std::vector<std::string> copy = command;
  std::vector<char*> arguments;
  for (std::string& argument : copy) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const std::string work = folder.work().string();
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    setenv("ROLLFEM_CACHE", cache.c_str(), 1);
    if (chdir(work.c_str()) != 0 || dup2(open("/dev/null", O_WRONLY), 1) < 0 ||
        dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2) < 0)
      _exit(126);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  Killed outcome;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (!outcome.killed && moment()) {
      outcome.killed = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  outcome.err = contents(err);
  return outcome;
}

/// Number of records whose name begins so.
inline int records(const std::filesystem::path& unfinished, const std::string& begin = "") {
  std::error_code error;
  int count = 0;
  for (std::filesystem::directory_iterator entry(unfinished, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->path().extension() == ".point" && name.compare(0, begin.size(), begin) == 0) ++count;
  }
  return count;
}

/// summary.json without times and without what names the call.
inline nlohmann::json timeless_summary(const std::filesystem::path& result) {
  const std::function<void(nlohmann::json&)> strip = [&](nlohmann::json& value) {
    if (value.is_object())
      for (const char* name : {"seconds", "started", "command", "case_file", "checksum"})
        value.erase(name);
    if (value.is_structured())
      for (nlohmann::json& entry : value) strip(entry);
  };
  nlohmann::json summary = nlohmann::json::parse(contents(result / "summary.json"));
  strip(summary);
  return summary;
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
      execute(folder, {"/usr/bin/python3", "-c", script, one.string(), other.string()});
  return outcome.out + outcome.err;
}

inline void expect_same_results(const Folder& folder, const std::filesystem::path& one,
                                const std::filesystem::path& other) {
  const auto difference = nlohmann::json::diff(timeless_summary(one), timeless_summary(other));
  EXPECT_TRUE(difference.empty()) << difference.dump().substr(0, 1000);
  EXPECT_EQ(different_fields(folder, one, other), "");
}

}  // namespace rollfem::testing
