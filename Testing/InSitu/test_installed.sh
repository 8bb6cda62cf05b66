#!/usr/bin/env bash
# Installs the build, runs the program sculptor, compiles the examples in C and Fortran against what was installed, runs them on two ranks, and
# looks with valgrind for leaks and memory errors of ours.
# usage: test_installed.sh SOURCE BUILD SCRATCH
set -euo pipefail
source="$1" build="$2" scratch="$3"
rm -rf "$scratch"
mkdir -p "$scratch"
cmake --install "$build" --prefix "$scratch/prefix" > "$scratch/install.log"
cd "$scratch"
export PKG_CONFIG_PATH="$scratch/prefix/lib/pkgconfig"
read -ra flags <<< "$(pkg-config --cflags --libs sculptor)"
examples="$source/Examples/sculptor"

expect() { # usage: expect TEXT FILE
  grep -q "$1" "$2" || { echo "'$1' is not in:"; cat "$2"; exit 1; }
}

# Leaks and errors of MPI and VTK are not ours: only reports with a function of ours among their callers count.
check_memory() { # usage: check_memory PROGRAM
  command -v valgrind > /dev/null || { echo "no valgrind: memory is not checked"; return; }
  mpiexec --bind-to none -n 2 valgrind --leak-check=full --show-leak-kinds=definite,indirect \
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

prefix/bin/sculptor --version > version.out
expect "^sculptor $(pkg-config --modversion sculptor)\$" version.out
prefix/bin/sculptor test > sculptor.out
expect "^PASS" sculptor.out

mpicc -std=c99 -Wall -Wextra -Werror "$examples/mesh_in_c.c" "${flags[@]}" -o mesh_in_c
mpiexec --bind-to none -n 2 ./mesh_in_c > mesh_in_c.out
expect "hexahedra in 1 fragment" mesh_in_c.out
mpiexec --bind-to none -n 1 ./mesh_in_c > mesh_in_c.1.out
cmp mesh_in_c.out mesh_in_c.1.out
check_memory mesh_in_c

if command -v gfortran > /dev/null; then
  gfortran -std=f2008 -Wall -Wextra -Werror -c "$(pkg-config --variable=includedir sculptor)/sculptor.f90"
  mpif90 -Wall "$examples/mesh_in_fortran.f90" sculptor.o "${flags[@]}" -o mesh_in_fortran
  mpiexec --bind-to none -n 2 ./mesh_in_fortran > mesh_in_fortran.out
  expect "ball: [1-9][0-9]* tetrahedra" mesh_in_fortran.out
  expect "hottest: 3[0-9][0-9]" mesh_in_fortran.out
  check_memory mesh_in_fortran
else
  echo "no gfortran: the example in Fortran is not run"
fi
cat mesh_in_*.out
