# Scans the VTK modules of the project and finds VTK with all components that they and the programs
# need: the VTK of ParaView for the plugin, otherwise a plain VTK.
include(CMake/PythonTargets.cmake)
if (VFM_PLUGIN)
  vfm_correct_paraview()
  # Components are named so that Qt is not required.
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager
    OPTIONAL_COMPONENTS VTKExtensionsIOSPCTH)
  set(vfm_vtk_place PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
else ()
  find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore) # for the scan
  set(vfm_vtk_place "")
endif ()

vtk_module_scan(
  MODULE_FILES
    "${PROJECT_SOURCE_DIR}/Filters/vtk.module"
    "${PROJECT_SOURCE_DIR}/Filters/Files/vtk.module"
  REQUEST_MODULES      VolumeFractionMesh::Filters VolumeFractionMesh::IO
  PROVIDES_MODULES     vfm_modules
  REQUIRES_MODULES     vfm_required
  UNRECOGNIZED_MODULES vfm_unrecognized
  ENABLE_TESTS         OFF)
set(vfm_components ${vfm_required})
list(TRANSFORM vfm_components REPLACE "^VTK::" "" REGEX "^VTK::")

set(vfm_program_components CommonCore IOCore IOLegacy IOXML ParallelMPI)
if (VFM_PLUGIN OR VFM_WRAP_PYTHON) # Catalyst also runs Python
  list(APPEND vfm_program_components Python WrappingPythonCore)
endif ()
find_package(VTK REQUIRED ${vfm_vtk_place} COMPONENTS ${vfm_components} ${vfm_program_components})
message(STATUS "VTK ${VTK_VERSION}: ${VTK_DIR}")
