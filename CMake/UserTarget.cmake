# Target `user`: everything that is installed and the simulation impact, without tests and
# benchmarks. To be included before their targets are added.

# Appends the targets that `all` builds in a source folder and in folders below to a list.
# usage: vfm_append_targets(LIST FOLDER)
function (vfm_append_targets list folder)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  foreach (target IN LISTS targets)
    get_target_property(type "${target}" TYPE)
    get_target_property(excluded "${target}" EXCLUDE_FROM_ALL)
    if (NOT type STREQUAL "INTERFACE_LIBRARY" AND NOT excluded)
      list(APPEND "${list}" "${target}")
    endif ()
  endforeach ()
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach (subfolder IN LISTS folders)
    vfm_append_targets("${list}" "${subfolder}")
  endforeach ()
  set("${list}" "${${list}}" PARENT_SCOPE)
endfunction ()

vfm_append_targets(vfm_user_targets "${PROJECT_SOURCE_DIR}")
add_custom_target(user COMMENT "What users run, without tests")
add_dependencies(user ${vfm_user_targets})
