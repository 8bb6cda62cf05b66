# Compiler flags of all code of the project. Every target links vfm_flags privately.
option(VFM_WERROR "Treat compiler warnings as errors" OFF)
set(VFM_SANITIZE "" CACHE STRING "Sanitizers of GCC and Clang: address,undefined or thread")

# Meshes are bitwise identical on x86-64 and ARM: -ffp-contract=off keeps the compiler from fusing
# products and sums, EIGEN_DONT_VECTORIZE keeps Eigen from it, which does so on ARM.
add_library(vfm_flags INTERFACE)
target_compile_options(vfm_flags INTERFACE
  -Wall -Wextra -ffp-contract=off -DEIGEN_DONT_VECTORIZE)
# GCC 12 takes the inlined strings of C++20 for overlapping ones: gcc.gnu.org/PR105651.
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(vfm_flags INTERFACE -Wno-restrict)
endif ()
if (VFM_WERROR)
  target_compile_options(vfm_flags INTERFACE -Werror)
endif ()

include("${CMAKE_CURRENT_LIST_DIR}/Hardening.cmake")

# All code of a program must be instrumented. The first report ends the program.
if (VFM_SANITIZE)
  add_compile_options("-fsanitize=${VFM_SANITIZE}" -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<COMPILE_LANGUAGE:CXX>:-D_GLIBCXX_ASSERTIONS>)
  add_link_options("-fsanitize=${VFM_SANITIZE}")
endif ()

# Precompiles headers of the standard library, which saves a fifth of the time. Not with ccache,
# which then finds more in its cache, and so that missing includes are found.
function (vfm_precompile_headers target)
  if (NOT CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    target_precompile_headers("${target}" PRIVATE
      <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <string> <tuple>
      <utility> <vector>)
  endif ()
endfunction ()

# Compiles sources with vectors of four doubles (Base/Lanes.h). Functions with them are always
# inlined, so their ABI does not matter. Clang rejects precompiled headers of other options.
function (vfm_use_lanes)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_OPTIONS "-Wno-psabi;-fno-math-errno" SKIP_PRECOMPILE_HEADERS ON)
endfunction ()

# Installs a library of the component Mesher as VolumeFractionMesh::NAME, with headers by their names
# in its include folder `folder`: those that users include and what these include, which
# Testing/Structure checks. It does not link vfm_flags, which is not installed. Inline functions of
# the headers must produce bitwise identical results in other projects too.
# usage: vfm_install_library(TARGET NAME FOLDER HEADER ..)
function (vfm_install_library target name folder)
  target_compile_features("${target}" PUBLIC cxx_std_20)
  target_compile_options("${target}"
    PRIVATE "$<TARGET_PROPERTY:vfm_flags,INTERFACE_COMPILE_OPTIONS>"
    INTERFACE "$<INSTALL_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>>")
  set_target_properties("${target}" PROPERTIES EXPORT_NAME "${name}")
  install(TARGETS "${target}" EXPORT Mesher
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INCLUDES DESTINATION "${vfm_headers_folder}")
  foreach (header IN LISTS ARGN)
    get_filename_component(module "${header}" DIRECTORY)
    install(FILES "${folder}/${header}" DESTINATION "${vfm_headers_folder}/${module}")
  endforeach ()
endfunction ()
