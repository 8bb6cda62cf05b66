# The pages that "?" in a panel opens, made of the server manager's XML.

# Sets the variable to whether Qt's tools are there: they can be links to a chooser with nothing behind, so one is tried. A ParaView with
# Qt 6 makes no pages of plugins.
function (vfm_find_help_tools found)
  if (PARAVIEW_QT_MAJOR_VERSION GREATER 5)
    set("${found}" OFF PARENT_SCOPE)
    message(STATUS "ParaView makes no help pages of plugins with Qt ${PARAVIEW_QT_MAJOR_VERSION}: the plugin has none")
    return ()
  endif ()
  find_package(Qt5 QUIET COMPONENTS Help)
  find_program(qt_xmlpatterns_executable
    NAMES xmlpatterns-qt5 xmlpatterns
    HINTS "${Qt5_DIR}/../../../bin" "${Qt5_DIR}/../../../libexec/qt5/bin"
    DOC "Path to xmlpatterns")
  set(result 1)
  if (Qt5Help_FOUND AND qt_xmlpatterns_executable)
    execute_process(COMMAND "${qt_xmlpatterns_executable}" -version
      RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  endif ()
  if (result EQUAL 0)
    set("${found}" ON PARENT_SCOPE)
  else ()
    set("${found}" OFF PARENT_SCOPE)
    message(STATUS "Qt's help tools (packages qttools5-dev, qtxmlpatterns5-dev-tools) were not found: the plugin has no help pages")
  endif ()
endfunction ()

# Makes the pages of a plugin anew when its XML changed, of which ParaView's rules do not know.
# usage: vfm_renew_help_pages(PLUGIN XML ...)
function (vfm_renew_help_pages plugin)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/paraview_help")
  set(pages "${folder}/${plugin}_doc.xslt")
  add_custom_command(OUTPUT "${pages}" APPEND DEPENDS ${ARGN})
  add_custom_command(OUTPUT "${folder}/${plugin}.qch" APPEND DEPENDS "${pages}")
endfunction ()
