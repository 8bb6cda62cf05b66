#!/usr/bin/env bash
# Installs the build, runs the program sculptor, compiles the hosts in C, C++ and Fortran against what was installed, by the lines of
# Documentation/user/simulation.md, runs them on several ranks, and looks with valgrind for leaks and memory errors of ours.
# usage: test_hosts.sh SOURCE BUILD SCRATCH [HOST]      HOST: of the hosts valgrind runs this one alone
set -euo pipefail
source="$1" build="$2" scratch="$3" one="${4:-}"
rm -rf "$scratch"
mkdir -p "$scratch"
export PREFIX="$scratch/prefix" SOURCE="$source"
cmake --install "$build" --prefix "$PREFIX" > "$scratch/install.log"
cp -r "$source/Examples/sculptor" "$scratch/hosts"
cd "$scratch/hosts"
. "$source/Testing/InSitu/from_outside.sh"
export PKG_CONFIG_PATH="$PREFIX/lib/pkgconfig"

# Leaks and errors of MPI and VTK are not ours: only reports with a function of ours among their callers count.
check_memory() { # usage: check_memory PROGRAM RANKS
  [[ -z "$one" || "$one" == "$1" ]] || return 0
  command -v valgrind > /dev/null || { echo "no valgrind: memory is not checked"; return; }
  mpiexec --bind-to none -n "$2" valgrind --leak-check=full --show-leak-kinds=definite,indirect \
    --num-callers=40 --log-file="$1.%p.valgrind" "./$1" > "$1.valgrind.out"
  for log in "$1".*.valgrind; do
    expect "ERROR SUMMARY" "$log"
    if awk '/^==[0-9]+== *$/ {
              if (report ~ /libsculptor|libvtkVolumeFraction|vfm::|alloc[^\n]*\n[^\n]*: (main|MAIN__) /) { print report; found = 1 }
              report = "" }
            { report = report "\n" $0 }
            END { exit !found }' "$log"; then
      echo "memory of ours: $log"
      exit 1
    fi
  done
}

"$PREFIX/bin/sculptor" --version > version.out
expect "^sculptor $(pkg-config --modversion sculptor)\$" version.out
"$PREFIX/bin/sculptor" test > sculptor.out
expect "^PASS" sculptor.out

# The library needs no VTK and no ParaView, nor anything that is linked to them.
ldd "$PREFIX/lib/libsculptor.so" > libraries.out
expect "libmpi" libraries.out
! grep -i "vtk\|paraview\|not found" libraries.out || { echo "libsculptor needs VTK or ParaView, or lacks something"; exit 1; }

# Headers and modules for hosts with warnings as errors.
headers="$(pkg-config --variable=includedir sculptor)"
for standard in 99 11; do
  gcc -std="c$standard" -pedantic -Wall -Wextra -Werror -fsyntax-only -x c "$headers/CMLPSculptor.c.h"
done
for standard in 11 14 17; do
  g++ -std="c++$standard" -pedantic -Wall -Wextra -Werror -fsyntax-only -x c++ "$headers/CMLPSculptor.hpp"
done
languages=(c cxx)
if command -v gfortran > /dev/null; then
  gfortran -std=f2008 -Wall -Wextra -Werror -fsyntax-only "$headers/cmlpsculptor.f90" "$headers/sculptor.f90"
  languages+=(fortran)
else
  echo "no gfortran: the hosts in Fortran are not run"
fi

compile_as_documented "$source/Documentation/user/simulation.md"
for language in "${languages[@]}"; do
  for ranks in 1 4; do
    run "half_sphere_$language" $ranks
    expect "^[1-9][0-9]* nodes, [1-9][0-9]* hexes, volume 7[12]" "half_sphere_$language.$ranks.out"
    cmp "half_sphere_c.$ranks.out" "half_sphere_$language.$ranks.out"
  done
  check_memory "half_sphere_$language" 2
done
cmp half_sphere_c.4.out <(mpiexec --bind-to none -n 4 build/half_sphere_cxx)
# Tetrahedra by TetGen depend on the ranks; their volume does not.
cmp <(sed 's/.* tets//' half_sphere_c.1.out) <(sed 's/.* tets//' half_sphere_c.4.out)

for host in mesh_in_c mesh_in_fortran; do
  if [[ -x $host ]]; then
    run "$host" 1
    run "$host" 4
    expect "ball: [1-9][0-9]* tetrahedra" "$host.4.out"
    expect "contact: [1-9][0-9]* triangles" "$host.4.out"
    expect "hottest: 3[0-9][0-9]" "$host.4.out"
    expect "^particles: 1, volume 0.100$" "$host.4.out"
    cmp mesh_in_c.1.out "$host.1.out"
    cmp mesh_in_c.1.out "$host.4.out"
    check_memory "$host" 2
  fi
done

# Blocks of two levels.
run levels_in_c 1
run levels_in_c 3
expect "^[1-9][0-9]* coarse and [1-9][0-9]* fine blocks: [1-9][0-9]* hexahedra" levels_in_c.3.out
cmp levels_in_c.1.out levels_in_c.3.out
check_memory levels_in_c 3

tail half_sphere_c.*.out mesh_in_c.1.out levels_in_c.3.out
