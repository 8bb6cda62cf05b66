#!/usr/bin/env bash
# The second kind of Catalyst without an implementation: libcatalyst's own stub dumps what it gets; a script that nobody runs is told.
# usage: test_dump.sh HOST SCRIPT SCRATCH
set -euo pipefail
host="$1" script="$2" scratch="$3"
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

run() { mpiexec --oversubscribe --bind-to none -n 3 "$host" "$@"; }

CATALYST_DATA_DUMP_DIRECTORY="$scratch/nodes" run --refined --boxes 4 > run.out
[[ $(grep -c "^host: step . done" run.out) == 4 ]]
for rank in 0 1 2; do
  for call in initialize execute_invc{0,1,2,3} finalize; do
    test -e "nodes/${call}_params.conduit_bin.3.$rank"
  done
  for name in ball plate id velocity vtkGhostType box0 box1 box2; do
    grep -q "\"$name\"" "nodes/execute_invc3_params.conduit_bin.3.${rank}_json"
  done
done

fails() { # usage: fails TEXT: each step, with it
  ! run "$script" > failed.out 2> failed.err || { cat failed.out; exit 1; }
  [[ $(grep -c "failed: $1" failed.out) == 4 ]] || { cat failed.out; exit 1; }
}

fails "No script is run: .*CATALYST_IMPLEMENTATION_NAME"
CATALYST_IMPLEMENTATION_NAME=nobody fails "Catalyst cannot start: there is no implementation 'nobody'"
