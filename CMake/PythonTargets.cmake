# Debian 13's ParaView says of its Python modules that they are NAME.so where they are NAME.cpython-313-x86_64-linux-gnu.so, and
# find_package ends there. Copies of those few files with the names mended, included before, make the targets; the package's own files
# leave targets alone that are there.

# Mends what lies in a folder of a VTK's or ParaView's CMake files, where it needs that.
function (vfm_mend_python_targets folder)
  file(GLOB prefix_file "${folder}/*-prefix.cmake")
  file(GLOB parts RELATIVE "${folder}" "${folder}/*Python*-targets-*.cmake") # one of each configuration
  if (NOT prefix_file OR NOT parts)
    return ()
  endif ()
  include("${prefix_file}")
  set(copies "${CMAKE_BINARY_DIR}/CMakeFiles/python_targets")
  foreach (part IN LISTS parts)
    file(READ "${folder}/${part}" text)
    string(REGEX MATCH "_IMPORT_PREFIX}([^\"]*)\\.so\"" module "${text}")
    set(module "${_vtk_module_import_prefix}${CMAKE_MATCH_1}")
    file(GLOB file "${module}.*.so")
    if (EXISTS "${module}.so" OR NOT file)
      continue ()
    endif ()
    string(REPLACE "${module}" "" suffix "${file}")
    string(REPLACE ".so\"" "${suffix}\"" text "${text}")
    file(WRITE "${copies}/${part}" "${text}")
    string(REGEX REPLACE "-targets-.*" "-targets.cmake" whole "${part}")
    file(READ "${folder}/${whole}" text)
    string(REPLACE "\${CMAKE_CURRENT_LIST_FILE}" "${folder}/${whole}" text "${text}") # which tells where the package is
    file(WRITE "${copies}/${whole}" "${text}")
    include("${copies}/${whole}")
  endforeach ()
endfunction ()

# The same in ParaView's own folder and that of its VTK; where they lie is told by a small file there that names no targets.
macro (vfm_mend_paraview)
  find_package(ParaViewFolder QUIET NAMES ParaView CONFIGS paraview-prefix.cmake HINTS "${ParaView_DIR}")
  mark_as_advanced(ParaViewFolder_DIR)
  vfm_mend_python_targets("${ParaViewFolder_DIR}/vtk")
  vfm_mend_python_targets("${ParaViewFolder_DIR}")
endmacro ()
