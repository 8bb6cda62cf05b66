"""Conserved state on several ranks, with randomly distributed blocks.

usage: mpiexec -n P pvbatch --sym TestConserveRanks.py FOLDER

A run on one rank stores its meshes in FOLDER. Runs on any number of ranks must give bitwise
identical arrays of elements and nodes and field data. Meshes of TetGen depend on the number of
ranks; only their sums are compared.
"""
import os
import pickle
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkCommunicator

import amr_cases
from conserve_cases import BOTH, CONSERVE, close, state
from gold_meshes import CONTROLLER, RANK, RANKS, check_gold, dealt, make_folder
from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, VolumeFractionToHex, VolumeFractionToTet, ball_and_plate, collect,
    image, labels, main, producer, reduced, run)

FOLDER = os.path.join(sys.argv[1], "conserve")
N = 14
BALL, PLATE = ball_and_plate(N)
# unresolved material, too little for thin parts
BALL[N - 1, 1, 1] = BALL[N - 3, 4, 5] = BALL[N - 1, N - 2, N - 2] = 0.1
FIELDS = {"ball": BALL, "plate": PLATE, "id": labels(N), **state((N, N, N))}
DENSITIES = {"rho - ball": FIELDS["density"], "rho - plate": 2 * FIELDS["density"]}
LATTICE = {"Method": "Lattice"}
AMR = amr_cases.fields(2)
for level, arrays in enumerate(AMR):
    arrays.update(state(arrays["ball"].shape, seed=level))
CASES = {
    "hex": {}, "nodes": BOTH, "order 1": {"StateOrder": 1},
    "particles": {"UnmeshedMaterial": "Particles", "ParticleClusters": 1},
    "dropped": {"UnmeshedMaterial": "Drop", "MeshVoid": 1},
    "regions": {"MinimumRegionCells": 40}, "long cells": {"MaximumAspectRatio": 1.5},
    "a material": {"DensityArrays": list(DENSITIES)},
    "lattice": {**LATTICE, **BOTH}, "cells": {"Method": "Cells", "MeshVoid": 1},
    "labels": {"LabelSmoothing": 2}}
LEVELS = {
    "levels": BOTH, "averaged": {"Refinement": "Off"},
    "one level": {"Refinement": "Input Levels", "MaximumLevel": 1},
    "crossing": {"FineInterfaces": 0}, "levels of tets": {**LATTICE, "Refinement": "Off"}}


def blocks(seed):
    """Returns half slabs of the field, randomly distributed."""
    result = vtkMultiBlockDataSet()
    cuts = [(z, x) for z in range(0, N, 2) for x in (0, N // 2)]
    for b, (z, x) in enumerate(dealt(cuts, seed)):
        window = (slice(z, z + 2), slice(None), slice(x, x + N // 2))
        block = image({name: values[window].copy()
                       for name, values in {**FIELDS, **DENSITIES}.items()})
        block.SetOrigin(ORIGIN[0] + x * SPACING[0], ORIGIN[1], ORIGIN[2] + z * SPACING[2])
        result.SetBlock(b, block)
    return result


def mesher_of(data, name, properties):
    make = VolumeFractionToTet if "Method" in properties else VolumeFractionToHex
    materials = {"MaterialIdArray": "id"} if name == "labels" else {
        "VolumeFractionArrays": ["ball", "plate"]}
    return make(Input=producer(data), **materials, **{**CONSERVE, **properties})


def test_same_state():
    make_folder(FOLDER)
    for cases, find in ((CASES, blocks),
                        (LEVELS, lambda seed: amr_cases.multiblock(
                            AMR, dealt(amr_cases.nested(), seed)))):
        for name, properties in cases.items():
            check_gold(mesher_of(find(RANKS), name, properties), FOLDER, name, True)


def particles_of(mesher):
    """Returns {name: values} of this rank's particles."""
    mesher.UpdatePipeline()
    data = mesher.GetClientSideObject().GetOutputDataObject(6)
    arrays = data.GetPointData()
    return {"points": vtk_to_numpy(data.GetPoints().GetData()),
            **{arrays.GetArrayName(a): vtk_to_numpy(arrays.GetArray(a))
               for a in range(arrays.GetNumberOfArrays())}}


def test_same_particles():
    """The particles of all ranks together are those of one rank, bit for bit."""
    make_folder(FOLDER)
    for clusters in (0, 1):
        mesher = mesher_of(blocks(RANKS), "", {"UnmeshedMaterial": "Particles",
                                               "ParticleClusters": clusters})
        path = os.path.join(FOLDER, "particles%d" % clusters)
        with open("%s.rank%d" % (path, RANK), "wb") as file:
            pickle.dump(particles_of(mesher), file)
        CONTROLLER.Barrier()
        right = True
        if RANK == 0:
            parts = []
            for rank in range(RANKS):
                with open("%s.rank%d" % (path, rank), "rb") as file:
                    parts.append(pickle.load(file))
            whole = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
            order = np.argsort(whole["Id"])
            whole = {name: values[order].tobytes() for name, values in whole.items()}
            if RANKS == 1:
                with open(path + ".gold", "wb") as file:
                    pickle.dump(whole, file)
            with open(path + ".gold", "rb") as file:
                right = pickle.load(file) == whole and len(order) >= 2 and "Mass" in whole
        assert reduced(int(right), vtkCommunicator.MIN_OP) == 1, clusters


def test_tetgen_keeps_sums():
    if "TetGen" in TET_METHODS:
        result = run(blocks(RANKS), VolumeFractionToTet, Method="TetGen", **CONSERVE)
        total = lambda name: np.array(result.field(name))
        problem = str(result.errors)
        if not result.errors:
            scale = np.abs(total("InputMomentum")).max()
            right = close(total("MeshMass") + total("UnmeshedMass"), total("InputMass"),
                          total("InputMass")) and close(
                total("MeshMomentum") + total("UnmeshedMomentum"), total("InputMomentum"), scale)
            problem = "" if right else "sums differ"
        assert reduced(int(bool(problem)), vtkCommunicator.SUM_OP) == 0, problem


def test_errors():
    """All ranks report one equal message."""
    for words, change in (
            (("The density array 'density' is -1 in cell (2, 3, 4)", "'plate'"),
             lambda fields: fields["density"].__setitem__((4, 3, 2), -1.0)),
            (("state kinds name 'nothing'",), None)):
        kept = {name: values.copy() for name, values in FIELDS.items()}
        if change:
            change(FIELDS)
        mesher = mesher_of(blocks(3), "", {} if change else {"StateKinds": ["nothing=volume"]})
        FIELDS.update(kept)
        errors, _ = collect(mesher.GetClientSideObject())
        mesher.UpdatePipeline()
        right = len(errors) == 1 and all(word in errors[0] for word in words)
        assert reduced(int(right), vtkCommunicator.SUM_OP) == RANKS, errors


main(globals())
