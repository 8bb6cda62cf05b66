# Python for tests on one and on several ranks. With the plugin it is ParaView's Python, otherwise
# plain Python with VTK. Then vtk_simple.py replaces paraview.simple and skips tests that require
# ParaView itself.
set(vfm_python_environment
  "VFM_WRAPPERS=${vfm_lib_folder}/python3/dist-packages" "VFM_SCULPTOR=$<TARGET_FILE:sculptor>"
  "VFM_OPTIONS=$<TARGET_FILE:describe_options>"
  "PYTHONPATH=${CMAKE_CURRENT_SOURCE_DIR}/Python:${CMAKE_CURRENT_SOURCE_DIR}/Support/QuickStart"
  PYTHONDONTWRITEBYTECODE=1 ${vfm_mpi_environment})
if (VFM_PLUGIN)
  set(vfm_python pvpython)
  set(vfm_ranks_python "${pvbatch_EXECUTABLE}" --sym)
  list(APPEND vfm_python_environment "VFM_PLUGIN=$<TARGET_FILE:VolumeFractionMesh>")
else ()
  set(vfm_python python3)
  set(python3_EXECUTABLE "${Python3_EXECUTABLE}") # the Python of VTK
  set(vfm_ranks_python "${python3_EXECUTABLE}")
endif ()

# Sets the properties of all Python tests. A failed pipeline does not change the exit status, so
# tests fail by the text of its messages.
function (vfm_set_python_properties test label)
  set_tests_properties("${test}" PROPERTIES
    ENVIRONMENT
      "${vfm_python_environment};OMPI_MCA_orte_tmpdir_base=${PROJECT_BINARY_DIR}/Testing/mpi/${test}"
    FAIL_REGULAR_EXPRESSION "ERR\\|;Traceback"
    LABELS "${label}"
    TIMEOUT ${vfm_timeout})
endfunction ()
