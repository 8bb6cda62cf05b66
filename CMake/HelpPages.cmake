# The pages that "?" in a panel opens, made of the server manager's XML.

# Sets the variable to whether the tools are there that ParaView makes pages with: of Qt 5, which can be links to a chooser with nothing
# behind, so one is tried; of Qt 6 since ParaView 6.
function (vfm_find_help_tools found)
  set(qt Qt5) # ParaView 5.11 does not tell
  if (PARAVIEW_QT_MAJOR_VERSION GREATER 5)
    set(qt "Qt${PARAVIEW_QT_MAJOR_VERSION}")
  endif ()
  set("${found}" OFF PARENT_SCOPE)
  if (qt STREQUAL "Qt5")
    set(packages "qttools5-dev, qtxmlpatterns5-dev-tools")
    find_package(Qt5 QUIET COMPONENTS Help)
    find_program(qt_xmlpatterns_executable
      NAMES xmlpatterns-qt5 xmlpatterns
      HINTS "${Qt5_DIR}/../../../bin" "${Qt5_DIR}/../../../libexec/qt5/bin"
      DOC "Path to xmlpatterns")
    set(tool "${qt_xmlpatterns_executable}" -version)
  elseif (ParaView_VERSION VERSION_LESS 6)
    message(STATUS "ParaView ${ParaView_VERSION} makes no help pages of plugins with ${qt}: the plugin has none")
    return ()
  else ()
    set(packages "qt6-tools-dev, qt6-documentation-tools, xsltproc")
    find_package("${qt}" QUIET COMPONENTS Help Tools)
    find_program(ParaViewClient_xsltproc_executable xsltproc DOC "Path to xsltproc")
    set(tool "${ParaViewClient_xsltproc_executable}" --version)
  endif ()
  execute_process(COMMAND ${tool} RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if ("${${qt}Help_FOUND}" AND result EQUAL 0)
    set("${found}" ON PARENT_SCOPE)
  else ()
    message(STATUS "The tools that ParaView makes help pages with (packages ${packages}) were not found: the plugin has none")
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
