# SPDX-License-Identifier: LGPL-2.1-or-later
# One call makes a folder a module: rollfem_module(contact DEPENDS ... LIBRARIES ...) builds all its
# .cpp files into librollfem_contact.so and exports it as rollfem::contact. Headers that are installed:
# bindings/interface/public_headers.txt.
function(rollfem_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual $<$<BOOL:${ROLLFEM_WERROR}>:-Werror>)
endfunction()

# Headers of deal.II, Eigen and CLI11 are read once for several files: a whole build takes half the
# time, a build after a change of one file longer.
function(rollfem_batches target)
  if(ROLLFEM_UNITY)
    # Files of one batch see each other's unnamed namespaces, and inlined across files GCC 12 sees
    # overflows in fmt that are none: no fault of theirs.
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    target_compile_options(${target} PRIVATE -Wno-shadow
      $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local -Wno-subobject-linkage -Wno-stringop-overflow>)
  endif()
endfunction()

# What parses, prints and writes but crunches no numbers is compiled in two thirds of the time this way.
function(rollfem_light target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# A library of the given sources, with what all of them share.
function(rollfem_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  set(target rollfem_${name})
  add_library(${target} SHARED ${ARG_SOURCES})
  add_library(rollfem::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rollfem>)
  foreach(dependency ${ARG_DEPENDS})
    target_link_libraries(${target} PUBLIC rollfem_${dependency})
  endforeach()
  target_link_libraries(${target} PUBLIC ${ARG_LIBRARIES} PRIVATE ${ARG_PRIVATE_LIBRARIES})
  rollfem_warnings(${target})
  rollfem_batches(${target})
  install(TARGETS ${target} EXPORT rollfem-targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# Sources of the folder and of the rooms in it. EXCEPT: those that belong to another library of it.
function(rollfem_module name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES;PRIVATE_LIBRARIES;EXCEPT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.hpp)
  list(REMOVE_ITEM sources "" ${ARG_EXCEPT})
  rollfem_library(${name} SOURCES ${sources} ${headers} DEPENDS ${ARG_DEPENDS}
    LIBRARIES ${ARG_LIBRARIES} PRIVATE_LIBRARIES ${ARG_PRIVATE_LIBRARIES})
endfunction()
