// SPDX-License-Identifier: LGPL-2.1-or-later
// The finite-element library as the program opens it: OpenBLAS takes kernels as wide as the
// registers of the processor, whether it knows the processor or not.
#include "modelling/fem/fem_library.hpp"

#include "support/test.hpp"
#include <dlfcn.h>

namespace {

#if ROLLFEM_WITH_FEM && defined(__x86_64__)

/// Whether Linux names this ability of the processor.
bool processor_has(const std::string& ability) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line, word; std::getline(file, line);)
    if (line.rfind("flags", 0) == 0)
      for (std::istringstream words(line); words >> word;)
        if (word == ability) return true;
  return false;
}

TEST(FemLibrary, OpenBlasUsesTheWidestRegisters) {
  if (std::getenv("OPENBLAS_CORETYPE") != nullptr) GTEST_SKIP() << "OPENBLAS_CORETYPE is set";
  rollfem::modelling::open_fem_library("this test");
  const auto core_name =
      reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (core_name == nullptr) GTEST_SKIP() << "another BLAS";
  if (processor_has("avx512f") && processor_has("avx512vl"))
    EXPECT_STREQ(core_name(), "SkylakeX");
  else if (processor_has("avx2") && processor_has("fma"))
    EXPECT_STREQ(core_name(), "Haswell");
  else
    EXPECT_STRNE(core_name(), "");
}

#endif

}  // namespace
