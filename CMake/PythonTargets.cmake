# Workaround for ParaView of Debian 13. Its CMake files expect Python modules NAME.so, but
# the modules are named NAME.cpython-313-x86_64-linux-gnu.so, and find_package fails.
# Corrected copies of these files are included first and define the targets. The files of
# the package skip targets that exist.

# Corrects the files in a CMake folder of VTK or ParaView, if necessary.
function (vfm_correct_python_targets folder)
  file(GLOB prefix_file "${folder}/*-prefix.cmake")
  # There is one file per configuration.
  file(GLOB parts RELATIVE "${folder}" "${folder}/*Python*-targets-*.cmake")
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
    # The file computes the folder of the package from its own path.
    string(REPLACE "\${CMAKE_CURRENT_LIST_FILE}" "${folder}/${whole}" text "${text}")
    file(WRITE "${copies}/${whole}" "${text}")
    include("${copies}/${whole}")
  endforeach ()
endfunction ()

# Corrects the files in the CMake folders of ParaView and of its VTK. They are found by a small
# file that does not define targets.
macro (vfm_correct_paraview)
  find_package(ParaViewFolder QUIET NAMES ParaView CONFIGS paraview-prefix.cmake
    HINTS "${ParaView_DIR}")
  mark_as_advanced(ParaViewFolder_DIR)
  vfm_correct_python_targets("${ParaViewFolder_DIR}/vtk")
  vfm_correct_python_targets("${ParaViewFolder_DIR}")
endmacro ()
