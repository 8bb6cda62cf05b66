"""Meshes of several levels on several ranks, with randomly distributed blocks.

usage: mpiexec -n P pvbatch --sym TestRefinementRanks.py FOLDER

A run on one rank stores its meshes in FOLDER. Runs on any number of ranks must give bitwise
identical meshes and the same warnings.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkCommunicator

from amr_cases import cut, fields, multiblock, nested
from gold_meshes import RANK, RANKS, check_gold, dealt, make_folder
from vfmtest import VolumeFractionToHex, ball_and_plate, collect, main, producer, reduced

FOLDER = os.path.join(sys.argv[1], "refinement")
NAMES = {"VolumeFractionArrays": ["ball", "plate"]}


def sphere(n):
    """Returns fractions of a sphere that the domain cuts."""
    z, y, x = np.meshgrid(*[np.arange(n) + 0.5] * 3, indexing="ij")
    distance = np.sqrt((x - 0.3 * n) ** 2 + (y - 0.6 * n) ** 2 + (z - 0.5 * n) ** 2)
    return {"ball": np.clip(0.45 * n + 0.5 - distance, 0, 1)}


def numbered(arrays):
    size = next(iter(arrays.values())).shape
    return {**arrays, "number": np.arange(np.prod(size)).reshape(size)}


def noise():
    """Returns random labels next to a block of one label."""
    ids = np.random.default_rng(7).choice([0, 2, 3], (8, 8, 8))
    return {"id": np.pad(ids, ((0, 0), (0, 0), (0, 8)), constant_values=2).astype(np.int32)}


def image_blocks(n):
    return [(0, box) for box in cut(n, 3)]


def two(n):
    return dict(zip(("ball", "plate"), ball_and_plate(n)))


def wished(all_fields):
    """Adds an array that requests one or two halvings of a few random cells."""
    draw = lambda shape: np.random.default_rng(11).choice([0, 1, 2], shape,
                                                          p=[0.98, 0.015, 0.005]).astype(np.uint8)
    return [{**arrays, "wish": draw(arrays["ball"].shape)} for arrays in all_fields]


SPHERE, TWO, SMALL, NOISE = ([numbered(arrays)]
                             for arrays in (sphere(24), two(28), two(12), noise()))
HALF = [(0, ((0, 8), (0, 8), (0, 7))), (0, ((0, 3), (0, 8), (7, 16))),
        (0, ((3, 8), (0, 8), (7, 16)))]
CHOSEN = {"Refinement": "Automatic", "RefinementArray": "wish", "ThinCells": 0.0,
          "FineInterfaces": 0}
CASES = {  # fields, blocks, properties
    "input levels": (fields(2), nested(), NAMES),
    "input levels and void": (fields(2), nested(), {**NAMES, "MeshVoid": 1, "FineLayers": 3}),
    "automatic on input levels": (fields(1), nested(1),
                                  {**NAMES, "Refinement": "Automatic", "MaximumLevel": 2,
                                   "InterfaceLayers": 1}),
    "coarsened once": (SPHERE, image_blocks(24),
                       {"VolumeFractionArrays": ["ball"], "Refinement": "Coarsen",
                        "MaximumLevel": 1}),
    "coarsened thrice": (SPHERE, image_blocks(24),
                         {"VolumeFractionArrays": ["ball"], "Refinement": "Coarsen",
                          "MeshVoid": 1}),
    "two materials": (TWO, image_blocks(28),
                      {**NAMES, "Refinement": "Coarsen", "MaximumLevel": 2, "MeshVoid": 1}),
    "noise": (NOISE, HALF,
              {"MaterialIdArray": "id", "Refinement": "Automatic", "RefineFlippedCells": 1}),
    "levels of long cells": (fields(2), nested(), {**NAMES, "MaximumAspectRatio": 1.5}),
    "labels of long cells": (NOISE, HALF,
                             {"MaterialIdArray": "id", "LabelSmoothing": 2,
                              "MaximumAspectRatio": 1.1, "Refinement": "Automatic",
                                           "InterfaceLayers": 1}),
    "chosen cells": (wished(SMALL), image_blocks(12), {**NAMES, **CHOSEN}),
    "chosen cells and boxes": (wished(SMALL), image_blocks(12),
                               {**NAMES, **CHOSEN, "FineInterfaces": 1, "MaximumLevel": 1,
                                                                 "RefinementBoxes": [
                                                                     -9, -9, -9, -0.2, 1.1, 3.3, 2],
                                                                     "ThinCells": 1.5}),
    "chosen cells of levels": (wished(fields(1)), nested(1),
                               {**NAMES, **CHOSEN, "MeshVoid": 1,
                                "RefinementBoxes": [-0.2, 1.1, 3.3, 0.1, 1.4, 3.5, 1]}),
    "stairs": (SMALL, image_blocks(12),
               {**NAMES, "Refinement": "Automatic", "InterfaceLayers": 2, "MaximumLevel": 2,
                "StairStep": 1}),
}


def mesher_of(name, seed):
    all_fields, blocks, properties = CASES[name]
    return VolumeFractionToHex(Input=producer(multiblock(all_fields, dealt(blocks, seed))),
                               StateArrays=["number"], **properties)


def test_same_mesh():
    make_folder(FOLDER)
    for name in CASES:
        mesher = mesher_of(name, RANKS)
        check_gold(mesher, FOLDER, name, True)
        levels = mesher.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
        cells = vtk_to_numpy(levels.GetArray("LevelCells"))  # sums over all ranks
        assert cells[-1] > 0 and cells[:-1].sum() + levels.GetArray("TransitionCells").GetValue(
            0) > 0, (name, cells)


def test_warning():
    """Only rank 0 gives the warning."""
    blocks = [(0, ((0, 4), (0, 12), (0, 8))), (0, ((4, 16), (0, 12), (0, 8)))]
    data = multiblock([{"ball": np.ones((16, 12, 8))}],
                      [block for i, block in enumerate(blocks) if i % RANKS == RANK])
    hexes = VolumeFractionToHex(Input=producer(data), VolumeFractionArrays=["ball"],
                                Refinement="Coarsen", MaximumLevel=3)
    errors, warnings = collect(hexes.GetClientSideObject())
    hexes.UpdatePipeline()
    right = not errors and len(warnings) == (RANK
                                             == 0) and all("12 cells along y" in text
                                                           for text in warnings)
    assert reduced(int(right), vtkCommunicator.SUM_OP) == RANKS, (errors, warnings)


main(globals())
