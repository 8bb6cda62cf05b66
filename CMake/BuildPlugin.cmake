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
if (vfm_shared_modules) # links to the libraries, for the RUNPATH of the plugin
  set(folder "${VFM_PLUGIN_FOLDER}/VolumeFractionMesh")
  file(RELATIVE_PATH up "/lib/${folder}" "/lib")
  string(REGEX REPLACE "/$" "" up "${up}")
  set(installed_link "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/plugin_libraries/libraries")
  foreach (link IN ITEMS "${vfm_lib_folder}/${folder}/libraries" "${installed_link}")
    get_filename_component(parent "${link}" DIRECTORY)
    file(MAKE_DIRECTORY "${parent}")
  endforeach ()
  file(CREATE_LINK "${up}/libraries" "${vfm_lib_folder}/${folder}/libraries" SYMBOLIC)
  file(CREATE_LINK "${up}" "${installed_link}" SYMBOLIC)
  install(FILES "${installed_link}" DESTINATION "${CMAKE_INSTALL_LIBDIR}/${folder}")
endif ()
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME Unspecified)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${vfm_lib_folder}/libraries")
set(BUILD_SHARED_LIBS "${vfm_shared_modules}")
