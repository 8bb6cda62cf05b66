# Tests of Catalyst 2: a test implementation receives the data passed to libcatalyst.
find_package(catalyst 2.0 REQUIRED COMPONENTS SDK)
add_subdirectory(CatalystDouble EXCLUDE_FROM_ALL)

# usage: vfm_add_catalyst_tests(NAME LABEL)
# Builds NAME.cxx and runs it on one and three ranks with the test implementation.
function (vfm_add_catalyst_tests name label)
  add_executable(${name} ${name}.cxx MpiMain.cxx)
  target_compile_definitions(${name} PRIVATE VFM_SOURCE="${PROJECT_SOURCE_DIR}")
  target_include_directories(${name} PRIVATE CatalystDouble)
  target_link_libraries(${name} PRIVATE vfm_catalyst catalyst::catalyst vfm_flags GTest::gtest)
  # The implementation calls a function of the executable.
  set_target_properties(${name} PROPERTIES ENABLE_EXPORTS ON)
  add_dependencies(${name} catalyst_vfm_double)
  foreach (ranks IN ITEMS 1 3)
    add_test(NAME ranks${ranks}.${name}
      COMMAND "${mpiexec_EXECUTABLE}" --oversubscribe --bind-to none -n "${ranks}"
        "$<TARGET_FILE:${name}>")
    set_tests_properties(ranks${ranks}.${name} PROPERTIES
      ENVIRONMENT "CATALYST_IMPLEMENTATION_NAME=vfm_double;CATALYST_IMPLEMENTATION_PATHS=\
$<TARGET_FILE_DIR:catalyst_vfm_double>;${vfm_mpi_environment}"
      LABELS "${label}"
      TIMEOUT ${vfm_timeout})
  endforeach ()
endfunction ()

vfm_add_catalyst_tests(CatalystNodesTest quick)
add_test(NAME ranks3.CatalystDump
  COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_dump.sh" "$<TARGET_FILE:CatalystHost>"
    "${PROJECT_SOURCE_DIR}/Examples/catalyst_mesh.py" "${CMAKE_CURRENT_BINARY_DIR}/dump")
set_tests_properties(ranks3.CatalystDump PROPERTIES
  ENVIRONMENT "${vfm_mpi_environment}"
  LABELS quick
  TIMEOUT ${vfm_timeout})

# VTK reads the data.
find_package(VTK QUIET PATHS "${VTK_DIR}" NO_DEFAULT_PATH OPTIONAL_COMPONENTS IOCatalystConduit)
if (TARGET VTK::IOCatalystConduit)
  vfm_add_catalyst_tests(CatalystMeshTest full)
  target_sources(CatalystMeshTest PRIVATE LevelBlocks.cxx)
  target_link_libraries(CatalystMeshTest PRIVATE
    vfm_host_blocks VolumeFractionMesh::Filters vfm_parallel VTK::IOCatalystConduit
    VTK::ParallelCore VTK::ParallelMPI VTK::mpi)
else ()
  message(STATUS "CatalystMeshTest is skipped: this VTK lacks the module IOCatalystConduit "
    "(VTK_ENABLE_CATALYST)")
endif ()
