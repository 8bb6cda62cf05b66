"""Rules of the house: Grid knows neither VTK nor MPI, and no source file grows past 1,000 lines."""
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
FOREIGN = re.compile(r'^\s*#\s*include\s*[<"](vtk|mpi|paraview|pv|pq)', re.IGNORECASE)
SOURCES = (".h", ".cxx", ".py", ".xml", ".txt", ".cmake")
LONGEST = 1000


def source_files():
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [f for f in folders if not f.startswith((".", "build")) and f not in ("out", "__pycache__")]
        for name in files:
            if name.endswith(SOURCES):
                yield os.path.relpath(os.path.join(folder, name), ROOT)


def read_lines(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.readlines()


def main():
    problems, count = [], 0
    for path in source_files():
        count += 1
        lines = read_lines(path)
        if len(lines) > LONGEST:
            problems.append("%s has %d lines" % (path, len(lines)))
        if path.startswith("Grid" + os.sep):
            problems += ["%s:%d: %s" % (path, i + 1, line.strip()) for i, line in enumerate(lines) if FOREIGN.match(line)]
    if count < 20:
        problems.append("only %d source files found" % count)
    print("\n".join(problems) or "%d files keep the rules" % count)
    sys.exit(1 if problems else 0)


main()
