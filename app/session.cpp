#include "app/session.hpp"

namespace rollfem::app {

ParallelSession::ParallelSession(const std::string& asked_by, int argc, char** argv)
    : entry_(open_fem_library(asked_by)) {
  entry_.start(argc, argv);
}

ParallelSession::~ParallelSession() {
  entry_.stop();
}

}  // namespace rollfem::app
