#!/usr/bin/env bash
# Uses the project from outside as CMake and pkg-config offer it: from the build tree, and from an installed tree that was moved; each component
# by a small project of its own.
# usage: test_package.sh SOURCE BUILD SCRATCH
set -euo pipefail
source="$1" build="$2" scratch="$3"
rm -rf "$scratch"
mkdir -p "$scratch/first"
cmake --install "$build" --prefix "$scratch/first/prefix" > "$scratch/install.log"
mv "$scratch/first" "$scratch/moved"
PYTHONDONTWRITEBYTECODE=1 python3 "$source/Testing/Package/check_built_files.py" "$scratch/moved/prefix"
cd "$scratch"
. "$source/Testing/InSitu/from_outside.sh"
packages="$source/Testing/InSitu/package"
flags=(-DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror -DOMPI_SKIP_MPICXX"
  "-DCMAKE_C_FLAGS=-std=c99 -Wall -Wextra -Werror" "-DCMAKE_Fortran_FLAGS=-Wall -Werror")

build_host() { # usage: build_host FOLDER SOURCES [options]
  cmake -S "$2" -B "$1" "${flags[@]}" "${@:3}" > "$1.log" 2>&1 && cmake --build "$1" >> "$1.log" 2>&1 || { cat "$1.log"; exit 1; }
}

run_catalyst() { # usage: run_catalyst PROGRAM
  rm -rf meshes
  if ldd "$1" | grep -q libcatalyst; then # of the second kind: what libcatalyst itself gets
    CATALYST_DATA_DUMP_DIRECTORY=meshes mpiexec --bind-to none -n 2 "$1" > catalyst.out
    expect "host: step 3 done" catalyst.out
    test -s meshes/execute_invc3_params.conduit_bin.2.1
    return
  fi
  VFM_PLUGIN="$build/lib/VolumeFractionMesh.so" VFM_ARRAYS=ball,plate VFM_OUT=meshes VFM_NAME=mesh VFM_STEPS=3 \
    mpiexec --bind-to none -n 2 "$1" "$source/Examples/catalyst_mesh.py" > catalyst.out
  expect "host: step 3 done" catalyst.out
  test -s meshes/mesh_000003.pvtu
}

finds_no_vtk() { # usage: finds_no_vtk FOLDER
  ! grep "^VTK_DIR" "$1/CMakeCache.txt" || { echo "$1 looks for VTK"; exit 1; }
}

# usage: test_components TREE; TREE: where CMake finds the package
test_components() {
  local where=("-DCMAKE_PREFIX_PATH=$1")

  build_host hosts "$source/Examples/sculptor" "${where[@]}" -DCMAKE_CXX_STANDARD=11
  expect "$1/lib/\(libraries/\)\?libsculptor" <(ldd hosts/half_sphere_c)
  for host in half_sphere_c half_sphere_cxx half_sphere_fortran; do
    [[ -x hosts/$host || $host != *fortran ]] || continue
    run "hosts/$host" 2
    expect "^[1-9][0-9]* nodes, [1-9][0-9]* hexes, volume 7[12]" "hosts/$host.2.out"
    cmp hosts/half_sphere_c.2.out "hosts/$host.2.out"
  done
  finds_no_vtk hosts

  build_host mesher "$packages/mesher" "${where[@]}"
  mesher/host > mesher.out
  expect "^[1-9][0-9]* hexes, volume 271.37" mesher.out
  [[ $(grep -c "tets, volume 271.37" mesher.out) -ge 2 ]] || { cat mesher.out; exit 1; }
  mesher/mesh_in_cxx > mesh_in_cxx.out
  expect "^[1-9][0-9]* hexes, volume 271.3" mesh_in_cxx.out
  finds_no_vtk mesher

  build_host filters "$packages/filters" "${where[@]}"
  filters/host filters/ball.e > filters.out
  expect "^[1-9][0-9]* hexes" filters.out
  test -s filters/ball.e
  expect "^VTK_DIR" filters/CMakeCache.txt # so what finds_no_vtk looks for would be there

  if [[ $has_catalyst ]]; then
    build_host catalyst "$packages/catalyst" "${where[@]}"
    run_catalyst catalyst/host
  fi
}

# usage: test_pkg_config TREE
test_pkg_config() {
  local -x PKG_CONFIG_PATH="$1/lib/pkgconfig"
  read -ra link <<< "$(pkg-config --cflags --libs sculptor)"
  mpicc "$source/Examples/sculptor/half_sphere.c" "${link[@]}" -o half_sphere_c
  expect "$1/lib/\(libraries/\|pkgconfig/../../lib/\)\?libsculptor" <(ldd half_sphere_c)
  run half_sphere_c 2
  cmp half_sphere_c.2.out hosts/half_sphere_c.2.out
  if [[ $has_catalyst ]]; then
    read -ra link <<< "$(pkg-config --cflags --libs vfm_catalyst)"
    mpicxx -std=c++20 "$source/Testing/InSitu/CatalystHost.cxx" "${link[@]}" -o catalyst_host
    run_catalyst ./catalyst_host
  fi
}

mkdir missing
echo 'find_package(VolumeFractionMesh REQUIRED COMPONENTS Mesher Rainbow)' > missing/CMakeLists.txt
! cmake -S missing -B missing/build "-DCMAKE_PREFIX_PATH=$build" > missing/log 2>&1 || { echo "Rainbow was found"; exit 1; }
expect "no component Rainbow" missing/log

has_catalyst=
[[ ! -e moved/prefix/lib/libvfm_catalyst.so ]] || has_catalyst=1
for tree in "$build" "$scratch/moved/prefix"; do
  rm -rf hosts mesher filters catalyst
  test_components "$tree"
  test_pkg_config "$tree"
done
cat mesher.out mesh_in_cxx.out filters.out half_sphere_c.2.out
