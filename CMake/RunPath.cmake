# Folders in which installed programs and libraries search for their libraries (RUNPATH).
#
# If the RUNPATH changes when a file is installed, CMake ends the one in the build tree with an empty
# entry. The loader reads an empty entry as the working folder, where anybody may have put a library.
# So both trees have the same RUNPATH: folders relative to the file, then those outside of the project
# that were linked from.
# usage: vfm_set_run_path(TARGET FOLDER ..)
function (vfm_set_run_path target)
  set_target_properties("${target}" PROPERTIES
    BUILD_WITH_INSTALL_RPATH ON
    INSTALL_RPATH_USE_LINK_PATH ON
    INSTALL_RPATH "${ARGN}")
endfunction ()
