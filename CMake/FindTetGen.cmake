# Finds TetGen, which does not install a CMake package, and defines the target TetGen::TetGen. It
# must be version 1.5, because version 1.6 has other settings.
find_path(TETGEN_INCLUDE_DIR tetgen.h)
find_library(TETGEN_LIBRARY tet)
mark_as_advanced(TETGEN_INCLUDE_DIR TETGEN_LIBRARY)
set(TetGen_is_1_5 "")
if (TETGEN_INCLUDE_DIR)
  file(STRINGS "${TETGEN_INCLUDE_DIR}/tetgen.h" TetGen_is_1_5 REGEX "int optlevel;")
endif ()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen
  REQUIRED_VARS TETGEN_LIBRARY TETGEN_INCLUDE_DIR TetGen_is_1_5)
if (TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(TetGen::TetGen PROPERTIES
    IMPORTED_LOCATION "${TETGEN_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${TETGEN_INCLUDE_DIR}")
endif ()
