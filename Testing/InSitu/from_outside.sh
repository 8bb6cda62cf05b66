# What the tests of the installed tree share; to be read by bash.

expect() { # usage: expect TEXT FILE
  local text
  text="$(cat "$2")" # once: it may be a pipe
  grep -q "$1" <<< "$text" || { echo "'$1' is not in $2:"; echo "$text"; exit 1; }
}

# The output goes to PROGRAM.RANKS.out.
run() { # usage: run PROGRAM RANKS
  mpiexec --bind-to none -n "$2" "./$1" > "$1.$2.out"
}

# The commands under "Compile and link", in this folder: those that this machine has what it takes for.
compile_as_documented() { # usage: compile_as_documented DOCUMENT
  awk '/^## / { on = $0 == "## Compile and link" } on && sub(/^    /, "")' "$1" > compile.sh
  expect "mpif90" compile.sh
  command -v gfortran > /dev/null || sed -i '/gfortran\|mpif90/d' compile.sh
  pkg-config --exists vfm_catalyst || sed -i '/vfm_catalyst/d' compile.sh
  bash -euxo pipefail compile.sh
}
