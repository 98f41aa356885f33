// SPDX-License-Identifier: LGPL-2.1-or-later
#include "app/version_text.hpp"

#include "base/errors.hpp"
#include "modelling/fem/fem_library.hpp"
#include "modelling/program/provenance.hpp"

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <fftw3.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>

namespace rollfem::app {

namespace {

std::string line(const char* what, const std::string& text) {
  return fmt::format("{:<16} {}\n", what, text);
}

std::string of_finite_elements() {
  if (!ROLLFEM_WITH_FEM) return line("finite elements", "no (built without deal.II)");
  try {
    const fem::About about = modelling::open_fem_library("--version").about();
    return line("finite elements", about.libraries) +
           line("SIMD", fmt::format("{} (this machine has {})", about.simd_variant,
                                    fmt::join(about.simd_variants, ", "))) +
           line("MPI", about.mpi);
  } catch (const contact::InputError& error) {
    return line("finite elements", fmt::format("no: {}", error.what()));
  }
}

}  // namespace

std::string version_text() {
  unsigned hdf5[3] = {};
  H5get_libversion(&hdf5[0], &hdf5[1], &hdf5[2]);
  // fftw_version is "fftw-3.3.10-sse2-avx".
  const std::string fftw = std::string(fftw_version).substr(5);
  std::string text =
      fmt::format("rollfem {} ({})\n", modelling::version(), modelling::commit()) +
      of_finite_elements() + line("Python module", ROLLFEM_WITH_PYTHON ? "yes" : "no") +
      line("libraries",
           fmt::format("Eigen {}.{}.{}, Boost {}.{}.{}, FFTW {}, HDF5 {}.{}.{}, fmt {}.{}.{}, "
                       "nlohmann/json {}.{}.{}, CLI11 {}",
                       EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                       BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100,
                       fftw.substr(0, fftw.find('-')), hdf5[0], hdf5[1], hdf5[2],
                       FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                       NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                       NLOHMANN_JSON_VERSION_PATCH, CLI11_VERSION));
  text.pop_back();  // CLI11 ends the line
  return text;
}

}  // namespace rollfem::app
