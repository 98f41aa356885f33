#include "models/fem/session.hpp"

namespace rollfem::modelling {

ParallelSession::ParallelSession(const std::string& asked_by, int argc, char** argv)
    : entry_(open_fem_library(asked_by)) {
  entry_.start(argc, argv);
}

ParallelSession::~ParallelSession() {
  entry_.stop();
}

}  // namespace rollfem::modelling
