#include "app/program.hpp"
#include "models/registry.hpp"

int main(int argc, char** argv) {
  return rollfem::app::run_program(argc, argv, rollfem::modelling::built_in_models());
}
