// The short table that `run` prints: patch and pressure of every model, and the creep curves.
#pragma once

#include "contact/result/result.hpp"

#include <string>
#include <vector>

namespace rollfem::app {

std::string run_table(const std::vector<contact::ModelResult>& models);

}  // namespace rollfem::app
