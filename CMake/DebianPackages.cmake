# Debian packages, made by `cpack -G DEB`: the program, the library and its headers, the plugin.
# usage: scripts/package
# A build with TetGen makes packages NAME-tetgen, which replace the others; their licence is the AGPL.
set(variant "")
set(vfm_license "BSD-3-Clause")
set(vfm_license_comment "")
if (VFM_ENABLE_TETGEN)
  set(variant "-tetgen")
  set(vfm_license "AGPL-3.0-or-later")
  set(vfm_license_comment "Comment: linked with TetGen, which is under the GNU Affero General Public\n License 3 or later (https://www.gnu.org/licenses/agpl-3.0), and so is this binary.\n The sources of this project are under the BSD licence below.\n")
endif ()
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" vfm_license_text)
string(REGEX REPLACE "\n\n" "\n.\n" vfm_license_text "${vfm_license_text}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" vfm_license_text "${vfm_license_text}")
file(STRINGS /etc/os-release release REGEX "^VERSION_ID=")
string(REGEX REPLACE "[^0-9]" "" release "${release}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~deb${release}")
set(CPACK_PACKAGE_CONTACT "The VolumeFractionMesh authors <maintainers@volume-fraction-mesh.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIBSCULPTOR_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/CMake/debian/triggers")
set(CPACK_COMPONENTS_ALL "")
set(files "${PROJECT_BINARY_DIR}/package-files")

# Adds a package of the installed files of a component.
# usage: vfm_add_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION)
macro (vfm_add_package component name section summary description)
  string(TOUPPER "${component}" upper)
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}${variant}")
  if (variant)
    set(CPACK_DEBIAN_${upper}_PACKAGE_PROVIDES "${name}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONFLICTS "${name}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_REPLACES "${name}")
  endif ()
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${description}")
  set(vfm_package "${name}${variant}")
  foreach (file IN ITEMS changelog.Debian copyright)
    configure_file("CMake/debian/${file}.in" "${files}/${vfm_package}/${file}" @ONLY)
  endforeach ()
  execute_process(COMMAND gzip -9nf "${files}/${vfm_package}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${files}/${vfm_package}/changelog.Debian.gz" "${files}/${vfm_package}/copyright"
    DESTINATION "share/doc/${vfm_package}" COMPONENT "${component}")
endmacro ()

# The manual page is the text of --help.
find_program(help2man_EXECUTABLE help2man REQUIRED)
set(page "${files}/sculptor.1")
add_custom_command(OUTPUT "${page}.gz"
  COMMAND "${help2man_EXECUTABLE}" --no-info --section=1 --output "${page}"
    "--name=makes meshes from volume fractions" "$<TARGET_FILE:sculptor>"
  COMMAND gzip -9nf "${page}"
  DEPENDS sculptor)
add_custom_target(manual_page ALL DEPENDS "${page}.gz")
add_dependencies(user manual_page)
install(FILES "${page}.gz" DESTINATION share/man/man1 COMPONENT sculptor)

# ParaView loads plugins that it finds listed: on Debian 13 in a file that its own list names, on
# Debian 12, where it has no list, in one beside its programs.
get_filename_component(paraview_folder "/usr/${CMAKE_INSTALL_LIBDIR}/${VFM_PLUGIN_FOLDER}" DIRECTORY)
if (EXISTS "${paraview_folder}/paraview.conf")
  set(plugin_file "${VFM_PLUGIN_FOLDER}/VolumeFractionMesh/VolumeFractionMesh.so")
  file(WRITE "${files}/plugins" "<?xml version=\"1.0\"?>\n<Plugins>\n"
    "  <Plugin name=\"VolumeFractionMesh\" auto_load=\"1\"\n"
    "    filename=\"/usr/${CMAKE_INSTALL_LIBDIR}/${plugin_file}\"/>\n</Plugins>\n")
  install(FILES "${files}/plugins" DESTINATION share/paraview COMPONENT plugin)
else ()
  file(WRITE "${files}/paraview.conf"
    "../${CMAKE_INSTALL_LIBDIR}/${VFM_PLUGIN_FOLDER}/VolumeFractionMesh.plugins.xml\n")
  install(FILES "${files}/paraview.conf" DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT plugin)
endif ()

set(text "Turns volume fractions on Cartesian and AMR grids into conforming hexahedral\n"
  "and tetrahedral meshes of every material, on any number of MPI ranks.")
string(JOIN "" text ${text})
vfm_add_package(sculptor sculptor science
  "meshes from volume fractions: command-line program" "${text}")
vfm_add_package(libsculptor libsculptor0 libs
  "meshes from volume fractions: library for simulations" "${text}")
vfm_add_package(libsculptor-dev libsculptor-dev libdevel
  "meshes from volume fractions: headers for C, C++ and Fortran" "${text}")
vfm_add_package(plugin paraview-volume-fraction-mesh science
  "meshes from volume fractions: plugin of ParaView" "${text}")
set(CPACK_DEBIAN_LIBSCULPTOR-DEV_PACKAGE_DEPENDS
  "libsculptor0${variant} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libopenmpi-dev")
set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS python3-paraview)
include(CPack)
