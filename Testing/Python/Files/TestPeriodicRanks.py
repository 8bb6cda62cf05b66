"""Periodic meshes of sculptor by MPI: the same bytes on 1 and 3 ranks."""
import os

import numpy as np

from mpi_run import mpi_run
from vfmtest import image, in_folder, main, write

SCULPTOR = os.environ["VFM_SCULPTOR"]
CELLS = 16
OPTIONS = {
    "lattice": ["--tetmesh", "Lattice", "--set", "Refinement=Coarsen"],
    "cells": ["--tetmesh", "Cells", "--set", "Refinement=Coarsen"],
    "joined": ["--tetmesh", "Lattice", "--set", "Refinement=Coarsen", "--periodic-sides", "Joined"],
    "free": ["--set", "Refinement=Coarsen", "--periodic-sides", "Free"],
    "selected": ["--refine-cells", "halvings"],
    "selected tetrahedra": ["--refine-cells", "halvings", "--tetmesh", "Lattice"],
    "state": ["--state", "speed", "--density", "density"],
}


@in_folder
def test_same_bytes_on_ranks(at):
    away = (np.indices(3 * [CELLS]) + 0.5) / CELLS
    squares = (np.minimum(away, 1 - away)**2).sum(0)
    labels = np.where(squares < 0.15**2, 2, 1)
    cells = {"id": labels, "halvings": (squares < 0.2**2).astype(int), "density": 1 + squares,
             "speed": np.sin(2 * np.pi * away[0])}
    path = write(image(cells), at("in.vti"))
    for name, arguments in OPTIONS.items():
        meshes = []
        for ranks in (1, 3):
            run = mpi_run(ranks, [SCULPTOR, path, at("%d.vtu" % ranks), "--labels", "id",
                                  "--periodic", "xyz", "--quiet", *arguments])
            assert run.returncode == 0 and run.stderr == "", (name, run)
            with open(at("%d.vtu" % ranks), "rb") as file:
                meshes.append(file.read())
        assert meshes[0] == meshes[1], name


main(globals())
