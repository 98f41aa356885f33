# SPDX-License-Identifier: LGPL-2.1-or-later
# Run at every build: writes modelling/version.cpp with the current commit, and touches it only when that
# changed. Wants SOURCE, OUTPUT and ROLLFEM_VERSION.
find_program(GIT git)
set(ROLLFEM_COMMIT "")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=12
    OUTPUT_VARIABLE ROLLFEM_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT ROLLFEM_COMMIT)
  set(ROLLFEM_COMMIT "unknown")
endif()
configure_file(${SOURCE}/modelling/program/version.cpp.in ${OUTPUT} @ONLY)
