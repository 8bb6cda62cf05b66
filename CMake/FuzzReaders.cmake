# Builds the fuzzers of the readers (Testing/Fuzz/Readers) by Clang with libFuzzer, without VTK and
# MPI. Of Grid and Mesher, only the modules that the readers use are compiled (scripts/fuzz).
find_package(EXPAT REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(PNG REQUIRED)
find_package(TIFF REQUIRED)
find_package(ZLIB REQUIRED)
file(GLOB vfm_grid_sources CONFIGURE_DEPENDS
  Grid/Ranks/*.cxx Grid/Base/*.cxx)
add_library(vfm_grid STATIC ${vfm_grid_sources})
target_include_directories(vfm_grid PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/Grid")
target_link_libraries(vfm_grid PUBLIC Eigen3::Eigen PRIVATE vfm_flags)
file(GLOB vfm_mesher_sources CONFIGURE_DEPENDS Mesher/Options/[A-Z]*.cxx Mesher/Input/*.cxx
  Mesher/State/ArrayStems.cxx Mesher/State/StateChoice.cxx Mesher/Summary/UniqueNames.cxx)
add_library(vfm_mesher STATIC ${vfm_mesher_sources})
target_include_directories(vfm_mesher PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/Mesher")
target_link_libraries(vfm_mesher PUBLIC vfm_grid PRIVATE vfm_flags)
add_subdirectory(Shapes)
add_subdirectory(IO)
add_subdirectory(Testing/Fuzz/Readers)
