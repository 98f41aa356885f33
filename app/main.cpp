#include "app/models.hpp"
#include "app/program.hpp"

int main(int argc, char** argv) {
  return rollfem::app::run_program(argc, argv, rollfem::app::built_in_models());
}
