"""Meshes that any number of ranks must make bit for bit as one rank alone did, which keeps them in
a folder."""
import os
import pickle

import numpy as np
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from compare_meshes import difference, merge, read_pieces
from vfmtest import collect, reduced, save_data

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def dealt(blocks, seed):
    """This rank's blocks; the last rank of three or more has none."""
    owners = np.random.default_rng(seed).integers(0, RANKS - 1 if RANKS > 2 else RANKS, len(blocks))
    return [block for block, owner in zip(blocks, owners) if owner == RANK]


def make_folder(folder):
    if RANK == 0:
        os.makedirs(folder, exist_ok=True)
    CONTROLLER.Barrier()


def whole_mesh(mesher, path):
    """Of all ranks, on rank 0."""
    errors, _ = collect(mesher.GetClientSideObject())
    save_data(path, mesher)
    CONTROLLER.Barrier()  # all have written
    assert not errors, errors
    mesh = merge(read_pieces(path)) if RANK == 0 else None
    CONTROLLER.Barrier()  # the next mesh goes to the same file
    return mesh


def check_gold(mesher, folder, name, keep):
    """keep: one rank alone writes the gold."""
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
