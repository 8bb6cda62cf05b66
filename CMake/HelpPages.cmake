# Help pages, which "?" in a panel opens. ParaView makes them from the XML of the server manager.

# Sets the variable `found` to whether the tools that ParaView makes help pages with were found.
# They are part of Qt 5, since ParaView 6 of Qt 6. A tool of Qt 5 can be a link to qtchooser without
# the tool itself, so one tool is run.
function (vfm_find_help_tools found)
  set(qt Qt5) # ParaView 5.11 does not set PARAVIEW_QT_MAJOR_VERSION
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
    message(STATUS "The plugin is built without help pages: ParaView ${ParaView_VERSION} "
      "does not make them with ${qt}")
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
    message(STATUS "The plugin is built without help pages: the tools of ParaView for them "
      "(packages ${packages}) were not found")
  endif ()
endfunction ()

# Makes the help pages of a plugin again after its XML changed.
# ParaView's rules lack this dependency.
# usage: vfm_renew_help_pages(PLUGIN XML ...)
function (vfm_renew_help_pages plugin)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/paraview_help")
  set(pages "${folder}/${plugin}_doc.xslt")
  add_custom_command(OUTPUT "${pages}" APPEND DEPENDS ${ARGN})
  add_custom_command(OUTPUT "${folder}/${plugin}.qch" APPEND DEPENDS "${pages}")
endfunction ()
