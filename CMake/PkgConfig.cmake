# Configures NAME.pc.in twice: for the installed tree, which may be moved, and as
# NAME-uninstalled.pc in lib/pkgconfig of the build tree. pkg-config prefers uninstalled files.
# usage: vfm_add_pkg_config(NAME headers of the installed tree, headers of the source tree ...)
function (vfm_add_pkg_config name installed_headers)
  file(RELATIVE_PATH up "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" /prefix)
  string(REGEX REPLACE "/$" "" up "${up}")
  set(prefix "\${pcfiledir}/${up}")
  set(libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(includedir "\${prefix}/${installed_headers}")
  set(headers "-I\${includedir}")
  configure_file("${name}.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${name}.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

  set(prefix "${CMAKE_BINARY_DIR}")
  set(libdir "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
  list(GET ARGN 0 includedir)
  list(TRANSFORM ARGN PREPEND "-I" OUTPUT_VARIABLE headers)
  list(JOIN headers " " headers)
  configure_file("${name}.pc.in"
    "${vfm_lib_folder}/pkgconfig/${name}-uninstalled.pc" @ONLY)
endfunction ()
