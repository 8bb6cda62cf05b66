"""Runs of the command-line tool `sculptor` (VFM_SCULPTOR) on some ranks, for tests."""
import os
import re
import unittest

from compare_meshes import difference, merge, read_pieces
from mpi_run import mpi_run

SCULPTOR = os.environ["VFM_SCULPTOR"]


def sculptor(*arguments, ranks=1, folder=None):
    """Runs the tool without a terminal; notices of mpiexec are removed from standard error."""
    return mpi_run(ranks, [SCULPTOR, *arguments], folder)


def mesh_file(path, output, *arguments, ranks=1, note="is read as void"):
    """Meshes a file and returns the standard output. Only messages with the note may be printed,
    by default that on label 0."""
    result = sculptor("--input", path, "--output", output, *arguments, ranks=ranks)
    assert result.returncode == 0 and all(
        note in line for line in result.stderr.splitlines()), result
    return result.stdout


def refused(code, text, *arguments, ranks=1):
    """Checks that the tool exits with that code and one message that contains the text."""
    result = sculptor(*arguments, ranks=ranks)
    lines = [line for line in result.stderr.splitlines() if not line.startswith("[warn]")]  # of MPI
    assert result.returncode == code, (code, result)
    assert len(lines) == 1 and lines[0].startswith("sculptor: ") and text in lines[0], (
        text, result)
    assert result.stdout == "", result


def rows(text):
    """Returns the rows of the printed tables: {name: numbers}."""
    found = {}
    for line in text.splitlines():
        numbers = line[28:].replace("%", "").split()
        if len(numbers) >= 5 and numbers[0].isdigit():
            found[line[:28].strip()] = [float(n) if n != "-" else None for n in numbers]
    return found


def check_same(output, mesh, time=None, besides=()):
    """Checks that the file holds the mesh and, if given, the time.

    besides: field data that only the file has.
    """
    pieces = read_pieces(output)
    for piece in pieces:
        field = piece.GetFieldData()
        assert (field.GetArray("TimeValue").GetTuple1(0) if time is not None
                else field.GetArray("TimeValue")) == time
        for name in ("TimeValue", *besides):
            field.RemoveArray(name)
    problem = difference(merge(pieces), merge([mesh]))
    assert not problem, "%s: %s" % (output, problem)
