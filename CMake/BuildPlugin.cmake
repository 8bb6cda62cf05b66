# Builds the ParaView plugin. build/lib/VolumeFractionMesh.so is a link to it.
include(CMake/HelpPages.cmake)
paraview_plugin_scan(
  PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS  vfm_plugins
  REQUIRES_MODULES  vfm_plugin_requires
  ENABLE_BY_DEFAULT ON)
set(vfm_plugin_folder plugins)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${vfm_lib_folder}")
paraview_plugin_build(
  PLUGINS              ${vfm_plugins}
  PLUGINS_FILE_NAME    "VolumeFractionMesh.plugins.xml"
  AUTOLOAD             ${vfm_plugins}
  LIBRARY_SUBDIRECTORY "${vfm_plugin_folder}")
file(CREATE_LINK
  "${vfm_plugin_folder}/VolumeFractionMesh/VolumeFractionMesh.so"
  "${vfm_lib_folder}/VolumeFractionMesh.so" SYMBOLIC)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${vfm_lib_folder}/libraries")
