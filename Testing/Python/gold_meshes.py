"""Reference meshes, which a run on one rank stores in a folder.

Runs on any number of ranks must reproduce them bitwise.
"""
import os
import pickle

import numpy as np
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from compare_meshes import difference, merge, read_pieces
from vfmtest import collect, reduced, save_data

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def dealt(blocks, seed):
    """Returns the blocks of this rank; with three or more ranks, the last one has no block."""
    owners = np.random.default_rng(seed).integers(0, RANKS - 1 if RANKS > 2 else RANKS, len(blocks))
    return [block for block, owner in zip(blocks, owners) if owner == RANK]


def make_folder(folder):
    if RANK == 0:
        os.makedirs(folder, exist_ok=True)
    CONTROLLER.Barrier()


def whole_mesh(mesher, path):
    """Returns the merged mesh of all ranks on rank 0, None on the others."""
    errors, _ = collect(mesher.GetClientSideObject())
    save_data(path, mesher)
    CONTROLLER.Barrier()  # all ranks have written
    assert not errors, errors
    mesh = merge(read_pieces(path)) if RANK == 0 else None
    CONTROLLER.Barrier()  # the next mesh overwrites the file
    return mesh


def check_gold(mesher, folder, name, keep):
    """Compares the mesh with the stored one; with `keep`, a run on one rank stores it first."""
    mesh = whole_mesh(mesher, os.path.join(folder, "ranks%d.pvtu" % RANKS))
    problem = ""
    if RANK == 0:
        path = os.path.join(folder, name + ".gold")
        if RANKS == 1 and keep:
            with open(path, "wb") as file:
                pickle.dump(mesh, file)
        with open(path, "rb") as file:
            gold = pickle.load(file)
        assert len(gold["cells"]) > 100
        problem = difference(mesh, gold)
    assert reduced(int(bool(problem)), vtkCommunicator.MAX_OP) == 0, (name, problem)
