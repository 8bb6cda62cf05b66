# Files for find_package(VolumeFractionMesh) in the build tree and in the installed tree. Each
# component has its own export, so a project that uses one component does not need the libraries of
# the others. vtk_module_build exports Filters and IO.
include(CMakePackageConfigHelpers)
set(vfm_exports sculptor Mesher)
if (TARGET vfm_catalyst)
  list(APPEND vfm_exports Catalyst)
endif ()
foreach (component IN LISTS vfm_exports)
  set(file "VolumeFractionMesh-${component}-targets.cmake")
  export(EXPORT "${component}" NAMESPACE VolumeFractionMesh::
    FILE "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/${file}")
  set(installed_with Unspecified)
  if (component STREQUAL "sculptor")
    set(installed_with libsculptor-dev)
  endif ()
  install(EXPORT "${component}" NAMESPACE VolumeFractionMesh::
    FILE "${file}" DESTINATION "${vfm_cmake_folder}" COMPONENT "${installed_with}")
endforeach ()
set(vfm_exported ${vfm_exports})
if (vfm_module_export)
  list(APPEND vfm_exported Filters IO)
endif ()

configure_file(CMake/VolumeFractionMeshConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/VolumeFractionMeshConfig.cmake" @ONLY)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/VolumeFractionMeshConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
set(vfm_own_files FindTetGen.cmake PythonTargets.cmake)
foreach (file IN LISTS vfm_own_files)
  configure_file("CMake/${file}" "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/${file}" COPYONLY)
endforeach ()
list(TRANSFORM vfm_own_files PREPEND CMake/)
install(FILES
    "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/VolumeFractionMeshConfig.cmake"
    "${CMAKE_BINARY_DIR}/${vfm_cmake_folder}/VolumeFractionMeshConfigVersion.cmake"
    ${vfm_own_files}
  DESTINATION "${vfm_cmake_folder}" COMPONENT libsculptor-dev)
