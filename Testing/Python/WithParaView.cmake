# Tests that require ParaView itself: its GUI, servers, filters and readers.
foreach (name IN ITEMS CellCount Colours CurvedCalculix Examples Printed Server)
  vfm_add_python_test(pvpython ParaView ${name} full)
endforeach ()
vfm_add_python_test(pvbatch Filters Pipeline full)
vfm_add_python_test(pvpython Files Saving quick)
# ParaView itself reports an unsupported type of input when the filter is created.
set_tests_properties(pvpython.Errors PROPERTIES FAIL_REGULAR_EXPRESSION "Traceback")

# Files of shock codes, read by ParaView.
if (TARGET ParaView::VTKExtensionsIOSPCTH)
  vfm_add_python_test(pvpython Files SpyPlot full)
  vfm_add_python_test(pvpython Filters ConserveInputs full)
  vfm_add_ranks_test(RankSpyPlot 3 full)
endif ()

# Only rank 0 runs the script.
add_test(NAME ranks4.RankOutputs
  COMMAND "${mpiexec_EXECUTABLE}" --oversubscribe --bind-to none -n 4
    "${pvbatch_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/Ranks/TestRankOutputs.py"
    "${CMAKE_CURRENT_BINARY_DIR}/ranks")
vfm_set_python_properties(ranks4.RankOutputs full)
set_tests_properties(ranks4.RankOutputs PROPERTIES FIXTURES_REQUIRED Ranks)
vfm_add_ranks_test(RankSeries 4 full)

# The ParaView GUI, on a virtual screen.
find_program(xvfb_run_EXECUTABLE xvfb-run REQUIRED)
set(on_screen "${xvfb_run_EXECUTABLE}" -a -s "-screen 0 1280x1024x24 -noreset")
add_test(NAME pvpython.Applies
  COMMAND ${on_screen} "${pvpython_EXECUTABLE}"
    "${CMAKE_CURRENT_SOURCE_DIR}/ParaView/TestApplies.py")
add_test(NAME ranks3.Applies
  COMMAND ${on_screen} "${mpiexec_EXECUTABLE}" --oversubscribe --bind-to none -n 3
    "${pvbatch_EXECUTABLE}" --sym
    "${CMAKE_CURRENT_SOURCE_DIR}/ParaView/TestApplies.py" "${CMAKE_CURRENT_BINARY_DIR}/applies")
foreach (test IN ITEMS pvpython.Applies ranks3.Applies)
  vfm_set_python_properties(${test} full)
  set_tests_properties(${test} PROPERTIES FAIL_REGULAR_EXPRESSION "Traceback") # errors are shown
endforeach ()

find_program(paraview_EXECUTABLE paraview)
if (paraview_EXECUTABLE)
  vfm_add_python_test(pvpython ParaView Window full)
else ()
  message(STATUS "The ParaView GUI (paraview) was not found: its test is skipped")
endif ()

# Finite element solutions on the meshes.
find_program(ccx_EXECUTABLE ccx)
if (ccx_EXECUTABLE)
  vfm_add_python_test(pvpython ParaView Calculix full)
else ()
  message(STATUS "CalculiX (ccx, package calculix-ccx) was not found: its test is skipped")
endif ()

# The figures of the Sculptor report.
file(GLOB figures CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Examples/report/figure_*.py")
foreach (figure IN LISTS figures)
  get_filename_component(name "${figure}" NAME_WE)
  add_test(NAME "report.${name}"
    COMMAND "${pvpython_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/ParaView/TestReport.py"
      "${figure}")
  vfm_set_python_properties("report.${name}" full)
  set_property(TEST "report.${name}" APPEND PROPERTY ENVIRONMENT "BUILD_DIR=${PROJECT_BINARY_DIR}")
endforeach ()
set_tests_properties(report.figure_18 PROPERTIES COST 40) # it begins early, because it is long
