include(GoogleTest)

# Each test has one label: unit, quick, full or release. scripts/test selects tests by label.

# Adds the tests of an executable. UNIT and QUICK: patterns of names of tests with this label; all
# others have the label full.
function (vfm_discover_tests target)
  cmake_parse_arguments(arg "" "" "UNIT;QUICK" ${ARGN})
  list(JOIN arg_UNIT ":" unit)
  set(chosen ${arg_UNIT} ${arg_QUICK})
  list(JOIN chosen ":" chosen)
  list(JOIN arg_QUICK ":" quick)
  if (unit)
    gtest_discover_tests(${target}
      TEST_FILTER "${unit}" TEST_LIST ${target}_unit NO_PRETTY_VALUES
      PROPERTIES LABELS unit TIMEOUT ${vfm_timeout})
  endif ()
  if (quick)
    gtest_discover_tests(${target}
      TEST_FILTER "${quick}-${unit}" TEST_LIST ${target}_quick NO_PRETTY_VALUES
      PROPERTIES LABELS quick TIMEOUT ${vfm_timeout})
  endif ()
  if (NOT unit STREQUAL "*")
    gtest_discover_tests(${target}
      TEST_FILTER "*-${chosen}" TEST_LIST ${target}_full NO_PRETTY_VALUES
      PROPERTIES LABELS full TIMEOUT ${vfm_timeout})
  endif ()
endfunction ()
set(vfm_timeout 900) # long for shared machines; ends ranks that wait for each other
