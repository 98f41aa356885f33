#include "models/program/provenance.hpp"

#include "models/program/version.hpp"

#include <chrono>
#include <ctime>
#include <unistd.h>

namespace rollfem::modelling {

namespace {

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

}  // namespace

postprocess::Provenance provenance_of(const contact::ModelRegistry& models,
                                      const std::string& command) {
  postprocess::Provenance made;
  made.version = version();
  made.commit = commit();
  made.host = host_name();
  made.started = utc_now();
  made.command = command;
  for (const contact::ModelInfo& model : models.all()) made.labels[model.name] = model.label;
  return made;
}

}  // namespace rollfem::modelling
