// The C entry through which the program reaches this library after opening it at run time.
#include "fem/model/model.hpp"

#include <deal.II/base/mpi.h>

#include <memory>

namespace {

std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> session;

void start(int& argc, char**& argv) {
  // One thread in deal.II: the cores go to MPI processes and to the two bodies solved side by side.
  if (!session) session = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(argc, argv, 1);
}

void stop() {
  session.reset();
}

int process() {
  return static_cast<int>(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
}

std::string from_first(const std::string& text) {
  return dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, text);
}

const rollfem::fem::Entry entry{
    start, stop, process, from_first, rollfem::fem::run_fem, rollfem::fem::mesh_case};

}  // namespace

extern "C" const rollfem::fem::Entry* rollfem_fem_entry() {
  return &entry;
}
