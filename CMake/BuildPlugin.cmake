# Builds the ParaView plugin. build/lib/VolumeFractionMesh.so is a link to it.
include(CMake/HelpPages.cmake)
set(vfm_shared_modules "${BUILD_SHARED_LIBS}")
set(BUILD_SHARED_LIBS ON) # ParaView loads plugins
paraview_plugin_scan(
  PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS  vfm_plugins
  REQUIRES_MODULES  vfm_plugin_requires
  ENABLE_BY_DEFAULT ON)
set(VFM_PLUGIN_FOLDER plugins CACHE STRING "Folder of the installed plugin, below lib")
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME plugin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${vfm_lib_folder}")
paraview_plugin_build(
  PLUGINS              ${vfm_plugins}
  PLUGINS_FILE_NAME    "VolumeFractionMesh.plugins.xml"
  AUTOLOAD             ${vfm_plugins}
  LIBRARY_SUBDIRECTORY "${VFM_PLUGIN_FOLDER}")
file(CREATE_LINK
  "${VFM_PLUGIN_FOLDER}/VolumeFractionMesh/VolumeFractionMesh.so"
  "${vfm_lib_folder}/VolumeFractionMesh.so" SYMBOLIC)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME Unspecified)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${vfm_lib_folder}/libraries")
set(BUILD_SHARED_LIBS "${vfm_shared_modules}")
